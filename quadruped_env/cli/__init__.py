"""Command line `mini-quadruped`: one module per command, and code that the commands share."""

"""The command line: `mini-quadruped`, one module per command, and what the commands share."""

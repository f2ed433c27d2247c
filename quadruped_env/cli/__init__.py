"""The command line: options, progress and errors that the programs share."""

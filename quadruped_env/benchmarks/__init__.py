"""How fast, how small, how exact: what the programs of the same names measure."""

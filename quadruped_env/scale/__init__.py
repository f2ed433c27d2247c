"""Training at scale: sweeps, ranks, and the simulation of thousands of robots on a GPU."""

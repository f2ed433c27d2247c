"""Many trainings at once: sweeps on Ray."""

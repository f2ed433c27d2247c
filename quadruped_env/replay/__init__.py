"""Replay of recorded joint trajectories: kinematic, or as motor targets in the simulation."""

"""Recorded joint trajectories played again: as a picture of the robot, or through the motors of the simulation."""

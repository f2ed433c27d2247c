"""Control in training and on a real robot: observations from readings, and joint targets from observations."""

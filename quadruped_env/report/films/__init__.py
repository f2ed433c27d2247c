"""Films of a robot, and what is drawn into them."""

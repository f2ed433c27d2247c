"""Films and stills of a robot, and what is drawn into them."""

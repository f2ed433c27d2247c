"""The ROS 2 tutorial's robot, for a ROS 2 installation."""

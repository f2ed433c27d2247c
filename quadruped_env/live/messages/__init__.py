"""Between the robot and ROS 2 messages: reading with validation, writing, and messages as text."""

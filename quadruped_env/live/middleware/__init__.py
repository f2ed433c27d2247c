"""DDS with ROS 2's names, types, hashes and qualities of service: nodes, publishers, subscriptions and the graph."""

"""The scene editor as a ROS 2 node."""

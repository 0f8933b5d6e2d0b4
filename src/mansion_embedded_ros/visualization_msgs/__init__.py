"""Interfaces of ROS 2 Jazzy's ``visualization_msgs``."""

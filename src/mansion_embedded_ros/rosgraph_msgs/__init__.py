"""Interfaces of ROS 2 Jazzy's ``rosgraph_msgs``."""

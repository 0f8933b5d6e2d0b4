"""Interfaces of ROS 2 Jazzy's ``diagnostic_msgs``."""

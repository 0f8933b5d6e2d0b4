"""Interfaces of ROS 2 Jazzy's ``nav_msgs``."""

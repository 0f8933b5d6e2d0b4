"""Interfaces of ROS 2 Jazzy's ``geometry_msgs``."""

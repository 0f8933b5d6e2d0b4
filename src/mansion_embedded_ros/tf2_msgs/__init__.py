"""Interfaces of ROS 2 Jazzy's ``tf2_msgs``."""

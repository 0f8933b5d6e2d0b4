"""Interfaces of ROS 2 Jazzy's ``builtin_interfaces``."""

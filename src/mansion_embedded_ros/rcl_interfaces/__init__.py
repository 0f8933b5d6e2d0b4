"""Interfaces of ROS 2 Jazzy's ``rcl_interfaces``."""

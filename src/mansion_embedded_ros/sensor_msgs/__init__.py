"""Interfaces of ROS 2 Jazzy's ``sensor_msgs``."""

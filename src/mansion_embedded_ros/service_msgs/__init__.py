"""Interfaces of ROS 2 Jazzy's ``service_msgs``."""

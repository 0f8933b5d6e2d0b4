"""Interfaces of ROS 2 Jazzy's ``unique_identifier_msgs``."""

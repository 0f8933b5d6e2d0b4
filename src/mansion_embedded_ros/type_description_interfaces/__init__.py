"""Interfaces of ROS 2 Jazzy's ``type_description_interfaces``."""

"""Interfaces of ROS 2 Jazzy's ``rmw_dds_common``."""

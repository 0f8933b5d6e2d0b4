"""Interfaces of ROS 2 Jazzy's ``std_srvs``."""

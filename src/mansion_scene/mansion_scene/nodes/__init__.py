"""Thin ROS 2 nodes around the scene's stages."""

"""Mansion end to end: Algorithm 1, the building folder, the node graph, the Python client and the command line."""

from mansion_msgs_py import __version__

__all__ = ["__version__"]

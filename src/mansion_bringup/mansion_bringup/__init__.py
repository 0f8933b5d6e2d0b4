"""Mansion end to end: Algorithm 1, the building folder, the node graph, the Python client and the command line."""

__version__ = "0.1.0"

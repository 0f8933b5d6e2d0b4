"""Mansion end to end: Algorithm 1 over all stages, the command line, launch files and the RViz view.

This is the only package that imports all the others; `nodes` holds the building director.
"""

__version__ = "0.1.0"

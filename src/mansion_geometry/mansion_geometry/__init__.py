"""Polygons, grids, free space and reachability: the geometry that planner, scene and skills share.

Coordinates are metres with x to the right and y up; polygons run counter-clockwise and do not repeat their
first point. Everything here is a pure function of its arguments.
"""

__version__ = "0.1.0"

"""Plane geometry that planner, scene and skills share: rings, rasters, shared walls, free space, reachability."""

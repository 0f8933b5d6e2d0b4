"""Where a robot can go: occupancy grids, paths on a floor, routes between floors, and what a laser sees."""

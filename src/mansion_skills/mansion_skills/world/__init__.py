"""The building in memory: where the robot, its load and the lifts are, and what differs from the scenes on disk."""

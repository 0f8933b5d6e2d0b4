"""The size of the robot's body, how far it reaches, and the width that it needs."""

from typing import Final

__all__ = ["BODY_RADIUS", "PASSAGE_WIDTH", "ROBOT_RADIUS", "ROBOT_REACH"]

ROBOT_RADIUS: Final = 0.20
"""Radius of the disc that the robot covers, metres."""

BODY_RADIUS: Final = ROBOT_RADIUS - 1e-3
"""Half the width that a passage needs, metres: the robot, less the rounding of coordinates."""

ROBOT_REACH: Final = 0.30
"""Distance beyond its body at which the robot has approached an object, metres."""

PASSAGE_WIDTH: Final = 0.6
"""Narrowest way that counts as walkable when walls and doors are planned, metres: the robot with some play."""

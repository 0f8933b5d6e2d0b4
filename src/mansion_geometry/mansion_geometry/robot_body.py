"""The size of the robot's body: the one place where it stands."""

from typing import Final

__all__ = ["BODY_RADIUS", "ROBOT_RADIUS"]

ROBOT_RADIUS: Final = 0.20
"""Of the disc that the robot covers, metres."""

BODY_RADIUS: Final = ROBOT_RADIUS - 1e-3
"""Half the width that a passage needs, metres: the robot, less the rounding of coordinates."""

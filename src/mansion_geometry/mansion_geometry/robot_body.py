"""The size of the robot's body, how far it reaches, the width that it needs, and what stands in its way."""

from typing import Final

__all__ = ["BODY_RADIUS", "CLEARANCE", "FLAT", "PASSAGE_WIDTH", "ROBOT_RADIUS", "ROBOT_REACH", "THIN", "in_the_way"]

ROBOT_RADIUS: Final = 0.20
"""Radius of the disc that the robot covers, metres."""

BODY_RADIUS: Final = ROBOT_RADIUS - 1e-3
"""Half the width that a passage needs, metres: the robot, less the rounding of coordinates."""

ROBOT_REACH: Final = 0.30
"""Distance beyond its body at which the robot has approached an object, metres."""

PASSAGE_WIDTH: Final = 0.6
"""Narrowest way that counts as walkable when walls and doors are planned, metres: the robot with some play."""

CLEARANCE: Final = 1.5
"""Height of the robot, metres: what hangs higher is not an obstacle."""

FLAT: Final = 0.05
"""Height up to which the robot drives over objects, rugs say; metres."""

THIN: Final = 0.02
"""Depth up to which what hangs on a wall stops nobody, metres."""


def in_the_way(bottom: float, top: float) -> bool:
    """Whether something between two heights above the floor, metres, stops the robot.

    Examples
    --------
    >>> in_the_way(0.0, 0.02), in_the_way(0.0, 0.8), in_the_way(1.9, 2.4)
    (False, True, False)
    """
    return bottom < CLEARANCE and top > FLAT

"""Options of the placement solver."""

from dataclasses import dataclass

from mansion_geometry.robot_body import ROBOT_RADIUS, ROBOT_REACH

__all__ = ["PlacementOptions"]


@dataclass(frozen=True)
class PlacementOptions:
    """Clearances and search budgets of the placement solver.

    Attributes
    ----------
    robot_radius, reach : float
        Radius of the disc robot and how far beyond its body it reaches, metres.
    margin : float
        Added to the radius and taken from the reach, so that a path found on one grid exists on any other, metres.
    tight : bool
        Whether objects that do not fit with `margin` and comfortable clearances are tried without them.
    cell : float
        Cell of the free-space grid, metres.
    door_depth : float
        Depth of the area before a door that stays clear, metres.
    window_depth : float
        Depth of the strip before a window where nothing taller than its sill stands, metres.
    aisle, public_aisle : float
        Aisle width aimed at in private and in public rooms, metres.
    wall_gap, gap : float
        Space left between a back and its wall, and between neighbours, metres.
    attempts : int
        Most constructions of a room from scratch; the search ends at the first without a fault.
    moves : int
        Most moves of the improvement pass (twice as many again without margins, where something is missing).
    effort : float
        Work after which the improvement ends, in units of about two microseconds of a desktop core.
    candidates : int
        Most poses of an object whose reachability is examined in one search.
    """

    robot_radius: float = ROBOT_RADIUS
    reach: float = ROBOT_REACH
    margin: float = 0.035
    tight: bool = True
    cell: float = 0.05
    door_depth: float = 0.80
    window_depth: float = 0.30
    aisle: float = 0.90
    public_aisle: float = 1.20
    wall_gap: float = 0.01
    gap: float = 0.02
    attempts: int = 3
    moves: int = 24
    effort: float = 170_000.0
    candidates: int = 16

"""The forms of a storey's plan: rooms along one corridor, around a hall, or along parallel corridors."""

from collections.abc import Sequence

from mansion_planner.program import aisle_sketch, corridor_sketch
from mansion_planner.program.hall_sketch import sketch_hall
from mansion_planner.program.model import Massing, Sketch, Storey

__all__ = ["capacity", "sketched"]


def capacity(massing: Massing, storey: Storey) -> float:
    """Return the area that rooms can take on a storey, square metres."""
    if massing.aisles is not None:
        return aisle_sketch.aisle_capacity(massing)
    return corridor_sketch.capacity(massing, storey)


def sketched(
    massing: Massing, storey: Storey, hub_id: str, pairs: list[tuple[str, str]], apart: Sequence[tuple[str, str]] = ()
) -> Sketch:
    """Lay out the rooms of a storey in the form of its massing.

    Parameters
    ----------
    massing : Massing
    storey : Storey
        With rooms whose areas add up to about the storey's capacity.
    hub_id : str
    pairs : list of (str, str)
        Room types to be side by side.
    apart : sequence of (str, str)
        Those that must not share a wall.
    """
    if massing.aisles is not None:
        return aisle_sketch.sketch_aisles(massing, storey, hub_id, pairs, apart)
    lay_out = sketch_hall if massing.hall else corridor_sketch.sketch_storey
    return lay_out(massing, storey, hub_id, pairs, apart)

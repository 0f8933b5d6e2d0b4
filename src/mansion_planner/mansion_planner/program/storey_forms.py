"""The forms of a storey's plan: rooms along one corridor, around a hall, or along parallel corridors."""

from collections.abc import Sequence
from dataclasses import replace

from mansion_planner.program import aisle_sketch, corridor_sketch
from mansion_planner.program.hall_sketch import sketch_hall
from mansion_planner.program.massing import corridor_width
from mansion_planner.program.model import Massing, Sketch, Storey

__all__ = ["capacity", "form_of", "sketched"]

_DEEPEST = 20.0
"""Depth of a storey up to which rooms line one corridor well, metres."""

_SHALLOWEST = 3.0
"""Least depth of the rooms along it, metres."""


def form_of(massing: Massing, storey: Storey) -> Massing:
    """Return the massing as a storey uses it: offices above a hall line a corridor between the same stairs and lifts.

    Parameters
    ----------
    massing : Massing
    storey : Storey

    Returns
    -------
    Massing
        The same one unless its hall gives way to a corridor.
    """
    if not massing.hall or storey.hub.zone != "circulation" or massing.depth > _DEEPEST:
        return massing
    corridor = corridor_width(storey.use, massing.length * massing.depth)
    stairs = [core.box for core in massing.cores if core.type == "stair"]
    lifts = [core.box for core in massing.cores if core.type == "elevator"]
    north = max([0.45 * (massing.depth - corridor), *(massing.depth - box[1] for box in stairs)])
    south = massing.depth - corridor - north
    lobby = max((box[2] + 2.0 for box in lifts), default=0.0)
    if south < max([_SHALLOWEST, *(box[3] for box in lifts)]):
        return massing
    return replace(massing, hall=False, north=north, corridor=corridor, south=south, lobby=lobby)


def capacity(massing: Massing, storey: Storey) -> float:
    """Return the area that rooms can take on a storey, square metres."""
    if massing.aisles is not None:
        return aisle_sketch.aisle_capacity(massing)
    return corridor_sketch.capacity(form_of(massing, storey), storey)


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
    form = form_of(massing, storey)
    lay_out = sketch_hall if form.hall else corridor_sketch.sketch_storey
    return lay_out(form, storey, hub_id, pairs, apart)

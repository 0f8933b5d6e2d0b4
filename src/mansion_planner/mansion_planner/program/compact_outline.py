"""Outlines of L-shaped homes whose arms are too narrow for a corridor with rooms on both sides."""

import itertools
import math
from collections.abc import Iterator
from dataclasses import replace

from shapely import affinity
from shapely.geometry import Polygon

from mansion_geometry.randomness import item_generator
from mansion_knowledge import kin_of
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.shape_sizes import holds_shape

__all__ = ["compact_l", "with_compact_outline"]

_LEAST = 48.0
"""Least gross area of a storey with two arms of rooms, square metres."""

_LEAST_WITH_STAIR = 70.0

_MOST = 230.0
"""Gross area of a storey up to which its arms are too narrow for a corridor with rooms on both sides, square metres."""

_WHOLE, _HALF = 1.0, 0.5
"""Steps of the corners, metres: cores stand at whole metres, and leave no gap to a side that does too."""

_MISSED = 0.02
"""Share of the area that the chosen outline may miss; the closest one is taken where none comes within it."""


def with_compact_outline(decisions: Decisions, area: float, stairs: int) -> Decisions:
    """Return decisions with an outline for an L-shaped home whose arms are too narrow for a corridor between rooms.

    Parameters
    ----------
    decisions : Decisions
    area : float
        Gross area of a storey, square metres.
    stairs : int
    """
    shapes = decisions.facts.shapes
    wanted = bool(shapes) and shapes[0][0] == "L" and decisions.building.family == "home" and decisions.outline is None
    if not wanted or not (_LEAST_WITH_STAIR if stairs else _LEAST) <= area <= _MOST:
        return decisions
    garage = any(kin_of(fact.room_type) == "garage" for fact in decisions.facts.rooms)
    if garage and holds_shape("L", area, stairs):
        return decisions  # rooms that share an outline freely leave no rectangle deep enough for cars
    return replace(decisions, outline=compact_l(area, decisions.seed, _WHOLE if stairs else _HALF), free_form=True)


def compact_l(area: float, seed: int, step: float = _HALF) -> Polygon:
    """Return an L-shaped outline with arms of about half its length and depth, mirrored as the seed says.

    Parameters
    ----------
    area : float
        Square metres; met to 2%, or as closely as corners in these steps allow.
    seed : int
        Chooses among the outlines that meet it.
    step : float
        Step of the coordinates, metres.

    Examples
    --------
    >>> outline = compact_l(64.0, 3)
    >>> abs(outline.area - 64.0) < 1.0, len(outline.exterior.coords) - 1
    (True, 6)
    """
    generator = item_generator(seed, "compact outline")
    found = list(_candidates(area, step))
    near = [sides for error, sides in found if error <= _MISSED] or [min(found)[1]]
    length, depth, arm, notch = near[int(generator.integers(len(near)))]
    outline = Polygon([(0.0, 0.0), (length, 0.0), (length, notch), (arm, notch), (arm, depth), (0.0, depth)])
    if generator.random() < 0.5:
        outline = affinity.scale(outline, xfact=-1.0, origin=(length / 2, 0.0))
    if generator.random() < 0.5:
        outline = affinity.scale(outline, yfact=-1.0, origin=(0.0, depth / 2))
    return Polygon(outline.exterior.coords).normalize().reverse()


def _candidates(area: float, step: float) -> Iterator[tuple[float, tuple[float, float, float, float]]]:
    """Yield the share of the area that each outline misses, and its length, depth and both arms, metres."""
    side = math.sqrt(area / 0.76)
    sides = [step * n for n in range(math.floor(0.85 * side / step), math.ceil(1.25 * side / step) + 1)]
    for length, depth in itertools.product(sides, sides):
        if not 1.0 <= length / depth <= 1.35:
            continue
        arms = (_arms(length, step), _arms(depth, step))
        for arm, notch in itertools.product(*arms):
            error = abs(length * depth - (length - arm) * (depth - notch) - area) / area
            yield error, (length, depth, arm, notch)


def _arms(side: float, step: float) -> list[float]:
    """Return the arms that go with a side: 0.48 to 0.6 of it, and at least one."""
    return [step * n for n in range(math.ceil(0.48 * side / step), math.floor(0.6 * side / step) + 1)] or [
        step * round(0.55 * side / step)
    ]

"""The part of each region that a robot can walk, and the stretches of wall that doors may use to reach it.

A room that is pinched to less than a passage is two rooms to a robot: only its largest walkable part counts, and
doors open on to nothing else.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Final

import shapely
from shapely.geometry import LineString, Polygon

from mansion_msgs_py.shapes import Point
from mansion_scene.structure.dimensions import INTERIOR_THICKNESS
from mansion_scene.structure.stretches import Stretch

__all__ = ["PASSAGE", "usable_stretches", "walkable_parts"]

PASSAGE: Final = 0.6
"""Narrowest way that counts as walkable, metres: a robot of radius 0.20 m and some play."""

_INSIDE = 0.03  # metres beyond the wall's face at which a stretch is looked up
_SHORTEST = 0.3


def walkable_parts(nets: Mapping[str, Polygon]) -> dict[str, Polygon]:
    """Return the largest part of each net interior in which no way is narrower than `PASSAGE`.

    It is the morphological opening of the net interior by a square; empty where the whole region is narrower.
    """
    radius = PASSAGE / 2 - 1e-3
    parts: dict[str, Polygon] = {}
    eroded = shapely.buffer(list(nets.values()), -radius, join_style="mitre")
    for name, shape in zip(nets, eroded, strict=True):
        pieces = [piece for piece in shapely.get_parts(shape) if not piece.is_empty]
        if not pieces:
            parts[name] = Polygon()
            continue
        largest = max(pieces, key=lambda piece: (round(piece.area, 6), piece.bounds))
        grown = largest.buffer(radius, join_style="mitre")
        parts[name] = grown.intersection(nets[name]) if not nets[name].covers(grown) else grown
    return parts


def usable_stretches(stretches: Sequence[Stretch], parts: Mapping[str, Polygon]) -> list[Stretch]:
    """Return the pieces of stretches that have walkable floor on every side that is a region.

    Parameters
    ----------
    parts : mapping
        Of `walkable_parts`; a side whose region it leaves out (a core) is not asked.
    """
    usable: list[Stretch] = []
    for stretch in stretches:
        dx, dy = stretch.direction
        # An outer wall stands outside its stretch, an inner one astride it.
        shift = _INSIDE if stretch.exterior else INTERIOR_THICKNESS / 2 + _INSIDE
        intervals = [(0.0, stretch.length)]
        for region, normal in ((stretch.left, (-dy, dx)), (stretch.right, (dy, -dx))):
            if region is not None and region in parts:
                beside = _intervals(stretch, (normal[0] * shift, normal[1] * shift), parts[region])
                intervals = _common(intervals, beside)
        usable.extend(_piece(stretch, low, high) for low, high in intervals)
    return usable


def _intervals(stretch: Stretch, offset: Point, part: Polygon) -> list[tuple[float, float]]:
    """Return where a stretch, moved by an offset, runs inside a part; with the half walls at its ends."""
    (x0, y0), (x1, y1) = stretch.start, stretch.end
    moved = LineString([(x0 + offset[0], y0 + offset[1]), (x1 + offset[0], y1 + offset[1])])
    inside = [piece for piece in shapely.get_parts(moved.intersection(part)) if piece.length > 0]
    dx, dy = stretch.direction
    half = INTERIOR_THICKNESS / 2
    intervals = []
    for piece in inside:
        along = sorted((x - x0 - offset[0]) * dx + (y - y0 - offset[1]) * dy for x, y in piece.coords)
        low = 0.0 if along[0] < half + 1e-3 else along[0]
        high = stretch.length if along[-1] > stretch.length - half - 1e-3 else along[-1]
        intervals.append((low, high))
    return sorted(intervals)


def _common(first: Sequence[tuple[float, float]], second: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    common = [(max(a, c), min(b, d)) for a, b in first for c, d in second]
    return [(low, high) for low, high in common if high - low > _SHORTEST]


def _piece(stretch: Stretch, low: float, high: float) -> Stretch:
    if low == 0.0 and high == stretch.length:
        return stretch
    return replace(stretch, start=stretch.at(low), end=stretch.at(high))

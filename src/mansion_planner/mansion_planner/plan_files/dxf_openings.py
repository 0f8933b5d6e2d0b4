"""Where a drawing has its doors and windows: arcs of leaves, and what is drawn in the plane of a wall."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import shapely
from shapely.geometry import LineString, MultiPoint, Polygon
from shapely.geometry.base import BaseGeometry

from mansion_msgs_py.shapes import Point, Segment

__all__ = ["Arc", "Mark", "door_segment", "is_double", "joined_marks", "window_segment"]

_BESIDE: Final = {"doors": 0.2, "windows": 0.45, "openings": 0.45}
"""Metres between parallel lines up to which they are of one opening: those of windows lie on both faces of walls."""

_MEETING: Final = 0.1
"""Metres between the tips of two leaves of one double door."""


@dataclass(frozen=True)
class Arc:
    """The arc that a leaf sweeps: its hinge and the two ends of the arc."""

    hinge: Point
    ends: tuple[Point, Point]


@dataclass(frozen=True)
class Mark:
    """What is drawn for one door or window, metres.

    Attributes
    ----------
    lines : tuple of tuple of Point
        Lines of everything but arcs.
    arcs : tuple of Arc
    handle : str
        Handle of its first entity in the drawing.
    """

    lines: tuple[tuple[Point, ...], ...]
    arcs: tuple[Arc, ...]
    handle: str

    @property
    def points(self) -> list[Point]:
        """All corners."""
        swept = [point for arc in self.arcs for point in (arc.hinge, *arc.ends)]
        return [*(point for line in self.lines for point in line), *swept]


def joined_marks(marks: Sequence[Mark], role: str) -> list[Mark]:
    """Return loose lines and arcs together where they are of one opening, in their order."""
    shapes = [_ground(mark, _BESIDE[role] / 2) for mark in marks]
    groups: list[list[int]] = []
    for k, shape in enumerate(shapes):
        meeting = [group for group in groups if any(shapes[other].intersects(shape) for other in group)]
        groups = [group for group in groups if group not in meeting]
        groups.append(sorted([k, *(other for group in meeting for other in group)]))
    return [
        Mark(
            tuple(line for k in group for line in marks[k].lines),
            tuple(arc for k in group for arc in marks[k].arcs),
            marks[group[0]].handle,
        )
        for group in sorted(groups)
    ]


def _ground(mark: Mark, beside: float) -> BaseGeometry:
    """Return the floor that an entity takes, widened sideways: openings in one line stay apart."""
    shapes: list[BaseGeometry] = [
        LineString(line).buffer(beside, cap_style="flat") for line in mark.lines if len(set(line)) > 1
    ]
    shapes += [Polygon([arc.hinge, *arc.ends]).buffer(_MEETING / 2) for arc in mark.arcs]
    return shapely.union_all(shapes)


def door_segment(mark: Mark, walls: BaseGeometry) -> Segment | None:
    """Return the clear opening of a door.

    An arc has two ends, that of the open leaf and that of the closed one, which is nearer to the faces of `walls`; two
    arcs are a double door between their hinges; without an arc it is the longer way through what is drawn.

    Parameters
    ----------
    mark : Mark
    walls : geometry
        Boundaries of the rooms.
    """
    if len(mark.arcs) >= 2:
        first, second = mark.arcs[0], mark.arcs[1]
        return first.hinge, second.hinge
    if mark.arcs:
        arc = mark.arcs[0]
        return arc.hinge, min(arc.ends, key=lambda end: _off(walls, arc.hinge, end))
    return window_segment(mark)


def _off(walls: BaseGeometry, hinge: Point, end: Point) -> float:
    line = LineString([hinge, end])
    return float(sum(walls.distance(line.interpolate(share, normalized=True)) for share in (0.25, 0.5, 0.75, 1.0)))


def is_double(mark: Mark) -> bool:
    """Whether a door has two leaves."""
    return len(mark.arcs) == 2


def window_segment(mark: Mark) -> Segment | None:
    """Return the longer middle line of the least rectangle around what is drawn, ``None`` for a point."""
    around = MultiPoint(mark.points).minimum_rotated_rectangle
    if isinstance(around, LineString) and around.length > 0.0:
        (ax, ay), (bx, by) = around.coords[0], around.coords[-1]
        return (ax, ay), (bx, by)
    if not isinstance(around, Polygon):
        return None
    corners = [(float(x), float(y)) for x, y in around.exterior.coords[:4]]
    a, b, c, d = corners if math.dist(corners[0], corners[1]) >= math.dist(corners[1], corners[2]) else (
        *corners[1:], corners[0]
    )  # fmt: skip
    return ((a[0] + d[0]) / 2, (a[1] + d[1]) / 2), ((b[0] + c[0]) / 2, (b[1] + c[1]) / 2)

"""Convex bodies that stand for the parts of a mesh in collisions: boxes, and hulls of what is round or slanted."""

import itertools
import math
from collections.abc import Sequence
from typing import NamedTuple, TypeAlias

import numpy as np

from mansion_assets.solids import Axis, Vec3, bar, box_solid, extruded, revolved, rounded_box
from mansion_geometry.compiled import Floats, Ints

__all__ = [
    "Box",
    "Convex",
    "Hull",
    "bar_bodies",
    "bounding_box",
    "extruded_bodies",
    "fitted",
    "revolved_bodies",
    "rounded_bodies",
    "volume_of",
]

SIDES = 12
"""Most sides of a round hull: its corners lie on the surface, its faces at most 3.4% of the radius inside it."""

SECTORS = 8
"""Convex pieces that go round a hollow body, such as a cup."""

KNEE = 0.1
"""Share of the radius by which a wall may bend before it is cut into bands."""

ROUND = 0.6
"""Share of the least half extent from which a rounded edge is followed; a box stands for sharper ones."""

LEAST = 1e-3
"""Metres below which a body is a sheet, for which a box stands: a hull needs a volume."""

Span: TypeAlias = tuple[float, float]


class Box(NamedTuple):
    """An axis-aligned box: centre and full extent, metres."""

    center: Vec3
    size: Vec3


class Hull(NamedTuple):
    """A closed convex mesh: (n, 3) vertices in metres and (m, 3) faces, counter-clockwise from outside."""

    vertices: Floats
    faces: Ints


Convex: TypeAlias = Box | Hull


def bounding_box(low: Floats, high: Floats) -> Box:
    """Return the box between two corners."""
    center, size = (low + high) / 2, high - low
    return Box((float(center[0]), float(center[1]), float(center[2])), (float(size[0]), float(size[1]), float(size[2])))


def volume_of(body: Convex) -> float:
    """Return the volume of a body, cubic metres."""
    if isinstance(body, Box):
        return math.prod(body.size)
    return abs(float(np.linalg.det(body.vertices[body.faces]).sum())) / 6


def fitted(body: Convex, center: Floats, scale: Floats) -> Convex:
    """Return a body moved by `-center` and then stretched along the axes."""
    if isinstance(body, Hull):
        return Hull((body.vertices - center) * scale, body.faces)
    middle, half = (np.array(body.center) - center) * scale, np.maximum(np.array(body.size) * scale, LEAST) / 2
    return bounding_box(middle - half, middle + half)


def _hull(vertices: Floats, faces: Ints) -> Convex:
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    return bounding_box(low, high) if float((high - low).min()) < LEAST else Hull(vertices, faces)


def rounded_bodies(x: Span, y: Span, z: Span, round_: float) -> list[Convex]:
    """Return the body of a box with rounded edges."""
    if round_ < ROUND:
        return [bounding_box(np.array([x[0], y[0], z[0]]), np.array([x[1], y[1], z[1]]))]
    vertices, faces = rounded_box(x, y, z, round_, SIDES)
    # The rings next to the poles lie level with them, so that the body rests on a face and not on a point.
    flat = vertices.copy()
    flat[:SIDES, 2], flat[-2 - SIDES : -2, 2] = z
    return [_hull(flat, faces)]


def bar_bodies(start: Vec3, end: Vec3, r: float, n: int) -> list[Convex]:
    """Return the body of a round bar: a box where it is thin and parallel to an axis."""
    vertices, faces = bar(start, end, r, min(n, SIDES))
    along = sorted(abs(b - a) for a, b in zip(start, end))
    if along[1] < 1e-6 and along[2] > 4 * r:
        return [bounding_box(vertices.min(axis=0), vertices.max(axis=0))]
    return [_hull(vertices, faces)]


def extruded_bodies(outline: Sequence[Span], span: Span, axis: Axis) -> list[Convex]:
    """Return the bodies of an outline drawn out along an axis, cut where it is not convex."""
    bodies = [_hull(*extruded(part, span, axis)) for part in _convex_outlines(outline)]
    return bodies if len(bodies) > 1 or not _is_rectangle(outline) else [_bounds(bodies[0])]


def _bounds(body: Convex) -> Box:
    return body if isinstance(body, Box) else bounding_box(body.vertices.min(axis=0), body.vertices.max(axis=0))


def _is_rectangle(outline: Sequence[Span]) -> bool:
    return len(outline) == 4 and len({u for u, _ in outline}) == 2 and len({v for _, v in outline}) == 2


def _convex_outlines(outline: Sequence[Span]) -> list[list[Span]]:
    """Cut an outline that its first corner sees all of into convex ones that meet in that corner."""
    ring = list(outline)
    if sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:] + ring[:1])) < 0.0:
        ring = [ring[0], *reversed(ring[1:])]
    parts: list[list[Span]] = []
    current = ring[:2]
    for corner in ring[2:]:
        if len(current) > 2 and not _is_convex([*current, corner]):
            parts.append(current)
            current = [ring[0], current[-1]]
        current.append(corner)
    return [part for part in [*parts, current] if _area(part) > 1e-9]


def _turn(a: Span, b: Span, c: Span) -> float:
    return (b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0])


def _is_convex(ring: list[Span]) -> bool:
    return all(_turn(ring[k - 2], ring[k - 1], ring[k]) > -1e-12 for k in range(len(ring)))


def _area(ring: list[Span]) -> float:
    return sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:] + ring[:1])) / 2


def revolved_bodies(profile: Sequence[Span], at: Span, n: int, stretch: Span) -> list[Convex]:
    """Return the slices of a solid body of revolution, or the floor and the sectors of the wall of a hollow one."""
    heights = [z for _, z in profile]
    if heights == sorted(heights) or heights == sorted(heights, reverse=True):
        upward = list(profile) if heights[0] <= heights[-1] else list(reversed(profile))
        return [_hull(*revolved(part, at, min(n, SIDES), stretch)) for part in _convex_slices(upward)]
    rim = heights.index(max(heights))
    outer, inner = list(profile[: rim + 1]), list(reversed(profile[rim:]))
    rising = all(a <= b for part in (outer, inner) for (_, a), (_, b) in itertools.pairwise(part))
    if not rising or len(inner) < 2:
        vertices, _ = revolved(profile, at, n, stretch)
        return [bounding_box(vertices.min(axis=0), vertices.max(axis=0))]
    return _hollow(outer, inner, at, stretch)


def _convex_slices(profile: Sequence[Span]) -> list[list[Span]]:
    """Cut a rising profile where it bends inward; slices without height are left out."""
    slices: list[list[Span]] = []
    current: list[Span] = [profile[0]]
    for point in profile[1:]:
        if len(current) > 1 and _turn(current[-2], current[-1], point) < -1e-12:
            slices.append(current)
            current = [current[-1]]
        current.append(point)
    return [part for part in [*slices, current] if part[-1][1] - part[0][1] > 1e-6]


def _hollow(outer: list[Span], inner: list[Span], at: Span, stretch: Span) -> list[Convex]:
    """Return the floor below the hollow and the sectors of the wall around it."""
    floor, top = inner[0][1], outer[-1][1]
    bodies: list[Convex] = []
    foot = [point for point in outer if point[1] < floor]
    if foot and floor - outer[0][1] > 1e-6:
        foot.append((_radius(outer, floor), floor))
        bodies += [_hull(*revolved(part, at, SIDES, stretch)) for part in _convex_slices(foot)]
    rings = [(_radius(outer, z), _radius(inner, z), z) for z in (floor, *_knees(outer, floor, top), top)]
    for pair in itertools.pairwise(rings):
        bodies += [_sector(pair, k, at, stretch) for k in range(SECTORS)]
    return bodies


def _knees(profile: Sequence[Span], low: float, high: float) -> list[float]:
    """Return the heights at which a profile is far from the straight line between two of its points."""
    ends = (_radius(profile, low), _radius(profile, high))
    return sorted(
        {
            z
            for r, z in profile
            if low < z < high and abs(r - float(np.interp(z, (low, high), ends))) > KNEE * max(*ends, 1e-6)
        }
    )


def _radius(profile: Sequence[Span], height: float) -> float:
    return float(np.interp(height, [z for _, z in profile], [r for r, _ in profile]))


def _sector(rings: Sequence[tuple[float, float, float]], k: int, at: Span, stretch: Span) -> Convex:
    corners = []
    for outside, inside, z in rings:
        for angle, r in ((k, inside), (k, outside), (k + 1, outside), (k + 1, inside)):
            turn = 2 * math.pi * angle / SECTORS
            corners.append((at[0] + math.cos(turn) * r * stretch[0], at[1] + math.sin(turn) * r * stretch[1], z))
    _, faces = box_solid((0.0, 1.0), (0.0, 1.0), (0.0, 1.0))
    return _hull(np.array(corners), faces)

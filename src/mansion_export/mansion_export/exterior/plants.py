"""Plants on a plot: trees, and shrubs along the walls."""

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import Final

import numpy as np
import shapely
from shapely.geometry import Polygon
from shapely.geometry.base import BaseGeometry

from mansion_export.meshes.materials import named
from mansion_export.meshes.model import Surface
from mansion_export.meshes.solids import Box, boxes_surface
from mansion_geometry.compiled import Floats, Ints
from mansion_geometry.randomness import item_generator
from mansion_msgs_py.shapes import Point

__all__ = ["along_walls", "shrubs", "tree", "tree_places"]

APART: Final = 5.0
"""Least distance between two trunks, metres."""

SHRUB: Final = 1.1
"""Between the middles of two shrubs of a row, metres."""

_CROWN: Final = ((7, 0.2, 0.42, 0.54, 0.13), (6, 0.17, 0.6, 0.72, 0.13), (3, 0.08, 0.8, 0.86, 0.12))
"""Clumps of leaves by rings from below: how many, how far out, between which heights, and how large, in heights."""


def tree_places(free: BaseGeometry, seed: int, *, most: int) -> Iterator[tuple[float, float, float]]:
    """Yield places and heights of trees in an area, apart from each other."""
    if free.is_empty:
        return
    generator = item_generator(seed, "trees")
    x0, y0, x1, y1 = free.bounds
    planted: list[tuple[float, float]] = []
    for _ in range(40 * most):
        x, y = float(generator.uniform(x0, x1)), float(generator.uniform(y0, y1))
        height = float(generator.uniform(3.8, 6.8))
        apart = all(math.dist((x, y), other) > APART for other in planted)
        if apart and free.contains(shapely.Point(x, y)):
            planted.append((x, y))
            yield x, y, height
        if len(planted) == most:
            return


def tree(x: float, y: float, height: float, ground: float) -> list[Surface]:
    """Return a trunk with a crown of several clumps of leaves, no two trees alike."""
    generator = item_generator(round(1000 * (x + 7 * y)), "crown")
    trunk = Box((x, y, ground + 0.27 * height), (0.17, 0.17, 0.54 * height))
    clumps = [_clump((x, y, ground + 0.62 * height), 0.22 * height, generator)]
    for number, out, low, high, size in _CROWN:
        first = float(generator.uniform(0.0, 1.0))
        for k in range(number):
            angle = 2 * math.pi * (k + first + float(generator.uniform(-0.2, 0.2))) / number
            away, up = out * height, float(generator.uniform(low, high))
            place = (x + away * math.cos(angle), y + away * math.sin(angle), ground + up * height)
            clumps.append(_clump(place, float(generator.uniform(0.85, 1.15)) * size * height, generator))
    return [boxes_surface([trunk], named("bark")), _leaves(clumps)]


def shrubs(line: Sequence[tuple[Point, Point]], keep_off: BaseGeometry, seed: int, ground: float) -> list[Surface]:
    """Return shrubs along the stretches of a line that lie clear of ways."""
    generator = item_generator(seed, "shrubs")
    clumps = []
    for (ax, ay), (bx, by) in line:
        count = int(math.hypot(bx - ax, by - ay) / SHRUB)
        for k in range(count):
            share = (k + 0.5) / count
            x, y = ax + share * (bx - ax), ay + share * (by - ay)
            radius = float(generator.uniform(0.3, 0.46))
            if not keep_off.intersects(shapely.Point(x, y).buffer(radius)):
                clumps.append(_clump((x, y, ground + 0.6 * radius), radius, generator))
    return [_leaves(clumps)] if clumps else []


def _leaves(clumps: Sequence[tuple[Floats, Ints]]) -> Surface:
    starts = np.cumsum([0, *(len(vertices) for vertices, _ in clumps)])
    vertices = np.concatenate([vertices for vertices, _ in clumps])
    faces = np.concatenate([faces + start for (_, faces), start in zip(clumps, starts)])
    return Surface(named("hedge"), vertices, faces)


def _clump(center: Sequence[float], radius: float, generator: np.random.Generator) -> tuple[Floats, Ints]:
    """Return an uneven ball: an icosahedron, each face in four."""
    points, faces = _BALL
    uneven = 1.0 + 0.16 * generator.uniform(-1.0, 1.0, len(points))
    return points * (radius * uneven)[:, None] * (1.0, 1.0, 0.9) + np.array(center), faces


def _ball() -> tuple[Floats, Ints]:
    """Return vertices and faces of a sphere of radius 1."""
    golden = (1 + math.sqrt(5)) / 2
    points = [(0.0, float(s), t * golden) for s in (-1, 1) for t in (-1, 1)]
    points = [*points, *((z, x, y) for x, y, z in points), *((y, z, x) for x, y, z in points)]
    corners = np.array(points, dtype=float) / math.hypot(1, golden)
    edge = min(float(np.linalg.norm(corners[0] - other)) for other in corners[1:]) + 1e-6
    near = np.linalg.norm(corners[:, None] - corners[None], axis=-1) < edge
    triples = [
        (a, b, c) for a in range(12) for b in range(a) for c in range(b) if near[a, b] and near[b, c] and near[a, c]
    ]
    middles: dict[tuple[int, int], int] = {}
    vertices = list(corners)

    def middle(a: int, b: int) -> int:
        key = (min(a, b), max(a, b))
        if key not in middles:
            point = corners[a] + corners[b]
            middles[key] = len(vertices)
            vertices.append(point / np.linalg.norm(point))
        return middles[key]

    faces = []
    for a, b, c in triples:
        if np.dot(np.cross(corners[b] - corners[a], corners[c] - corners[a]), corners[a]) < 0.0:
            b, c = c, b
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        faces += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
    return np.array(vertices), np.array(faces, dtype=np.int64)


_BALL: Final = _ball()


def along_walls(slab: Polygon, away: float) -> list[tuple[Point, Point]]:
    """Return the sides of a line around a building, its corners left free."""
    ring = slab.buffer(away, join_style="mitre").exterior
    sides = []
    points = list(ring.coords)
    for (ax, ay), (bx, by) in pairwise(points):
        length = math.hypot(bx - ax, by - ay)
        if length > 2.5:
            share = 0.8 / length
            dx, dy = share * (bx - ax), share * (by - ay)
            sides.append(((ax + dx, ay + dy), (bx - dx, by - dy)))
    return sides

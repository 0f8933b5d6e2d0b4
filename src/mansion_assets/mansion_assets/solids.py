"""Triangles of simple closed bodies: boxes, bodies of revolution, bars, rounded boxes, extruded outlines.

Each function returns the vertices, an (n, 3) array in metres, and the faces, an (m, 3) array counter-clockwise from
outside.
"""

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import Literal, TypeAlias

import numpy as np

from mansion_geometry.compiled import Floats, Ints

__all__ = ["Axis", "Vec3", "bar", "box_solid", "extruded", "revolved", "rounded_box", "sheet", "tapered_bar"]

Vec3: TypeAlias = tuple[float, float, float]
Span: TypeAlias = tuple[float, float]
Axis: TypeAlias = Literal["x", "y", "z"]

_BOX_FACES = np.array(
    [
        (0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7), (0, 1, 5), (0, 5, 4),
        (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 6), (3, 0, 4), (3, 4, 7),
    ]
)  # fmt: skip


def box_solid(x: Span, y: Span, z: Span) -> tuple[Floats, Ints]:
    """Return an axis-aligned box."""
    (x0, x1), (y0, y1), (z0, z1) = x, y, z
    vertices = np.array(
        [
            (x0, y0, z0), (x1, y0, z0), (x1, y1, z0), (x0, y1, z0),
            (x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1),
        ]
    )  # fmt: skip
    return vertices, _BOX_FACES


def revolved(profile: Sequence[tuple[float, float]], at: Span, n: int, stretch: Span) -> tuple[Floats, Ints]:
    """Return a body of revolution of `n` sides about the vertical axis through `at`.

    Parameters
    ----------
    profile : sequence of (radius, height)
        Points from pole to pole; `stretch` scales the radius along x and along y.
    """
    angles = np.linspace(0.0, 2 * math.pi, n, endpoint=False)
    circle = np.stack([np.cos(angles) * stretch[0], np.sin(angles) * stretch[1]], axis=1)
    rings = [np.column_stack([circle * r + np.array(at), np.full(n, z)]) for r, z in profile]
    vertices = np.concatenate([*rings, [[*at, profile[0][1]], [*at, profile[-1][1]]]])
    return vertices, _ring_faces(len(profile), n)


@lru_cache(maxsize=512)
def _ring_faces(rings: int, n: int) -> Ints:
    """Join rings of `n` vertices; close the first and the last with fans about the two poles after them.

    The array is shared by all bodies with this number of rings, and cannot be written to.
    """
    i = np.arange(n)
    j = (i + 1) % n
    faces = []
    for k in range(rings - 1):
        a, b = k * n, (k + 1) * n
        faces += [np.column_stack([a + i, a + j, b + j]), np.column_stack([a + i, b + j, b + i])]
    first, last = rings * n, rings * n + 1
    end = (rings - 1) * n
    faces.append(np.column_stack([np.full(n, first), j, i]))
    faces.append(np.column_stack([np.full(n, last), end + i, end + j]))
    joined = np.concatenate(faces)
    joined.flags.writeable = False
    return joined


def _cross(a: Sequence[float] | Floats, b: Sequence[float] | Floats) -> Floats:
    """Return the cross product of two vectors; NumPy's, made for arrays of them, takes ten times as long for two."""
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def bar(start: Vec3, end: Vec3, r: float, n: int) -> tuple[Floats, Ints]:
    """Return a round bar of `n` sides between two points."""
    return tapered_bar(start, end, r, r, n)


def tapered_bar(start: Vec3, end: Vec3, r0: float, r1: float, n: int) -> tuple[Floats, Ints]:
    """Return a cone of `n` sides that is cut off, with a radius at either end."""
    a, b = np.array(start), np.array(end)
    axis = (b - a) / max(float(np.linalg.norm(b - a)), 1e-9)
    side = _cross(axis, (0.0, 0.0, 1.0) if abs(axis[2]) < 0.9 else (1.0, 0.0, 0.0))
    side /= np.linalg.norm(side)
    other = _cross(axis, side)
    angles = np.linspace(0.0, 2 * math.pi, n, endpoint=False)
    ring = np.outer(np.cos(angles), side) + np.outer(np.sin(angles), other)
    return np.concatenate([a + r0 * ring, b + r1 * ring, [a], [b]]), _ring_faces(2, n)


def rounded_box(x: Span, y: Span, z: Span, round_: float, n: int) -> tuple[Floats, Ints]:
    """Return a box with rounded edges; `round_` 1 makes an ellipsoid."""
    half = np.array([(b - a) / 2 for a, b in (x, y, z)])
    center = np.array([(a + b) / 2 for a, b in (x, y, z)])
    radius = half if round_ >= 1.0 else np.minimum(half, round_ * float(half.min()))
    m = max(4, 4 * (n // 4))
    lon = (np.arange(m) + 0.5) * 2 * math.pi / m
    lat = np.linspace(-math.pi / 2, math.pi / 2, m // 2 + 2)[1:-1]
    if round_ >= 1.0:
        lon = np.arange(m) * 2 * math.pi / m
    rows = [
        np.column_stack([math.cos(b) * np.cos(lon), math.cos(b) * np.sin(lon), np.full(m, math.sin(b))]) for b in lat
    ]
    unit = np.concatenate([*rows, [[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]]])
    vertices = unit * radius + np.where(np.abs(unit) < 1e-9, 0.0, np.sign(unit)) * (half - radius)
    peaks = np.abs(vertices).max(axis=0)
    return vertices * (half / np.maximum(peaks, 1e-9)) + center, _ring_faces(len(lat), m)


def extruded(outline: Sequence[tuple[float, float]], span: Span, axis: Axis) -> tuple[Floats, Ints]:
    """Return a convex outline drawn out along an axis: (y, z) along x, (x, z) along y, (x, y) along z."""
    n = len(outline)
    order = {"x": (2, 0, 1), "y": (0, 2, 1), "z": (0, 1, 2)}[axis]
    flat = [[(u, v, s) for u, v in outline] for s in span]
    vertices = np.array(flat, dtype=float).reshape(2 * n, 3)[:, order]
    area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(outline, [*outline[1:], outline[0]], strict=True))
    faces = []
    for k in range(n):
        q = (k + 1) % n
        faces += [(k, q, n + q), (k, n + q, n + k)]
    for k in range(1, n - 1):
        faces += [(0, k + 1, k), (n, n + k, n + k + 1)]
    table = np.array(faces)
    if (area < 0) != (axis == "y"):
        table = table[:, ::-1]
    return vertices, table


def sheet(grid: Floats, thick: float) -> tuple[Floats, Ints]:
    """Return a bent sheet through a grid of points, (rows, columns, 3), `thick` downwards.

    Seen from its upper face, columns follow each other to the right and rows upwards.
    """
    rows, columns = grid.shape[:2]
    upper = grid.reshape(-1, 3)
    vertices = np.concatenate([upper, upper - np.array([0.0, 0.0, thick])])
    at = np.arange(rows * columns).reshape(rows, columns)
    a, b, c, d = (part.ravel() for part in (at[:-1, :-1], at[:-1, 1:], at[1:, 1:], at[1:, :-1]))
    top = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    rim = np.concatenate([at[0, :-1], at[:-1, -1], at[-1, :0:-1], at[:0:-1, 0]])
    follow, below = np.roll(rim, -1), rows * columns
    sides = [np.column_stack([rim, rim + below, follow + below]), np.column_stack([rim, follow + below, follow])]
    return vertices, np.concatenate([top, top[:, ::-1] + below, *sides])

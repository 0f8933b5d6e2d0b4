"""Builds a mesh from boxes, turned bodies, rods and cushions, in metres from the floor below the asset's centre."""

import itertools
import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from mansion_scene.catalogue import Asset, Surface, Volume

__all__ = ["Box", "Builder", "Piece", "Rect"]

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]
Vec3 = tuple[float, float, float]


class Box(NamedTuple):
    """An axis-aligned box: centre and full extent, metres."""

    center: Vec3
    size: Vec3


class Rect(NamedTuple):
    """A carrier of the asset in the builder's frame."""

    x0: float
    x1: float
    y0: float
    y1: float
    z: float
    top: float


class Piece:
    """The triangles of one part in one material."""

    def __init__(self, part: str, material: str) -> None:
        self.part, self.material = part, material
        self.vertices: list[Floats] = []
        self.faces: list[Ints] = []
        self._count = 0

    def add(self, vertices: Floats, faces: Ints) -> None:
        """Append triangles."""
        self.vertices.append(vertices)
        self.faces.append(faces + self._count)
        self._count += len(vertices)


_BOX_FACES = np.array(
    [
        (0, 2, 1), (0, 3, 2), (4, 5, 6), (4, 6, 7), (0, 1, 5), (0, 5, 4),
        (1, 2, 6), (1, 6, 5), (2, 3, 7), (2, 7, 6), (3, 0, 4), (3, 4, 7),
    ]
)  # fmt: skip


class Builder:
    """Collects the pieces and the collision boxes of one asset.

    Attributes
    ----------
    w, d, h : float
        The asset's size; x runs from -w/2 to w/2, y from -d/2 (back) to d/2 (front), z from 0 to h.
    p : dict
        The recipe's parameters.
    """

    def __init__(self, asset: Asset) -> None:
        self.asset = asset
        self.w, self.d, self.h = asset.size
        self.p: dict[str, Any] = asset.parameters
        self.pieces: dict[tuple[str, str], Piece] = {}
        self.boxes: list[Box] = []

    @property
    def tops(self) -> list[Rect]:
        """Surfaces in this frame."""
        return [self._rect(s) for s in self.asset.surfaces]

    @property
    def cells(self) -> list[Rect]:
        """Inner volumes in this frame: `z` is the floor, `top` the ceiling of each."""
        return [self._cell(v) for v in self.asset.volumes]

    def _rect(self, s: Surface) -> Rect:
        z = s.z + self.h / 2
        return Rect(s.x - s.w / 2, s.x + s.w / 2, s.y - s.d / 2, s.y + s.d / 2, z, z + s.clearance)

    def _cell(self, v: Volume) -> Rect:
        low = v.z - v.h / 2 + self.h / 2
        return Rect(v.x - v.w / 2, v.x + v.w / 2, v.y - v.d / 2, v.y + v.d / 2, low, low + v.h)

    def mat(self, role: str = "main", default: str = "wood_oak") -> str:
        """Return the material of a role of the recipe."""
        return self.asset.materials.get(role, default)

    def raw(
        self, vertices: Floats, faces: Ints, material: str, part: str, solid: bool = False
    ) -> None:
        """Add triangles; a solid's bounding box takes part in collisions."""
        key = (part, material)
        self.pieces.setdefault(key, Piece(part, material)).add(vertices, faces)
        if solid:
            low, high = vertices.min(axis=0), vertices.max(axis=0)
            center, size = (low + high) / 2, high - low
            self.boxes.append(
                Box(
                    (float(center[0]), float(center[1]), float(center[2])),
                    (float(size[0]), float(size[1]), float(size[2])),
                )
            )

    def box(
        self,
        x: tuple[float, float],
        y: tuple[float, float],
        z: tuple[float, float],
        material: str,
        part: str = "body",
        solid: bool = True,
    ) -> None:
        """Add an axis-aligned box; a thin one that is no solid is lifted off the face of the asset that it lies in."""
        if not solid:
            x, y, z = (
                self._lifted(x, self.w / 2),
                self._lifted(y, self.d / 2),
                self._lifted(z, self.h),
            )
        (x0, x1), (y0, y1), (z0, z1) = x, y, z
        vertices = np.array(
            [
                (x0, y0, z0), (x1, y0, z0), (x1, y1, z0), (x0, y1, z0),
                (x0, y0, z1), (x1, y0, z1), (x1, y1, z1), (x0, y1, z1),
            ]
        )  # fmt: skip
        self.raw(vertices, _BOX_FACES, material, part, solid)

    @staticmethod
    def _lifted(span: tuple[float, float], limit: float) -> tuple[float, float]:
        """Move a thin span's outer end 1.5 mm beyond `limit`, so that it does not share a plane with what it is on."""
        flush = span[1] - span[0] <= 0.012 and abs(span[1] - limit) < 1e-6
        return (span[0], span[1] + 0.0015) if flush and limit > 0.02 else span

    def lathe(
        self,
        profile: Sequence[tuple[float, float]],
        material: str,
        at: tuple[float, float] = (0.0, 0.0),
        part: str = "body",
        n: int = 20,
        stretch: tuple[float, float] = (1.0, 1.0),
        solid: bool = True,
    ) -> None:
        """Add a body of revolution about a vertical axis; `profile` lists (radius, height) from pole to pole."""
        angles = np.linspace(0.0, 2 * math.pi, n, endpoint=False)
        circle = np.stack([np.cos(angles) * stretch[0], np.sin(angles) * stretch[1]], axis=1)
        rings = [np.column_stack([circle * r + np.array(at), np.full(n, z)]) for r, z in profile]
        vertices = np.concatenate([*rings, [[*at, profile[0][1]], [*at, profile[-1][1]]]])
        i = np.arange(n)
        j = (i + 1) % n
        faces = []
        for k in range(len(profile) - 1):
            a, b = k * n, (k + 1) * n
            faces += [
                np.column_stack([a + i, a + j, b + j]),
                np.column_stack([a + i, b + j, b + i]),
            ]
        first, last = len(profile) * n, len(profile) * n + 1
        faces.append(np.column_stack([np.full(n, first), j, i]))
        end = (len(profile) - 1) * n
        faces.append(np.column_stack([np.full(n, last), end + i, end + j]))
        self.raw(vertices, np.concatenate(faces), material, part, solid)

    def cyl(
        self,
        x: float,
        y: float,
        z: tuple[float, float],
        r: float,
        material: str,
        part: str = "body",
        r2: float | None = None,
        n: int = 16,
        solid: bool = True,
    ) -> None:
        """Add an upright cylinder, or a cone frustum whose upper radius is `r2`."""
        self.lathe(
            [(r, z[0]), (r if r2 is None else r2, z[1])], material, (x, y), part, n, solid=solid
        )

    def rod(
        self,
        start: Vec3,
        end: Vec3,
        r: float,
        material: str,
        part: str = "frame",
        n: int = 8,
        solid: bool = False,
    ) -> None:
        """Add a round bar between two points."""
        a, b = np.array(start), np.array(end)
        axis = (b - a) / max(float(np.linalg.norm(b - a)), 1e-9)
        side = np.cross(axis, (0.0, 0.0, 1.0) if abs(axis[2]) < 0.9 else (1.0, 0.0, 0.0))
        side /= np.linalg.norm(side)
        other = np.cross(axis, side)
        angles = np.linspace(0.0, 2 * math.pi, n, endpoint=False)
        ring = r * (np.outer(np.cos(angles), side) + np.outer(np.sin(angles), other))
        vertices = np.concatenate([a + ring, b + ring, [a], [b]])
        i = np.arange(n)
        j = (i + 1) % n
        faces = np.concatenate(
            [
                np.column_stack([i, j, n + j]),
                np.column_stack([i, n + j, n + i]),
                np.column_stack([np.full(n, 2 * n), j, i]),
                np.column_stack([np.full(n, 2 * n + 1), n + i, n + j]),
            ]
        )
        self.raw(vertices, faces, material, part, solid)

    def path(self, points: Sequence[Vec3], r: float, material: str, part: str = "frame") -> None:
        """Add round bars along a line of points."""
        for start, end in itertools.pairwise(points):
            self.rod(start, end, r, material, part)

    def ball(
        self,
        center: Vec3,
        radii: Vec3,
        material: str,
        part: str = "body",
        n: int = 12,
        solid: bool = True,
    ) -> None:
        """Add an ellipsoid."""
        self.cushion(
            (center[0] - radii[0], center[0] + radii[0]),
            (center[1] - radii[1], center[1] + radii[1]),
            (center[2] - radii[2], center[2] + radii[2]),
            material,
            part,
            round_=1.0,
            n=n,
            solid=solid,
        )

    def cushion(
        self,
        x: tuple[float, float],
        y: tuple[float, float],
        z: tuple[float, float],
        material: str,
        part: str = "cushion",
        round_: float = 0.45,
        n: int = 10,
        solid: bool = True,
    ) -> None:
        """Add a box with rounded edges; `round_` 1 makes an ellipsoid."""
        half = np.array([(b - a) / 2 for a, b in (x, y, z)])
        center = np.array([(a + b) / 2 for a, b in (x, y, z)])
        radius = half if round_ >= 1.0 else np.minimum(half, round_ * float(half.min()))
        m = max(4, 4 * (n // 4))
        lon = (np.arange(m) + 0.5) * 2 * math.pi / m
        lat = np.linspace(-math.pi / 2, math.pi / 2, m // 2 + 2)[1:-1]
        if round_ >= 1.0:
            lon = np.arange(m) * 2 * math.pi / m
        rows = [
            np.column_stack(
                [math.cos(b) * np.cos(lon), math.cos(b) * np.sin(lon), np.full(m, math.sin(b))]
            )
            for b in lat
        ]
        unit = np.concatenate([*rows, [[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]]])
        vertices = unit * radius + np.where(np.abs(unit) < 1e-9, 0.0, np.sign(unit)) * (
            half - radius
        )
        peaks = np.abs(vertices).max(axis=0)
        vertices = vertices * (half / np.maximum(peaks, 1e-9)) + center
        i = np.arange(m)
        j = (i + 1) % m
        faces = []
        for k in range(len(lat) - 1):
            a, c = k * m, (k + 1) * m
            faces += [
                np.column_stack([a + i, a + j, c + j]),
                np.column_stack([a + i, c + j, c + i]),
            ]
        south, north = len(lat) * m, len(lat) * m + 1
        end = (len(lat) - 1) * m
        faces.append(np.column_stack([np.full(m, south), j, i]))
        faces.append(np.column_stack([np.full(m, north), end + i, end + j]))
        self.raw(vertices, np.concatenate(faces), material, part, solid)

    def prism(
        self,
        outline: Sequence[tuple[float, float]],
        span: tuple[float, float],
        material: str,
        axis: str = "x",
        part: str = "body",
        solid: bool = True,
    ) -> None:
        """Add a convex outline drawn out along an axis: (y, z) along x, (x, z) along y, (x, y) along z."""
        n = len(outline)
        order = {"x": (2, 0, 1), "y": (0, 2, 1), "z": (0, 1, 2)}[axis]
        flat = [[(u, v, s) for u, v in outline] for s in span]
        vertices = np.array(flat, dtype=float).reshape(2 * n, 3)[:, order]
        area = sum(
            a[0] * b[1] - b[0] * a[1]
            for a, b in zip(outline, [*outline[1:], outline[0]], strict=True)
        )
        faces = []
        for k in range(n):
            q = (k + 1) % n
            faces += [(k, q, n + q), (k, n + q, n + k)]
        for k in range(1, n - 1):
            faces += [(0, k + 1, k), (n, n + k, n + k + 1)]
        table = np.array(faces)
        if (area < 0) != (axis == "y"):
            table = table[:, ::-1]
        self.raw(vertices, table, material, part, solid)

    def legs(
        self,
        z: tuple[float, float],
        r: float,
        material: str,
        inset: float = 0.04,
        round_: bool = False,
    ) -> None:
        """Add four legs at the corners."""
        for sx in (-1, 1):
            for sy in (-1, 1):
                x, y = sx * (self.w / 2 - inset - r), sy * (self.d / 2 - inset - r)
                if round_:
                    self.cyl(x, y, z, r, material, "legs", n=10)
                else:
                    self.box((x - r, x + r), (y - r, y + r), z, material, "legs")

    def wheels(self, r: float, inset: float = 0.05, material: str = "rubber_black") -> None:
        """Add four castors."""
        for sx in (-1, 1):
            for sy in (-1, 1):
                x, y = sx * (self.w / 2 - inset), sy * (self.d / 2 - inset)
                self.rod((x - 0.015, y, r), (x + 0.015, y, r), r, material, "wheels", n=12)

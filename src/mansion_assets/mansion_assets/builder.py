"""Builder of meshes from boxes, bodies of revolution, rods and cushions.

Coordinates are metres from the floor below the asset's centre.
"""

import itertools
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from typing import Any, Final, Literal, NamedTuple, TypeAlias

from mansion_assets.catalogue import Asset, Surface, Volume
from mansion_assets.convex import (
    Box,
    Convex,
    bar_bodies,
    bounding_box,
    extruded_bodies,
    revolved_bodies,
    rounded_bodies,
)
from mansion_assets.joints import DOOR_OPENS, DRAWER_OPENS, Joint
from mansion_assets.solids import Axis, Vec3, bar, box_solid, extruded, revolved, rounded_box, tapered_bar
from mansion_geometry.compiled import Floats, Ints

__all__ = ["TRAY", "Body", "Box", "Builder", "Chunk", "Hinge", "Piece", "Rect"]


Hinge: TypeAlias = Literal["left", "right", "bottom", "top", "back"]
"""Where a door hangs, seen from the front; ``back`` is a lid's."""

TRAY: Final = 0.008
"""Thickness of a drawer's bottom, metres; its sides have half of it."""


class Rect(NamedTuple):
    """A carrier of the asset in the builder's frame."""

    x0: float
    x1: float
    y0: float
    y1: float
    z: float
    top: float


class Chunk(NamedTuple):
    """The triangles of one primitive: of which moving part, and whether only an open one shows them."""

    vertices: Floats
    faces: Ints
    link: str
    hidden: bool


class Piece:
    """The triangles of one part in one material."""

    def __init__(self, part: str, material: str) -> None:
        self.part, self.material = part, material
        self.chunks: list[Chunk] = []

    def fitted(self, center: Floats, scale: Floats) -> "Piece":
        """Return the piece moved by `-center` and then stretched along the axes."""
        piece = Piece(self.part, self.material)
        piece.chunks = [chunk._replace(vertices=(chunk.vertices - center) * scale) for chunk in self.chunks]
        return piece


class Body(NamedTuple):
    """A convex body that collides: of which moving part, and whether only an open one needs it."""

    shape: Convex
    link: str
    hidden: bool


class Builder:
    """Collects the pieces, the convex bodies and the joints of one asset.

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
        self.bodies: list[Body] = []
        self.joints: list[Joint] = []
        self._link, self._hidden = "", False

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

    def whole_box(self) -> Box:
        """Return a collision box of the whole asset."""
        return Box((0.0, 0.0, self.h / 2), (self.w, self.d, self.h))

    def mat(self, role: str = "main", default: str = "wood_oak") -> str:
        """Return the material of a role of the recipe."""
        return self.asset.materials.get(role, default)

    @contextmanager
    def moving(self, joint: Joint) -> Iterator[None]:
        """Make what is added within a part that moves at a joint."""
        self.joints.append(joint)
        self._link = joint.part
        try:
            yield
        finally:
            self._link = ""

    @contextmanager
    def fixed_to(self, part: str) -> Iterator[None]:
        """Make what is added within move with a part that there is already, as a sign with its door."""
        before, self._link = self._link, part
        try:
            yield
        finally:
            self._link = before

    def door(
        self, x: tuple[float, float], y: tuple[float, float], z: tuple[float, float], hinge: Hinge = "left"
    ) -> AbstractContextManager[None]:
        """Make what is added within a door that turns at one edge of its front face, or a lid at its back edge."""
        axis, origin = {
            "left": ((0.0, 0.0, 1.0), (x[0], y[1], z[0])),
            "right": ((0.0, 0.0, -1.0), (x[1], y[1], z[0])),
            "bottom": ((-1.0, 0.0, 0.0), (x[0], y[1], z[0])),
            "top": ((1.0, 0.0, 0.0), (x[0], y[1], z[1])),
            "back": ((1.0, 0.0, 0.0), (x[0], y[0], z[1])),
        }[hinge]
        name = self._unused("lid" if hinge == "back" else "door")
        return self.moving(Joint(name, "hinge", axis, origin, DOOR_OPENS))

    @contextmanager
    def drawer(
        self, x: tuple[float, float], y: tuple[float, float], z: tuple[float, float], material: str
    ) -> Iterator[None]:
        """Make what is added within the front of a drawer that slides forward, and give it a tray.

        Parameters
        ----------
        x, y, z : (float, float)
            The tray from outside; its front is open, where the drawer's own front stands.
        """
        joint = Joint(
            self._unused("drawer"), "slide", (0.0, 1.0, 0.0), (x[0], y[1], z[0]), DRAWER_OPENS * (y[1] - y[0])
        )
        with self.moving(joint):
            yield
            with self.hidden():
                self.box(x, y, (z[0], z[0] + TRAY), material, "tray", solid=False)
                for side in ((x[0], x[0] + TRAY / 2), (x[1] - TRAY / 2, x[1])):
                    self.box(side, y, z, material, "tray", solid=False)
                self.box(x, (y[0], y[0] + TRAY / 2), z, material, "tray", solid=False)

    def _unused(self, name: str) -> str:
        return f"{name}_{1 + sum(joint.part.startswith(name) for joint in self.joints)}"

    @contextmanager
    def hidden(self) -> Iterator[None]:
        """Make what is added within seen, and collided with, only where parts move: a drawer's tray."""
        self._hidden = True
        try:
            yield
        finally:
            self._hidden = False

    def raw(
        self,
        vertices: Floats,
        faces: Ints,
        material: str,
        part: str,
        *,
        solid: bool = False,
        bodies: Sequence[Convex] | None = None,
    ) -> None:
        """Add triangles, and the convex `bodies` that they are, their bounding box where there are none.

        A solid's bounding box is one of the few boxes that the editor reckons with.
        """
        key = (part, material)
        piece = self.pieces.setdefault(key, Piece(part, material))
        piece.chunks.append(Chunk(vertices, faces, self._link, self._hidden))
        whole = bounding_box(vertices.min(axis=0), vertices.max(axis=0))
        self.bodies += [Body(body, self._link, self._hidden) for body in bodies or [whole]]
        if solid:
            self.boxes.append(whole)

    def box(
        self,
        x: tuple[float, float],
        y: tuple[float, float],
        z: tuple[float, float],
        material: str,
        part: str = "body",
        *,
        solid: bool = True,
    ) -> None:
        """Add an axis-aligned box; a thin one that is not solid is lifted off the face of the asset that it lies in."""
        if not solid:
            x, y, z = (self._lifted(x, self.w / 2), self._lifted(y, self.d / 2), self._lifted(z, self.h))
        self.raw(*box_solid(x, y, z), material, part, solid=solid)

    def hollow(
        self,
        x: tuple[float, float],
        y: tuple[float, float],
        z: tuple[float, float],
        t: float,
        material: str,
        part: str = "case",
    ) -> None:
        """Add a box of walls `t` thick, open towards the front, for a case with something inside."""
        self.box((x[0], x[0] + t), y, z, material, part)
        self.box((x[1] - t, x[1]), y, z, material, part)
        self.box(x, (y[0], y[0] + t), z, material, part)
        self.box(x, y, (z[0], z[0] + t), material, part)
        self.box(x, y, (z[1] - t, z[1]), material, part)

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
        *,
        solid: bool = True,
    ) -> None:
        """Add a body of revolution about a vertical axis; `profile` lists (radius, height) from pole to pole."""
        bodies = revolved_bodies(profile, at, n, stretch)
        self.raw(*revolved(profile, at, n, stretch), material, part, solid=solid, bodies=bodies)

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
        *,
        solid: bool = True,
    ) -> None:
        """Add an upright cylinder, or a cone frustum whose upper radius is `r2`."""
        self.lathe([(r, z[0]), (r if r2 is None else r2, z[1])], material, (x, y), part, n, solid=solid)

    def rod(
        self, start: Vec3, end: Vec3, r: float, material: str, part: str = "frame", n: int = 8, *, solid: bool = False
    ) -> None:
        """Add a round bar between two points."""
        self.raw(*bar(start, end, r, n), material, part, solid=solid, bodies=bar_bodies(start, end, r, n))

    def taper(
        self, start: Vec3, end: Vec3, radii: tuple[float, float], material: str, part: str = "body", n: int = 12
    ) -> None:
        """Add a round bar with a radius at either end: a nozzle, a leg, the tip of a pencil."""
        bodies = bar_bodies(start, end, max(radii), n)
        self.raw(*tapered_bar(start, end, radii[0], radii[1], n), material, part, bodies=bodies)

    def path(self, points: Sequence[Vec3], r: float, material: str, part: str = "frame") -> None:
        """Add round bars along a line of points."""
        for start, end in itertools.pairwise(points):
            self.rod(start, end, r, material, part)

    def ball(
        self, center: Vec3, radii: Vec3, material: str, part: str = "body", n: int = 12, *, solid: bool = True
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
        *,
        solid: bool = True,
    ) -> None:
        """Add a box with rounded edges; `round_` 1 makes an ellipsoid."""
        bodies = rounded_bodies(x, y, z, round_)
        self.raw(*rounded_box(x, y, z, round_, n), material, part, solid=solid, bodies=bodies)

    def prism(
        self,
        outline: Sequence[tuple[float, float]],
        span: tuple[float, float],
        material: str,
        axis: Axis = "x",
        part: str = "body",
        *,
        solid: bool = True,
    ) -> None:
        """Add a convex outline drawn out along an axis: (y, z) along x, (x, z) along y, (x, y) along z."""
        bodies = extruded_bodies(outline, span, axis)
        self.raw(*extruded(outline, span, axis), material, part, solid=solid, bodies=bodies)

    def legs(
        self, z: tuple[float, float], r: float, material: str, inset: float = 0.04, *, round_: bool = False
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

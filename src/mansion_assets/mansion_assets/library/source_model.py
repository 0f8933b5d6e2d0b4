"""A model as it is in a user's file, before it is turned, scaled and named: rigid parts, triangles, looks."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from mansion_assets.joints import Joint
from mansion_geometry.compiled import Floats, Ints

__all__ = ["Look", "SourceModel", "SourcePart", "SourceSurface"]


class Look(NamedTuple):
    """How a surface looks: sRGB from 0 to 255 and opacity from 0 to 1, metallic, roughness."""

    color: tuple[int, int, int]
    opacity: float = 1.0
    metallic: float = 0.0
    roughness: float = 0.8
    name: str = ""


class SourceSurface(NamedTuple):
    """Triangles of one look: (n, 3) vertices and (m, 3) faces."""

    vertices: Floats
    faces: Ints
    look: Look

    @property
    def area(self) -> float:
        """Area of the triangles."""
        corners = self.vertices[self.faces]
        return float(np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])).sum()) / 2


@dataclass(frozen=True)
class SourcePart:
    """A rigid part: the body, whose name is empty, or one that moves at a joint.

    Attributes
    ----------
    boxes : tuple of (low, high)
        Boxes that the file gives for collisions.
    """

    name: str
    surfaces: tuple[SourceSurface, ...]
    joint: Joint | None = None
    boxes: tuple[tuple[Floats, Floats], ...] = ()

    @property
    def points(self) -> Floats:
        """All vertices, (n, 3)."""
        return np.concatenate([surface.vertices for surface in self.surfaces] or [np.zeros((0, 3))])


@dataclass(frozen=True)
class SourceModel:
    """A model, z up.

    Attributes
    ----------
    name : str
        What the file calls it.
    front : str
        What is known of where its front is; empty where nothing is. The front faces +y.
    mass : float, optional
        Kilograms.
    notes : tuple of str
        Parts of the file that were left out or changed.
    """

    name: str
    parts: tuple[SourcePart, ...]
    front: str = ""
    mass: float | None = None
    notes: tuple[str, ...] = field(default=())

    @property
    def points(self) -> Floats:
        """All vertices, (n, 3)."""
        return np.concatenate([part.points for part in self.parts] or [np.zeros((0, 3))])

    @property
    def triangles(self) -> int:
        """Number of triangles."""
        return sum(len(surface.faces) for part in self.parts for surface in part.surfaces)

    @property
    def bounds(self) -> tuple[Floats, Floats]:
        """The lowest and the highest corner of what is drawn."""
        used = [surface.vertices[np.unique(surface.faces)] for part in self.parts for surface in part.surfaces]
        points = np.concatenate(used)
        return points.min(axis=0), points.max(axis=0)

    def turned(self, degrees: float) -> "SourceModel":
        """Return the model turned counter-clockwise about the vertical."""
        c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
        turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
        quarter = np.round(turn) if degrees % 90.0 == 0.0 else turn
        return self.mapped(lambda points: points @ quarter.T, quarter)

    def placed(self, center: Floats, scale: float) -> "SourceModel":
        """Return the model moved by `-center` and then scaled."""
        moved = self.mapped(lambda points: (points - center) * scale, np.eye(3))
        parts = [
            replace(part, joint=part.joint._replace(travel=part.joint.travel * scale))
            if part.joint is not None and part.joint.kind == "slide"
            else part
            for part in moved.parts
        ]
        return replace(moved, parts=tuple(parts))

    def mapped(self, place: Callable[[Floats], Floats], turn: Floats) -> "SourceModel":
        """Return the model with every point moved by `place`, and every direction turned."""
        return replace(self, parts=tuple(_mapped(part, place, turn) for part in self.parts))


def _mapped(part: SourcePart, place: Callable[[Floats], Floats], turn: Floats) -> SourcePart:
    joint = part.joint
    if joint is not None:
        origin, axis = place(np.array([joint.origin]))[0].tolist(), (turn @ np.array(joint.axis)).tolist()
        joint = joint._replace(origin=(origin[0], origin[1], origin[2]), axis=(axis[0], axis[1], axis[2]))
    surfaces = tuple(surface._replace(vertices=place(surface.vertices)) for surface in part.surfaces)
    return replace(part, surfaces=surfaces, joint=joint, boxes=tuple(_mapped_boxes(part.boxes, place)))


def _mapped_boxes(
    boxes: Sequence[tuple[Floats, Floats]], place: Callable[[Floats], Floats]
) -> list[tuple[Floats, Floats]]:
    found = []
    for low, high in boxes:
        corners = place(np.array([low, high]))
        found.append((corners.min(axis=0), corners.max(axis=0)))
    return found

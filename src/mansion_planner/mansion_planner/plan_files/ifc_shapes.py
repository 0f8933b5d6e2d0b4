"""Shapes from the bodies of an IFC file: floors of spaces, and places of openings, in metres."""

import importlib
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
import shapely
from shapely.geometry import Polygon

from mansion_geometry.compiled import Floats, Ints
from mansion_msgs_py.shapes import Point

__all__ = ["Shapes", "Span"]

_FLAT: Final = 0.5
"""Least share of a triangle's normal that points down where it is part of a floor."""

_STRAIGHT: Final = 0.01
"""Metres by which corners may be off the straight line between their neighbours."""

_OBLONG: Final = 2.0
"""How many times longer than thick a wall is whose direction is sure."""

_COLUMN: Final = 0.3
"""Square metres up to which a hole in a room is a column, a duct or an inexactness."""

_SNAP: Final = 1e-4
_LEAST: Final = 1e-8


@dataclass(frozen=True)
class Span:
    """An opening: where it begins and ends along its wall, from which to which height."""

    segment: tuple[Point, Point]
    bottom: float
    top: float


class Shapes:
    """Bodies of the elements of a file.

    Parameters
    ----------
    scale : float
        Metres of a unit of the file.
    """

    def __init__(self, scale: float) -> None:
        self._geometry: Any = importlib.import_module("ifcopenshell.geom")
        self._placement: Any = importlib.import_module("ifcopenshell.util.placement")
        self._scale = scale
        self._settings = self._geometry.settings()
        self._settings.set("use-world-coords", True)
        self._settings.set("disable-opening-subtractions", True)

    def mesh(self, element: Any) -> tuple[Floats, Ints] | None:
        """Return vertices (n, 3) and triangles (m, 3) of an element, ``None`` where it has no body."""
        if element is None or element.Representation is None:
            return None
        try:
            made = self._geometry.create_shape(self._settings, element).geometry
        except RuntimeError:
            return None
        vertices = np.array(made.verts, dtype=float).reshape(-1, 3)
        faces = np.array(made.faces, dtype=np.int64).reshape(-1, 3)
        return (vertices, faces) if len(faces) else None

    def floor(self, space: Any) -> tuple[Polygon, float] | None:
        """Return the floor of a space and its height, ``None`` where it has none."""
        body = self.mesh(space)
        if body is None:
            return None
        vertices, faces = body
        corners = vertices[faces]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        sizes = np.linalg.norm(normals, axis=1)
        flat = np.abs(normals[:, 2]) > _FLAT * np.maximum(sizes, _LEAST)
        down = flat & (normals[:, 2] < 0.0)
        pieces = shapely.polygons(corners[down if down.any() else flat][:, :, :2])
        whole = shapely.union_all(pieces[shapely.area(pieces) > _LEAST], grid_size=_SNAP)
        parts = [part for part in shapely.get_parts(whole) if isinstance(part, Polygon)]
        if not parts:
            return None
        largest = max(parts, key=lambda part: part.area).simplify(_STRAIGHT)
        if not isinstance(largest, Polygon):
            return None
        holes = [hole for hole in largest.interiors if Polygon(hole).area >= _COLUMN]
        return Polygon(largest.exterior, holes), float(vertices[:, 2].min())

    def footprint(self, element: Any) -> Polygon | None:
        """Return the least rectangle around an element in plan, ``None`` where it has no body."""
        body = self.mesh(element)
        if body is None:
            return None
        around = shapely.MultiPoint(body[0][:, :2]).minimum_rotated_rectangle
        return around if isinstance(around, Polygon) else None

    def span(self, element: Any, opening: Any, width: float | None, host: Any = None) -> Span | None:
        """Return where a door or a window is: by its opening, else by its own body, else by its placement.

        Parameters
        ----------
        element : entity
            The door or the window; or an opening that nothing fills.
        opening : entity, optional
            What it fills.
        width : float, optional
            Its overall width in metres, by which the direction of the wall is told from that across it.
        host : entity, optional
            The wall, whose longer side tells that direction better.
        """
        frame = np.array(self._placement.get_local_placement(element.ObjectPlacement), dtype=float)
        body = self.mesh(opening) or self.mesh(element)
        if body is None:
            return self._placed(frame, width)
        vertices = body[0]
        bottom, top = float(vertices[:, 2].min()), float(vertices[:, 2].max())
        sides = []
        for axis in (frame[:2, 0], frame[:2, 1]):
            length = float(np.linalg.norm(axis))
            if length < _LEAST:
                continue
            unit = axis / length
            across = np.array([-unit[1], unit[0]])
            along, off = vertices[:, :2] @ unit, vertices[:, :2] @ across
            middle = across * (off.min() + off.max()) / 2
            sides.append((unit * along.min() + middle, unit * along.max() + middle))
        if not sides:
            return None
        start, end = sides[self._along(frame, sides, width, host)]
        return Span((_point(start), _point(end)), bottom, top)

    def _along(self, frame: Floats, sides: Sequence[tuple[Floats, Floats]], width: float | None, host: Any) -> int:
        """Return which axis of an element's frame runs along its wall."""
        wall = self.mesh(host)
        if wall is not None and len(sides) > 1:
            first, second = (float(np.ptp(wall[0][:, :2] @ frame[:2, axis])) for axis in (0, 1))
            if max(first, second) > _OBLONG * min(first, second):
                return 0 if first > second else 1
        if width is None:
            return 0
        return int(np.argmin([abs(float(np.linalg.norm(end - start)) - width) for start, end in sides]))

    def _placed(self, frame: Floats, width: float | None) -> Span | None:
        if width is None:
            return None
        start = frame[:3, 3] * self._scale
        end = start[:2] + frame[:2, 0] * width
        return Span((_point(start), _point(end)), float(start[2]), float(start[2]))


def _point(values: Floats) -> Point:
    return round(float(values[0]), 4), round(float(values[1]), 4)

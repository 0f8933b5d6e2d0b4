"""The name of a building that is not a home, in letters over its main entrance."""

import math
from collections.abc import Iterator
from itertools import pairwise
from typing import Final

import numpy as np
import shapely
from shapely.geometry import LineString, Polygon, box

from mansion_export.exterior.entrances import ABOVE, THICKNESS, accent, outward
from mansion_export.exterior.lettering import lettering
from mansion_export.meshes.materials import named
from mansion_export.meshes.model import Material, Node, Part, Surface
from mansion_export.meshes.solids import polygon_surface
from mansion_export.presentation import building_name, main_door
from mansion_knowledge import default_knowledge
from mansion_msgs_py.scene import Door, FloorScene
from mansion_msgs_py.shapes import Point

__all__ = ["sign_parts"]

HEIGHT: Final = 0.62
"""Height of the letters where there is room for them, metres."""

BORDER: Final = 0.16
"""Margin of the board around the letters, metres."""

BOARD: Final = 0.05
RAISED: Final = 0.06
"""Thickness of the board, and of the letters on it, metres."""

CORNER: Final = 0.4
"""From the board to the corners of the building, metres."""


def sign_parts(scene: FloorScene) -> Iterator[Part]:
    """Yield the board with the building's name over the widest door to the street; homes have none."""
    door = main_door(scene) if scene.floor == 1 else None
    if door is None or default_knowledge().groups.is_dwelling(scene.building_type):
        return
    letters = lettering(building_name(scene))
    if letters.is_empty:
        return
    placed = _placed(scene, door, letters.bounds[2])
    if placed is None:
        return
    start, along, out, height = placed
    wide = letters.bounds[2] * height
    base = door.height + ABOVE + THICKNESS + 0.1
    board = box(-BORDER, -BORDER / 2, wide + BORDER, height + BORDER / 2)
    text = shapely.affinity.scale(letters, height, height, origin=(0, 0))
    surfaces = [_upright(board, 0.0, BOARD, accent(scene), (start, along, out, base))]
    frame = start, along, out, base
    surfaces += [
        _upright(part, BOARD, BOARD + RAISED, named("signal_white"), frame) for part in shapely.get_parts(text)
    ]
    name = f"F{scene.floor}/sign"
    yield Node(name, name, "site"), surfaces


def _placed(scene: FloorScene, door: Door, wide: float) -> tuple[Point, Point, Point, float] | None:
    """Return where a text as wide as that at height 1 begins, its directions along and out of the wall, its height.

    Parameters
    ----------
    wide : float
        Of the text, in heights.
    """
    outline = Polygon(scene.outline, scene.holes)
    out = outward(door, outline)
    along = (-out[1], out[0])
    (ax, ay), (bx, by) = door.segment
    middle = np.array([(ax + bx) / 2, (ay + by) / 2])
    thick = max((wall.thickness for wall in scene.walls if wall.exterior), default=0.24)
    side = _side(outline, middle)
    if side is None:
        return None
    ends = sorted(float((np.array(end) - middle) @ np.array(along)) for end in side)
    low, high = ends[0] + CORNER + BORDER, ends[1] - CORNER - BORDER
    height = min(HEIGHT, (high - low) / wide)
    if height < HEIGHT / 2:
        return None
    length = wide * height
    first = min(max(-length / 2, low), high - length)
    start = middle + first * np.array(along) + _offset(side, middle, out, thick) * np.array(out)
    return (float(start[0]), float(start[1])), along, out, height


def _side(outline: Polygon, place: np.ndarray[tuple[int, ...], np.dtype[np.float64]]) -> tuple[Point, Point] | None:
    """Return the side of the outline that a door in the outer wall is in."""
    for ring in (outline.exterior, *outline.interiors):
        points = list(ring.simplify(1e-3).coords)
        for a, b in pairwise(points):
            if LineString([a, b]).distance(shapely.Point(place)) < 0.3 and math.dist(a, b) > 1.0:
                return a, b
    return None


def _offset(
    side: tuple[Point, Point], place: np.ndarray[tuple[int, ...], np.dtype[np.float64]], out: Point, thick: float
) -> float:
    """Return how far the outer face of the wall lies outside the middle of a door, metres."""
    return float((np.array(side[0]) - place) @ np.array(out)) + thick


def _upright(
    shape: Polygon, near: float, far: float, material: Material, frame: tuple[Point, Point, Point, float]
) -> Surface:
    """Return a flat shape as a plate before a wall."""
    (x0, y0), along, out, base = frame
    flat = polygon_surface(shape, near, far, material)
    u, v, w = flat.vertices.T
    vertices = np.column_stack([x0 + u * along[0] + w * out[0], y0 + u * along[1] + w * out[1], base + v])
    return Surface(material, vertices, flat.faces, flat.coordinates)

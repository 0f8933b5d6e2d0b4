"""The name of a building that is not a home, in letters over its main entrance."""

from collections.abc import Iterator
from typing import Final

import numpy as np
import shapely
from shapely.geometry import Polygon, box

from mansion_export.exterior.entrances import ABOVE, THICKNESS, accent
from mansion_export.exterior.fronts import front_of
from mansion_export.exterior.lettering import lettering
from mansion_export.meshes.materials import named
from mansion_export.meshes.model import Material, Node, Part, Surface
from mansion_export.meshes.solids import polygon_surface
from mansion_export.presentation import building_name, main_door
from mansion_knowledge import default_knowledge
from mansion_msgs_py.scene import FloorScene
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
    placed = _placed(scene, letters.bounds[2])
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


def _placed(scene: FloorScene, wide: float) -> tuple[Point, Point, Point, float] | None:
    """Return where a text as wide as that at height 1 begins, its directions along and out of the wall, its height.

    Parameters
    ----------
    wide : float
        Of the text, in heights.
    """
    front = front_of(scene)
    if front is None:
        return None
    low, high = front.low + CORNER + BORDER, front.high - CORNER - BORDER
    height = min(HEIGHT, (high - low) / wide)
    if height < HEIGHT / 2:
        return None
    length = wide * height
    return front.at(min(max(-length / 2, low), high - length)), front.along, front.out, height


def _upright(
    shape: Polygon, near: float, far: float, material: Material, frame: tuple[Point, Point, Point, float]
) -> Surface:
    """Return a flat shape as a plate before a wall."""
    (x0, y0), along, out, base = frame
    flat = polygon_surface(shape, near, far, material)
    u, v, w = flat.vertices.T
    vertices = np.column_stack([x0 + u * along[0] + w * out[0], y0 + u * along[1] + w * out[1], base + v])
    return Surface(material, vertices, flat.faces, flat.coordinates)

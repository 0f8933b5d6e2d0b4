"""Stairs and lifts as nodes of a model, and the signs over their doors."""

from collections.abc import Iterator
from math import cos, degrees, radians, sin
from typing import Final

import numpy as np

from mansion_export.meshes.materials import named
from mansion_export.meshes.model import Material, Node, Part, Surface
from mansion_export.meshes.solids import Box, box_between, boxes_surface
from mansion_knowledge import default_knowledge
from mansion_msgs_py.scene import Box3, FloorScene, LiftDetails, SceneCore, StairDetails
from mansion_msgs_py.shapes import Point3

__all__ = ["core_parts", "core_sign"]

RAIL = 0.05
"""Breadth of a handrail, metres."""

WALL = 0.05
"""Thickness of a lift cabin's walls, metres."""

_WORDS: Final = {"elevator": "LIFT", "stair": "STAIRS"}

_PLATES: Final = {
    "elevator": Material("sign_blue", (0.07, 0.22, 0.55), roughness=0.6, emission=0.3),
    "stair": Material("sign_green", (0.02, 0.42, 0.25), roughness=0.6, emission=0.3),
}

_LETTERS: Final = Material("sign_white", (1.0, 1.0, 1.0), roughness=0.6, emission=0.9)

_FONT: Final = {
    "A": "01110 10001 10001 11111 10001 10001 10001",
    "F": "11111 10000 10000 11110 10000 10000 10000",
    "I": "111 010 010 010 010 010 111",
    "L": "10000 10000 10000 10000 10000 10000 11111",
    "R": "11110 10001 10001 11110 10100 10010 10001",
    "S": "01111 10000 10000 01110 00001 00001 11110",
    "T": "11111 00100 00100 00100 00100 00100 00100",
}
"""Rows of each letter's points, the uppermost first."""

_DOT: Final = 0.026
"""Side of a letter's point, metres."""

_MARGIN: Final = 0.06

_THICK: Final = 0.03

_ABOVE: Final = 0.14
"""From the door's head to the plate, metres."""

_HEIGHT: Final = 7 * _DOT + 2 * _MARGIN


def core_parts(scene: FloorScene, cabins: frozenset[str] | None = None) -> Iterator[Part]:
    """Yield flights, landings and handrails, the lifts with their panels, and the signs over the doors.

    Parameters
    ----------
    cabins : frozenset of str, optional
        Ids of the cores whose cabin stands on this floor; all when it is left out.
    """
    for core in scene.cores:
        if sign := core_sign(scene, core):
            name = f"{core.id}/sign"
            yield Node(name, _mesh_name(scene, name), "cores"), sign
        if isinstance(core.details, StairDetails):
            yield Node(core.id, _mesh_name(scene, core.id), "cores", room=core.id), _stair(core.details)
        elif isinstance(core.details, LiftDetails):
            name = f"{core.id}/call_panel"
            yield Node(name, _mesh_name(scene, name), "cores"), _call_panel(core.details)
            if cabins is None or core.id in cabins:
                yield Node(core.id, _mesh_name(scene, core.id), "cores", room=core.id), _cabin(core.details)


def _mesh_name(scene: FloorScene, part: str) -> str:
    """Return the name of a core's mesh: a core has one id on all floors, but not one shape."""
    return f"F{scene.floor}/{part}"


def _stair(details: StairDetails) -> list[Surface]:
    steps = [box_between(low, high) for low, high in (*details.treads, *details.landings)]
    nosing = [_nosing(box) for box in details.treads]
    surfaces = [
        boxes_surface(steps, named("polished_concrete")),
        boxes_surface([bar for bar in nosing if bar is not None], named("rubber")),
    ]
    for start, end in details.rails:
        surfaces += _rail(start, end)
    return surfaces


def _nosing(tread: Box3) -> Box | None:
    """Return a dark strip on a step, which tells steps apart."""
    (x0, y0, _), (x1, y1, z1) = tread
    if min(x1 - x0, y1 - y0) < 0.1:
        return None
    if x1 - x0 > y1 - y0:
        middle = (y0 + y1) / 2
        return box_between((x0 + 0.02, middle - 0.015, z1), (x1 - 0.02, middle + 0.015, z1 + 0.003))
    middle = (x0 + x1) / 2
    return box_between((middle - 0.015, y0 + 0.02, z1), (middle + 0.015, y1 - 0.02, z1 + 0.003))


def _rail(start: Point3, end: Point3) -> list[Surface]:
    """Return a handrail as a slanted bar, and balusters down to the steps every metre."""
    a, b = np.array(start), np.array(end)
    along = b - a
    flat = float(np.hypot(along[0], along[1]))
    across = np.array([-along[1], along[0], 0.0]) / max(flat, 1e-6) * RAIL / 2
    if flat < 1e-6:
        across = np.array([RAIL / 2, 0.0, 0.0])
    up = np.array([0.0, 0.0, RAIL / 2])
    corners = [p + s * across + t * up for t in (-1, 1) for s in (-1, 1) for p in (a, b)]
    bar = boxes_surface([Box((0.0, 0.0, 0.0), (1.0, 1.0, 1.0))], named("painted_steel"))
    bar = Surface(bar.material, np.array(corners), _outward(np.array(corners), bar.faces))
    posts = []
    count = max(2, round(flat / 1.0) + 1)
    for t in np.linspace(0.0, 1.0, count):
        x, y, z = (a + t * along).tolist()
        posts.append(Box((x, y, z - 0.45), (0.03, 0.03, 0.9)))
    return [bar, boxes_surface(posts, named("painted_steel"))]


def _outward(
    corners: np.ndarray[tuple[int, ...], np.dtype[np.float64]], faces: np.ndarray[tuple[int, ...], np.dtype[np.int64]]
) -> np.ndarray[tuple[int, ...], np.dtype[np.int64]]:
    """Turn all faces of a hexahedron to look outward, which its corners decide together."""
    a, b, c = (corners[faces[:, i]] for i in range(3))
    volume = float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum())
    return faces if volume > 0 else np.ascontiguousarray(faces[:, ::-1])


def _cabin(details: LiftDetails) -> list[Surface]:
    surfaces = [
        boxes_surface(_cabin_boxes(details), named("brushed_steel")),
        boxes_surface([_floor(details)], named("dark_tiles")),
        boxes_surface([_lamp(details)], _lamp_material()),
        *_plate(details.button_panel, details.facing, 0.24, 0.9, named("painted_steel")),
    ]
    for button in details.buttons:
        surfaces += _plate(button.position, details.facing, 0.05, 0.05, named("button_light"))
    return surfaces


def _call_panel(details: LiftDetails) -> list[Surface]:
    """Return a dark plate with a lit button for up and one for down; it stands out on light walls."""
    (x, y, z), turn = details.call_panel, np.radians(details.facing)
    face = (x + 0.012 * float(np.cos(turn)), y + 0.012 * float(np.sin(turn)))
    plate = _plate(details.call_panel, details.facing, 0.14, 0.34, named("painted_steel"))
    for up in (0.07, -0.07):
        plate += _plate((*face, z + up), details.facing, 0.06, 0.06, named("button_light"))
    return plate


def _lamp_material() -> Material:
    return Material("lift_lamp", (1.0, 0.97, 0.9), roughness=0.5, emission=1.0)


def _cabin_boxes(details: LiftDetails) -> list[Box]:
    """Return the cabin's walls and roof; the side of its door is open."""
    (x0, y0, z0), (x1, y1, z1) = details.cabin
    turn = round(details.facing / 90.0) % 4
    sides = {
        0: ((x1 - WALL, y0, z0), (x1, y1, z1)),
        1: ((x0, y1 - WALL, z0), (x1, y1, z1)),
        2: ((x0, y0, z0), (x0 + WALL, y1, z1)),
        3: ((x0, y0, z0), (x1, y0 + WALL, z1)),
    }
    boxes = [box_between(low, high) for key, (low, high) in sides.items() if key != turn]
    boxes.append(box_between((x0, y0, z1 - WALL), (x1, y1, z1)))
    return boxes


def _floor(details: LiftDetails) -> Box:
    (x0, y0, z0), (x1, y1, _) = details.cabin
    return box_between((x0, y0, z0), (x1, y1, max(z0 + 0.02, 0.0)))


def _lamp(details: LiftDetails) -> Box:
    (x0, y0, _), (x1, y1, z1) = details.cabin
    cx, cy = (x0 + x1) / 2, (y0 + y1) / 2
    return Box((cx, cy, z1 - WALL - 0.01), (0.5 * (x1 - x0), 0.5 * (y1 - y0), 0.02))


def _plate(at: Point3, facing: float, width: float, height: float, material: Material) -> list[Surface]:
    """Return a thin plate across `facing`, the same on both sides."""
    box = Box(at, (width, 0.03 if height > 0.06 else 0.05, height), facing - 90.0)
    return [boxes_surface([box], material)]


def core_sign(scene: FloorScene, core: SceneCore) -> list[Surface]:
    """Return the sign on the wall over a core's door, on the landing side; none without a door.

    Where the wall is too low, the sign hangs before the door's head. Stairs of a home have no sign.
    """
    door = next((door for door in scene.doors if door.id == core.door), None)
    if door is None or (core.type == "stair" and default_knowledge().is_dwelling(scene.building_type)):
        return []
    walls = {wall.id: wall for wall in scene.walls}
    wall = walls.get(door.wall)
    deep, top = (wall.thickness, wall.height) if wall is not None else (0.12, 2.7)
    (ax, ay), (bx, by) = door.segment
    yaw = radians(core.entrance[2])
    out = (cos(yaw), sin(yaw))
    away = deep / 2 + _THICK / 2
    x, y = (ax + bx) / 2 + out[0] * away, (ay + by) / 2 + out[1] * away
    z = min(door.height + _ABOVE + _HEIGHT / 2, top - _HEIGHT / 2)
    turn = degrees(yaw) + 90.0
    word = _WORDS[core.type]
    plate = Box((x, y, z), (_width(word) + 2 * _MARGIN, _THICK, _HEIGHT), turn)
    right = (-out[1], out[0])
    letters = [
        Box(
            (
                x + right[0] * across + out[0] * (_THICK / 2 + 0.004),
                y + right[1] * across + out[1] * (_THICK / 2 + 0.004),
                z + up,
            ),
            (wide, 0.008, _DOT),
            turn,
        )
        for across, up, wide in _strokes(word)
    ]
    return [boxes_surface([plate], _PLATES[core.type]), boxes_surface(letters, _LETTERS)]


def _width(word: str) -> float:
    return _DOT * (sum(len(_FONT[letter].split()[0]) + 1 for letter in word) - 1)


def _strokes(word: str) -> list[tuple[float, float, float]]:
    """Return the rows of points as bars: middle across and up from the word's middle, and length; metres."""
    bars, left = [], -_width(word) / 2
    for letter in word:
        rows = _FONT[letter].split()
        for k, row in enumerate(rows):
            start = 0
            while (begin := row.find("1", start)) >= 0:
                end = row.find("0", begin)
                start = len(row) if end < 0 else end
                middle = left + _DOT * (begin + start) / 2
                bars.append((middle, _DOT * (3 - k), _DOT * (start - begin)))
        left += _DOT * (len(rows[0]) + 1)
    return bars

"""Signs over the doors of lifts and stairs: white letters on a coloured plate, as buildings have them."""

from math import cos, degrees, radians, sin
from typing import Final

from mansion_export.model import Material, Surface
from mansion_export.solids import Box
from mansion_export.solids3d import boxes_surface
from mansion_msgs_py.scene import FloorScene, SceneCore
from mansion_scene.structure.outer_doors import is_residential

__all__ = ["core_sign"]

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


def core_sign(scene: FloorScene, core: SceneCore) -> list[Surface]:
    """Return the sign on the wall over a core's door, on the side from which one comes; none without a door.

    Where the wall is too low, the sign hangs before the door's head. Nobody puts a sign over the stairs at home.
    """
    door = next((door for door in scene.doors if door.id == core.door), None)
    if door is None or (core.type == "stair" and is_residential(scene.building_type)):
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

"""Rooms as tinted areas, and names and areas where they can be read."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from mansion_export.plan.label_places import LabelBox, place_label
from mansion_export.plan.palette import INK, room_tint
from mansion_export.plan.shapes import Area, Canvas, Label, Shape
from mansion_msgs_py.scene import FloorScene, SceneRoom

__all__ = ["draw_rooms", "label_rooms", "room_title"]

LETTER = 0.62
"""Mean width of a letter over the height of its font."""

_LEADING = 1.22
"""Height of a row over that of its font."""

_LETTER_SHARE, _LETTERS = 0.014, (0.2, 0.45)
"""Height of the largest letters over the floor's longer side, and its least and most, metres."""

_SHARES = (1.0, 0.85, 0.7, 0.58, 0.48)
"""Heights of letters that are tried, over the largest."""


def draw_rooms(scene: FloorScene) -> list[Canvas]:
    """Draw the floor of each room."""
    return [
        Canvas(
            "rooms",
            (Area(room.polygon, room_tint(room.room_type, room.kind), width=0.0, holes=tuple(room.holes)),),
            room.id,
            f"{room_title(room)}, {room.area:.1f} m²",
        )
        for room in scene.rooms
        if room.kind not in ("stair", "elevator")
    ]


def room_title(room: SceneRoom) -> str:
    """Return the name that a person reads: the room's own, or its type in words."""
    name = room.name or room.id.rsplit("/", 1)[-1]
    words = name.replace("_", " ").strip()
    return words[:1].upper() + words[1:]


def label_rooms(scene: FloorScene) -> list[Canvas]:
    """Write each room's name and area where they cover least, along the room where it is narrow."""
    outline = np.asarray(scene.outline, dtype=float)
    tallest = float(np.clip(_LETTER_SHARE * np.ptp(outline, axis=0).max(), *_LETTERS))
    canvases = []
    for room in scene.rooms:
        if room.kind in ("stair", "elevator"):
            continue
        canvases.append(Canvas("labels", tuple(_label(scene, room, tallest)), ""))
    return canvases


def _label(scene: FloorScene, room: SceneRoom, tallest: float) -> list[Shape]:
    options = _options(room_title(room).split(" "), tallest)
    boxes = [LabelBox(way.width, way.height, way.size / tallest) for way in options]
    best = place_label(scene, room, boxes)
    option = options[best.option]
    lines = [(row, option.size, True, INK["text"]) for row in option.rows]
    lines.append((f"{room.area:.1f} m²", 0.85 * option.size, False, INK["muted"]))
    shapes: list[Shape] = []
    for i, (text, letter, bold, color) in enumerate(lines):
        offset = ((len(lines) - 1) / 2 - i) * _LEADING * option.size
        x, y = best.at
        place = (x - offset, y) if best.turned else (x, y + offset)
        angle = 90.0 if best.turned else 0.0
        shapes.append(Label(place, text, letter, color, bold=bold, angle=angle))
    return shapes


@dataclass(frozen=True)
class _Option:
    """A way to write a name: its rows and the height of its letters in metres."""

    rows: list[str]
    size: float

    @property
    def width(self) -> float:
        return max(max(len(row) for row in self.rows), 6) * LETTER * self.size

    @property
    def height(self) -> float:
        return _LEADING * self.size * (len(self.rows) + 1)


def _options(words: Sequence[str], tallest: float) -> list[_Option]:
    """Return ways to write a name, the largest letters first, each in one to three rows."""
    return [_Option(rows, share * tallest) for share in _SHARES for rows in _wraps(words)]


def _wraps(words: Sequence[str]) -> list[list[str]]:
    """Break words into one, two or three rows of about equal length."""
    joined = " ".join(words)
    wraps = [[joined]]
    for count in (2, 3):
        if len(words) < count:
            break
        rows: list[str] = []
        row, target = "", len(joined) / count
        for word in words:
            if row and len(row) + len(word) / 2 > target and len(rows) < count - 1:
                rows.append(row)
                row = word
            else:
                row = f"{row} {word}".strip()
        wraps.append([*rows, row])
    return wraps

"""Rooms of a plan: tinted areas, and their names and areas where they cover least of the furniture."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil

import numpy as np

from mansion_export.plan.palette import INK, room_tint
from mansion_export.plan.shapes import Area, Canvas, Label, Shape
from mansion_export.presentation import room_title
from mansion_geometry.compiled import Bools, Floats, Ints
from mansion_geometry.rasters import ring_mask
from mansion_msgs_py.scene import FloorScene, SceneRoom
from mansion_msgs_py.shapes import Point

__all__ = ["LabelBox", "LabelPlace", "draw_rooms", "label_rooms", "place_label"]

LETTER = 0.62
"""Mean width of a letter over the height of its font."""

_LEADING = 1.22
"""Height of a row over that of its font."""

_LETTER_SHARE, _LETTERS = 0.014, (0.2, 0.45)
"""Height of the largest letters over the floor's longer side, and its least and most, metres."""

_SHARES = (1.0, 0.85, 0.7, 0.58, 0.48)
"""Heights of letters that are tried, over the largest."""


_CELL, _MOST = 0.12, 90
"""Side of a cell, metres, and most cells along a side of a room."""

_MARGIN = 1.0
"""Around a room, metres."""

_COVERED, _TURNED, _ASIDE = 4.0, 0.15, 0.12
"""What it costs to cover furniture (for the whole label), to be turned, and to be off the middle."""

_LEAVING = (0.4, 60.0)
"""What it costs to touch a wall at all, and for the whole label: any label that fits is better."""

_WALL = 0.08
"""From a room's outline to where its letters may stand, metres: half a wall and a little paper."""


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
    """A name broken into rows, and the height of its letters in metres."""

    rows: list[str]
    size: float

    @property
    def width(self) -> float:
        return max(max(len(row) for row in self.rows), 6) * LETTER * self.size

    @property
    def height(self) -> float:
        return _LEADING * self.size * (len(self.rows) + 1)


def _options(words: Sequence[str], tallest: float) -> list[_Option]:
    """Return the name in one to three rows at each height of letters, the largest first."""
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


@dataclass(frozen=True)
class LabelBox:
    """A label as wide and as high as its text, metres; `worth` grows with its letters."""

    width: float
    height: float
    worth: float


@dataclass(frozen=True)
class LabelPlace:
    """The label that was chosen (an index), its middle, and whether it is turned by 90 degrees."""

    option: int
    at: Point
    turned: bool


def place_label(scene: FloorScene, room: SceneRoom, boxes: Sequence[LabelBox]) -> LabelPlace:
    """Choose among labels and places.

    Parameters
    ----------
    scene : FloorScene
        Whose furniture and door swings are kept legible.
    room : SceneRoom
    boxes : sequence of LabelBox
        In falling order of their worth.
    """
    xs, ys, inside = _cells(room.polygon, room.holes)
    covered = _covered(scene, room, xs, ys)
    clear = _clear_of_walls(room, xs, ys)
    outside_sums, covered_sums = _sums(~clear), _sums(covered & inside)
    aside = np.hypot(
        (xs[None, :] - xs[inside.any(0)].mean()) / np.ptp(xs), (ys[:, None] - ys[inside.any(1)].mean()) / np.ptp(ys)
    )
    # Only in the room are labels placed, a part of the cells.
    rows, columns = (slice(k[0], k[-1] + 1) for k in (np.flatnonzero(inside.any(1)), np.flatnonzero(inside.any(0))))
    inside, aside = inside[rows, columns], aside[rows, columns]
    best, found = -np.inf, LabelPlace(0, (float(xs[0]), float(ys[0])), False)
    for option, box in enumerate(boxes):
        for turned in (False, True):
            most = box.worth - (_TURNED if turned else 0.0)
            if most <= best:
                continue
            across, up = (box.height, box.width) if turned else (box.width, box.height)
            window = _window(across, up, xs, ys, rows, columns)
            outside = window.share(outside_sums)
            cost = _COVERED * window.share(covered_sums)
            cost += np.where(outside > 0.0, _LEAVING[0] + _LEAVING[1] * outside, 0.0)
            value = box.worth - cost - _ASIDE * aside - (_TURNED if turned else 0.0)
            value = np.where(inside, value, -np.inf)
            j, i = np.unravel_index(int(np.argmax(value)), value.shape)
            if value[j, i] > best + 1e-9:
                best = float(value[j, i])
                at = float(xs[columns.start + i]), float(ys[rows.start + j])
                found = LabelPlace(option, at, turned)
    return found


def _covered(scene: FloorScene, room: SceneRoom, xs: Floats, ys: Floats) -> Bools:
    """Return the cells that furniture, a door's leaf or its swing takes."""
    taken = np.zeros((len(ys), len(xs)), dtype=bool)
    for item in scene.objects:
        if item.room != room.id or item.mount != "floor" or item.size[2] <= 0.05:
            continue
        c, s = np.cos(np.radians(item.rotation)), np.sin(np.radians(item.rotation))
        dx, dy = xs[None, :] - item.position[0], ys[:, None] - item.position[1]
        taken |= (np.abs(dx * c + dy * s) < item.size[0] / 2) & (np.abs(dy * c - dx * s) < item.size[1] / 2)
    for door in scene.doors:
        if room.id in door.rooms and door.kind not in ("open", "frame", "doorway", "sliding"):
            (ax, ay), (bx, by) = door.segment
            reach = 0.75 * door.width
            near = np.hypot(xs[None, :] - (ax + bx) / 2, ys[:, None] - (ay + by) / 2) < reach
            taken |= near
    return taken


def _cells(ring: Sequence[Point], holes: Sequence[Sequence[Point]]) -> tuple[Floats, Floats, Bools]:
    """Return cell centres and which of them lie in the room."""
    points = np.asarray(ring, dtype=float)
    (x0, y0), (x1, y1) = points.min(0), points.max(0)
    # A margin around the room, so that a label that leaves it is seen to.
    x0, y0, x1, y1 = x0 - _MARGIN, y0 - _MARGIN, x1 + _MARGIN, y1 + _MARGIN
    nx = int(np.clip((x1 - x0) / _CELL, 3, _MOST))
    ny = int(np.clip((y1 - y0) / _CELL, 3, _MOST))
    xs = x0 + (np.arange(nx) + 0.5) * (x1 - x0) / nx
    ys = y0 + (np.arange(ny) + 0.5) * (y1 - y0) / ny
    inside = ring_mask(points, xs, ys)
    for hole in holes:
        inside &= ~ring_mask(np.asarray(hole, dtype=float), xs, ys)
    if not inside.any():
        inside[ny // 2, nx // 2] = True
    return xs, ys, inside


def _clear_of_walls(room: SceneRoom, xs: Floats, ys: Floats) -> Bools:
    """Return the cells of the room that no wall takes."""
    clear = np.ones((len(ys), len(xs)), dtype=bool)
    for dx, dy in ((-_WALL, -_WALL), (-_WALL, _WALL), (_WALL, -_WALL), (_WALL, _WALL)):
        clear &= ring_mask(np.asarray(room.polygon, dtype=float), xs + dx, ys + dy)
        for hole in room.holes:
            clear &= ~ring_mask(np.asarray(hole, dtype=float), xs + dx, ys + dy)
    return clear


def _sums(cells: Bools) -> Floats:
    """Return sums over all cells below and left of each corner: a summed-area table (Crow, F. C. 1984)."""
    sums = np.zeros((cells.shape[0] + 1, cells.shape[1] + 1))
    sums[1:, 1:] = cells.cumsum(0).cumsum(1)
    return sums


@dataclass(frozen=True)
class _Window:
    """A window around each of some cells: the corners of each row and column of them, and how many cells it has."""

    low_rows: Ints
    high_rows: Ints
    low_columns: Ints
    high_columns: Ints
    cells: int

    def share(self, sums: Floats) -> Floats:
        """Return the share of marked cells in the window around each cell."""
        rows = sums[self.high_rows] - sums[self.low_rows]
        share: Floats = (rows[:, self.high_columns] - rows[:, self.low_columns]) / self.cells
        return share


def _window(width: float, height: float, xs: Floats, ys: Floats, rows: slice, columns: slice) -> _Window:
    """Return the window of a size around each cell of some rows and columns."""
    nx, ny = len(xs), len(ys)
    rx = max(1, ceil(width / 2 / float(xs[1] - xs[0]) - 0.5))
    ry = max(1, ceil(height / 2 / float(ys[1] - ys[0]) - 0.5))
    i, j = np.arange(nx)[columns], np.arange(ny)[rows]
    return _Window(
        np.maximum(j - ry, 0),
        np.minimum(j + ry + 1, ny),
        np.maximum(i - rx, 0),
        np.minimum(i + rx + 1, nx),
        (2 * ry + 1) * (2 * rx + 1),
    )

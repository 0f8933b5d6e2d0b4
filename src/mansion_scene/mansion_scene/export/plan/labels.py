"""Rooms as tinted areas, and names and areas where they can be read."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.scene import FloorScene, SceneRoom
from mansion_msgs_py.shapes import Point
from mansion_scene.export.plan.palette import INK, room_tint
from mansion_scene.export.plan.shapes import Area, Canvas, Label, Shape

__all__ = ["draw_rooms", "label_rooms", "room_title"]

FloatArray = npt.NDArray[np.float64]

LETTER = 0.56
"""Mean width of a letter over the height of its font."""


def draw_rooms(scene: FloorScene) -> list[Canvas]:
    """Draw the floor of each room."""
    return [
        Canvas(
            "rooms",
            (
                Area(
                    room.polygon,
                    room_tint(room.room_type, room.kind),
                    width=0.0,
                    holes=tuple(room.holes),
                ),
            ),
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
    """Write each room's name and area at its widest place, along the room where it is narrow."""
    canvases = []
    for room in scene.rooms:
        if room.kind in ("stair", "elevator"):
            continue
        canvases.append(Canvas("labels", tuple(_label(scene, room)), ""))
    return canvases


def _label(scene: FloorScene, room: SceneRoom) -> list[Shape]:
    at, width, height = _place(scene, room)
    words = room_title(room).split(" ")
    turned = height > 1.8 * width
    along, across = (height, width) if turned else (width, height)
    best: tuple[float, list[str]] = (0.0, [" ".join(words)])
    for rows in _wraps(words):
        longest = max(max(len(row) for row in rows), 6)
        size = min(0.34, 0.9 * along / (longest * LETTER), 0.9 * across / (1.25 * (len(rows) + 1)))
        if size > best[0] + 0.02:
            best = (size, rows)
    size, rows = max(best[0], 0.12), best[1]
    lines = [(row, size, True, INK["text"]) for row in rows]
    lines.append((f"{room.area:.1f} m²", 0.85 * size, False, INK["muted"]))
    shapes: list[Shape] = []
    for i, (text, letter, bold, color) in enumerate(lines):
        offset = ((len(lines) - 1) / 2 - i) * 1.22 * size
        place = (at[0] - offset, at[1]) if turned else (at[0], at[1] + offset)
        shapes.append(Label(place, text, letter, color, bold=bold, angle=90.0 if turned else 0.0))
    return shapes


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


def _place(scene: FloorScene, room: SceneRoom) -> tuple[Point, float, float]:
    """Find where a label stands best: free of the room's furniture as far as that goes, and wide.

    Returns the place and the free width and height around it.
    """
    xs, ys, inside = _grid(room.polygon, room.holes)
    covered = np.zeros_like(inside)
    for item in scene.objects:
        if item.room == room.id and item.mount == "floor" and item.size[2] > 0.05:
            reach = max(item.size[0], item.size[1]) / 2
            near_x = np.abs(xs - item.position[0]) < reach
            near_y = np.abs(ys - item.position[1]) < reach
            covered[np.ix_(near_y, near_x)] = True
    # A label has two lines: it is as wide as the narrowest row that it crosses.
    right = _runs(_thinned(inside, int(0.45 / float(ys[1] - ys[0])) + 1), 1)
    right = np.maximum(right, np.minimum(_runs(inside, 1), 1.0)) * float(xs[1] - xs[0])
    up = _runs(inside, 0) * float(ys[1] - ys[0])
    worth = np.minimum(right, 3.0) * np.minimum(up, 1.6)
    worth = np.maximum(worth, 0.8 * np.minimum(up, 3.0) * np.minimum(right, 0.9))
    worth = np.where(inside, worth * (1.0 - 0.7 * _share(covered, xs, ys)), -1.0)
    middle = np.hypot(
        xs[None, :] - xs[inside.any(0)].mean(), ys[:, None] - ys[inside.any(1)].mean()
    )
    j, i = np.unravel_index(int(np.argmax(worth - 0.05 * middle)), worth.shape)
    return (float(xs[i]), float(ys[j])), float(right[j, i]), float(up[j, i])


def _share(covered: npt.NDArray[np.bool_], xs: FloatArray, ys: FloatArray) -> FloatArray:
    """Covered share of the window of a usual label around each cell."""
    ny, nx = covered.shape
    rx = max(1, round(0.9 / float(xs[1] - xs[0])))
    ry = max(1, round(0.4 / float(ys[1] - ys[0])))
    sums = np.zeros((ny + 1, nx + 1))
    sums[1:, 1:] = covered.cumsum(0).cumsum(1)
    i0, i1 = np.clip(np.arange(nx) - rx, 0, nx), np.clip(np.arange(nx) + rx + 1, 0, nx)
    j0, j1 = np.clip(np.arange(ny) - ry, 0, ny), np.clip(np.arange(ny) + ry + 1, 0, ny)
    total = (
        sums[np.ix_(j1, i1)] - sums[np.ix_(j0, i1)] - sums[np.ix_(j1, i0)] + sums[np.ix_(j0, i0)]
    )
    share: FloatArray = total / ((j1 - j0)[:, None] * (i1 - i0)[None, :])
    return share


def _grid(
    ring: Sequence[Point], holes: Sequence[Sequence[Point]]
) -> tuple[FloatArray, FloatArray, npt.NDArray[np.bool_]]:
    """Cells of about a fifth of a metre, at most 60 a side, and which centres lie in the room."""
    points = np.asarray(ring, dtype=float)
    (x0, y0), (x1, y1) = points.min(0), points.max(0)
    nx = int(np.clip((x1 - x0) / 0.2, 3, 60))
    ny = int(np.clip((y1 - y0) / 0.2, 3, 60))
    xs = x0 + (np.arange(nx) + 0.5) * (x1 - x0) / nx
    ys = y0 + (np.arange(ny) + 0.5) * (y1 - y0) / ny
    inside = _inside(points, xs, ys)
    for hole in holes:
        inside &= ~_inside(np.asarray(hole, dtype=float), xs, ys)
    if not inside.any():
        inside[ny // 2, nx // 2] = True
    return xs, ys, inside


def _inside(ring: FloatArray, xs: FloatArray, ys: FloatArray) -> npt.NDArray[np.bool_]:
    result = np.zeros((len(ys), len(xs)), dtype=bool)
    for (ax, ay), (bx, by) in zip(ring, np.roll(ring, -1, axis=0)):
        if ay == by:
            continue
        rows = (ay > ys) != (by > ys)
        cross = (bx - ax) * (ys - ay) / (by - ay) + ax
        result ^= rows[:, None] & (xs[None, :] < cross[:, None])
    return result


def _thinned(inside: npt.NDArray[np.bool_], rows: int) -> npt.NDArray[np.bool_]:
    """Keep the cells whose neighbours up to some rows above and below are inside, too."""
    thin = inside.copy()
    for shift in range(1, rows + 1):
        thin[shift:] &= inside[:-shift]
        thin[:-shift] &= inside[shift:]
        thin[:shift] = False
        thin[-shift:] = False
    return thin


def _runs(inside: npt.NDArray[np.bool_], axis: int) -> FloatArray:
    """Twice the free cells to the nearer end of each cell's run along an axis: room for centred text."""
    grid = np.moveaxis(inside, axis, 1).astype(float)
    ahead = np.zeros_like(grid)
    behind = np.zeros_like(grid)
    for k in range(grid.shape[1]):
        before = behind[:, k - 1] if k else 0.0
        behind[:, k] = (before + 1.0) * grid[:, k]
        m = grid.shape[1] - 1 - k
        after = ahead[:, m + 1] if k else 0.0
        ahead[:, m] = (after + 1.0) * grid[:, m]
    runs: FloatArray = 2.0 * np.minimum(ahead, behind) - grid
    return np.moveaxis(runs, 1, axis)

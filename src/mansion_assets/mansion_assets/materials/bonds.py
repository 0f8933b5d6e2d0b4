"""How pieces are laid on a tile: courses of boards, bricks and tiles, herringbone, hexagons, and irregular cells."""

from dataclasses import dataclass

import numpy as np

from mansion_assets.materials.canvas import Canvas
from mansion_geometry.compiled import Bools, Floats, Ints
from mansion_geometry.randomness import item_generator

__all__ = ["Pieces", "cells", "courses", "herringbone", "hexagons"]


@dataclass(frozen=True, slots=True)
class Pieces:
    """Which piece each texel lies on.

    Attributes
    ----------
    number : (rows, columns) array of int
        From 0.
    along, across : (rows, columns) array
        Place on the piece, metres.
    edge : (rows, columns) array
        Distance to the piece's edge, metres.
    """

    number: Ints
    along: Floats
    across: Floats
    edge: Floats


def courses(canvas: Canvas, length: float, width: float, shifts: tuple[float, ...] = (0.0,)) -> Pieces:
    """Lay pieces in rows; row k begins ``shifts[k]`` of a length further right, over and over.

    Lengths and widths are fitted to whole numbers of pieces and, down the tile, to whole rounds of `shifts`.
    """
    x, y = canvas.places
    columns = max(1, round(canvas.size[0] / length))
    rows = max(1, round(canvas.size[1] / width / len(shifts))) * len(shifts)
    length, width = canvas.size[0] / columns, canvas.size[1] / rows
    row = np.minimum((y / width).astype(np.int64), rows - 1)
    moved = x / length - np.array(shifts)[row % len(shifts)]
    column = np.floor(moved).astype(np.int64)
    along, across = (moved - column) * length, y - row * width
    edge = np.minimum.reduce([along, length - along, across, width - across])
    return Pieces(row * columns + column % columns, along, across, edge)


def herringbone(canvas: Canvas, repeats: int, ratio: int) -> Pieces:
    """Lay blocks of `ratio` times their width as herringbone, its points up; `repeats` zigzags fit across the tile.

    In the frame of the blocks the pattern repeats by (1, 1) and by (n, -n) widths, n the ratio; turned by 45 degrees
    these are the sides of the tile, so it is n / k times as high as wide, k a divisor of `repeats` times n.
    """
    x, y = canvas.places
    width = canvas.size[0] / (repeats * ratio * np.sqrt(2.0))
    i, j = (x + y) / np.sqrt(2.0) / width, (x - y) / np.sqrt(2.0) / width
    column, row = np.floor(i).astype(np.int64), np.floor(j).astype(np.int64)
    step = (column - row) % (2 * ratio)
    lying = step < ratio
    along = np.where(lying, step + i - column, step - ratio + (row + 1 - j)) * width
    across = np.where(lying, j - row, i - column) * width
    first = np.where(lying, column - step, column), np.where(lying, row, row + step - ratio)
    edge = np.minimum.reduce([along, ratio * width - along, across, width - across])
    return Pieces(_wrapped(canvas, first, width, lying), along, across, edge)


def _wrapped(canvas: Canvas, first: tuple[Ints, Ints], width: float, lying: Bools) -> Ints:
    """Number blocks by the place of their first square, the same in every repetition of the tile."""
    root = width / np.sqrt(2.0)
    x, y = (first[0] + first[1] + 1) * root, (first[0] - first[1]) * root
    steps = [np.round(value / root).astype(np.int64) % round(side / root) for value, side in zip((x, y), canvas.size)]
    _, number = np.unique((steps[0] * 4096 + steps[1]) * 2 + lying, return_inverse=True)
    numbers: Ints = number.reshape(lying.shape).astype(np.int64)
    return numbers


def hexagons(canvas: Canvas, columns: int, rows: int) -> Pieces:
    """Lay hexagons with points up and down: `columns` across the tile and twice `rows` down."""
    x, y = canvas.places
    w, h = canvas.size[0] / columns, canvas.size[1] / rows
    found = []
    for shift in (0.0, 0.5):
        column, row = np.floor(x / w - shift + 0.5), np.floor(y / h - shift + 0.5)
        dx, dy = x - (column + shift) * w, y - (row + shift) * h
        found.append((dx, dy, (column % columns) * rows * 2 + (row % rows) * 2 + 2 * shift))
    (ax, ay, an), (bx, by, bn) = found
    near = np.hypot(ax, ay) <= np.hypot(bx, by)
    dx, dy = np.where(near, ax, bx), np.where(near, ay, by)
    # Sides stand upright or lean by 30 degrees where h is the square root of three times w; else nearly so.
    normal = np.array([w / 2, h / 2]) / np.hypot(w / 2, h / 2)
    lean = np.hypot(w / 2, h / 2) / 2 - (np.abs(dx) * normal[0] + np.abs(dy) * normal[1])
    return Pieces(np.where(near, an, bn).astype(np.int64), dx, dy, np.minimum(w / 2 - np.abs(dx), lean))


def cells(canvas: Canvas, salt: str, size: float) -> Pieces:
    """Return irregular cells of about `size` metres around random points, one in each square of a grid.

    `along` is the distance to the nearest point, `across` to the second nearest (Worley, S. 1996, A cellular texture
    basis function); `edge` is half their difference.
    """
    columns, rows = (max(3, round(side / size)) for side in canvas.size)
    w, h = canvas.size[0] / columns, canvas.size[1] / rows
    strewn = item_generator(0, canvas.name, salt).random((rows, columns, 2))
    x, y = canvas.places
    column, row = np.floor(x / w).astype(np.int64), np.floor(y / h).astype(np.int64)
    first, second = np.full(canvas.shape, np.inf), np.full(canvas.shape, np.inf)
    number = np.zeros(canvas.shape, dtype=np.int64)
    for dy in (-1, 0, 1):
        for dx in (-1, 0, 1):
            point = strewn[(row + dy) % rows, (column + dx) % columns]
            away = np.hypot(x - (column + dx + point[..., 0]) * w, y - (row + dy + point[..., 1]) * h)
            nearer = away < first
            second = np.where(nearer, first, np.minimum(second, away))
            number = np.where(nearer, (row + dy) % rows * columns + (column + dx) % columns, number)
            first = np.minimum(first, away)
    return Pieces(number, first, second, (second - first) / 2)

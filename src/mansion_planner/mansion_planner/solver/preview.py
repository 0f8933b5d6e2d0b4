"""A small PNG picture of the layout so far, with the parent of the next round highlighted (Algorithm 3, line 2)."""

import struct
import zlib

import numpy as np
from numpy.typing import NDArray

from mansion_geometry.compiled import Floats, Ints

__all__ = ["png_bytes", "render_preview"]

PARENT = (255, 196, 61)
OBSTACLE = (70, 70, 70)
OUTSIDE = (255, 255, 255)
WALL = (25, 25, 25)


def png_bytes(pixels: NDArray[np.uint8]) -> bytes:
    """Encode (rows, columns, 3) pixels as a PNG image."""

    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    rows, columns, _ = pixels.shape
    raw = np.zeros((rows, 1 + 3 * columns), np.uint8)
    raw[:, 1:] = pixels.reshape(rows, 3 * columns)
    header = struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0)
    return (
        b"\x89PNG\r\n\x1a\n"
        + chunk(b"IHDR", header)
        + chunk(b"IDAT", zlib.compress(raw.tobytes(), 6))
        + chunk(b"IEND", b"")
    )


def render_preview(
    xs: Floats, ys: Floats, labels: Ints, parent: int, rooms: int, outside: int, size: int = 384
) -> bytes:
    """Render labelled cells from above, y up, with walls dark and the parent highlighted.

    Parameters
    ----------
    xs, ys : arrays
        Grid lines.
    labels : (rows, columns) int array
    parent, rooms, outside : int
        Label to highlight, first label that is no room, label of the outside.
    size : int
        Longer side in pixels.
    """
    low = np.array([xs[1], ys[1]])
    span = np.array([xs[-2], ys[-2]]) - low
    scale = (size - 8) / float(span.max())
    shape = np.ceil(span * scale).astype(int) + 8
    x = low[0] + (np.arange(shape[0]) - 4 + 0.5) / scale
    y = low[1] + (np.arange(shape[1]) - 4 + 0.5) / scale
    column = np.clip(np.searchsorted(xs, x, side="right") - 1, 0, labels.shape[1] - 1)
    row = np.clip(np.searchsorted(ys, y, side="right") - 1, 0, labels.shape[0] - 1)
    value = labels[np.ix_(row, column)][::-1]
    pixels = np.empty((*value.shape, 3), np.uint8)
    shade = (value * 37) % 60
    pixels[:] = np.stack([190 - shade, 205 - shade // 2, 225 - shade // 3], -1)
    pixels[(value >= rooms) & (value != parent)] = OBSTACLE
    pixels[value == outside] = OUTSIDE
    pixels[value > outside] = (200, 220, 200)
    pixels[value == parent] = PARENT
    edge = np.zeros(value.shape, bool)
    edge[1:] |= value[1:] != value[:-1]
    edge[:, 1:] |= value[:, 1:] != value[:, :-1]
    pixels[edge] = WALL
    return png_bytes(pixels)

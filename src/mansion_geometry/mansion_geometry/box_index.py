"""A grid over the plane that tells which of many boxes can touch a small region (a uniform bucket index)."""

import math

import numpy as np

from mansion_geometry.compiled import Floats, Labels, kernel

__all__ = ["box_buckets", "bucket_of"]


_MOST = 64
"""Most buckets along an axis."""


@kernel
def bucket_of(value: float, low: float, size: float, count: int) -> int:
    """Return the bucket that a coordinate falls in; what lies outside counts for the first or last."""
    return int(min(count - 1, max(0, math.floor((value - low) / size))))


@kernel
def box_buckets(boxes: Floats, least: float) -> tuple[float, float, float, int, Labels, Labels]:
    """Sort boxes into square buckets, each box into every bucket that its bounding square touches.

    Parameters
    ----------
    boxes : (m, 6) array
        See `mansion_geometry.boxes`.
    least : float
        Least side of a bucket, metres.

    Returns
    -------
    x0, y0, size : float
        Lower left corner and side of the first bucket.
    across : int
        Buckets along each axis; bucket (row, column) has the number ``row * across + column``.
    starts : (across * across + 1,) array
        Where each bucket's entries begin in `items`.
    items : (n,) array
        Indices of boxes, ascending within a bucket.
    """
    x0, y0, x1, y1 = math.inf, math.inf, -math.inf, -math.inf
    m = boxes.shape[0]
    for i in range(m):
        r = math.hypot(boxes[i, 4], boxes[i, 5])
        x0, x1 = min(x0, boxes[i, 0] - r), max(x1, boxes[i, 0] + r)
        y0, y1 = min(y0, boxes[i, 1] - r), max(y1, boxes[i, 1] + r)
    if m == 0:
        x0, y0, x1, y1 = 0.0, 0.0, 0.0, 0.0
    span = max(x1 - x0, y1 - y0)
    across = int(min(_MOST, max(1, math.floor(span / least))))
    size = max(span / across, 1e-6)
    starts = np.zeros(across * across + 1, dtype=np.int32)
    spans = np.empty((m, 4), dtype=np.int32)
    for i in range(m):
        r = math.hypot(boxes[i, 4], boxes[i, 5])
        spans[i, 0] = bucket_of(boxes[i, 1] - r, y0, size, across)
        spans[i, 1] = bucket_of(boxes[i, 1] + r, y0, size, across)
        spans[i, 2] = bucket_of(boxes[i, 0] - r, x0, size, across)
        spans[i, 3] = bucket_of(boxes[i, 0] + r, x0, size, across)
        for row in range(spans[i, 0], spans[i, 1] + 1):
            for col in range(spans[i, 2], spans[i, 3] + 1):
                starts[row * across + col + 1] += 1
    for b in range(across * across):
        starts[b + 1] += starts[b]
    items = np.empty(starts[-1], dtype=np.int32)
    filled = starts[:-1].copy()
    for i in range(m):
        for row in range(spans[i, 0], spans[i, 1] + 1):
            for col in range(spans[i, 2], spans[i, 3] + 1):
                at = row * across + col
                items[filled[at]] = i
                filled[at] += 1
    return x0, y0, size, across, starts, items

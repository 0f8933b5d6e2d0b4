"""Soft shading of corners and of what stands on something, for pictures that people look at.

Ambient occlusion in the plane of the picture (M. Mittring, "Finding Next Gen: CryEngine 2", SIGGRAPH 2007 courses), by
the depths on both sides of a pixel: on a flat face the reciprocal of depth is linear, however the face leans.
"""

import math
from typing import Final

import numpy as np

from mansion_geometry.compiled import Floats
from mansion_skills.vision.frame import Depth, Picture

__all__ = ["contact_shaded"]

RINGS: Final = (0.04, 0.07, 0.12, 0.19, 0.29, 0.42)
"""How far beside a pixel depths are compared, metres at the distance of the picture's middle depth."""

AXES: Final = 4
"""Directions in which the points of a ring are compared; each ring is turned against the one before."""

STRENGTH: Final = 1.0
"""How much darker the bottom of a deep hollow is."""

STANDS_BEFORE: Final = 1.6
"""What is nearer than the pixel by that many times its distance aside stands before it, and not beside it."""


def contact_shaded(rgb: Picture, depth: Depth, focal: float) -> Picture:
    """Return a picture with its hollows darker.

    Parameters
    ----------
    rgb : (height, width, 3) array of uint8
    depth : (height, width) array
        Along the optical axis, metres; infinite where nothing is seen.
    focal : float
        Pixels.
    """
    seen = np.isfinite(depth)
    if not seen.any():
        return rgb
    near = np.where(seen, 1.0 / np.maximum(depth, 1e-3), 0.0).astype(np.float64)
    middle = float(np.median(depth[seen]))
    margin = math.ceil(RINGS[-1] * focal / middle) + 1
    # Beyond the edges faces go on as they lean.
    wide = np.pad(near, margin, mode="reflect", reflect_type="odd")
    dark = np.zeros(depth.shape)
    for number, ring in enumerate(RINGS):
        reach = max(1.0, ring * focal / middle)
        for axis in range(AXES):
            angle = math.pi * (axis + 0.5 * (number % 2)) / AXES
            rows, columns = round(reach * math.sin(angle)), round(reach * math.cos(angle))
            dark += _hollow(near, wide, margin, rows, columns, math.hypot(rows, columns) / focal)
    dark = _smoothed(np.where(seen, dark / (AXES * len(RINGS)), 0.0))
    return np.asarray(np.clip(rgb * (1.0 - STRENGTH * dark)[..., None] + 0.5, 0.0, 255.0), dtype=np.uint8)


def _hollow(near: Floats, wide: Floats, margin: int, rows: int, columns: int, angle: float) -> Floats:
    """Tell how much nearer the two points some pixels aside are on average, 0 to 1 of their distance to the pixel.

    Parameters
    ----------
    near, wide : arrays
        Reciprocals of depths, of the picture and with a margin around it.
    angle : float
        Tangent of the angle between the pixel and either point.
    """
    height, width = near.shape
    depth = 1.0 / np.maximum(near, 1e-6)
    scale = depth / max(angle, 1e-6)
    first = wide[margin + rows : margin + rows + height, margin + columns : margin + columns + width]
    second = wide[margin - rows : margin - rows + height, margin - columns : margin - columns + width]
    steps = (first - near) * scale, (second - near) * scale
    nearest = np.maximum(*steps)
    fades = np.clip(2.0 * (STANDS_BEFORE - nearest), 0.0, 1.0)
    return np.asarray(fades * np.clip((steps[0] + steps[1]) / 2.0, 0.0, 1.0))


def _smoothed(values: Floats) -> Floats:
    """Return the means of five by five neighbours."""
    for axis in (0, 1):
        padded = np.pad(values, [(2, 2) if axis == side else (0, 0) for side in (0, 1)], mode="edge")
        parts = [np.take(padded, np.arange(k, k + values.shape[axis]), axis=axis) for k in range(5)]
        values = np.mean(parts, axis=0)
    return values

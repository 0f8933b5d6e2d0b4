"""Colours of a z-buffer's pixels: sun with soft shadows, dark where something nearer begins, glass on top."""

import numpy as np
import numpy.typing as npt

from mansion_geometry.compiled import kernel

__all__ = ["blend_glass", "shade_pixels"]

_EDGE, _HOLLOW = 0.16, 0.13
"""How much darker a pixel beside an edge gets, and one in the corner below something."""


@kernel
def _nearer(depth: npt.NDArray[np.float32], y: int, x: int, reach: int, most: float) -> float:
    """Count, to two, the neighbours at `reach` that are nearer to the eye, by at most `most` metres."""
    height, width = depth.shape
    here = depth[y, x]
    total = 0.0
    for dy, dx in ((-reach, 0), (reach, 0), (0, -reach), (0, reach)):
        j, i = y + dy, x + dx
        if j < 0 or i < 0 or j >= height or i >= width:
            continue
        step = depth[j, i] - here
        if 0.0 < step < most:
            total += min(step / 0.25, 1.0)
    return min(total, 2.0)


@kernel
def shade_pixels(
    depth: npt.NDArray[np.float32],
    index: npt.NDArray[np.int32],
    lighting: npt.NDArray[np.float64],
    colors: npt.NDArray[np.float64],
    shadow: npt.NDArray[np.float32],
    shadow_frame: tuple[float, float, float],
    view_frame: tuple[float, float, float],
    turn: npt.NDArray[np.float64],
    image: npt.NDArray[np.float32],
) -> None:
    """Colour the pixels that are hit.

    Parameters
    ----------
    depth, index : (height, width) arrays
        Towards the eye, metres; the triangle, -1 for none.
    lighting : (n, 5) array
        Of each triangle: shade without the sun, the sun's part, a step off the face in the light's axes.
    colors : (n, 3) array
    shadow : (rows, columns) array
        Depths towards the light.
    shadow_frame, view_frame : (x, y, length)
        Place of the first cell and metres a cell; place of the first pixel and pixels a metre.
    turn : (3, 3) array
        From the view's axes to the light's: ``place @ turn``.
    image : (height, width, 3) array
        Written.
    """
    height, width = depth.shape
    left, bottom, cell = shadow_frame
    x0, y0, scale = view_frame
    reach = max(2, int(np.round(0.12 * scale)))
    for y in range(height):
        for x in range(width):
            k = index[y, x]
            if k < 0:
                continue
            u, v, w = x0 + x / scale, y0 - y / scale, float(depth[y, x])
            shade = lighting[k, 0]
            if lighting[k, 1] > 0.0:
                a = u * turn[0, 0] + v * turn[1, 0] + w * turn[2, 0] + lighting[k, 2]
                b = u * turn[0, 1] + v * turn[1, 1] + w * turn[2, 1] + lighting[k, 3]
                c = u * turn[0, 2] + v * turn[1, 2] + w * turn[2, 2] + lighting[k, 4]
                i = min(max(int((a - left) / cell), 1), shadow.shape[1] - 2)
                j = min(max(int((b - bottom) / cell), 1), shadow.shape[0] - 2)
                lit = 0
                for dj, di in ((0, 0), (0, 1), (0, -1), (1, 0), (-1, 0)):
                    if c > shadow[j + dj, i + di] - 0.05:
                        lit += 1
                shade += lighting[k, 1] * lit / 5.0
            dark = _EDGE * _nearer(depth, y, x, 1, 1e9)
            dark += _HOLLOW * _nearer(depth, y, x, reach, 4.0)
            shade *= 1.0 - 0.5 * dark
            for channel in range(3):
                image[y, x, channel] = colors[k, channel] * shade


@kernel
def blend_glass(
    index: npt.NDArray[np.int32],
    colors: npt.NDArray[np.float64],
    alpha: npt.NDArray[np.float64],
    image: npt.NDArray[np.float32],
) -> None:
    """Lay the nearest glass over what is behind it.

    Parameters
    ----------
    index : (height, width) array
        The nearest triangle of glass, -1 for none.
    """
    for y in range(index.shape[0]):
        for x in range(index.shape[1]):
            k = index[y, x]
            if k >= 0:
                for channel in range(3):
                    image[y, x, channel] = image[y, x, channel] * (1.0 - alpha[k]) + colors[k, channel] * alpha[k]

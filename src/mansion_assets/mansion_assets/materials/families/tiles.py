"""Ceramic tiles with grout: square, in running bond, hexagonal, as a checkerboard."""

import numpy as np

from mansion_assets.materials.bonds import Pieces, courses, hexagons
from mansion_assets.materials.canvas import Canvas
from mansion_assets.materials.layers import Layers, mixed, smooth_step, tones
from mansion_geometry.compiled import Floats

__all__ = ["checkerboard", "hexagonal", "square"]


def _grouted(canvas: Canvas, pieces: Pieces, shade: Floats, grout: float, grey: float, cloud: float) -> Layers:
    """Part tiles by grout `grout` metres wide, whose shade is `grey`; `cloud` is how uneven a tile's glaze is."""
    gap = 1.0 - smooth_step(pieces.edge, 0.42 * grout, 0.62 * grout)
    rounded = smooth_step(pieces.edge, 0.4 * grout, grout + 0.002)
    sand = canvas.noise("sand", (0.001, 0.001))
    glaze = shade * (1.0 + cloud * canvas.clouds("glaze", 0.05, 3))[..., None]
    joint = np.full((*canvas.shape, 3), grey) * (1.0 + 0.05 * sand)[..., None]
    tilt = 0.0004 * (canvas.chances("tilt", pieces.number) - 0.5)
    height = 0.0016 * rounded + tilt * (1.0 - gap) + 0.00005 * sand * gap
    return Layers(mixed(glaze, joint, gap), height, mixed(np.ones(canvas.shape), np.full(canvas.shape, 2.2), gap))


def square(
    canvas: Canvas,
    length: float,
    width: float,
    shift: float = 0.0,
    grout: float = 0.003,
    grey: float = 0.84,
    variety: float = 0.03,
    cloud: float = 0.008,
) -> Layers:
    """Rectangular tiles in rows, every other row moved by `shift` of a length."""
    pieces = courses(canvas, length, width, (0.0, shift) if shift else (0.0,))
    tone = 1.0 + variety * (canvas.chances("tone", pieces.number) - 0.5)
    return _grouted(canvas, pieces, tones(tone), grout, grey, cloud)


def checkerboard(canvas: Canvas, length: float, light: float = 1.28, dark: float = 0.3) -> Layers:
    """Square tiles, alternately light and dark."""
    pieces = courses(canvas, length, length)
    columns = round(canvas.size[0] / length)
    even = (pieces.number // columns + pieces.number % columns) % 2 == 0
    tone = np.where(even, light, dark) * (1.0 + 0.04 * (canvas.chances("tone", pieces.number) - 0.5))
    return _grouted(canvas, pieces, tones(tone), 0.003, 0.8, 0.02)


def hexagonal(canvas: Canvas, columns: int, rows: int) -> Layers:
    """Hexagonal tiles with their points up."""
    pieces = hexagons(canvas, columns, rows)
    tone = 1.0 + 0.05 * (canvas.chances("tone", pieces.number) - 0.5)
    return _grouted(canvas, pieces, tones(tone), 0.004, 0.72, 0.008)

"""Metals, plastics, vinyl, rubber, lacquer, paper and glazes: smooth or finely grained sheets."""

import numpy as np

from mansion_assets.materials.bonds import cells, courses
from mansion_assets.materials.canvas import Canvas
from mansion_assets.materials.layers import Layers, smooth_step, tones

__all__ = ["brushed", "flakes", "grained", "pulp", "studs"]


def brushed(canvas: Canvas, contrast: float = 0.05) -> Layers:
    """Brushed metal: fine scratches along x."""
    lines = canvas.noise("lines", (0.12, 0.0006)) * 0.7 + canvas.noise("hairs", (0.03, 0.0006)) * 0.3
    return Layers(tones(1.0 + contrast * lines), 0.00001 * lines, 1.0 + 0.18 * lines)


def grained(canvas: Canvas, grain: float = 0.0015, depth: float = 0.00004, contrast: float = 0.012) -> Layers:
    """Moulded plastic, powder coat, lacquer or glaze: bumps of `grain` metres."""
    bumps = canvas.noise("bumps", (grain, grain))
    return Layers(tones(1.0 + contrast * bumps), depth * bumps, 1.0 + 0.06 * bumps)


def flakes(canvas: Canvas, size: float = 0.006, contrast: float = 0.1, width: float = 0.0) -> Layers:
    """Vinyl, linoleum or epoxy with flakes; in sheets of `width` metres with welded seams, if that is not 0."""
    pieces = cells(canvas, "flakes", size)
    lot = canvas.chances("flake", pieces.number)
    seen = 1.0 - smooth_step(pieces.along, 0.25 * size, 0.45 * size)
    value = 1.0 + contrast * seen * np.where(lot > 0.7, -1.0, np.where(lot < 0.25, 0.6, 0.0))
    value += 0.008 * canvas.clouds("broad", 0.1, 3)
    height = np.zeros(canvas.shape)
    if width:
        seam = 1.0 - smooth_step(courses(canvas, canvas.size[0], width).across, 0.001, 0.004)
        value, height = value * (1.0 - 0.1 * seam), 0.0002 * seam
    return Layers(tones(value), height, 1.0 + 0.05 * seen)


def studs(canvas: Canvas, step: float = 0.025) -> Layers:
    """Rubber sheet with round studs."""
    x, y = canvas.places
    columns, rows = (max(1, round(side / step)) for side in canvas.size)
    w, h = canvas.size[0] / columns, canvas.size[1] / rows
    away = np.hypot((x % w) - w / 2, (y % h) - h / 2)
    stud = 1.0 - smooth_step(away, 0.3 * step, 0.38 * step)
    value = 0.94 + 0.08 * stud + 0.02 * canvas.noise("dust", (0.004, 0.004))
    return Layers(tones(value), 0.0006 * stud, 1.0 - 0.1 * stud)


def pulp(canvas: Canvas) -> Layers:
    """Paper and card: short fibres in all directions."""
    fibres = canvas.noise("one", (0.006, 0.0008)) + canvas.noise("other", (0.0008, 0.006))
    return Layers(tones(1.0 + 0.012 * fibres), 0.00002 * fibres, np.ones(canvas.shape))

"""Stones: marble, granite, terrazzo, sawn blocks, rubble and gravel."""

import numpy as np

from mansion_assets.materials.bonds import cells, courses
from mansion_assets.materials.canvas import Canvas
from mansion_assets.materials.layers import Layers, colour, mixed, smooth_step, tones

__all__ = ["blocks", "granite", "gravel", "marble", "rubble", "terrazzo"]


def marble(canvas: Canvas, length: float = 0.0, veins: float = 0.2) -> Layers:
    """Polished marble with veins; in slabs of `length` metres where that is not 0."""
    warp = canvas.clouds("warp", 0.35, 5)
    shade = np.zeros(canvas.shape)
    for name, width, strength in (("main", 0.06, 1.0), ("fine", 0.03, 0.45)):
        line = np.abs(canvas.clouds(name, 0.3, 5) + 0.2 * warp)
        shade = np.maximum(shade, strength * (1.0 - smooth_step(line, 0.0, width * 2.2)))
    value = 1.0 - veins * shade * smooth_step(warp, -1.2, 0.8) - 0.025 * canvas.clouds("haze", 0.25, 3)
    height, rough = np.zeros(canvas.shape), np.ones(canvas.shape)
    if length:
        gap = 1.0 - smooth_step(courses(canvas, length, length).edge, 0.0004, 0.0018)
        value, height, rough = value * (1.0 - 0.22 * gap), -0.0006 * gap, 1.0 + 2.0 * gap
    return Layers(tones(value, -0.08), height, rough)


def granite(canvas: Canvas, contrast: float = 0.15) -> Layers:
    """Granite: light and dark crystals of a few millimetres."""
    pieces = cells(canvas, "crystals", 0.0035)
    crystal = canvas.chances("crystal", pieces.number)
    dark = (canvas.chances("mica", pieces.number) > 0.86) * 1.0
    value = 1.0 + contrast * (crystal - 0.5) - 1.6 * contrast * dark + 0.04 * canvas.clouds("broad", 0.04, 2)
    return Layers(tones(value), np.zeros(canvas.shape), 1.0 + 0.2 * (crystal - 0.5))


def terrazzo(canvas: Canvas, ground: str, chips: list[str]) -> Layers:
    """Polished terrazzo: chips of several colours and sizes in a ground."""
    shade = colour(ground) * (1.0 + 0.02 * canvas.clouds("ground", 0.1, 3))[..., None]
    palette = np.array([colour(text) for text in chips])
    for name, size in (("coarse", 0.022), ("fine", 0.011)):
        pieces = cells(canvas, name, size)
        reach = size * (0.2 + 0.28 * canvas.chances(f"{name} reach", pieces.number))
        wobble = 1.0 + 0.25 * canvas.noise(f"{name} wobble", (size / 2, size / 2))
        chip = 1.0 - smooth_step(pieces.along * wobble - reach, -0.0008, 0.0008)
        pick = (canvas.chances(f"{name} colour", pieces.number) * len(palette)).astype(np.int64)
        shade = mixed(shade, palette[pick], chip)
    return Layers(shade, np.zeros(canvas.shape), np.ones(canvas.shape), own_colours=True)


def blocks(
    canvas: Canvas, length: float, width: float, joint: float = 0.006, variety: float = 0.16, rough: float = 1.0
) -> Layers:
    """Sawn blocks in running bond, such as sandstone, paving or cladding; `rough` is how uneven their faces are."""
    pieces = courses(canvas, length, width, (0.0, 0.5, 0.2, 0.7))
    gap = 1.0 - smooth_step(pieces.edge, 0.25 * joint, joint)
    bed = canvas.noise("bed", (0.25, 0.03))
    pits = canvas.clouds("pits", 0.02, 3)
    tone = variety * (canvas.chances("tone", pieces.number) - 0.5)
    value = (1.0 + tone + 0.03 * bed + 0.035 * pits) * (1.0 - 0.35 * gap)
    lift = 0.002 * rough * canvas.chances("lift", pieces.number)
    return Layers(tones(value, 0.2), 0.0007 * rough * pits + lift * (1.0 - gap) - 0.003 * gap, 1.0 + 0.05 * pits)


def rubble(canvas: Canvas, size: float) -> Layers:
    """Split stones of irregular shape with wide joints."""
    pieces = cells(canvas, "stones", size)
    gap = 1.0 - smooth_step(pieces.edge, 0.003, 0.009)
    pits = canvas.clouds("pits", 0.03, 4)
    tone = 0.3 * (canvas.chances("tone", pieces.number) - 0.5)
    value = (1.0 + tone + 0.05 * pits) * (1.0 - 0.4 * gap)
    return Layers(tones(value, 0.25), 0.002 * pits - 0.008 * gap, np.ones(canvas.shape))


def gravel(canvas: Canvas) -> Layers:
    """Loose gravel, as it lies on flat roofs."""
    pieces = cells(canvas, "pebbles", 0.024)
    round_ = smooth_step(pieces.edge, 0.0, 0.007)
    tone = 0.5 * (canvas.chances("tone", pieces.number) - 0.5)
    value = (1.0 + tone) * (0.62 + 0.38 * round_) + 0.05 * canvas.clouds("broad", 0.1, 2)
    return Layers(tones(value, 0.15), 0.006 * round_, np.ones(canvas.shape))

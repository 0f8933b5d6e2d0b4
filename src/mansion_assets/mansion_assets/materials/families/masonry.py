"""Masonry: bricks, concrete, plaster and render, and panels of facades and ceilings."""

import numpy as np

from mansion_assets.materials.bonds import cells, courses
from mansion_assets.materials.canvas import Canvas
from mansion_assets.materials.layers import Layers, colour, mixed, smooth_step, tones

__all__ = ["acoustic", "bricks", "concrete", "panels", "plaster", "roof_tiles", "wallpaper"]


def bricks(canvas: Canvas, brick: str, mortar: str, variety: float = 0.22) -> Layers:
    """Bricks of 240 by 71 mm in running bond with joints of 10 mm."""
    pieces = courses(canvas, 0.25, 0.0833, (0.0, 0.5))
    worn = canvas.noise("worn", (0.02, 0.02)) * 0.0012
    gap = 1.0 - smooth_step(pieces.edge + worn, 0.0042, 0.0068)
    grit = canvas.clouds("grit", 0.012, 4)
    tone = 1.0 + variety * (canvas.chances("tone", pieces.number) - 0.5) + 0.05 * grit
    burnt = (canvas.chances("burnt", pieces.number) > 0.87) * 0.18
    face = colour(brick) * tones(tone - burnt, 0.1)
    joint = colour(mortar) * (1.0 + 0.04 * canvas.noise("sand", (0.002, 0.002)))[..., None]
    height = 0.0006 * grit + 0.001 * canvas.chances("lift", pieces.number) - 0.006 * gap
    return Layers(mixed(face, joint, gap), height, 1.0 + 0.05 * grit, own_colours=True)


def concrete(canvas: Canvas, stains: float = 0.035, pores: float = 1.0) -> Layers:
    """Cast concrete: stains of the formwork, and pores."""
    cloud = canvas.clouds("cloud", 0.22, 5)
    grain = canvas.noise("grain", (0.004, 0.004))
    holes = cells(canvas, "pores", 0.045)
    reach = 0.004 * canvas.chances("reach", holes.number) - 0.0015
    pore = pores * (1.0 - smooth_step(holes.along - reach, -0.0008, 0.0012))
    value = 1.0 + stains * cloud + 0.018 * grain - 0.3 * pore
    return Layers(tones(value, 0.1), 0.0001 * grain - 0.0015 * pore, 1.0 + 0.08 * cloud)


def plaster(canvas: Canvas, grain: float = 0.008, depth: float = 0.00012, contrast: float = 0.007) -> Layers:
    """Plaster, rolled paint or render: grains of `grain` metres, `depth` metres high."""
    bumps = canvas.noise("bumps", (grain, grain)) + 0.4 * canvas.noise("fine", (grain / 2.5, grain / 2.5))
    broad = canvas.clouds("broad", 0.06, 2)
    return Layers(tones(1.0 + contrast * (0.8 * bumps + 0.35 * broad)), depth * bumps, 1.0 + 0.02 * bumps)


def wallpaper(canvas: Canvas, stripe: float = 0.06, contrast: float = 0.07) -> Layers:
    """Woven wallpaper with stripes and a small sprig on each second one."""
    x, y = canvas.places
    count = 2 * max(1, round(canvas.size[0] / stripe / 2))
    step = canvas.size[0] / count
    band = np.floor(x / step).astype(np.int64) % 2
    rows = max(1, round(canvas.size[1] / (2 * step)))
    dx, dy = x % step - step / 2, (y % (canvas.size[1] / rows)) - canvas.size[1] / rows / 2
    petals = np.hypot(dx, dy) - 0.2 * step * (0.65 + 0.35 * np.cos(5 * np.arctan2(dy, dx)))
    sprig = (1.0 - smooth_step(petals, -0.0006, 0.0006)) * band
    weave = 0.5 * canvas.noise("warp", (0.0006, 0.01)) + 0.5 * canvas.noise("weft", (0.01, 0.0006))
    value = 1.0 - contrast * band - 1.6 * contrast * sprig + 0.012 * weave
    return Layers(tones(value, 0.15), 0.00005 * weave + 0.0001 * sprig, np.ones(canvas.shape))


def panels(canvas: Canvas, length: float, width: float, joint: float = 0.01, shine: float = 0.3) -> Layers:
    """Large panels with open joints: of metal, concrete or resin; `shine` is how unevenly they shine."""
    pieces = courses(canvas, length, width)
    gap = 1.0 - smooth_step(pieces.edge, 0.3 * joint, 0.6 * joint)
    tone = 0.035 * (canvas.chances("tone", pieces.number) - 0.5)
    cloud = canvas.clouds("cloud", 0.4, 3)
    value = (1.0 + tone + 0.012 * cloud) * (1.0 - 0.55 * gap)
    return Layers(tones(value), -0.004 * gap, 1.0 + 0.1 * shine * cloud)


def roof_tiles(canvas: Canvas, length: float, width: float, bulge: float = 0.02) -> Layers:
    """Roof tiles or slates in courses that overlap; `bulge` is how far each rises at its middle, metres."""
    pieces = courses(canvas, width, length, (0.0, 0.5))
    grit = canvas.noise("grit", (0.004, 0.004))
    tone = 0.22 * (canvas.chances("tone", pieces.number) - 0.5)
    arch = np.sin(np.pi * np.clip(pieces.along / width, 0.0, 1.0))
    overlap = smooth_step(pieces.across, 0.0, 0.05 * length)
    seam = 1.0 - smooth_step(np.minimum(pieces.along, width - pieces.along), 0.001, 0.006)
    value = (1.0 + tone + 0.03 * grit) * (0.55 + 0.45 * overlap) * (1.0 - 0.35 * seam) * (0.86 + 0.14 * arch)
    return Layers(tones(value, 0.15), bulge * arch + 0.01 * pieces.across / length, 1.0 + 0.03 * grit)


def acoustic(canvas: Canvas, length: float = 0.6) -> Layers:
    """Ceiling boards of mineral fibre, with fissures, on a grid of white rails."""
    pieces = courses(canvas, length, length)
    rail = 1.0 - smooth_step(pieces.edge, 0.011, 0.013)
    shadow = smooth_step(pieces.edge, 0.012, 0.02)
    holes = cells(canvas, "fissures", 0.013)
    hole = 1.0 - smooth_step(holes.along - 0.0026 * canvas.chances("reach", holes.number), -0.0006, 0.001)
    value = (1.0 - 0.2 * hole * (1.0 - rail)) * (0.88 + 0.12 * np.maximum(shadow, rail))
    return Layers(tones(value), 0.003 * rail - 0.001 * hole, np.ones(canvas.shape))

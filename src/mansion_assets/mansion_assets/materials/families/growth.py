"""Plants, soil and food: leaves, grass, earth, and the skins of fruit and bread."""

import numpy as np

from mansion_assets.materials.bonds import cells, courses
from mansion_assets.materials.canvas import Canvas
from mansion_assets.materials.layers import Layers, smooth_step, tones

__all__ = ["grass", "leaves", "skin", "soil"]


def leaves(canvas: Canvas) -> Layers:
    """Foliage: leaves with a midrib and side veins, lighter and darker."""
    pieces = courses(canvas, 0.05, 0.025, (0.0, 0.5))
    length, width = 0.05, 0.025
    middle = pieces.across - width / 2
    rib = 1.0 - smooth_step(np.abs(middle), 0.0, 0.0012)
    slant = (pieces.along - 0.8 * np.abs(middle)) % 0.006
    vein = 0.5 * (1.0 - smooth_step(np.minimum(slant, 0.006 - slant), 0.0, 0.0011))
    outline = np.abs(middle) / (0.5 * width * np.sin(np.pi * np.clip(pieces.along / length, 0.0, 1.0)) + 1e-6)
    shadow = smooth_step(outline, 0.85, 1.15)
    tone = 0.22 * (canvas.chances("tone", pieces.number) - 0.5)
    value = (1.0 + tone + 0.12 * np.maximum(rib, vein)) * (1.0 - 0.45 * shadow)
    return Layers(tones(value, 0.05), 0.001 * (1.0 - shadow) - 0.0003 * rib, 1.0 + 0.2 * shadow)


def grass(canvas: Canvas) -> Layers:
    """Mown lawn: blades in tufts, lighter and darker."""
    pieces = cells(canvas, "tufts", 0.03)
    blades = canvas.noise("blades", (0.003, 0.012)) + canvas.noise("slanted", (0.009, 0.004))
    tone = 0.2 * (canvas.chances("tone", pieces.number) - 0.5)
    value = 1.0 + tone + 0.09 * blades + 0.06 * canvas.clouds("patches", 0.7, 3)
    return Layers(tones(value, 0.12), 0.004 * blades, np.ones(canvas.shape))


def soil(canvas: Canvas) -> Layers:
    """Potting soil: crumbs."""
    pieces = cells(canvas, "crumbs", 0.008)
    crumb = smooth_step(pieces.edge, 0.0, 0.003)
    tone = 0.35 * (canvas.chances("tone", pieces.number) - 0.5)
    return Layers(tones((1.0 + tone) * (0.6 + 0.4 * crumb), 0.2), 0.003 * crumb, np.ones(canvas.shape))


def skin(canvas: Canvas) -> Layers:
    """Fruit, bread and other food: mottled."""
    spots = canvas.clouds("spots", 0.02, 3)
    return Layers(tones(1.0 + 0.03 * spots, 0.3), 0.0002 * spots, 1.0 + 0.1 * spots)

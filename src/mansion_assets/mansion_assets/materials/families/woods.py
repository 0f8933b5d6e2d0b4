"""Woods: veneer, painted wood, cork, and floors of strips, planks and herringbone."""

import numpy as np

from mansion_assets.materials.bonds import Pieces, courses, herringbone
from mansion_assets.materials.canvas import Canvas
from mansion_assets.materials.layers import Layers, smooth_step, tones
from mansion_geometry.compiled import Floats

__all__ = ["boards", "cork", "painted", "parquet", "veneer"]


def _grain(canvas: Canvas, ring: float) -> tuple[Floats, Floats]:
    """Return growth rings and fibres that run along x, both of mean 0, about -1 to 1; `ring` is metres a ring."""
    _, y = canvas.places
    count = max(1, round(canvas.size[1] / ring))
    bend = canvas.noise("bend", (0.5, 0.08)) * 0.55 + canvas.noise("wave", (0.15, 0.02)) * 0.08
    phase = (count * y / canvas.size[1] + bend) % 1.0
    rings = 2.0 * phase**2.2 - 0.6
    fibres = canvas.noise("fibres", (0.10, 0.0012)) * 0.6 + canvas.noise("pores", (0.02, 0.0006)) * 0.4
    return rings, np.clip(fibres / 2.0, -1.0, 1.0)


def veneer(canvas: Canvas, ring: float = 0.03, contrast: float = 0.13) -> Layers:
    """Sawn or veneered wood, its grain along x."""
    rings, fibres = _grain(canvas, ring)
    value = 1.0 - contrast * (0.5 * rings + 0.55 * fibres) + 0.03 * canvas.noise("broad", (0.6, 0.1))
    return Layers(tones(value, 0.3), 0.00006 * fibres, 1.0 + 0.08 * fibres)


def painted(canvas: Canvas) -> Layers:
    """Painted wood: even, with the faint strokes of a roller."""
    strokes = canvas.noise("strokes", (0.06, 0.003)) * 0.7 + canvas.noise("orange peel", (0.004, 0.004)) * 0.5
    return Layers(tones(1.0 + 0.008 * strokes), 0.00004 * strokes, 1.0 + 0.05 * strokes)


def cork(canvas: Canvas) -> Layers:
    """Pressed cork: light and dark grains."""
    grains = canvas.noise("grains", (0.004, 0.004)) + 0.5 * canvas.noise("dust", (0.0015, 0.0015))
    return Layers(tones(1.0 + 0.09 * np.clip(grains, -2.5, 1.5), 0.2), 0.0003 * grains, np.ones(canvas.shape))


def _laid(canvas: Canvas, pieces: Pieces, joint: float, contrast: float, variety: float, wear: float) -> Layers:
    """Give each piece wood of its own and part the pieces by joints `joint` metres wide."""
    rings, fibres = _grain(canvas, 0.03)
    x = pieces.along + canvas.chances("from x", pieces.number) * canvas.size[0]
    y = pieces.across + canvas.chances("from y", pieces.number) * canvas.size[1]
    ring, fibre = canvas.sample(rings, x, y), canvas.sample(fibres, x, y)
    tone = variety * (canvas.chances("tone", pieces.number) - 0.5)
    used = wear * canvas.clouds("wear", 0.2, 3)
    value = 1.0 + tone - contrast * (0.5 * ring + 0.6 * fibre) - 0.05 * used
    gap = 1.0 - smooth_step(pieces.edge, 0.3 * joint, joint)
    warmth = 0.3 * (canvas.chances("warmth", pieces.number) - 0.2)
    shade = tones(value, 0.28) * (1.0 + np.array([0.05, 0.0, -0.05]) * warmth[..., None])
    shade *= (1.0 - 0.5 * gap)[..., None]
    return Layers(shade, 0.0001 * fibre - 0.0012 * gap, 1.0 + 0.1 * fibre + 0.1 * used + 0.3 * gap)


def boards(
    canvas: Canvas,
    length: float,
    width: float,
    joint: float = 0.002,
    contrast: float = 0.16,
    variety: float = 0.16,
    wear: float = 0.0,
) -> Layers:
    """Strips, planks, decking or cladding: boards along x, their ends spread over three or more courses."""
    pieces = courses(canvas, length, width, (0.0, 0.62, 0.27, 0.81))
    return _laid(canvas, pieces, joint, contrast, variety, wear)


def parquet(canvas: Canvas, repeats: int, ratio: int, contrast: float = 0.14, variety: float = 0.2) -> Layers:
    """Herringbone parquet; see `mansion_assets.materials.bonds.herringbone`."""
    return _laid(canvas, herringbone(canvas, repeats, ratio), 0.0016, contrast, variety, 0.0)

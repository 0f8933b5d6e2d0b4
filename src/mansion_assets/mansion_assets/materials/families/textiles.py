"""Fabrics by weave, knitted and pile fabrics, carpets, and leather."""

import numpy as np

from mansion_assets.materials.bonds import cells
from mansion_assets.materials.canvas import Canvas
from mansion_assets.materials.layers import Layers, smooth_step, tones

__all__ = ["carpet", "leather", "towelling", "weave"]


def weave(canvas: Canvas, thread: float, over: int = 1, slub: float = 0.1) -> Layers:
    """Woven cloth: plain where a thread goes over one thread, twill over two.

    Parameters
    ----------
    thread : float
        Metres from thread to thread.
    over : int
    slub : float
        How unevenly threads are dyed.
    """
    x, y = canvas.places
    period = 2 * over
    columns, rows = (period * max(1, round(side / thread / period)) for side in canvas.size)
    u, v = x / canvas.size[0] * columns, y / canvas.size[1] * rows
    i, j = np.floor(u).astype(np.int64), np.floor(v).astype(np.int64)
    upright = (i + j) % period < over
    a, b = u - i - 0.5, v - j - 0.5
    round_ = np.sqrt(np.clip(1.0 - (2 * np.where(upright, a, b)) ** 2 * 0.9, 0.0, 1.0))
    sunk = 1.0 - 0.35 * (2 * np.where(upright, b, a)) ** 2
    warp, weft = canvas.chances("warp", i), canvas.chances("weft", j)
    dyed = np.where(upright, warp, weft) - 0.5 + 0.25 * canvas.noise("fibre", (0.003, 0.003))
    melange = canvas.noise("melange", (0.03, 0.008)) + canvas.noise("melange across", (0.008, 0.03))
    value = 0.72 + 0.3 * round_ * sunk + slub * dyed + 0.022 * melange
    return Layers(tones(value), 0.35 * thread * round_ * sunk, np.ones(canvas.shape))


def towelling(canvas: Canvas) -> Layers:
    """Soft pile: towels, bedding and plush."""
    loops = canvas.noise("loops", (0.0022, 0.0022))
    folds = canvas.clouds("folds", 0.12, 3)
    value = 1.0 + 0.04 * loops + 0.01 * folds
    return Layers(tones(value), 0.0004 * loops + 0.0006 * folds, np.ones(canvas.shape))


def carpet(canvas: Canvas, tuft: float = 0.006, contrast: float = 0.16, tile: float = 0.0) -> Layers:
    """Carpet of loops `tuft` metres apart; in squares of `tile` metres, their pile turned by turns, if not 0."""
    pieces = cells(canvas, "tufts", tuft)
    loop = 1.0 - smooth_step(pieces.along, 0.0, 0.75 * tuft)
    dyed = canvas.chances("dye", pieces.number) - 0.5
    value = 1.0 - contrast * (0.75 - loop) + contrast * 1.1 * dyed + 0.02 * canvas.clouds("trodden", 0.12, 3)
    if tile:
        x, y = canvas.places
        turned = (np.floor(x / tile).astype(np.int64) + np.floor(y / tile).astype(np.int64)) % 2
        edge = np.minimum(np.minimum(x % tile, tile - x % tile), np.minimum(y % tile, tile - y % tile))
        value = (value + 0.05 * (turned - 0.5)) * (1.0 - 0.12 * (1.0 - smooth_step(edge, 0.0, 0.004)))
    return Layers(tones(value), 0.0025 * loop, np.ones(canvas.shape))


def leather(canvas: Canvas) -> Layers:
    """Grained leather: small pebbles parted by creases."""
    pieces = cells(canvas, "pebbles", 0.0045)
    crease = 1.0 - smooth_step(pieces.edge, 0.0, 0.0011)
    broad = canvas.clouds("broad", 0.05, 3)
    value = 1.0 - 0.2 * crease + 0.03 * broad + 0.04 * (canvas.chances("tone", pieces.number) - 0.5)
    return Layers(tones(value, 0.2), 0.0004 * (1.0 - crease), 1.0 + 0.25 * crease)

"""Pictures for frames and screens: paintings, posters, maps, and what a display shows. None repeats."""

from collections.abc import Sequence

import numpy as np

from mansion_assets.materials.canvas import Canvas
from mansion_assets.materials.layers import Layers, colour, mixed, smooth_step
from mansion_geometry.compiled import Bools, Floats
from mansion_geometry.randomness import item_generator

__all__ = [
    "botanical",
    "chart",
    "circles",
    "city",
    "document",
    "fields",
    "hills",
    "interface",
    "readout",
    "reflection",
    "world_map",
]


def _ground(canvas: Canvas, text: str) -> Floats:
    return np.broadcast_to(colour(text), (*canvas.shape, 3)).copy()


def _painted(canvas: Canvas, shade: Floats, *, brush: float = 0.02) -> Layers:
    """Return a picture with the strokes of a brush."""
    strokes = canvas.noise("strokes", (0.02, 0.004)) * brush
    return Layers(shade * (1.0 + strokes)[..., None], 0.0004 * strokes / 0.02, np.ones(canvas.shape), own_colours=True)


def _lit(canvas: Canvas, shade: Floats) -> Layers:
    """Return what a flat screen shows."""
    return Layers(shade, np.zeros(canvas.shape), np.ones(canvas.shape), own_colours=True)


def reflection(canvas: Canvas, sky: Sequence[str], ground: str) -> Layers:
    """What panes of glass mirror by day: the sky from its first to its last colour with a bank of light, the ground."""
    x, y = canvas.places
    shade = mixed(_ground(canvas, sky[0]), _ground(canvas, sky[-1]), smooth_step(y, 0.0, 0.75))
    shade = mixed(shade, _ground(canvas, ground), smooth_step(y, 0.62, 1.0))
    across = (x + 0.55 * y) % 1.0
    bank = smooth_step(across, 0.1, 0.3) * (1.0 - smooth_step(across, 0.42, 0.5))
    return _lit(canvas, shade * (0.86 + 0.2 * bank)[..., None])


def _inside(canvas: Canvas, x: tuple[float, float], y: tuple[float, float]) -> Bools:
    """Tell which texels lie in a rectangle, in shares of the picture from its upper left corner."""
    across, down = canvas.places
    return (across >= x[0]) & (across < x[1]) & (down >= y[0]) & (down < y[1])


def _fill(shade: Floats, where: Bools, text: str) -> Floats:
    return mixed(shade, np.broadcast_to(colour(text), shade.shape), where * 1.0)


def hills(canvas: Canvas, sky: Sequence[str], ridges: Sequence[str]) -> Layers:
    """Landscape: a sky from its first to its last colour, a sun, and ridges from far to near."""
    x, y = canvas.places
    shade = mixed(_ground(canvas, sky[0]), _ground(canvas, sky[-1]), smooth_step(y, 0.0, 0.6))
    disc = 1.0 - smooth_step(np.hypot(x - 0.68, y - 0.26), 0.065, 0.075)
    shade = mixed(shade, _ground(canvas, "#fff3cf"), disc)
    for k, text in enumerate(ridges):
        bend = canvas.noise(f"ridge {k}", (0.16 / (1 + 0.3 * k), 1.0))[0]
        line = 0.42 + 0.52 * k / len(ridges) + 0.05 * bend[None, :]
        shade = mixed(shade, _ground(canvas, text), smooth_step(y - line, -0.004, 0.004))
    return _painted(canvas, shade)


def fields(canvas: Canvas, ground: str, blocks: Sequence[str]) -> Layers:
    """Abstract: soft-edged fields of colour one above the other."""
    x, y = canvas.places
    shade = _ground(canvas, ground)
    wobble = 0.012 * canvas.clouds("wobble", 0.1, 3)
    for k, text in enumerate(blocks):
        low, high = 0.07 + 0.9 * k / len(blocks), 0.9 * (k + 1) / len(blocks) + 0.04
        inner = np.minimum.reduce([x - 0.09, 0.91 - x, y - low, high - y]) + wobble
        shade = mixed(shade, _ground(canvas, text), smooth_step(inner, -0.01, 0.03))
    return _painted(canvas, shade, brush=0.035)


def circles(canvas: Canvas, ground: str, palette: Sequence[str], count: int = 9) -> Layers:
    """Abstract: discs, rings and bars over each other."""
    x, y = canvas.places
    shade = _ground(canvas, ground)
    rng = item_generator(0, canvas.name, "shapes")
    for k in range(count):
        cx, cy, r = rng.uniform(0.2, 0.8), rng.uniform(0.2, 0.8), rng.uniform(0.06, 0.22)
        kind, angle = k % 3, rng.uniform(0.0, np.pi)
        if kind == 2:
            u = (x - cx) * np.cos(angle) + (y - cy) * np.sin(angle)
            v = (y - cy) * np.cos(angle) - (x - cx) * np.sin(angle)
            away = np.maximum(np.abs(u) - 1.8 * r, np.abs(v) - 0.12 * r)
        else:
            away = np.hypot(x - cx, y - cy) - r
            away = np.abs(away) - 0.15 * r if kind == 1 else away
        shade = mixed(shade, _ground(canvas, palette[k % len(palette)]), 1.0 - smooth_step(away, -0.002, 0.002))
    return _painted(canvas, shade)


def botanical(canvas: Canvas, ground: str, leaf: str, flower: str) -> Layers:
    """Print of a plant: a bent stem with leaves in pairs and a flower."""
    x, y = canvas.places
    shade = _ground(canvas, ground)
    stem = 0.5 + 0.06 * np.sin(4.0 * y)
    drawn = 1.0 - smooth_step(np.abs(x - stem), 0.004, 0.008)
    shade = mixed(shade, _ground(canvas, leaf), drawn * ((y > 0.24) & (y < 0.92)))
    for k in range(6):
        for side in (-1, 1):
            cy = 0.36 + 0.09 * k + 0.02 * side
            cx = 0.5 + 0.06 * np.sin(4.0 * cy) + side * 0.11
            u = (x - cx) * np.cos(0.5) + side * (y - cy) * np.sin(0.5)
            v = -side * (x - cx) * np.sin(0.5) + (y - cy) * np.cos(0.5)
            blade = (u / 0.12) ** 2 + (v / 0.035) ** 2
            tone = colour(leaf) * (0.85 + 0.06 * k)
            vein = np.clip(np.abs(v) / 0.004, 0.7, 1.0)[..., None]
            shade = mixed(shade, tone * vein, 1.0 - smooth_step(blade, 0.9, 1.05))
    angle = np.arctan2(y - 0.2, x - 0.55)
    petals = np.hypot(x - 0.55, y - 0.2) - 0.08 * (0.7 + 0.3 * np.cos(6 * angle))
    shade = mixed(shade, _ground(canvas, flower), 1.0 - smooth_step(petals, -0.003, 0.003))
    heart = 1.0 - smooth_step(np.hypot(x - 0.55, y - 0.2), 0.018, 0.022)
    return _painted(canvas, mixed(shade, _ground(canvas, "#e2b64a"), heart), brush=0.012)


def city(canvas: Canvas, sky: Sequence[str], wall: str, light: str) -> Layers:
    """Skyline at dusk with lit windows."""
    x, y = canvas.places
    shade = mixed(_ground(canvas, sky[0]), _ground(canvas, sky[-1]), smooth_step(y, 0.0, 0.85))
    rng = item_generator(0, canvas.name, "towers")
    for layer in range(3):
        count = 7 + 3 * layer
        tops = 0.28 + 0.17 * layer + rng.uniform(0.0, 0.26, count)
        tower = np.minimum((x * count).astype(np.int64), count - 1)
        tone = colour(wall) * (1.5 - 0.4 * layer)
        body = (y > tops[tower]) * 1.0
        shade = mixed(shade, np.broadcast_to(tone, shade.shape), body)
        columns, rows = (x * count * 4).astype(np.int64), (y * 36).astype(np.int64)
        pane = ((x * count * 4) % 1.0 > 0.4) & ((y * 36) % 1.0 > 0.5) & (y > tops[tower] + 0.02)
        lit = rng.random((count * 4 + 1, 37))[columns, rows] > 0.6
        shade = mixed(shade, _ground(canvas, light), 0.85 * (pane & lit))
    return _painted(canvas, shade, brush=0.012)


def world_map(canvas: Canvas, sea: str, land: str) -> Layers:
    """Map: land and sea with contours, on a grid of degrees."""
    x, y = canvas.places
    ground = canvas.clouds("land", 0.22, 6)
    shade = mixed(_ground(canvas, sea), _ground(canvas, land), smooth_step(ground, 0.25, 0.29))
    high = smooth_step(ground, 0.8, 1.8)[..., None]
    shade = shade * (1.0 - 0.28 * high)
    coast = 1.0 - smooth_step(np.abs(ground - 0.27), 0.0, 0.06)
    grid = ((x * 12) % 1.0 < 0.03) | ((y * 8) % 1.0 < 0.02)
    return _painted(canvas, shade * (1.0 - 0.3 * coast - 0.12 * grid)[..., None], brush=0.004)


def _lines(canvas: Canvas, salt: str, x: tuple[float, float], y: tuple[float, float], rows: int) -> Bools:
    """Return lines of words of uneven length that fill a rectangle."""
    across, down = canvas.places
    row = np.clip(((down - y[0]) / (y[1] - y[0]) * rows).astype(np.int64), 0, rows - 1)
    lengths = item_generator(0, canvas.name, salt).uniform(0.35, 1.0, rows)
    words = canvas.noise(salt, (0.018, 0.0001))[0] > -0.9
    within = _inside(canvas, x, y) & (across < x[0] + (x[1] - x[0]) * lengths[row])
    written: Bools = within & ((down - y[0]) / (y[1] - y[0]) * rows % 1.0 < 0.5) & words[None, :]
    return written


def interface(canvas: Canvas) -> Layers:
    """Screen of a computer: a desktop with a window of text and a list beside it."""
    shade = mixed(_ground(canvas, "#2f5d92"), _ground(canvas, "#5f95c4"), smooth_step(canvas.places[1], 0.0, 1.0))
    shade = _fill(shade, _inside(canvas, (0.0, 1.0), (0.93, 1.0)), "#1d2a3c")
    shade = _fill(shade, _inside(canvas, (0.1, 0.92), (0.08, 0.86)), "#f4f6f8")
    shade = _fill(shade, _inside(canvas, (0.1, 0.92), (0.08, 0.15)), "#33475f")
    shade = _fill(shade, _inside(canvas, (0.1, 0.3), (0.15, 0.86)), "#dfe6ee")
    shade = _fill(shade, _lines(canvas, "list", (0.12, 0.28), (0.19, 0.8), 10), "#6f8298")
    shade = _fill(shade, _lines(canvas, "text", (0.34, 0.89), (0.19, 0.82), 16), "#56606c")
    return _lit(canvas, shade)


def document(canvas: Canvas) -> Layers:
    """Screen or sheet with a heading and text."""
    shade = _fill(_ground(canvas, "#e9ecef"), _inside(canvas, (0.1, 0.6), (0.08, 0.14)), "#2f4a6b")
    return _lit(canvas, _fill(shade, _lines(canvas, "text", (0.1, 0.9), (0.2, 0.92), 22), "#737b84"))


def chart(canvas: Canvas) -> Layers:
    """Poster or slide with a heading, bars and text."""
    shade = _fill(_ground(canvas, "#f5f2ea"), _inside(canvas, (0.08, 0.7), (0.07, 0.14)), "#2b3a4a")
    for k, height in enumerate((0.2, 0.34, 0.28, 0.45, 0.4, 0.55)):
        low = 0.1 + 0.13 * k
        where = _inside(canvas, (low, low + 0.09), (0.78 - 0.9 * height, 0.78))
        shade = _fill(shade, where, ("#c8573c", "#3f78a8", "#e0a93c")[k % 3])
    return _lit(canvas, _fill(shade, _lines(canvas, "text", (0.1, 0.88), (0.83, 0.94), 3), "#7a7a76"))


def readout(canvas: Canvas) -> Layers:
    """Small display of an appliance: figures and a curve on dark green."""
    x, y = canvas.places
    shade = _fill(_ground(canvas, "#123524"), _lines(canvas, "figures", (0.1, 0.9), (0.14, 0.5), 2), "#8ef0a4")
    curve = 0.75 + 0.1 * np.sin(9.0 * x) * np.sin(31.0 * x)
    return _lit(canvas, mixed(shade, _ground(canvas, "#8ef0a4"), 1.0 - smooth_step(np.abs(y - curve), 0.015, 0.03)))

"""Arrows over the view into a stair, for the directions that exist (skill card TakeStairs)."""

from typing import Any

import numpy as np

from mansion_skills.vision.drawing import DOWN, PAPER, UP, write
from mansion_skills.vision.frame import Picture

__all__ = ["with_arrows"]


def with_arrows(view: Picture, up: str | None, down: str | None) -> Picture:
    """Draw an arrow up and an arrow down, each with what is written below it; ``None`` where there is no way.

    Parameters
    ----------
    view : (h, w, 3) array of uint8
    up, down : str, optional
        ``Up to floor 3``, say.
    """
    from PIL import Image, ImageDraw

    picture = Image.fromarray(view).convert("RGBA")
    layer = Image.new("RGBA", picture.size, (0, 0, 0, 0))
    draw = ImageDraw.Draw(layer)
    width, height = picture.size
    for text, sign, x, color in ((up, -1, 0.3, UP), (down, 1, 0.7, DOWN)):
        if text is not None:
            _arrow(draw, (width * x, height * 0.62), height * 0.17, sign, color)
            band = (width * (x - 0.19), height * 0.83, width * (x + 0.19), height * 0.92)
            draw.rounded_rectangle(band, height * 0.02, fill=(*color, 235))
            middle = (width * x, height * 0.875)
            size = round(height * 0.055)
            write(draw, middle, text, size, width=width * 0.36, fill=PAPER, anchor="mm")
    return np.array(Image.alpha_composite(picture, layer).convert("RGB"))


def _arrow(draw: Any, middle: tuple[float, float], reach: float, sign: int, color: tuple[int, int, int]) -> None:
    """Draw an arrow that points up (`sign` -1) or down (1)."""
    x, y = middle
    shape = [(0, 1), (0.75, 0.15), (0.32, 0.15), (0.32, -1), (-0.32, -1), (-0.32, 0.15), (-0.75, 0.15)]
    points = [(x + reach * u, y + sign * reach * v) for u, v in shape]
    draw.polygon(points, fill=(*color, 225), outline=(*PAPER, 255), width=3)

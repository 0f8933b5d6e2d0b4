"""Patterns of floor finishes: planks, tiles, weave and speckle, as grey textures that a material's colour tints."""

from dataclasses import dataclass
from io import BytesIO

import numpy as np
import numpy.typing as npt

__all__ = ["PATTERNS", "Pattern", "pattern_of", "pattern_png"]

PIXELS = 256

_Grey = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Pattern:
    """A pattern that repeats every `period` metres.

    Attributes
    ----------
    words : tuple of str
        A material whose name has one of them is laid so.
    """

    name: str
    period: float
    words: tuple[str, ...]


PATTERNS = (
    Pattern("tiles", 1.2, ("ceramic", "tile", "marble", "porcelain", "slate", "granite", "stone")),
    Pattern("planks", 1.6, ("oak", "wood", "plank", "parquet", "herringbone", "bamboo", "cork")),
    Pattern("weave", 0.8, ("carpet", "rug", "felt")),
    Pattern("speckle", 1.2, ("terrazzo", "concrete", "vinyl", "rubber", "epoxy", "screed")),
)


def pattern_of(material: str) -> Pattern | None:
    """Return how a floor of a material is laid; ``None`` for plain ones."""
    return next((p for p in PATTERNS if any(word in material for word in p.words)), None)


def pattern_png(pattern: Pattern) -> bytes:
    """Return a pattern as a PNG file of 256 x 256 pixels; always the same one."""
    from PIL import Image

    draw = {"tiles": _tiles, "planks": _planks, "weave": _weave, "speckle": _speckle}
    rng = np.random.default_rng([len(pattern.name), PIXELS])
    grey = np.clip(np.round(255 * draw[pattern.name](rng)), 0, 255).astype(np.uint8)
    file = BytesIO()
    Image.fromarray(np.repeat(grey[..., None], 3, axis=2)).save(file, "PNG")
    return file.getvalue()


def _tiles(rng: np.random.Generator) -> _Grey:
    """Two by two tiles with joints."""
    half = PIXELS // 2
    grey = np.repeat(np.repeat(rng.uniform(0.93, 1.0, (2, 2)), half, axis=0), half, axis=1)
    joint = np.arange(PIXELS) % half < 3
    grey[joint, :] = grey[:, joint] = 0.68
    return grey


def _planks(rng: np.random.Generator) -> _Grey:
    """Eight rows of boards, each with its own shade, grain and end."""
    rows, deep = 8, PIXELS // 8
    grey = np.empty((PIXELS, PIXELS))
    for row in range(rows):
        ends = np.sort(rng.integers(0, PIXELS, 2))
        shade = rng.uniform(0.82, 1.0, 2)
        along = np.arange(PIXELS)
        board = np.where((along >= ends[0]) & (along < ends[1]), shade[0], shade[1])
        grain = 1.0 + 0.03 * rng.standard_normal((deep, 1))
        strip = board[None, :] * grain
        strip[:2, :] = 0.62
        strip[:, ends] = 0.62
        grey[row * deep : (row + 1) * deep] = strip
    return grey


def _weave(rng: np.random.Generator) -> _Grey:
    """Short threads in squares that turn from one to the next."""
    grey = 0.94 + 0.05 * rng.standard_normal((PIXELS, PIXELS))
    quarter = (np.arange(PIXELS) // (PIXELS // 2)) % 2
    return grey - 0.035 * (quarter[:, None] ^ quarter[None, :])


def _speckle(rng: np.random.Generator) -> _Grey:
    """Chips of two sizes in an even ground."""
    grey = np.full((PIXELS, PIXELS), 0.97)
    for count, size, shade in ((260, 3, 0.8), (120, 5, 0.88)):
        for y, x in rng.integers(0, PIXELS - size, (count, 2)).tolist():
            grey[y : y + size, x : x + size] = shade
    return grey

"""Textures of materials for pictures: shrunk to a view's scale, and kept as long as they have room in memory."""

import io
import threading
from collections.abc import Callable, Hashable
from dataclasses import dataclass
from functools import cache
from typing import Final

import numpy as np

from mansion_assets.materials import material_set, set_names, texture_set
from mansion_export.meshes.model import Material
from mansion_geometry.compiled import Floats, Ints

__all__ = ["ArrayCache", "Tiles", "base_color", "texture_number", "tiles_at"]


SEEN = 0.02
"""How far a texel is from the mean at least, to be seen."""


class ArrayCache:
    """Arrays by what they were made from; beyond a number of bytes those go that were used longest ago.

    `functools.lru_cache` counts entries, which says little where one is a thousand times as large as another.

    Parameters
    ----------
    most : int
        Bytes of all arrays together; the latest one stays, however large it is.
    """

    def __init__(self, most: int) -> None:
        self._most = most
        self._guard = threading.Lock()
        self._arrays: dict[Hashable, Floats] = {}
        self._bytes = 0

    @property
    def size(self) -> int:
        """Bytes of what is kept."""
        return self._bytes

    def get(self, key: Hashable, make: Callable[[], Floats]) -> Floats:
        """Return the array of a key, which is made where it is not kept."""
        with self._guard:
            found = self._arrays.pop(key, None)
            if found is not None:
                self._arrays[key] = found
                return found
        made = make()
        with self._guard:
            if key not in self._arrays:
                self._arrays[key] = made
                self._bytes += made.nbytes
            while self._bytes > self._most and len(self._arrays) > 1:
                self._bytes -= self._arrays.pop(next(iter(self._arrays))).nbytes
        return made


_SHRUNK: Final = ArrayCache(most=48_000_000)
"""Tiles of the latest pictures, of which one shows up to 30 MB; all sets at all scales would be 180 MB."""


@cache
def texture_number(name: str) -> int:
    """Return the number of a set of textures, -1 for none."""
    return set_names().index(name) if name else -1


def base_color(material: Material) -> tuple[float, float, float]:
    """Return what to multiply texels with: the material's colour, white where the texture has colours of its own."""
    own = material.texture and texture_set(material.texture).own_colours
    return (1.0, 1.0, 1.0) if own else material.color


@dataclass(frozen=True, slots=True)
class Tiles:
    """Base colours of several sets, which `base_color` times a texel is what is seen of a material.

    Attributes
    ----------
    texels : (n, 3) array
        Row by row, one tile after the other.
    frames : (sets, 3) array of int
        For each set by its number: its first texel, columns and rows; no columns where nothing of it is seen.
    sizes : (sets, 2) array
        Width and height of each tile, metres.
    """

    texels: Floats
    frames: Ints
    sizes: Floats


def tiles_at(numbers: Ints, scale: float) -> Tiles:
    """Return the sets with these numbers, shrunk until a texel is no smaller than half a pixel.

    Parameters
    ----------
    numbers : (n,) array of int
        Those that are seen; negative ones are left out.
    scale : float
        Pixels a metre.
    """
    names = set_names()
    frames, sizes = np.zeros((len(names), 3), dtype=np.int64), np.ones((len(names), 2))
    parts: list[Floats] = []
    first = 0
    for number in sorted({int(value) for value in numbers if value >= 0}):
        chosen = material_set(names[number])
        steps = [max(0, int(np.log2(max(density / scale, 1.0)))) for density in chosen.density]
        tile = _shrunk(names[number], *steps)
        if np.abs(tile - 1.0).max() < SEEN:
            continue
        frames[number] = (first, tile.shape[1], tile.shape[0])
        sizes[number] = chosen.size
        parts.append(tile.reshape(-1, 3))
        first += len(parts[-1])
    return Tiles(np.concatenate(parts) if parts else np.ones((1, 3)), frames, sizes)


def _shrunk(name: str, halved_across: int, halved_down: int) -> Floats:
    """Return a set's texels, (rows, columns, 3), halved some times each way."""
    return _SHRUNK.get((name, halved_across, halved_down), lambda: _halved(name, halved_across, halved_down))


def _halved(name: str, halved_across: int, halved_down: int) -> Floats:
    """Return means over blocks of a set's base colour, over the mean of all unless the colours are its own."""
    from PIL import Image

    made = texture_set(name)
    pixels = np.asarray(Image.open(io.BytesIO(made.base)).convert("RGB"))
    rows, columns = pixels.shape[:2]
    down, across = min(2**halved_down, rows), min(2**halved_across, columns)
    # Whole numbers, and whole rows first: a mean over both axes at once goes through memory in short steps.
    whole = pixels[: rows // down * down].reshape(rows // down, down, columns * 3).sum(axis=1, dtype=np.uint32)
    whole = whole.reshape(rows // down, columns, 3)[:, : columns // across * across]
    totals = whole.reshape(rows // down, columns // across, across, 3).sum(axis=2, dtype=np.uint32)
    level = np.ones(3) if made.own_colours else np.array(made.level)
    texels: Floats = totals / (255.0 * down * across * level)
    return texels

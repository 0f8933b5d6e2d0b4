"""The textures of a set: base colour, normal, and occlusion, roughness and metal, as JPEG; made once for each user."""

import hashlib
import io
from functools import cache
from importlib.resources import files
from pkgutil import resolve_name
from typing import Any

import msgspec
import numpy as np
import numpy.typing as npt

from mansion_assets.materials.canvas import Canvas
from mansion_assets.materials.layers import Layers
from mansion_assets.materials.sets import MaterialSet, material_set
from mansion_assets.user_cache import cache_folder, kept
from mansion_geometry.compiled import Floats
from mansion_msgs_py.codec import prepared
from mansion_msgs_py.late_imports import importing

__all__ = ["TextureSet", "draw", "texture_set"]

STEEP = 0.9995
"""Upward part of the normal of a slope of 1 in 30; flatter reliefs are few steps of a byte, and left out."""

Pixels = npt.NDArray[np.uint8]

QUALITY = 85
"""Quality of the JPEG files."""


class TextureSet(msgspec.Struct, frozen=True):
    """A set of textures as files, with the axes of glTF 2.0: row 0 is the top of the tile.

    Attributes
    ----------
    size : (width, height)
        Size of the tile, metres.
    level : (r, g, b)
        Mean of the base colour, sRGB from 0 to 1: a material's own colour over this is the tint.
    own_colours : bool
        The base colour is the material's, and is not tinted.
    base, normal, surface : bytes
        JPEG: sRGB colour; tangent-space normals, y up, empty where the material is flat; occlusion, roughness and metal
        in red, green and blue.
    roughness : float
        Mean of `surface`'s green.
    """

    size: tuple[float, float]
    level: tuple[float, float, float]
    own_colours: bool
    base: bytes
    normal: bytes
    surface: bytes
    roughness: float

    def tint(self, color: tuple[float, float, float]) -> tuple[float, float, float]:
        """Return what to multiply the base colour with, sRGB, so that its mean is `color`, as nearly as 1 allows."""
        if self.own_colours:
            return (1.0, 1.0, 1.0)
        r, g, b = (min(1.0, channel / level) for channel, level in zip(color, self.level))
        return (r, g, b)


@cache
def texture_set(name: str) -> TextureSet:
    """Return the textures of a set: from the user's cache, or made and kept there where it can be written.

    ``MANSION_MATERIALS_CACHE`` names the folder; else it is ``mansion/materials`` of the user's cache. Files are named
    by a hash of what determines them: the set's data and the code of the procedures.
    """
    chosen = material_set(name)
    file = cache_folder("materials", "MANSION_MATERIALS_CACHE") / f"{name}_{_fingerprint(name, chosen)}.set"
    return kept(file, prepared(TextureSet), lambda: _encoded(chosen, draw(name)))


def draw(name: str) -> Layers:
    """Draw the tile of a set by its procedure."""
    chosen = material_set(name)
    with importing:
        procedure: Any = resolve_name(f"mansion_assets.materials.families.{chosen.procedure.replace('.', ':')}")
    layers: Layers = procedure(Canvas(name, chosen.size, chosen.pixels), **chosen.parameters)
    return layers


def _fingerprint(name: str, chosen: MaterialSet) -> str:
    return hashlib.sha256(_code() + name.encode() + msgspec.json.encode(chosen)).hexdigest()[:16]


@cache
def _code() -> bytes:
    """Return a hash of the modules that textures are made by."""
    package = files("mansion_assets.materials")
    modules = [package.joinpath(f"{name}.py") for name in ("canvas", "layers", "bonds", "textures")]
    modules += sorted(package.joinpath("families").iterdir(), key=lambda entry: entry.name)
    texts = [entry.read_bytes() for entry in modules if entry.name.endswith(".py")]
    return hashlib.sha256(b"\0".join(texts)).digest()


def _encoded(chosen: MaterialSet, layers: Layers) -> TextureSet:
    # The brightest places of a shade become white, so that a tint never needs to be above 1 for the colours in use.
    shade = layers.shade if layers.own_colours else layers.shade / max(float(np.quantile(layers.shade, 0.998)), 1e-6)
    base = _bytes(shade)
    relief = normals(layers.height, chosen)
    occlusion = _occlusion(layers.height, chosen)
    rough = np.clip(0.8 * layers.roughness, 0.0, 1.0)
    packed = _bytes(np.stack([occlusion, rough, np.ones_like(rough)], axis=-1))
    return TextureSet(
        size=chosen.size,
        level=_mean(base),
        own_colours=layers.own_colours,
        base=_jpeg(base),
        normal=_jpeg(_bytes(0.5 + 0.5 * relief)) if (relief[..., 2] < STEEP).any() else b"",
        surface=_jpeg(packed, shrink=2),
        roughness=round(float(packed[..., 1].mean()) / 255.0, 6),
    )


def normals(height: Floats, chosen: MaterialSet) -> Floats:
    """Return unit normals of a relief, (rows, columns, 3): x to the right, y up, z out of the surface."""
    dx, dy = (chosen.size[i] / chosen.pixels[i] for i in (0, 1))
    rise_x = (np.roll(height, -1, axis=1) - np.roll(height, 1, axis=1)) / (2 * dx)
    rise_y = (np.roll(height, 1, axis=0) - np.roll(height, -1, axis=0)) / (2 * dy)
    found = np.stack([-rise_x, -rise_y, np.ones_like(height)], axis=-1)
    unit: Floats = found / np.linalg.norm(found, axis=-1, keepdims=True)
    return unit


def _occlusion(height: Floats, chosen: MaterialSet) -> Floats:
    """Return how much light reaches each place, 0 to 1: less where it lies below what is around it."""
    texel = min(chosen.size[0] / chosen.pixels[0], chosen.size[1] / chosen.pixels[1])
    around = height
    for axis in (0, 1):
        around = np.mean([np.roll(around, step, axis=axis) for step in (-2, -1, 0, 1, 2)], axis=0)
    return 1.0 - np.clip((around - height) / (6.0 * texel), 0.0, 0.6)


def _mean(pixels: Pixels) -> tuple[float, float, float]:
    r, g, b = (pixels.reshape(-1, 3).mean(axis=0) / 255.0).round(6).tolist()
    return (r, g, b)


def _bytes(values: Floats) -> Pixels:
    return np.asarray(np.clip(values, 0.0, 1.0) * 255.0 + 0.5, dtype=np.uint8)


def _jpeg(pixels: Pixels, shrink: int = 1) -> bytes:
    from PIL import Image

    grey = bool((pixels == pixels[..., :1]).all())
    image = Image.fromarray(pixels[..., 0] if grey else pixels)
    buffer = io.BytesIO()
    (image.reduce(shrink) if shrink > 1 else image).save(buffer, format="JPEG", quality=QUALITY, subsampling=2)
    return buffer.getvalue()

"""Pictures of assets: one by itself, and many on a sheet with their names."""

import io
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Final

from mansion_assets.catalogue import Asset, Catalogue
from mansion_assets.library.source_model import SourceSurface
from mansion_export.meshes.asset_surfaces import asset_surfaces
from mansion_export.meshes.model import Material, Node, Surface, assemble
from mansion_export.pictures.projecting import bounds_along
from mansion_export.pictures.renderer import View, flatten, render

if TYPE_CHECKING:
    from PIL.Image import Image

__all__ = ["THUMBNAIL", "asset_picture", "contact_sheet", "source_thumbnail"]

THUMBNAIL: Final = 256
"""Pixels of a side of the picture that a library keeps of each asset."""

_VIEW: Final = View(azimuth=-125.0, elevation=28.0)
_VIEW_FROM_BELOW: Final = View(azimuth=-125.0, elevation=-28.0)
"""View of what hangs from a ceiling, as people see it."""

_SHINE: Final = 2.0
"""How much brighter what gives light is drawn than it were lit by the sun alone."""

_MARGIN: Final = 16
_LINE: Final = 14
_COLUMNS: Final = 8
_GROUND: Final = (0.965, 0.965, 0.965)
_PAPER: Final = "#f6f6f6"


def asset_picture(asset: Asset, catalogue: Catalogue, size: int) -> "Image":
    """Draw an asset of a catalogue from the front and right, as large as fits a square of `size` pixels.

    The eye is above it, but below what hangs from a ceiling.
    """
    view = _VIEW_FROM_BELOW if asset.mount == "ceiling" else _VIEW
    return _drawn(asset_surfaces(asset.key, catalogue, ""), size, view)


def source_thumbnail(surfaces: Sequence[SourceSurface], size: int = THUMBNAIL) -> bytes:
    """Return the picture of a model that is added to a library, as a PNG."""
    seen = []
    for number, surface in enumerate(surfaces):
        red, green, blue = (value / 255.0 for value in surface.look.color)
        look = Material(f"m{number}", (red, green, blue), surface.look.opacity)
        seen.append(Surface(look, surface.vertices, surface.faces))
    return _png(_drawn(seen, size, _VIEW))


def contact_sheet(assets: Sequence[Asset], catalogue: Catalogue, *, tile: int = 180, columns: int = _COLUMNS) -> bytes:
    """Return one picture of many assets, each with its name and category, as a PNG.

    Parameters
    ----------
    tile : int
        Pixels of a side of each.
    """
    from PIL import Image, ImageDraw

    columns = max(1, min(columns, len(assets)))
    rows = max(1, -(-len(assets) // columns))
    sheet = Image.new("RGB", (columns * tile, rows * (tile + 2 * _LINE)), _PAPER)
    pen = ImageDraw.Draw(sheet)
    for number, asset in enumerate(assets):
        x, y = number % columns * tile, number // columns * (tile + 2 * _LINE)
        picture = asset_picture(asset, catalogue, tile)
        sheet.paste(picture, (x + (tile - picture.width) // 2, y + (tile - picture.height) // 2))
        for line, text in enumerate((asset.key, asset.category)):
            pen.text((x + 4, y + tile + line * _LINE - 2), _cut(text, tile), fill="#777777" if line else "black")
    return _png(sheet)


def _cut(text: str, tile: int) -> str:
    most = tile // 7
    return text if len(text) <= most else text[: most - 1] + "…"


def _drawn(surfaces: Sequence[Surface], size: int, seen_from: View) -> "Image":
    from PIL import Image

    part = Node("asset", "asset", "objects", rotation=180.0), [_shining(surface) for surface in surfaces]
    triangles = flatten(assemble("asset", 1, 0.0, [part]))
    low, high = bounds_along(triangles.corners, seen_from.axes())
    scale = (size - _MARGIN) / max(float((high - low)[:2].max()), 1e-9)
    pixels = render(triangles, replace(seen_from, scale=scale), _GROUND)
    return Image.fromarray(pixels)


def _shining(surface: Surface) -> Surface:
    """Brighten what gives light."""
    look = surface.material
    if look.emission < 1.0:
        return surface
    red, green, blue = (value * _SHINE for value in look.color)
    return replace(surface, material=replace(look, color=(red, green, blue)))


def _png(picture: "Image") -> bytes:
    buffer = io.BytesIO()
    picture.save(buffer, format="PNG")
    return buffer.getvalue()

"""Contact sheets of the catalogue's meshes: ``python benchmarks/catalogue/contact_sheet.py OUT [CATEGORY ...]``.

Each tile is one asset seen from the front, right and above, in its materials.
"""

import sys
from dataclasses import replace
from pathlib import Path

from PIL import Image, ImageDraw

from mansion_assets.catalogue import Asset, Catalogue, load_catalogue
from mansion_export.building_model import asset_surfaces
from mansion_export.model import Node, assemble
from mansion_export.renderer import View, bounds, flatten, project, render

TILE = 180
COLUMNS = 8
SUPERSAMPLING = 2
VIEW = View(azimuth=-125.0, elevation=28.0)


def draw(asset: Asset, catalogue: Catalogue, size: int) -> Image.Image:
    """Draw an asset as large as fits a tile."""
    part = Node("asset", "asset", "objects", rotation=180.0), asset_surfaces(asset.key, catalogue, "")
    triangles = flatten(assemble(asset.key, 1, 0.0, [part]))
    low, high = bounds(project(triangles.corners, VIEW.axes()))
    scale = SUPERSAMPLING * (size - 16) / max(float((high - low)[:2].max()), 1e-9)
    pixels = render(triangles, replace(VIEW, scale=scale), (0.965, 0.965, 0.965))
    return Image.fromarray(pixels).reduce(SUPERSAMPLING)


def main(argv: list[str]) -> int:
    """Write sheets of 64 tiles; without categories, the first own or AI2-THOR asset of each."""
    out, names = Path(argv[0]), argv[1:]
    out.mkdir(parents=True, exist_ok=True)
    catalogue = load_catalogue()
    assets = [catalogue.by_category(name)[0] for name in names or catalogue.categories]
    per_sheet = COLUMNS * 8
    for sheet, start in enumerate(range(0, len(assets), per_sheet)):
        chosen = assets[start : start + per_sheet]
        rows = -(-len(chosen) // COLUMNS)
        canvas = Image.new("RGB", (COLUMNS * TILE, rows * (TILE + 14)), "#f6f6f6")
        pen = ImageDraw.Draw(canvas)
        for number, asset in enumerate(chosen):
            x, y = number % COLUMNS * TILE, number // COLUMNS * (TILE + 14)
            picture = draw(asset, catalogue, TILE)
            canvas.paste(picture, (x + (TILE - picture.width) // 2, y + (TILE - picture.height) // 2))
            pen.text((x + 4, y + TILE), asset.category, fill="black")
        canvas.save(out / f"sheet_{sheet + 1:02}.png")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

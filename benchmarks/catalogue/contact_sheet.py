"""Contact sheets of the catalogue's meshes: ``python benchmarks/catalogue/contact_sheet.py OUT [CATEGORY ...]``.

Each tile is one asset seen from the front, right and above, drawn by a small z-buffer rasteriser.
"""

import sys
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

from mansion_assets.catalogue import Asset, load_catalogue
from mansion_assets.meshes import mesh

TILE = 180
COLUMNS = 8
LIGHT = np.array([0.45, 0.6, 0.8]) / np.linalg.norm([0.45, 0.6, 0.8])


def triangles(asset: Asset) -> tuple[np.ndarray, np.ndarray]:
    """Return the triangles (n, 3, 3) of an asset and their shaded colours (n, 3)."""
    corners, colours = [], []
    for part in mesh(asset):
        t = part.vertices[part.faces]
        normal = np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0])
        normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)
        shade = 0.5 + 0.5 * np.clip(normal @ LIGHT, 0, 1)
        rgb = np.array([int(part.material.color[i : i + 2], 16) for i in (1, 3, 5)])
        if part.material.emissive:
            shade = np.ones_like(shade)
        keep = np.ones(len(t), bool) if part.material.opacity > 0.9 else np.arange(len(t)) % 2 == 0
        corners.append(t[keep])
        colours.append((shade[:, None] * rgb)[keep])
    return np.concatenate(corners), np.concatenate(colours)


def project(points: np.ndarray) -> np.ndarray:
    """Return (x, y, depth) seen from the front, the right and above."""
    yaw, pitch = np.radians(215), np.radians(28)
    x = points[..., 0] * np.cos(yaw) + points[..., 1] * np.sin(yaw)
    y = -points[..., 0] * np.sin(yaw) + points[..., 1] * np.cos(yaw)
    up = points[..., 2] * np.cos(pitch) + y * np.sin(pitch)
    depth = -points[..., 2] * np.sin(pitch) + y * np.cos(pitch)
    return np.stack([x, up, depth], axis=-1)


def draw(corners: np.ndarray, colours: np.ndarray, size: int) -> Image.Image:
    """Rasterise triangles with a z-buffer."""
    p = project(corners)
    low, high = p[..., :2].min(axis=(0, 1)), p[..., :2].max(axis=(0, 1))
    scale = (size - 16) / max(float((high - low).max()), 1e-9)
    xy = (p[..., :2] - (low + high) / 2) * scale * [1, -1] + size / 2
    image = np.full((size, size, 3), 246.0)
    nearest = np.full((size, size), np.inf)
    for t, z, colour in zip(xy, p[..., 2], colours, strict=True):
        x0, y0 = np.maximum(np.floor(t.min(axis=0)).astype(int), 0)
        x1, y1 = np.minimum(np.ceil(t.max(axis=0)).astype(int) + 1, size)
        if x1 <= x0 or y1 <= y0:
            continue
        gx, gy = np.meshgrid(np.arange(x0, x1) + 0.5, np.arange(y0, y1) + 0.5)
        a, b, c = t
        area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if abs(area) < 1e-9:
            continue
        u = ((b[0] - gx) * (c[1] - gy) - (b[1] - gy) * (c[0] - gx)) / area
        v = ((c[0] - gx) * (a[1] - gy) - (c[1] - gy) * (a[0] - gx)) / area
        w = 1 - u - v
        depth = u * z[0] + v * z[1] + w * z[2]
        inside = (u >= -1e-6) & (v >= -1e-6) & (w >= -1e-6)
        block = nearest[y0:y1, x0:x1]
        closer = inside & (depth < block)
        block[closer] = depth[closer]
        image[y0:y1, x0:x1][closer] = colour
    return Image.fromarray(image.astype(np.uint8))


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
        canvas = Image.new("RGB", (COLUMNS * TILE, rows * (TILE + 14)), "white")
        pen = ImageDraw.Draw(canvas)
        for number, asset in enumerate(chosen):
            x, y = number % COLUMNS * TILE, number // COLUMNS * (TILE + 14)
            canvas.paste(draw(*triangles(asset), TILE), (x, y))
            pen.text((x + 4, y + TILE), asset.category, fill="black")
        canvas.save(out / f"sheet_{sheet + 1:02}.png")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

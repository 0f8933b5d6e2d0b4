"""A small software renderer: orthographic z-buffer with a sun's shadows and contact shading."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from mansion_geometry.compiled import kernel
from mansion_scene.export.triangles import Triangles

__all__ = ["View", "render"]

Floats = npt.NDArray[np.float64]

SUN = np.array([-0.45, -0.62, 0.95]) / np.linalg.norm([-0.45, -0.62, 0.95])
"""Direction towards the light."""

AMBIENT, DIRECT, FILL = 0.60, 0.44, 0.16
SHADOW_CELL = 0.04
"""Metres of a shadow map's cell."""


@dataclass(frozen=True, slots=True)
class View:
    """An axonometric view.

    Attributes
    ----------
    azimuth, elevation : float
        Where the eye stands, degrees: azimuth counter-clockwise from +x, elevation above the ground.
    scale : float
        Pixels a metre.
    """

    azimuth: float = -62.0
    elevation: float = 48.0
    scale: float = 40.0

    def axes(self) -> Floats:
        """Return the rows right, up and towards the eye."""
        a, e = np.radians(self.azimuth), np.radians(self.elevation)
        toward = np.array([np.cos(a) * np.cos(e), np.sin(a) * np.cos(e), np.sin(e)])
        right = np.array([-np.sin(a), np.cos(a), 0.0])
        return np.stack([right, np.cross(toward, right), toward])


@kernel
def _fill(
    corners: npt.NDArray[np.float64],
    order: npt.NDArray[np.int64],
    depth: npt.NDArray[np.float64],
    index: npt.NDArray[np.int64],
) -> None:
    """Rasterise triangles (x, y in pixels, z towards the eye): nearest depth and its triangle."""
    height, width = depth.shape
    for k in order:
        ax, ay, az = corners[k, 0, 0], corners[k, 0, 1], corners[k, 0, 2]
        bx, by, bz = corners[k, 1, 0], corners[k, 1, 1], corners[k, 1, 2]
        cx, cy, cz = corners[k, 2, 0], corners[k, 2, 1], corners[k, 2, 2]
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        if abs(area) < 1e-12:
            continue
        low_x = max(int(np.floor(min(ax, bx, cx))), 0)
        high_x = min(int(np.ceil(max(ax, bx, cx))), width - 1)
        low_y = max(int(np.floor(min(ay, by, cy))), 0)
        high_y = min(int(np.ceil(max(ay, by, cy))), height - 1)
        for y in range(low_y, high_y + 1):
            py = y + 0.5
            for x in range(low_x, high_x + 1):
                px = x + 0.5
                u = ((bx - px) * (cy - py) - (by - py) * (cx - px)) / area
                v = ((cx - px) * (ay - py) - (cy - py) * (ax - px)) / area
                w = 1.0 - u - v
                if u < -1e-9 or v < -1e-9 or w < -1e-9:
                    continue
                z = u * az + v * bz + w * cz
                if z > depth[y, x]:
                    depth[y, x] = z
                    index[y, x] = k


def render(
    triangles: Triangles, view: View, background: tuple[float, float, float] = (1.0, 1.0, 1.0)
) -> npt.NDArray[np.uint8]:
    """Draw triangles from an axonometric view.

    Parameters
    ----------
    triangles : Triangles
    view : View
    background : (r, g, b)

    Returns
    -------
    (height, width, 3) array of uint8
        Just large enough for the triangles, first row on top.
    """
    axes = view.axes()
    seen = triangles.corners @ axes.T
    low = seen.reshape(-1, 3).min(0)
    high = seen.reshape(-1, 3).max(0)
    pixels = seen.copy()
    pixels[..., 0] = (seen[..., 0] - low[0]) * view.scale + 4
    pixels[..., 1] = (high[1] - seen[..., 1]) * view.scale + 4
    width = int(np.ceil((high[0] - low[0]) * view.scale)) + 8
    height = int(np.ceil((high[1] - low[1]) * view.scale)) + 8
    opaque = np.flatnonzero(triangles.alpha > 0.99)
    depth = np.full((height, width), -np.inf)
    index = np.full((height, width), -1, dtype=np.int64)
    _fill(pixels, opaque, depth, index)
    image = np.empty((height, width, 3))
    image[:] = background
    hit = index >= 0
    rows, columns = np.nonzero(hit)
    triangle = index[hit]
    normals = _normals(triangles.corners)[triangle]
    # Both sides of a face are lit as the one that is seen.
    normals *= np.sign(normals @ axes[2])[:, None]
    where = (
        ((columns + 0.5 - 4) / view.scale + low[0])[:, None] * axes[0]
        + (high[1] - (rows + 0.5 - 4) / view.scale)[:, None] * axes[1]
        + depth[hit][:, None] * axes[2]
    )
    lit = _sunlit(triangles, opaque, where, normals)
    sun = np.clip(normals @ SUN, 0.0, 1.0) * lit
    shade = AMBIENT + DIRECT * sun + FILL * normals[:, 2] * 0.5
    image[hit] = triangles.colors[triangle] * shade[:, None]
    image *= _contact(depth, hit, view.scale)[..., None]
    _blend_glass(triangles, pixels, depth, image)
    return np.asarray(np.clip(image, 0.0, 1.0) * 255.0 + 0.5, dtype=np.uint8)


def _normals(corners: Floats) -> Floats:
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    unit: Floats = cross / np.maximum(np.linalg.norm(cross, axis=1, keepdims=True), 1e-12)
    return unit


def _sunlit(
    triangles: Triangles, opaque: npt.NDArray[np.int64], where: Floats, normals: Floats
) -> Floats:
    """Return for each place how much of the sun reaches it, by a shadow map, softened over 3 x 3 cells."""
    right = np.cross([0.0, 0.0, 1.0], SUN)
    right /= np.linalg.norm(right)
    axes = np.stack([right, np.cross(SUN, right), SUN])
    cast = triangles.corners @ axes.T
    low = cast.reshape(-1, 3).min(0)
    extent = cast.reshape(-1, 3).max(0) - low
    cell = max(SHADOW_CELL, float(extent[:2].max()) / 2000.0)
    cells = cast.copy()
    cells[..., :2] = (cast[..., :2] - low[:2]) / cell
    shape = (int(extent[1] / cell) + 2, int(extent[0] / cell) + 2)
    depth = np.full(shape, -np.inf)
    _fill(cells, opaque, depth, np.full(shape, -1, dtype=np.int64))
    here = (where + normals * 0.03) @ axes.T
    i = np.clip(((here[:, 1] - low[1]) / cell).astype(int), 0, shape[0] - 1)
    j = np.clip(((here[:, 0] - low[0]) / cell).astype(int), 0, shape[1] - 1)
    lit = np.zeros(len(where))
    for di in (-1, 0, 1):
        for dj in (-1, 0, 1):
            m = np.clip(i + di, 0, shape[0] - 1)
            n = np.clip(j + dj, 0, shape[1] - 1)
            lit += here[:, 2] > depth[m, n] - 0.05
    lit /= 9.0
    return lit


def _contact(depth: Floats, hit: npt.NDArray[np.bool_], scale: float) -> Floats:
    """Darken what lies just behind something nearer: corners, gaps and outlines."""
    filled = np.where(hit, depth, depth[hit].min() if hit.any() else 0.0)
    factor = np.ones(depth.shape)
    for reach, weight in ((1, 0.16), (max(2, round(0.12 * scale)), 0.13)):
        nearer = np.zeros(depth.shape)
        for axis in (0, 1):
            for shift in (-reach, reach):
                step = np.roll(filled, shift, axis) - filled
                nearer += np.clip(step / 0.25, 0.0, 1.0) * (step < 4.0 if reach > 1 else 1.0)
        factor -= weight * np.minimum(nearer, 2.0) / 2.0
    return np.where(hit, factor, 1.0)


def _blend_glass(triangles: Triangles, pixels: Floats, depth: Floats, image: Floats) -> None:
    """Lay the nearest glass over what is behind it."""
    clear = np.flatnonzero(triangles.alpha <= 0.99)
    if not len(clear):
        return
    index = np.full(depth.shape, -1, dtype=np.int64)
    _fill(pixels, clear, depth.copy(), index)
    hit = index >= 0
    alpha = triangles.alpha[index[hit]][:, None]
    image[hit] = image[hit] * (1.0 - alpha) + triangles.colors[index[hit]] * alpha

"""A small software renderer: orthographic z-buffer with a sun's shadows and contact shading."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from mansion_geometry.compiled import kernel
from mansion_scene.export.triangles import Triangles

__all__ = ["View", "render"]

Floats = npt.NDArray[np.float64]
Singles = npt.NDArray[np.float32]

SUN = np.array([-0.45, -0.62, 0.95]) / np.linalg.norm([-0.45, -0.62, 0.95])
"""Direction towards the light."""

_ACROSS = np.array([-SUN[1], SUN[0], 0.0]) / np.hypot(SUN[0], SUN[1])
LIGHT = np.stack([_ACROSS, np.cross(SUN, _ACROSS), SUN])
"""The axes of the shadow map: right, up, towards the light."""

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
    depth: npt.NDArray[np.float32],
    index: npt.NDArray[np.int32],
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
        slope_x = ((bz - az) * (cy - ay) - (cz - az) * (by - ay)) / area
        slope_y = ((cz - az) * (bx - ax) - (bz - az) * (cx - ax)) / area
        low_y = max(int(np.ceil(min(ay, by, cy) - 0.5)), 0)
        high_y = min(int(np.floor(max(ay, by, cy) - 0.5)), height - 1)
        for y in range(low_y, high_y + 1):
            py = y + 0.5
            left, right = 1e18, -1e18
            for e in range(3):
                f = (e + 1) % 3
                py0, py1 = corners[k, e, 1], corners[k, f, 1]
                if (py0 <= py) != (py1 <= py):
                    t = (py - py0) / (py1 - py0)
                    px = corners[k, e, 0] + t * (corners[k, f, 0] - corners[k, e, 0])
                    left, right = min(left, px), max(right, px)
            low_x = max(int(np.ceil(left - 0.5 - 1e-9)), 0)
            high_x = min(int(np.floor(right - 0.5 + 1e-9)), width - 1)
            z = az + slope_x * (low_x + 0.5 - ax) + slope_y * (py - ay)
            for x in range(low_x, high_x + 1):
                if z > depth[y, x]:
                    depth[y, x] = z
                    index[y, x] = k
                z += slope_x


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
    depth = np.full((height, width), -np.inf, dtype=np.float32)
    index = np.full((height, width), -1, dtype=np.int32)
    _fill(pixels, opaque, depth, index)
    hit = index >= 0
    triangle = index[hit]
    normals = _normals(triangles.corners)
    # Both sides of a face are lit as the one that is seen.
    normals *= np.sign(normals @ axes[2])[:, None]
    sun = np.clip(normals @ SUN, 0.0, 1.0)
    base = AMBIENT + 0.5 * FILL * normals[:, 2]
    # A little way off its face, so that no face shades itself.
    away = (0.03 * normals @ LIGHT.T).astype(np.float32)[triangle]
    here = _in_light(view, low, high, depth, hit) + away
    lit = _sunlit(triangles.corners @ LIGHT.T, opaque, here)
    shade = base[triangle] + DIRECT * sun[triangle] * lit
    image = np.empty((height, width, 3), dtype=np.float32)
    image[:] = background
    image[hit] = triangles.colors[triangle] * shade[:, None]
    image *= _contact(depth, hit, view.scale)[..., None]
    _blend_glass(triangles, pixels, depth, image)
    return np.asarray(np.clip(image, 0.0, 1.0) * 255.0 + 0.5, dtype=np.uint8)


def _normals(corners: Floats) -> Floats:
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    unit: Floats = cross / np.maximum(np.linalg.norm(cross, axis=1, keepdims=True), 1e-12)
    return unit


def _in_light(
    view: View, low: Floats, high: Floats, depth: Singles, hit: npt.NDArray[np.bool_]
) -> Singles:
    """Return the places of the pixels that are hit, in the axes of the light."""
    rows, columns = np.nonzero(hit)
    turn = (view.axes() @ LIGHT.T).astype(np.float32)
    u = ((columns - 3.5) / view.scale + low[0]).astype(np.float32)
    v = (high[1] - (rows - 3.5) / view.scale).astype(np.float32)
    place: Singles = u[:, None] * turn[0] + v[:, None] * turn[1] + depth[hit][:, None] * turn[2]
    return place


def _sunlit(cast: Floats, opaque: npt.NDArray[np.int64], here: Singles) -> Singles:
    """Return for each place how much of the sun reaches it, by a shadow map, softened over five cells."""
    low = cast.reshape(-1, 3).min(0)
    extent = cast.reshape(-1, 3).max(0) - low
    cell = max(SHADOW_CELL, float(extent[:2].max()) / 2000.0)
    cells = cast.copy()
    cells[..., :2] = (cast[..., :2] - low[:2]) / cell + 2
    shape = (int(extent[1] / cell) + 5, int(extent[0] / cell) + 5)
    depth = np.full(shape, -np.inf, dtype=np.float32)
    _fill(cells, opaque, depth, np.full(shape, -1, dtype=np.int32))
    spots = ((here[:, :2] - low[:2].astype(np.float32)) / np.float32(cell)).astype(np.int32) + 2
    j = np.clip(spots[:, 0], 1, shape[1] - 2)
    i = np.clip(spots[:, 1], 1, shape[0] - 2)
    lit = np.zeros(len(here), dtype=np.float32)
    for di, dj in ((0, 0), (0, 1), (0, -1), (1, 0), (-1, 0)):
        lit += here[:, 2] > depth[i + di, j + dj] - np.float32(0.05)
    return lit / np.float32(5.0)


def _contact(depth: Singles, hit: npt.NDArray[np.bool_], scale: float) -> Singles:
    """Darken what lies just behind something nearer: corners, gaps and outlines."""
    filled = np.where(hit, depth, depth[hit].min() if hit.any() else np.float32(0.0))
    factor = np.ones(depth.shape, dtype=np.float32)
    for reach, weight in ((1, 0.16), (max(2, round(0.12 * scale)), 0.13)):
        nearer = np.zeros(depth.shape, dtype=np.float32)
        for axis in (0, 1):
            for shift in (-reach, reach):
                step = np.roll(filled, shift, axis) - filled
                nearer += np.clip(step / 0.25, 0.0, 1.0) * (step < 4.0 if reach > 1 else 1.0)
        factor -= weight * np.minimum(nearer, 2.0) / 2.0
    return np.where(hit, factor, np.float32(1.0))


def _blend_glass(triangles: Triangles, pixels: Floats, depth: Singles, image: Singles) -> None:
    """Lay the nearest glass over what is behind it."""
    clear = np.flatnonzero(triangles.alpha <= 0.99)
    if not len(clear):
        return
    index = np.full(depth.shape, -1, dtype=np.int32)
    _fill(pixels, clear, depth.copy(), index)
    hit = index >= 0
    alpha = triangles.alpha[index[hit]][:, None]
    image[hit] = image[hit] * (1.0 - alpha) + triangles.colors[index[hit]] * alpha

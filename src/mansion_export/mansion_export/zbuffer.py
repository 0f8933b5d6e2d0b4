"""A small software renderer: orthographic z-buffer with a sun's shadows and contact shading."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from mansion_export.shading import blend_glass, shade_pixels
from mansion_export.triangles import Triangles, bounds, project
from mansion_geometry.compiled import kernel

__all__ = ["View", "render"]

Floats = npt.NDArray[np.float64]
Singles = npt.NDArray[np.float32]

SUN = np.array([-0.45, -0.62, 0.95]) / np.linalg.norm([-0.45, -0.62, 0.95])
"""Direction towards the light."""

_ACROSS = np.array([-SUN[1], SUN[0], 0.0]) / np.hypot(SUN[0], SUN[1])
LIGHT = np.stack([_ACROSS, np.cross(SUN, _ACROSS), SUN])
"""The axes of the shadow map: right, up, towards the light."""

AMBIENT, DIRECT, FILL = 0.60, 0.44, 0.16
SHADOW_CELL = 0.05
"""Metres of a shadow map's cell."""

_BORDER = 4


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
        low_y = max(int(np.ceil(min(ay, by, cy) - 0.5)), 0)
        high_y = min(int(np.floor(max(ay, by, cy) - 0.5)), height - 1)
        if low_y > high_y:
            continue
        slope_x = ((bz - az) * (cy - ay) - (cz - az) * (by - ay)) / area
        slope_y = ((cz - az) * (bx - ax) - (bz - az) * (cx - ax)) / area
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
    pixels = project(triangles.corners, axes)
    low, high = bounds(pixels)
    pixels[..., 0] = (pixels[..., 0] - low[0]) * view.scale + _BORDER
    pixels[..., 1] = (high[1] - pixels[..., 1]) * view.scale + _BORDER
    width = int(np.ceil((high[0] - low[0]) * view.scale)) + 2 * _BORDER
    height = int(np.ceil((high[1] - low[1]) * view.scale)) + 2 * _BORDER
    clear = triangles.alpha <= 0.99
    opaque = np.flatnonzero(~clear)
    depth = np.full((height, width), -np.inf, dtype=np.float32)
    index = np.full((height, width), -1, dtype=np.int32)
    _fill(pixels, opaque, depth, index)
    image = np.empty((height, width, 3), dtype=np.float32)
    image[:] = background
    # Where pixel (0, 0) lies in the view's plane, and the way from the view's axes to the light's.
    origin = np.array([low[0] - (_BORDER - 0.5) / view.scale, high[1] + (_BORDER - 0.5) / view.scale])
    turn = axes @ LIGHT.T
    shadow, corner, cell = _shadow_map(project(triangles.corners, LIGHT), opaque)
    shade_pixels(
        depth,
        index,
        _lighting(triangles.corners, axes[2], SUN, LIGHT),
        triangles.colors,
        shadow,
        (float(corner[0]), float(corner[1]), cell),
        (float(origin[0]), float(origin[1]), view.scale),
        turn,
        image,
    )
    glass = np.flatnonzero(clear)
    if len(glass):
        front = np.full(depth.shape, -1, dtype=np.int32)
        _fill(pixels, glass, depth, front)
        blend_glass(front, triangles.colors, triangles.alpha, image)
    return np.asarray(np.clip(image, 0.0, 1.0) * 255.0 + 0.5, dtype=np.uint8)


@kernel
def _lighting(
    corners: npt.NDArray[np.float64],
    toward: npt.NDArray[np.float64],
    sun: npt.NDArray[np.float64],
    light: npt.NDArray[np.float64],
) -> npt.NDArray[np.float64]:
    """Return for each triangle: shade without the sun, the sun's part, and a step off the face in the light's axes."""
    out = np.zeros((len(corners), 5))
    for k in range(len(corners)):
        ax, ay, az = corners[k, 1] - corners[k, 0]
        bx, by, bz = corners[k, 2] - corners[k, 0]
        x, y, z = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
        length = max(np.sqrt(x * x + y * y + z * z), 1e-12)
        # Both sides of a face are lit as the one that is seen.
        if x * toward[0] + y * toward[1] + z * toward[2] < 0.0:
            length = -length
        x, y, z = x / length, y / length, z / length
        out[k, 0] = AMBIENT + 0.5 * FILL * z
        out[k, 1] = DIRECT * max(x * sun[0] + y * sun[1] + z * sun[2], 0.0)
        # A little way off its face, so that no face shades itself.
        for axis in range(3):
            out[k, 2 + axis] = 0.03 * (x * light[axis, 0] + y * light[axis, 1] + z * light[axis, 2])
    return out


def _shadow_map(cast: Floats, opaque: npt.NDArray[np.int64]) -> tuple[Singles, Floats, float]:
    """Return the depths that the sun sees, the place of cell (0, 0), and the length of a cell."""
    low, high = bounds(cast)
    extent = high - low
    cell = max(SHADOW_CELL, float(extent[:2].max()) / 1600.0)
    cast[..., :2] = (cast[..., :2] - low[:2]) / cell + 2
    shape = (int(extent[1] / cell) + 5, int(extent[0] / cell) + 5)
    depth = np.full(shape, -np.inf, dtype=np.float32)
    _fill(cast, opaque, depth, np.full(shape, -1, dtype=np.int32))
    return depth, low[:2] - 2 * cell, cell

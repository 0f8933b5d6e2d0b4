"""The light of pictures: the sun with soft shadows, the sky, darker hollows, textures, and haze far away.

Shadows come of a shadow map (Williams, L. 1978, Casting curved shadows on curved surfaces), whose five samples a pixel
soften their edges (Reeves, W. T., Salesin, D. H., Cook, R. L. 1987, Rendering antialiased shadows with depth maps).
"""

from typing import Final

import numpy as np
import numpy.typing as npt

from mansion_export.pictures.projecting import bounds_along, project, rasterise
from mansion_geometry.compiled import Floats, Ints, kernel

__all__ = ["LIGHT", "NO_HAZE", "faces_seen", "shade_pixels", "shadow_map"]

Singles = npt.NDArray[np.float32]

SUN = np.array([-0.45, -0.62, 0.95]) / np.linalg.norm([-0.45, -0.62, 0.95])
"""Direction towards the light."""

_ACROSS = np.array([-SUN[1], SUN[0], 0.0]) / np.hypot(SUN[0], SUN[1])

LIGHT = np.stack([_ACROSS, np.cross(SUN, _ACROSS), SUN])
"""The axes of the shadow map: right, up, towards the light."""

AMBIENT, DIRECT, FILL = 0.58, 0.46, 0.14

SKYLIGHT, SUNLIGHT = (0.965, 0.995, 1.055), (1.04, 1.0, 0.92)
"""Colours of the light of the sky, which shadows have, and of the sun."""

NO_HAZE: Final = (1.0, 1.0, 1.0, np.inf)

SHADOW_CELL = 0.05
"""Metres of a shadow map's cell."""

_EDGE, _HOLLOW = 0.16, 0.6
"""How much darker a pixel beside an edge gets, and how much less of the sky's light reaches the bottom of a hollow."""


@kernel
def faces_seen(
    corners: npt.NDArray[np.float64],
    pixels: npt.NDArray[np.float64],
    coordinates: npt.NDArray[np.float64],
    eye: npt.NDArray[np.float64],
    perspective: bool,
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    """Return how each triangle is lit, and how its texture lies in the picture.

    Parameters
    ----------
    corners, pixels : (n, 3, 3) arrays
        In the world, and in the picture.
    coordinates : (n, 3, 2) array
        On textures.
    eye : (3,) array
        Where the eye is, or without perspective the direction towards it.
    perspective : bool

    Returns
    -------
    (n, 5) array
        Shade without the sun, the sun's part, and a step off the face along the axes of `LIGHT`.
    (n, 8) array
        A pixel, the first coordinate there with its growth a pixel to the right and down, and the second; with
        perspective they are over the distance.
    """
    lit, laid = np.zeros((len(corners), 5)), np.zeros((len(corners), 8))
    for k in range(len(corners)):
        ax, ay, az = corners[k, 1] - corners[k, 0]
        bx, by, bz = corners[k, 2] - corners[k, 0]
        x, y, z = ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx
        length = max(np.sqrt(x * x + y * y + z * z), 1e-12)
        # Both sides of a face are lit as the one that is seen.
        ex, ey, ez = eye
        if perspective:
            ex, ey, ez = eye - corners[k, 0]
        if x * ex + y * ey + z * ez < 0.0:
            length = -length
        x, y, z = x / length, y / length, z / length
        lit[k, 0] = AMBIENT + 0.5 * FILL * z
        lit[k, 1] = DIRECT * max(x * SUN[0] + y * SUN[1] + z * SUN[2], 0.0)
        # Three centimetres off the face, so that no face shades itself.
        for axis in range(3):
            lit[k, 2 + axis] = 0.03 * (x * LIGHT[axis, 0] + y * LIGHT[axis, 1] + z * LIGHT[axis, 2])
        px, py = pixels[k, 0, 0], pixels[k, 0, 1]
        qx, qy = pixels[k, 1, 0] - px, pixels[k, 1, 1] - py
        rx, ry = pixels[k, 2, 0] - px, pixels[k, 2, 1] - py
        area = qx * ry - rx * qy
        laid[k, 0], laid[k, 1] = px, py
        for axis in range(2):
            a, b, c = coordinates[k, 0, axis], coordinates[k, 1, axis], coordinates[k, 2, axis]
            if perspective:
                a, b, c = a * pixels[k, 0, 2], b * pixels[k, 1, 2], c * pixels[k, 2, 2]
            laid[k, 2 + 3 * axis] = a
            laid[k, 3 + 3 * axis] = ((b - a) * ry - (c - a) * qy) / area
            laid[k, 4 + 3 * axis] = ((c - a) * qx - (b - a) * rx) / area
    return lit, laid


def shadow_map(casting: Floats, opaque: Ints) -> tuple[Singles, Floats, float]:
    """Return the depths that the sun sees, the place of cell (0, 0), and the length of a cell.

    Parameters
    ----------
    casting : (n, 3, 3) array
        Corners in the world.
    opaque : (m,) array of int
        The triangles that cast shadows.
    """
    low, high = bounds_along(casting, LIGHT)
    extent = high - low
    cell = max(SHADOW_CELL, float(extent[:2].max()) / 1600.0)
    placed = project(casting, LIGHT)
    _count_cells(placed, (float(low[0]), float(low[1])), cell)
    shape = (int(extent[1] / cell) + 5, int(extent[0] / cell) + 5)
    depth = np.full(shape, -np.inf, dtype=np.float32)
    rasterise(placed, opaque, depth, np.full(shape, -1, dtype=np.int32))
    return depth, low[:2] - 2 * cell, cell


@kernel
def _count_cells(placed: npt.NDArray[np.float64], low: tuple[float, float], cell: float) -> None:
    """Turn the first two coordinates of corners into cells of a map that begins two cells below `low`."""
    for k in range(len(placed)):
        for corner in range(3):
            for axis in range(2):
                placed[k, corner, axis] = (placed[k, corner, axis] - low[axis]) / cell + 2.0


@kernel
def _occlusion(depth: npt.NDArray[np.float32], y: int, x: int, reach: int, most: float) -> float:
    """Count, to two, the neighbours at `reach` that are nearer to the eye, by at most `most` metres."""
    height, width = depth.shape
    here = depth[y, x]
    total = 0.0
    for dy, dx in ((-reach, 0), (reach, 0), (0, -reach), (0, reach)):
        j, i = y + dy, x + dx
        if j < 0 or i < 0 or j >= height or i >= width:
            continue
        step = depth[j, i] - here
        if 0.0 < step < most:
            total += min(step / 0.25, 1.0)
    return min(total, 2.0)


@kernel
def _hollow(depth: npt.NDArray[np.float32], y: int, x: int, scale: float) -> float:
    """Tell how far a pixel lies in a hollow, 0 to 1: what lies to both sides of it is nearer to the eye on average.

    A flat face is no hollow, however it leans. What is nearer by far more than it is aside stands before the pixel, and
    not beside it.
    """
    height, width = depth.shape
    here = depth[y, x]
    total = 0.0
    for ring in range(4):
        away = 0.08 * 1.8**ring
        reach = max(1 + ring, int(np.round(away * scale)))
        for dy, dx in ((reach, 0), (0, reach), (reach, reach), (reach, -reach)):
            j0, i0, j1, i1 = y - dy, x - dx, y + dy, x + dx
            if min(j0, i0, j1, i1) < 0 or max(j0, j1) >= height or max(i0, i1) >= width:
                continue
            first, second = depth[j0, i0] - here, depth[j1, i1] - here
            most = 3.0 * reach / scale
            if first < most and second < most and first + second > 0.0:
                total += min((first + second) * scale / reach, 1.0)
    return total / 16.0


@kernel
def _sunlit(
    shadow: npt.NDArray[np.float32],
    shadow_frame: tuple[float, float, float],
    view_frame: tuple[float, float, float, float, float, float],
    turn: Floats,
    lit: Floats,
    k: int,
    y: float,
    x: float,
    w: float,
) -> float:
    """Return the share of five samples of the shadow map about a sample of triangle `k` that the sun reaches."""
    left, bottom, cell = shadow_frame
    u0, v0, x0, y0, scale, eye = view_frame
    away = eye - w if np.isfinite(eye) else 1.0
    u, v = u0 + (x - x0) * away / scale, v0 - (y - y0) * away / scale
    a = u * turn[0, 0] + v * turn[1, 0] + w * turn[2, 0] + lit[k, 2]
    b = u * turn[0, 1] + v * turn[1, 1] + w * turn[2, 1] + lit[k, 3]
    c = u * turn[0, 2] + v * turn[1, 2] + w * turn[2, 2] + lit[k, 4]
    i = min(max(int((a - left) / cell), 1), shadow.shape[1] - 2)
    j = min(max(int((b - bottom) / cell), 1), shadow.shape[0] - 2)
    reached = 0
    for dj, di in ((0, 0), (0, 1), (0, -1), (1, 0), (-1, 0)):
        if c > shadow[j + dj, i + di] - 0.05:
            reached += 1
    return reached / 5.0


@kernel
def shade_pixels(
    depth: npt.NDArray[np.float32],
    index: npt.NDArray[np.int32],
    glass: npt.NDArray[np.int32],
    faces: tuple[Floats, Floats],
    surfaces: tuple[Floats, Floats, Ints],
    tiles: tuple[Floats, Ints, Floats],
    shadow: npt.NDArray[np.float32],
    shadow_frame: tuple[float, float, float],
    view_frame: tuple[float, float, float, float, float, float],
    turn: npt.NDArray[np.float64],
    haze: tuple[float, float, float, float],
    image: npt.NDArray[np.float32],
) -> None:
    """Colour pixels, each the mean of two by two samples; samples that show one triangle are shaded together.

    Parameters
    ----------
    depth, index : (2 height, 2 width) arrays
        Depth of each sample towards the eye, metres, and its triangle, -1 for none.
    glass : (2 height, 2 width) array
        The nearest triangle of glass before them, -1 for none; of no length where there is no glass.
    faces : arrays
        What `faces_seen` returns.
    surfaces : ((n, 3), (n,), (n,)) arrays
        Colours, their alpha, and numbers of the sets of textures.
    tiles : arrays
        The parts of `Tiles`.
    shadow : (rows, columns) array
        Depths towards the light.
    shadow_frame : (x, y, length)
        Place of the first cell and metres a cell.
    view_frame : (u, v, x, y, scale, eye)
        The place in the view's plane that sample x, y shows, samples a metre, and the eye's depth: infinite without
        perspective, else samples a metre are those of what is 1 m from the eye.
    turn : (3, 3) array
        From the view's axes to the light's: ``place @ turn``.
    haze : (red, green, blue, length)
        What far things fade to, and how far away 63% of them are faded, metres.
    image : (height, width, 3) array
        The background; drawn over.
    """
    height, width = image.shape[:2]
    # Unpacked once: each array that is taken out of a tuple counts its references anew.
    lit, laid = faces
    colors, alpha, textures = surfaces
    texels, frames, sizes = tiles
    scale, eye = view_frame[4], view_frame[5]
    total = np.zeros(3)
    for j in range(height):
        for i in range(width):
            y, x = 2 * j, 2 * i
            k = index[y, x]
            alike = k == index[y, x + 1] and k == index[y + 1, x] and k == index[y + 1, x + 1]
            away = eye - depth[y, x] if np.isfinite(eye) and k >= 0 else 1.0
            hollow = -1.0
            back = (image[j, i, 0], image[j, i, 1], image[j, i, 2])
            total[:] = 0.0
            for sample in range(1 if alike else 4):
                dy, dx = sample // 2, sample % 2
                k = index[y + dy, x + dx]
                seen = back
                if k >= 0:
                    if hollow < 0.0:
                        away = eye - depth[y + dy, x + dx] if np.isfinite(eye) else 1.0
                        hollow = _hollow(depth, y + dy, x + dx, scale / away)
                    row, column, w = float(y + dy), float(x + dx), float(depth[y + dy, x + dx])
                    if alike:
                        row, column = y + 0.5, x + 0.5
                        w = 0.25 * (depth[y, x] + depth[y, x + 1] + depth[y + 1, x] + depth[y + 1, x + 1])
                    dark = 1.0 - 0.5 * _EDGE * _occlusion(depth, y + dy, x + dx, 1, 1e9)
                    light = (dark * (1.0 - _HOLLOW * hollow), dark)
                    texel = (1.0, 1.0, 1.0)
                    if textures[k] >= 0 and frames[textures[k], 1] > 0:
                        away = eye - w if np.isfinite(eye) else 1.0
                        texel = _texel(texels, frames, sizes, textures[k], laid, k, row, column, away)
                    sunny = 0.0
                    if lit[k, 1] > 0.0:
                        sunny = lit[k, 1] * _sunlit(shadow, shadow_frame, view_frame, turn, lit, k, row, column, w)
                    seen = _coloured(colors, k, texel, lit[k, 0] * light[0], sunny * light[1], eye - w, haze)
                for channel in range(3):
                    total[channel] += seen[channel]
            share = 1.0 if alike else 0.25
            for channel in range(3):
                image[j, i, channel] = share * total[channel]
            if len(glass):
                for sample in range(4):
                    pane = glass[y + sample // 2, x + sample % 2]
                    if pane >= 0:
                        part = 0.25 * alpha[pane]
                        for channel in range(3):
                            image[j, i, channel] += part * (colors[pane, channel] - share * total[channel])


@kernel
def _coloured(
    colors: Floats,
    k: int,
    texel: tuple[float, float, float],
    sky: float,
    sunny: float,
    away: float,
    haze: tuple[float, float, float, float],
) -> tuple[float, float, float]:
    """Return the colour of triangle `k` in the light of sky and sun, so far away."""
    clear = np.exp(-away / haze[3]) if np.isfinite(haze[3]) else 1.0
    return (
        colors[k, 0] * texel[0] * (sky * SKYLIGHT[0] + sunny * SUNLIGHT[0]) * clear + haze[0] * (1.0 - clear),
        colors[k, 1] * texel[1] * (sky * SKYLIGHT[1] + sunny * SUNLIGHT[1]) * clear + haze[1] * (1.0 - clear),
        colors[k, 2] * texel[2] * (sky * SKYLIGHT[2] + sunny * SUNLIGHT[2]) * clear + haze[2] * (1.0 - clear),
    )


@kernel
def _texel(
    texels: Floats, frames: Ints, sizes: Floats, number: int, laid: Floats, k: int, y: float, x: float, away: float
) -> tuple[float, float, float]:
    """Return what a set of textures shows of triangle `k` at a sample."""
    dx, dy = x + 0.5 - laid[k, 0], y + 0.5 - laid[k, 1]
    s = (laid[k, 2] + laid[k, 3] * dx + laid[k, 4] * dy) * away
    t = (laid[k, 5] + laid[k, 6] * dx + laid[k, 7] * dy) * away
    return _sampled(texels, frames, sizes, number, s, t)


@kernel
def _sampled(
    texels: Floats, frames: Ints, sizes: Floats, number: int, u: float, v: float
) -> tuple[float, float, float]:
    """Return a tile's value at a place in metres, weighted between the four nearest texels."""
    first, columns, rows = frames[number, 0], frames[number, 1], frames[number, 2]
    x, y = u / sizes[number, 0] * columns - 0.5, -v / sizes[number, 1] * rows - 0.5
    left, top = np.floor(x), np.floor(y)
    across, down = x - left, y - top
    i0, j0 = int(left) % columns, int(top) % rows
    i1, j1 = i0 + 1, j0 + 1
    if i1 == columns:
        i1 = 0
    if j1 == rows:
        j1 = 0
    a, b = first + j0 * columns, first + j1 * columns
    p, q = (1.0 - across) * (1.0 - down), across * (1.0 - down)
    r, s = (1.0 - across) * down, across * down
    return (
        p * texels[a + i0, 0] + q * texels[a + i1, 0] + r * texels[b + i0, 0] + s * texels[b + i1, 0],
        p * texels[a + i0, 1] + q * texels[a + i1, 1] + r * texels[b + i0, 1] + s * texels[b + i1, 1],
        p * texels[a + i0, 2] + q * texels[a + i1, 2] + r * texels[b + i0, 2] + s * texels[b + i1, 2],
    )

"""A small software renderer: an orthographic z-buffer with shadows of the sun and contact shading.

Models are flattened to triangles, rasterised to depths and triangle numbers (Catmull, E. 1974, A subdivision algorithm
for computer display of curved surfaces), and shaded by a shadow map (Williams, L. 1978, Casting curved shadows on
curved surfaces), whose five samples a pixel soften the edges of shadows (Reeves, W. T., Salesin, D. H., Cook, R. L.
1987, Rendering antialiased shadows with depth maps).
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, fields, replace

import numpy as np
import numpy.typing as npt

from mansion_export.meshes.model import Mesh, Model, Node
from mansion_export.pictures.texture_sampling import base_color, sampled, texture_number, tiles_at
from mansion_geometry.compiled import Bools, Floats, Ints, kernel

__all__ = ["Triangles", "View", "bounds", "flatten", "project", "render"]


Singles = npt.NDArray[np.float32]

SUN = np.array([-0.45, -0.62, 0.95]) / np.linalg.norm([-0.45, -0.62, 0.95])
"""Direction towards the light."""

_ACROSS = np.array([-SUN[1], SUN[0], 0.0]) / np.hypot(SUN[0], SUN[1])

LIGHT = np.stack([_ACROSS, np.cross(SUN, _ACROSS), SUN])
"""The axes of the shadow map: right, up, towards the light."""

AMBIENT, DIRECT, FILL = 0.58, 0.46, 0.14

SKYLIGHT, SUNLIGHT = (0.965, 0.995, 1.055), (1.04, 1.0, 0.92)
"""Colours of the light of the sky, which shadows have, and of the sun."""

SHADOW_CELL = 0.05
"""Metres of a shadow map's cell."""

_BORDER = 4

_EDGE, _HOLLOW = 0.16, 0.6
"""How much darker a pixel beside an edge gets, and how much less of the sky's light reaches the bottom of a hollow."""


@dataclass(frozen=True, slots=True)
class Triangles:
    """Triangles in world coordinates.

    Attributes
    ----------
    corners : (n, 3, 3) array
    colors : (n, 3) array
        sRGB from 0 to 1.
    alpha : (n,) array
    textures : (n,) array of int
        Numbers of the sets of textures that the colours tint, see `texture_number`; -1 for none.
    coordinates : (n, 3, 2) array
        Place of the corners on the textures, metres.
    """

    corners: Floats
    colors: Floats
    alpha: Floats
    textures: Ints
    coordinates: Floats

    @staticmethod
    def plain(corners: Floats, color: Floats) -> "Triangles":
        """Return opaque triangles of one colour."""
        count = len(corners)
        colors = np.tile(color, (count, 1))
        return Triangles(corners, colors, np.ones(count), np.full(count, -1), np.zeros((count, 3, 2)))

    def where(self, keep: Bools | Ints) -> "Triangles":
        """Return some of the triangles."""
        return Triangles(*(getattr(self, part.name)[keep] for part in fields(self)))

    @staticmethod
    def join(parts: "Sequence[Triangles]") -> "Triangles":
        """Return the triangles of several lists, one list after the other."""
        if not parts:
            return Triangles.plain(np.zeros((0, 3, 3)), np.zeros(3))
        return Triangles(*(np.concatenate([getattr(part, each.name) for part in parts]) for each in fields(Triangles)))


def flatten(model: Model, keep: Callable[[Node], bool] | None = None) -> Triangles:
    """Return all triangles of a model, in its own frame.

    Parameters
    ----------
    keep : callable, optional
        Which nodes to take; all when it is left out.
    """
    nodes = [node for node in model.nodes if keep is None or keep(node)]
    meshes: dict[str, int] = {}
    for node in nodes:
        meshes.setdefault(node.mesh, len(meshes))
    sources = [_triangles(model.meshes[name]) for name in meshes]
    source = Triangles.join(sources)
    starts = np.cumsum([0, *(len(part.alpha) for part in sources)])
    which = np.array([meshes[node.mesh] for node in nodes], dtype=np.int64)
    poses = np.array([(*node.scale, *node.position, np.radians(node.rotation)) for node in nodes]).reshape(-1, 7)
    counts = (starts[1:] - starts[:-1])[which]
    corners = np.empty((int(counts.sum()), 3, 3))
    origin = np.empty(len(corners), dtype=np.int64)
    _place_instances(source.corners, starts, which, poses, corners, origin)
    return replace(source.where(origin), corners=corners)


def _triangles(mesh: Mesh) -> Triangles:
    """Return a mesh's triangles in its own frame."""
    counts = [len(surface.faces) for surface in mesh.surfaces]
    if not counts:
        return Triangles.join([])
    return Triangles(
        np.concatenate([surface.vertices[surface.faces] for surface in mesh.surfaces]),
        np.repeat([base_color(surface.material) for surface in mesh.surfaces], counts, axis=0),
        np.repeat([surface.material.alpha for surface in mesh.surfaces], counts),
        np.repeat([texture_number(surface.material.texture) for surface in mesh.surfaces], counts),
        np.concatenate([surface.coordinates for surface in mesh.surfaces]),
    )


@kernel
def _place_instances(
    source: npt.NDArray[np.float64],
    starts: npt.NDArray[np.int64],
    which: npt.NDArray[np.int64],
    poses: npt.NDArray[np.float64],
    corners: npt.NDArray[np.float64],
    origin: npt.NDArray[np.int64],
) -> None:
    """Write the triangles of mesh ``which[i]`` at ``poses[i]``: scale, position, angle; and where each came from."""
    at = 0
    for i in range(len(which)):
        sx, sy, sz = poses[i, 0], poses[i, 1], poses[i, 2]
        c, s = np.cos(poses[i, 6]), np.sin(poses[i, 6])
        for k in range(starts[which[i]], starts[which[i] + 1]):
            for corner in range(3):
                x, y = source[k, corner, 0] * sx, source[k, corner, 1] * sy
                corners[at, corner, 0] = x * c - y * s + poses[i, 3]
                corners[at, corner, 1] = x * s + y * c + poses[i, 4]
                corners[at, corner, 2] = source[k, corner, 2] * sz + poses[i, 5]
            origin[at] = k
            at += 1


@kernel
def project(corners: npt.NDArray[np.float64], axes: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Return corners, shape (n, 3, 3), along the rows of `axes`."""
    out = np.empty_like(corners)
    for k in range(len(corners)):
        for corner in range(3):
            x, y, z = corners[k, corner, 0], corners[k, corner, 1], corners[k, corner, 2]
            for axis in range(3):
                out[k, corner, axis] = x * axes[axis, 0] + y * axes[axis, 1] + z * axes[axis, 2]
    return out


@kernel
def bounds(corners: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Return the lowest and the highest coordinates of corners, shape (n, 3, 3), as rows."""
    out = np.empty((2, 3))
    out[0], out[1] = np.inf, -np.inf
    for k in range(len(corners)):
        for corner in range(3):
            for axis in range(3):
                out[0, axis] = min(out[0, axis], corners[k, corner, axis])
                out[1, axis] = max(out[1, axis], corners[k, corner, axis])
    return out


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
def _rasterise(
    corners: npt.NDArray[np.float64],
    order: npt.NDArray[np.int64],
    depth: npt.NDArray[np.float32],
    index: npt.NDArray[np.int32],
) -> None:
    """Write the nearest depth and its triangle for each pixel; x and y are in pixels, z towards the eye."""
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
    _rasterise(pixels, opaque, depth, index)
    image = np.empty((height, width, 3), dtype=np.float32)
    image[:] = background
    # Where pixel (0, 0) lies in the view's plane, and the rotation from the view's axes to the light's.
    origin = np.array([low[0] - (_BORDER - 0.5) / view.scale, high[1] + (_BORDER - 0.5) / view.scale])
    turn = axes @ LIGHT.T
    shadow, corner, cell = _shadow_map(project(triangles.corners, LIGHT), opaque)
    tiles = tiles_at(np.unique(triangles.textures), view.scale)
    _shade_pixels(
        depth,
        index,
        _lighting(triangles.corners, index, axes[2], SUN, LIGHT),
        triangles.colors,
        (pixels, triangles.coordinates, triangles.textures),
        (tiles.texels, tiles.frames, tiles.sizes),
        shadow,
        (float(corner[0]), float(corner[1]), cell),
        (float(origin[0]), float(origin[1]), view.scale),
        turn,
        image,
    )
    glass = np.flatnonzero(clear)
    if len(glass):
        front = np.full(depth.shape, -1, dtype=np.int32)
        _rasterise(pixels, glass, depth, front)
        _blend_glass(front, triangles.colors, triangles.alpha, image)
    return np.asarray(np.clip(image, 0.0, 1.0) * 255.0 + 0.5, dtype=np.uint8)


@kernel
def _lighting(
    corners: npt.NDArray[np.float64],
    index: npt.NDArray[np.int32],
    toward: npt.NDArray[np.float64],
    sun: npt.NDArray[np.float64],
    light: npt.NDArray[np.float64],
) -> npt.NDArray[np.float64]:
    """Return how each triangle that a pixel shows is lit.

    As (n, 5) rows: shade without the sun, the sun's part, and a step off the face in the light's axes.
    """
    seen = np.zeros(len(corners), dtype=np.bool_)
    for y in range(index.shape[0]):
        for x in range(index.shape[1]):
            if index[y, x] >= 0:
                seen[index[y, x]] = True
    out = np.zeros((len(corners), 5))
    for k in np.flatnonzero(seen):
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
        # Three centimetres off the face, so that no face shades itself.
        for axis in range(3):
            out[k, 2 + axis] = 0.03 * (x * light[axis, 0] + y * light[axis, 1] + z * light[axis, 2])
    return out


def _shadow_map(cast: Floats, opaque: npt.NDArray[np.int64]) -> tuple[Singles, Floats, float]:
    """Return the depths that the sun sees, the place of cell (0, 0), and the length of a cell."""
    low, high = bounds(cast)
    extent = high - low
    cell = max(SHADOW_CELL, float(extent[:2].max()) / 1600.0)
    placed = cast.copy()
    placed[..., :2] = (cast[..., :2] - low[:2]) / cell + 2
    shape = (int(extent[1] / cell) + 5, int(extent[0] / cell) + 5)
    depth = np.full(shape, -np.inf, dtype=np.float32)
    _rasterise(placed, opaque, depth, np.full(shape, -1, dtype=np.int32))
    return depth, low[:2] - 2 * cell, cell


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
def _shade_pixels(
    depth: npt.NDArray[np.float32],
    index: npt.NDArray[np.int32],
    lighting: npt.NDArray[np.float64],
    colors: npt.NDArray[np.float64],
    laid: tuple[Floats, Floats, Ints],
    tiles: tuple[Floats, Ints, Floats],
    shadow: npt.NDArray[np.float32],
    shadow_frame: tuple[float, float, float],
    view_frame: tuple[float, float, float],
    turn: npt.NDArray[np.float64],
    image: npt.NDArray[np.float32],
) -> None:
    """Colour the pixels that are hit.

    Parameters
    ----------
    depth, index : (height, width) arrays
        Towards the eye, metres; the triangle, -1 for none.
    lighting : (n, 5) array
        For each triangle in `index`: shade without the sun, the sun's part, a step off the face in the light's axes.
    colors : (n, 3) array
    laid : ((n, 3, 3), (n, 3, 2), (n,)) arrays
        Corners in the picture, their coordinates on textures, and the numbers of these.
    tiles : arrays
        The parts of `Tiles`.
    shadow : (rows, columns) array
        Depths towards the light.
    shadow_frame, view_frame : (x, y, length)
        Place of the first cell and metres a cell; place of the first pixel and pixels a metre.
    turn : (3, 3) array
        From the view's axes to the light's: ``place @ turn``.
    image : (height, width, 3) array
        Written.
    """
    height, width = depth.shape
    corners, coordinates, textures = laid
    texels, frames, sizes = tiles
    left, bottom, cell = shadow_frame
    x0, y0, scale = view_frame
    for y in range(height):
        for x in range(width):
            k = index[y, x]
            if k < 0:
                continue
            u, v, w = x0 + x / scale, y0 - y / scale, float(depth[y, x])
            sky, sunny = lighting[k, 0], 0.0
            if lighting[k, 1] > 0.0:
                a = u * turn[0, 0] + v * turn[1, 0] + w * turn[2, 0] + lighting[k, 2]
                b = u * turn[0, 1] + v * turn[1, 1] + w * turn[2, 1] + lighting[k, 3]
                c = u * turn[0, 2] + v * turn[1, 2] + w * turn[2, 2] + lighting[k, 4]
                i = min(max(int((a - left) / cell), 1), shadow.shape[1] - 2)
                j = min(max(int((b - bottom) / cell), 1), shadow.shape[0] - 2)
                lit = 0
                for dj, di in ((0, 0), (0, 1), (0, -1), (1, 0), (-1, 0)):
                    if c > shadow[j + dj, i + di] - 0.05:
                        lit += 1
                sunny = lighting[k, 1] * lit / 5.0
            dark = _EDGE * _occlusion(depth, y, x, 1, 1e9)
            sky *= 1.0 - _HOLLOW * _hollow(depth, y, x, scale)
            texel = (1.0, 1.0, 1.0)
            if textures[k] >= 0 and frames[textures[k], 1] > 0:
                s, t = _place_on_tile(corners[k], coordinates[k], x + 0.5, y + 0.5)
                texel = sampled(texels, frames[textures[k]], sizes[textures[k]], s, t)
            for channel in range(3):
                light = (sky * SKYLIGHT[channel] + sunny * SUNLIGHT[channel]) * (1.0 - 0.5 * dark)
                image[y, x, channel] = colors[k, channel] * texel[channel] * light


@kernel
def _place_on_tile(corners: Floats, coordinates: Floats, x: float, y: float) -> tuple[float, float]:
    """Return the coordinates of the point of a triangle that is seen at a place of the picture."""
    ax, ay = corners[0, 0], corners[0, 1]
    bx, by = corners[1, 0] - ax, corners[1, 1] - ay
    cx, cy = corners[2, 0] - ax, corners[2, 1] - ay
    area = bx * cy - by * cx
    b = ((x - ax) * cy - (y - ay) * cx) / area
    c = ((y - ay) * bx - (x - ax) * by) / area
    a = 1.0 - b - c
    return (
        a * coordinates[0, 0] + b * coordinates[1, 0] + c * coordinates[2, 0],
        a * coordinates[0, 1] + b * coordinates[1, 1] + c * coordinates[2, 1],
    )


@kernel
def _blend_glass(
    index: npt.NDArray[np.int32],
    colors: npt.NDArray[np.float64],
    alpha: npt.NDArray[np.float64],
    image: npt.NDArray[np.float32],
) -> None:
    """Blend the nearest glass with what is behind it.

    Parameters
    ----------
    index : (height, width) array
        The nearest triangle of glass, -1 for none.
    """
    for y in range(index.shape[0]):
        for x in range(index.shape[1]):
            k = index[y, x]
            if k >= 0:
                for channel in range(3):
                    image[y, x, channel] = image[y, x, channel] * (1.0 - alpha[k]) + colors[k, channel] * alpha[k]

"""Triangles in the plane of a picture: projected, bounded, and rasterised to depths and triangle numbers.

The z-buffer follows Catmull, E. 1974, A subdivision algorithm for computer display of curved surfaces.
"""

import numpy as np
import numpy.typing as npt

from mansion_geometry.compiled import Floats, kernel

__all__ = ["bounds", "bounds_along", "number_seen", "project", "rasterise", "seen_along", "seen_from", "turned"]


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


@kernel
def bounds_along(corners: npt.NDArray[np.float64], axes: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Return the `bounds` of corners along the rows of `axes`."""
    out = np.empty((2, 3))
    out[0], out[1] = np.inf, -np.inf
    for k in range(len(corners)):
        for corner in range(3):
            x, y, z = corners[k, corner, 0], corners[k, corner, 1], corners[k, corner, 2]
            for axis in range(3):
                along = x * axes[axis, 0] + y * axes[axis, 1] + z * axes[axis, 2]
                out[0, axis] = min(out[0, axis], along)
                out[1, axis] = max(out[1, axis], along)
    return out


@kernel
def seen_along(
    corners: npt.NDArray[np.float64],
    axes: npt.NDArray[np.float64],
    left_top: tuple[float, float],
    scale: float,
    border: float,
) -> npt.NDArray[np.float64]:
    """Return corners as pixels of a picture without perspective, and how far they are towards the eye.

    Parameters
    ----------
    corners : (n, 3, 3) array
    axes : (3, 3) array
        Right, up, and towards the eye.
    left_top : (float, float)
        The place along the first two axes that the picture shows in its upper left corner, within the border.
    scale : float
        Pixels a metre.
    border : float
        Pixels.
    """
    out = np.empty_like(corners)
    for k in range(len(corners)):
        for corner in range(3):
            x, y, z = corners[k, corner, 0], corners[k, corner, 1], corners[k, corner, 2]
            right = x * axes[0, 0] + y * axes[0, 1] + z * axes[0, 2]
            up = x * axes[1, 0] + y * axes[1, 1] + z * axes[1, 2]
            out[k, corner, 0] = (right - left_top[0]) * scale + border
            out[k, corner, 1] = (left_top[1] - up) * scale + border
            out[k, corner, 2] = x * axes[2, 0] + y * axes[2, 1] + z * axes[2, 2]
    return out


@kernel
def seen_from(
    corners: npt.NDArray[np.float64],
    axes: npt.NDArray[np.float64],
    eye: npt.NDArray[np.float64],
    focal: float,
    center: npt.NDArray[np.float64],
) -> npt.NDArray[np.float64]:
    """Return corners as pixels of a camera's picture, and the inverse of their distance along its optical axis.

    Parameters
    ----------
    corners : (n, 3, 3) array
    axes : (3, 3) array
        Right, up, and towards the eye.
    eye : (3,) array
        The eye's place along the axes.
    focal : float
        Focal length, pixels.
    center : (2,) array
        Where the optical axis meets the picture, pixels.
    """
    out = np.empty_like(corners)
    for k in range(len(corners)):
        for corner in range(3):
            x, y, z = corners[k, corner, 0], corners[k, corner, 1], corners[k, corner, 2]
            right = x * axes[0, 0] + y * axes[0, 1] + z * axes[0, 2]
            up = x * axes[1, 0] + y * axes[1, 1] + z * axes[1, 2]
            inverse = 1.0 / max(eye[2] - (x * axes[2, 0] + y * axes[2, 1] + z * axes[2, 2]), 0.1)
            out[k, corner, 0] = center[0] + focal * (right - eye[0]) * inverse
            out[k, corner, 1] = center[1] - focal * (up - eye[1]) * inverse
            out[k, corner, 2] = inverse
    return out


@kernel
def number_seen(index: npt.NDArray[np.int32], glass: npt.NDArray[np.int32], triangles: int) -> npt.NDArray[np.int64]:
    """Return which of a number of triangles are seen, in their order, and number them anew in `index` and `glass`.

    Parameters
    ----------
    index, glass : (height, width) arrays
        The triangle that each pixel shows, -1 for none; changed to numbers of what is returned.
    triangles : int
        How many there are.
    """
    new = np.full(triangles, -1, dtype=np.int32)
    for picture in (index, glass):
        for y in range(picture.shape[0]):
            for x in range(picture.shape[1]):
                if picture[y, x] >= 0:
                    new[picture[y, x]] = 0
    seen = np.flatnonzero(new == 0)
    for number in range(len(seen)):
        new[seen[number]] = number
    for picture in (index, glass):
        for y in range(picture.shape[0]):
            for x in range(picture.shape[1]):
                if picture[y, x] >= 0:
                    picture[y, x] = new[picture[y, x]]
    return seen


@kernel
def rasterise(
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


def turned(corners: Floats, turns: int) -> Floats:
    """Return corners turned by quarters about the vertical, counter-clockwise."""
    if turns % 4 == 0:
        return corners
    c, s = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[turns % 4]
    return project(corners, np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]))

"""Texture coordinates in metres: each face is laid flat along the axis that it faces most (box projection)."""

import numpy as np

from mansion_geometry.compiled import Floats, Ints, kernel

__all__ = ["box_coordinates", "fitted_coordinates", "slope_coordinates"]


@kernel
def box_coordinates(vertices: Floats, faces: Ints, bodies: Ints, turned: bool) -> Floats:
    """Return each face's corners on its textures, (m, 3, 2): metres to the right and up, seen from outside.

    Parameters
    ----------
    vertices : (n, 3) array
    faces : (m, 3) array of int
    bodies : (k,) array of int
        First face of each body: board, leg or cushion.
    turned : bool
        Lay the first coordinate along each body's longest side, as the grain of wood runs, and begin elsewhere on the
        tile for each body. Otherwise the second coordinate is the height on upright faces.
    """
    found = np.empty((len(faces), 3, 2))
    for body in range(len(bodies)):
        first = bodies[body]
        last = bodies[body + 1] if body + 1 < len(bodies) else len(faces)
        longest = _longest_side(vertices, faces, first, last) if turned else -1
        # Multiples of the golden section spread evenly over any tile.
        u0 = (0.6180339887 * body) % 1.0 if turned else 0.0
        v0 = (0.3819660113 * body) % 1.0 if turned else 0.0
        for f in range(first, last):
            axis, sign = _facing(vertices, faces, f)
            for corner in range(3):
                x, y, z = vertices[faces[f, corner]]
                if axis == 0:
                    u, v, upward = sign * y, z, 2
                elif axis == 1:
                    u, v, upward = -sign * x, z, 2
                else:
                    u, v, upward = x, sign * y, 1
                if upward == longest:
                    u, v = v, -u
                found[f, corner, 0] = u + u0
                found[f, corner, 1] = v + v0
    return found


@kernel
def fitted_coordinates(vertices: Floats, faces: Ints, bodies: Ints) -> Floats:
    """Return coordinates from 0 to 1 over each side of each body, so that it is filled by one picture.

    Parameters and result are those of `box_coordinates`.
    """
    found = box_coordinates(vertices, faces, bodies, False)
    for body in range(len(bodies)):
        first = bodies[body]
        last = bodies[body + 1] if body + 1 < len(bodies) else len(faces)
        low, high = np.full((6, 2), np.inf), np.full((6, 2), -np.inf)
        sides = np.empty(last - first, dtype=np.int64)
        for f in range(first, last):
            axis, sign = _facing(vertices, faces, f)
            side = 2 * axis + (1 if sign > 0.0 else 0)
            sides[f - first] = side
            for k in range(2):
                low[side, k] = min(low[side, k], found[f, :, k].min())
                high[side, k] = max(high[side, k], found[f, :, k].max())
        for f in range(first, last):
            side = sides[f - first]
            for k in range(2):
                found[f, :, k] = (found[f, :, k] - low[side, k]) / max(high[side, k] - low[side, k], 1e-9)
    return found


def slope_coordinates(vertices: Floats, faces: Ints) -> Floats:
    """Return coordinates as of `box_coordinates` in true size on any slope: along its level lines, and up it."""
    corners = vertices[faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    level = np.stack([-normals[:, 1], normals[:, 0], np.zeros(len(faces))], axis=1)
    level[np.linalg.norm(level, axis=1) < 1e-9] = (1.0, 0.0, 0.0)
    level /= np.linalg.norm(level, axis=1, keepdims=True)
    up = np.cross(normals, level)
    up /= np.maximum(np.linalg.norm(up, axis=1, keepdims=True), 1e-12)
    found: Floats = np.stack([np.einsum("fkx,fx->fk", corners, axis) for axis in (level, up)], axis=-1)
    return found


@kernel
def _longest_side(vertices: Floats, faces: Ints, first: int, last: int) -> int:
    """Return the axis along which faces reach furthest."""
    best, longest = -1.0, 0
    for axis in range(3):
        low, high = np.inf, -np.inf
        for f in range(first, last):
            for corner in range(3):
                value = vertices[faces[f, corner], axis]
                low, high = min(low, value), max(high, value)
        if high - low > best + 1e-6:
            best, longest = high - low, axis
    return longest


@kernel
def _facing(vertices: Floats, faces: Ints, f: int) -> tuple[int, float]:
    """Return the axis that a face is most at right angles to, and the side of it that it looks to."""
    a, b, c = vertices[faces[f, 0]], vertices[faces[f, 1]], vertices[faces[f, 2]]
    ux, uy, uz = b[0] - a[0], b[1] - a[1], b[2] - a[2]
    vx, vy, vz = c[0] - a[0], c[1] - a[1], c[2] - a[2]
    nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    if abs(nz) >= abs(nx) and abs(nz) >= abs(ny):
        return 2, 1.0 if nz >= 0.0 else -1.0
    if abs(nx) >= abs(ny):
        return 0, 1.0 if nx >= 0.0 else -1.0
    return 1, 1.0 if ny >= 0.0 else -1.0

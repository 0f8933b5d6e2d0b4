"""Vertex normals: smooth over flat angles, sharp over steep ones."""

import numpy as np

from mansion_geometry.compiled import Floats, Ints, kernel

__all__ = ["SMOOTH", "corner_normals", "textured_corners"]


SMOOTH = float(np.cos(np.radians(40.0)))
"""Faces that meet at less than this angle are shaded as one curved surface."""


def corner_normals(vertices: Floats, faces: Ints) -> tuple[Floats, Floats, Ints]:
    """Give each corner of each face a normal, smooth over flat angles, and join equal corners.

    Parameters
    ----------
    vertices : (n, 3) array
    faces : (m, 3) array of int

    Returns
    -------
    (points, normals, faces)
        Arrays (k, 3), (k, 3) and (l, 3); faces without area are left out.
    """
    points, normals, _, joined = textured_corners(vertices, faces, np.zeros((len(faces), 3, 2)))
    return points, normals, joined


def textured_corners(vertices: Floats, faces: Ints, coordinates: Floats) -> tuple[Floats, Floats, Floats, Ints]:
    """Do as `corner_normals`, and join only corners at one place on the textures.

    Parameters
    ----------
    vertices : (n, 3) array
    faces : (m, 3) array of int
    coordinates : (m, 3, 2) array
        Place of each face's corners on its textures.

    Returns
    -------
    (points, normals, coordinates, faces)
        Arrays (k, 3), (k, 3), (k, 2) and (l, 3).
    """
    vertices = np.ascontiguousarray(vertices, dtype=np.float64)
    faces = np.ascontiguousarray(faces, dtype=np.int64)
    coordinates = np.ascontiguousarray(coordinates, dtype=np.float64)
    a, b, c = (vertices[faces[:, i]] for i in range(3))
    areas = _cross(b - a, c - a)
    lengths = np.sqrt((areas * areas).sum(axis=1))
    keep = lengths > 1e-12
    if not keep.all():
        faces, areas, lengths, coordinates = faces[keep], areas[keep], lengths[keep], coordinates[keep]
    return _join_corners(vertices, faces, coordinates, areas, areas / lengths[:, None], SMOOTH)


def _cross(a: Floats, b: Floats) -> Floats:
    out = np.empty_like(a)
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        out[:, i] = a[:, j] * b[:, k] - a[:, k] * b[:, j]
    return out


@kernel
def _weld(vertices: Floats) -> Ints:
    """Number the positions of vertices in order of first appearance; vertices equal to 0.01 mm share a position."""
    count = len(vertices)
    size = 16
    while size < 2 * count:
        size *= 2
    table = np.full(size, -1, dtype=np.int64)
    keys = np.empty((count, 3), dtype=np.int64)
    place = np.empty(count, dtype=np.int64)
    found = 0
    for v in range(count):
        for axis in range(3):
            keys[v, axis] = np.int64(np.round(vertices[v, axis] * 1e5))
        # The multipliers of Teschner et al. (2003), Optimized spatial hashing for collision detection of deformable
        # objects; a table twice as large as the vertices keeps the probes of open addressing short.
        slot = (keys[v, 0] * 73856093 ^ keys[v, 1] * 19349663 ^ keys[v, 2] * 83492791) & (size - 1)
        while True:
            other = table[slot]
            if other < 0:
                table[slot] = v
                place[v] = found
                found += 1
                break
            if keys[other, 0] == keys[v, 0] and keys[other, 1] == keys[v, 1] and keys[other, 2] == keys[v, 2]:
                place[v] = place[other]
                break
            slot = (slot + 1) & (size - 1)
    return place


@kernel
def _corners_by_place(place: Ints, faces: Ints) -> tuple[Ints, Ints]:
    """Group corners: those at position p are ``members[starts[p] : starts[p + 1]]``; corner k is of face k // 3."""
    corners = 3 * len(faces)
    starts = np.zeros(len(place) + 1, dtype=np.int64)
    for k in range(corners):
        starts[place[faces[k // 3, k % 3]] + 1] += 1
    starts = np.cumsum(starts)
    fill = starts[:-1].copy()
    members = np.empty(corners, dtype=np.int64)
    for k in range(corners):
        p = place[faces[k // 3, k % 3]]
        members[fill[p]] = k
        fill[p] += 1
    return starts, members


@kernel
def _shared_normal(
    f: int, members: Ints, start: int, end: int, areas: Floats, units: Floats, smooth: float
) -> tuple[float, float, float]:
    """Return the unit sum of the area normals of those faces of ``members[start:end]`` that nearly face as `f` does."""
    x, y, z = 0.0, 0.0, 0.0
    for j in range(start, end):
        g = members[j] // 3
        alike = units[f, 0] * units[g, 0] + units[f, 1] * units[g, 1] + units[f, 2] * units[g, 2]
        if alike > smooth:
            x += areas[g, 0]
            y += areas[g, 1]
            z += areas[g, 2]
    length = np.sqrt(x * x + y * y + z * z)
    if length > 1e-12:
        return x / length, y / length, z / length
    return units[f, 0], units[f, 1], units[f, 2]


@kernel
def _equal_corner(
    normals: Floats, places: Floats, start: int, end: int, normal: tuple[float, float, float], u: float, v: float
) -> int:
    """Return the first of ``normals[start:end]`` that is `normal` at the place (u, v) of the textures, or `end`."""
    x, y, z = normal
    for q in range(start, end):
        alike = abs(normals[q, 0] - x) < 1e-4 and abs(normals[q, 1] - y) < 1e-4 and abs(normals[q, 2] - z) < 1e-4
        if alike and abs(places[q, 0] - u) < 1e-4 and abs(places[q, 1] - v) < 1e-4:
            return q
    return end


@kernel
def _join_corners(
    vertices: Floats, faces: Ints, coordinates: Floats, areas: Floats, units: Floats, smooth: float
) -> tuple[Floats, Floats, Floats, Ints]:
    """Give each corner its shared normal; corners at one position with the same normal and place become one point."""
    corners = 3 * len(faces)
    starts, members = _corners_by_place(_weld(vertices), faces)
    points = np.empty((corners, 3))
    normals = np.empty((corners, 3))
    places = np.empty((corners, 2))
    joined = np.empty((len(faces), 3), dtype=np.int64)
    count = 0
    for p in range(len(vertices)):
        first = count
        for i in range(starts[p], starts[p + 1]):
            f, corner = members[i] // 3, members[i] % 3
            x, y, z = _shared_normal(f, members, starts[p], starts[p + 1], areas, units, smooth)
            u, v = coordinates[f, corner, 0], coordinates[f, corner, 1]
            mine = _equal_corner(normals, places, first, count, (x, y, z), u, v)
            if mine == count:
                points[mine] = vertices[faces[f, corner]]
                normals[mine, 0], normals[mine, 1], normals[mine, 2] = x, y, z
                places[mine, 0], places[mine, 1] = u, v
                count += 1
            joined[f, corner] = mine
    return points[:count].copy(), normals[:count].copy(), places[:count].copy(), joined

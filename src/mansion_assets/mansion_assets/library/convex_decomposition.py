"""Convex decomposition of triangles: convex bodies as they are, the rest by CoACD [1]_ or into boxes of filled cells.

References
----------
.. [1] Wei, X., et al. (2022). Approximate convex decomposition for 3D meshes with collision-aware concavity and tree
   search. ACM Transactions on Graphics, 41(4). https://github.com/SarahWeiii/CoACD
"""

import importlib
import importlib.util
from collections.abc import Iterator, Sequence
from itertools import compress, permutations
from typing import Any, Final

import numpy as np
import trimesh

from mansion_assets.convex import Box, Convex, Hull, bounding_box
from mansion_assets.glb_meshes import PieceRecord
from mansion_assets.piece_budget import budget_of, simplified
from mansion_geometry.compiled import Bools, Floats, Ints
from mansion_msgs_py.shapes import Size3

__all__ = ["METHODS", "boxes_of_cells", "decomposed", "method", "piece_record"]

METHODS: Final = {"coacd": "convex bodies, and CoACD of the rest", "cells": "boxes of filled cells"}

_COACD: Final = {
    "preprocess_resolution": 40,
    "max_ch_vertex": 32,
    "resolution": 1000,
    "mcts_iterations": 40,
    "mcts_max_depth": 2,
    "mcts_nodes": 10,
}
"""Five times as quick as CoACD's own settings; its hulls have at most 6% more volume on a table and a ring."""

_MOST_FACES: Final = 400
"""Most faces of a body that may be a piece as it is: engines want hulls of few."""

_PLANE: Final = 1e-4
"""Share of its extent by which a convex body may miss the plane of a face."""

_CELLS: Final = 28
"""Cells along the longest edge."""

_LEAST_CELL: Final = 0.006
"""Metres."""

_THINNEST: Final = 1e-3
"""Metres of the least side of a piece: what is flat has no volume, and engines want one."""

_DIGITS: Final = 5


def method() -> str:
    """Return how this machine decomposes: a key of `METHODS`."""
    return "coacd" if importlib.util.find_spec("coacd") else "cells"


def decomposed(vertices: Floats, faces: Ints, size: Size3, free: Sequence[Box], how: str) -> list[Convex]:
    """Return the convex pieces of triangles, within the budget of the asset's size.

    Parameters
    ----------
    vertices, faces : (n, 3) and (m, 3) arrays
        Metres.
    size : (w, d, h)
        Size of the whole asset.
    free : sequence of Box
        Room for objects, which no joined piece takes.
    how : str
        A key of `METHODS`.
    """
    if how == "coacd":
        return _hulls(vertices, faces, size, free)
    return simplified(boxes_of_cells(vertices[faces]), size, free)


def _hulls(vertices: Floats, faces: Ints, size: Size3, free: Sequence[Box]) -> list[Convex]:
    """Return closed convex bodies as they are, and hulls of the rest."""
    # Vertices that differ by their normals alone are one, or no body would be closed.
    mesh = trimesh.Trimesh(vertices, faces, process=True)
    connected = trimesh.graph.connected_components(mesh.face_adjacency, nodes=np.arange(len(mesh.faces)), min_len=1)
    bodies = [mesh.submesh([found], append=True) for found in connected]
    convex = [_is_convex(body) for body in bodies]
    pieces = [_hull(np.asarray(body.vertices), np.asarray(body.faces)) for body in compress(bodies, convex)]
    rest = [body for body, whole in zip(bodies, convex, strict=True) if not whole]
    budget = budget_of(size)
    if rest:
        remaining = trimesh.util.concatenate(rest)
        pieces += _searched(np.asarray(remaining.vertices), np.asarray(remaining.faces), max(budget - len(pieces), 1))
    return pieces if len(pieces) <= budget else simplified(pieces, size, free)


def _is_convex(body: Any) -> bool:
    """Whether a mesh is closed, of a size worth the test, and has no vertex outside the plane of a face."""
    if len(body.faces) > _MOST_FACES or not body.is_watertight:
        return False
    beyond = np.einsum("vfi,fi->vf", body.vertices[:, None] - body.triangles[None, :, 0], body.face_normals)
    return float(beyond.max()) <= _PLANE * float(body.extents.max())


def _searched(vertices: Floats, faces: Ints, most: int) -> list[Convex]:
    coacd: Any = importlib.import_module("coacd")
    coacd.set_log_level("error")
    mesh = coacd.Mesh(vertices, faces.astype(np.int32))
    found = coacd.run_coacd(mesh, max_convex_hull=most, seed=0, **_COACD)
    # Triangles that bound no solid are wrapped in a shell of a cell of the resolution first, so that hulls reach beyond
    # them; scaled to the extent of the triangles, which keeps them convex, none stands out of its part.
    points = np.concatenate([np.asarray(corners) for corners, _ in found])
    low, extent = vertices.min(axis=0), np.ptp(vertices, axis=0)
    first, reach = points.min(axis=0), np.maximum(np.ptp(points, axis=0), 1e-9)
    return [
        _hull(low + (np.asarray(corners) - first) * (extent / reach), np.asarray(sides)) for corners, sides in found
    ]


def _hull(vertices: Floats, faces: Ints) -> Convex:
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    if float((high - low).min()) < _THINNEST:
        return bounding_box(low, np.maximum(high, low + _THINNEST))
    return Hull(vertices.astype(np.float64), faces.astype(np.int64))


def boxes_of_cells(corners: Floats) -> list[Convex]:
    """Return boxes that together hold triangles, and what they enclose.

    Parameters
    ----------
    corners : (m, 3, 3) array
        Corners of the triangles.

    Notes
    -----
    Cells of a raster that a triangle passes through, or that are closed in on all six sides, are joined to boxes,
    greedily the largest that begins at each; a side that cuts the outer cells is then moved to the triangles.
    """
    low, high = corners.reshape(-1, 3).min(axis=0), corners.reshape(-1, 3).max(axis=0)
    cell = max(float((high - low).max()) / _CELLS, _LEAST_CELL)
    shape = np.maximum(np.ceil((high - low) / cell - 1e-6).astype(int), 1)
    points = np.concatenate(list(_sampled(corners, cell / 2.5)))
    at = np.clip(((points - low) / cell).astype(int), 0, shape - 1)
    surface = np.zeros(tuple(shape.tolist()), dtype=bool)
    surface[at[:, 0], at[:, 1], at[:, 2]] = True
    left = _filled(surface)
    boxes: list[Convex] = []
    while left.any():
        first, last = _grown(left)
        left[first[0] : last[0], first[1] : last[1], first[2] : last[2]] = False
        inside = points[((at >= first) & (at < last)).all(axis=1)]
        boxes.append(_fitted(first, last, surface, inside, low, high, cell))
    return boxes


def _sampled(corners: Floats, step: float) -> Iterator[Floats]:
    """Yield points no further apart than `step` on every triangle."""
    edges = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    parts = np.clip(np.ceil(edges / step).astype(int), 1, 4 * _CELLS)
    for count in np.unique(parts).tolist():
        u, v = np.meshgrid(np.arange(count + 1) / count, np.arange(count + 1) / count, indexing="ij")
        inside = u + v <= 1.0 + 1e-9
        weights = np.stack([1.0 - u[inside] - v[inside], u[inside], v[inside]], axis=1)
        yield np.einsum("kc,mcx->mkx", weights, corners[parts == count]).reshape(-1, 3)


def _filled(surface: Bools) -> Bools:
    """Return the cells of the surface and those that it closes in along all three axes, both ways."""
    closed = np.ones_like(surface)
    for axis in range(3):
        before = np.maximum.accumulate(surface, axis=axis)
        after = np.flip(np.maximum.accumulate(np.flip(surface, axis=axis), axis=axis), axis=axis)
        closed &= before & after
    return surface | closed


def _grown(left: Bools) -> tuple[Ints, Ints]:
    """Return the largest box of set cells that begins at the first, of those grown along one axis after another."""
    start = np.array(np.unravel_index(int(left.argmax()), left.shape))
    best, found = 0, (start, start + 1)
    for order in permutations(range(3)):
        first, last = start.copy(), start + 1
        for axis in order:
            while last[axis] < left.shape[axis]:
                slab = [slice(int(first[a]), int(last[a])) for a in range(3)]
                slab[axis] = slice(int(last[axis]), int(last[axis]) + 1)
                if not left[tuple(slab)].all():
                    break
                last[axis] += 1
        volume = int(np.prod(last - first))
        if volume > best:
            best, found = volume, (first, last)
    return found


def _fitted(first: Ints, last: Ints, surface: Bools, points: Floats, low: Floats, high: Floats, cell: float) -> Box:
    """Return a box of cells, its sides moved in to the triangles where the outer cells hold some."""
    near, far = low + cell * first, np.minimum(low + cell * last, high)
    block = surface[first[0] : last[0], first[1] : last[1], first[2] : last[2]]
    for axis in range(3) if len(points) else ():
        if np.take(block, 0, axis=axis).any():
            near[axis] = max(near[axis], float(points[:, axis].min()))
        if np.take(block, -1, axis=axis).any():
            far[axis] = min(far[axis], float(points[:, axis].max()))
    thin = far - near < 1e-3
    middle = (near + far) / 2
    near, far = np.where(thin, middle - 5e-4, near), np.where(thin, middle + 5e-4, far)
    return bounding_box(near, far)


def piece_record(part: str, piece: Convex) -> PieceRecord:
    """Return a piece as files have it."""
    if isinstance(piece, Box):
        (x, y, z), (w, d, h) = piece.center, piece.size
        return PieceRecord(
            part=part,
            center=(round(x, _DIGITS), round(y, _DIGITS), round(z, _DIGITS)),
            size=(round(w, _DIGITS), round(d, _DIGITS), round(h, _DIGITS)),
        )
    rows = np.round(piece.vertices, _DIGITS).tolist()
    return PieceRecord(
        part=part, vertices=[(v[0], v[1], v[2]) for v in rows], faces=[(f[0], f[1], f[2]) for f in piece.faces.tolist()]
    )

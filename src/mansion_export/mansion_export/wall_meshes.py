"""The body of a wall as one closed mesh, cut at its openings."""

from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from mansion_export.appearance import named, surface_material
from mansion_export.model import Material, Surface
from mansion_export.solids import Opening, WallBodies
from mansion_msgs_py.scene import Wall
from mansion_scene.structure.materials import DEFAULT_FACADE

__all__ = ["wall_surfaces"]

Quad: TypeAlias = tuple[int, int, int, int]

SAME = 1e-6
"""Cuts of a wall that are nearer than this, metres, are one."""


def wall_surfaces(wall: Wall, bodies: WallBodies) -> list[Surface]:
    """Return a wall's faces, each in the material of its room, and its edges.

    Parameters
    ----------
    wall : Wall
    bodies : WallBodies
        Of the wall's floor: where it is cut, and how far it goes on at corners.

    Returns
    -------
    list of Surface
        Left face, right face with the wall's two ends, and what is seen of its core: its top and the reveals of doors
        and windows.

    Notes
    -----
    Wall and openings are cut along one grid of upright and level lines, and the cells of a face share their corners.
    Bodies of boxes would meet in T-junctions, through which renderers let the background shine as dotted lines.
    """
    openings = bodies.openings(wall)
    along = _cuts(bodies.stretch(wall), [(each.low, each.high) for each in openings])
    up = _cuts((0.0, wall.height), [(each.sill, each.head) for each in openings])
    solid = _solid(along, up, openings)
    vertices = _vertices(wall, along, up)
    count = len(up)

    def corner(i: int, k: int, right: int) -> int:
        return (i * count + k) * 2 + right

    left: list[Quad] = []
    right: list[Quad] = []
    core: list[Quad] = []
    for i, k in np.argwhere(solid).tolist():
        a, b, c, d = ((i, k), (i + 1, k), (i + 1, k + 1), (i, k + 1))
        left.append((corner(*b, 0), corner(*a, 0), corner(*d, 0), corner(*c, 0)))
        right.append((corner(*a, 1), corner(*b, 1), corner(*c, 1), corner(*d, 1)))
        sides = ((i, k - 1, a, b), (i + 1, k, b, c), (i, k + 1, c, d), (i - 1, k, d, a))
        for ni, nk, start, end in sides:
            beyond = not (0 <= ni < solid.shape[0])
            if beyond or not (0 <= nk < solid.shape[1]) or not solid[ni, nk]:
                quad = (corner(*start, 0), corner(*end, 0), corner(*end, 1), corner(*start, 1))
                (right if beyond else core).append(quad)
    outside = wall.right_material or (DEFAULT_FACADE if wall.exterior else "")
    materials = (
        surface_material(wall.left_material, "wall"),
        surface_material(outside, "wall"),
        named("white_drywall"),
    )
    return [_surface(vertices, quads, material) for quads, material in zip((left, right, core), materials) if quads]


def _cuts(ends: tuple[float, float], spans: list[tuple[float, float]]) -> npt.NDArray[np.float64]:
    """Return where a wall is cut in one direction, ascending, its ends included."""
    inner = sorted(value for span in spans for value in span if ends[0] < value < ends[1])
    cuts = [ends[0]]
    for value in inner:
        if value > cuts[-1] + SAME and value < ends[1] - SAME:
            cuts.append(value)
    return np.array([*cuts, ends[1]])


def _solid(
    along: npt.NDArray[np.float64], up: npt.NDArray[np.float64], openings: list[Opening]
) -> npt.NDArray[np.bool_]:
    """Tell which cells of the grid no opening takes; (len(along) - 1, len(up) - 1)."""
    x, z = (along[1:] + along[:-1])[:, None] / 2, (up[1:] + up[:-1])[None] / 2
    solid = np.ones((len(along) - 1, len(up) - 1), dtype=bool)
    for each in openings:
        solid &= ~((each.low < x) & (x < each.high) & (each.sill < z) & (z < each.head))
    return solid


def _vertices(wall: Wall, along: npt.NDArray[np.float64], up: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    """Return the grid's corners on the left and right face, (2 * len(along) * len(up), 3)."""
    start, end = np.array(wall.segment[0], dtype=float), np.array(wall.segment[1], dtype=float)
    unit = (end - start) / max(float(np.hypot(*(end - start))), 1e-9)
    to_left = np.array([-unit[1], unit[0]]) * wall.thickness / 2
    grid = np.zeros((len(along), len(up), 2, 3))
    grid[..., :2] = (start + along[:, None] * unit)[:, None, None]
    grid[:, :, 0, :2] += to_left
    grid[:, :, 1, :2] -= to_left
    grid[..., 2] = up[None, :, None]
    return grid.reshape(-1, 3)


def _surface(vertices: npt.NDArray[np.float64], quads: list[Quad], material: Material) -> Surface:
    """Cut quads into triangles and drop the corners that none uses."""
    corners = np.array(quads, dtype=np.int64)
    faces = corners[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)
    used, compact = np.unique(faces, return_inverse=True)
    return Surface(material, vertices[used], compact.reshape(faces.shape))

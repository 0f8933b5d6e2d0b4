"""Walls of a floor, cut at their openings and joined at their corners: as intervals, boxes and closed meshes."""

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from mansion_assets.texture_coordinates import box_coordinates
from mansion_export.meshes.materials import named, surface_material
from mansion_export.meshes.model import Material, Surface
from mansion_export.meshes.solids import Box
from mansion_geometry.compiled import Floats
from mansion_msgs_py.scene import FloorScene, Wall
from mansion_msgs_py.shapes import Segment
from mansion_scene.structure.materials import DEFAULT_FACADE

__all__ = ["Opening", "WallBodies", "span", "wall_surfaces"]


SEAM = 0.002
"""Metres by which a lengthened wall stays behind the face it meets, so that no two faces coincide."""

NEAR = 0.05

SPIKE = 0.5
"""Sine of the angle below which two walls are not mitred: the outer corner would be a long spike."""

Quad: TypeAlias = tuple[int, int, int, int]

SAME = 1e-6
"""Cuts of a wall that are nearer than this, metres, are one."""


@dataclass(frozen=True, slots=True)
class Opening:
    """A hole in a wall, in metres along its centre line and above the floor."""

    id: str
    low: float
    high: float
    sill: float
    head: float


def span(wall: Wall, segment: Segment) -> tuple[float, float]:
    """Project a segment on a wall's centre line; metres from the wall's start, ascending."""
    (ax, ay), (bx, by) = wall.segment
    length = float(np.hypot(bx - ax, by - ay)) or 1.0
    ux, uy = (bx - ax) / length, (by - ay) / length
    t = sorted((x - ax) * ux + (y - ay) * uy for x, y in segment)
    return t[0], t[1]


class WallBodies:
    """The bodies of a floor's walls.

    Parameters
    ----------
    scene : FloorScene
    """

    def __init__(self, scene: FloorScene) -> None:
        walls = scene.walls
        starts = np.array([wall.segment[0] for wall in walls], dtype=float).reshape(-1, 2)
        ends = np.array([wall.segment[1] for wall in walls], dtype=float).reshape(-1, 2)
        vectors = ends - starts
        self._lengths = np.maximum(np.hypot(vectors[:, 0], vectors[:, 1]), 1e-9)
        self._units = vectors / self._lengths[:, None]
        self._starts, self._ends = starts, ends
        self._half = np.array([wall.thickness / 2 for wall in walls])
        self._beyond_ends = self._extensions()
        self._mitres = self._mitred_ends([wall.height for wall in walls])
        self._index = {wall.id: i for i, wall in enumerate(walls)}
        self._openings: dict[str, list[Opening]] = {wall.id: [] for wall in walls}
        by_id = {wall.id: wall for wall in walls}
        for door in scene.doors:
            wall = by_id.get(door.wall)
            if wall is not None:
                low, high = span(wall, door.segment)
                head = min(door.height, wall.height)
                self._openings[wall.id].append(Opening(door.id, low, high, 0.0, head))
        for window in scene.windows:
            wall = by_id.get(window.wall)
            if wall is not None:
                low, high = span(wall, window.segment)
                head = min(window.sill + window.height, wall.height)
                self._openings[wall.id].append(Opening(window.id, low, high, window.sill, head))
        for found in self._openings.values():
            found.sort(key=lambda opening: opening.low)

    def openings(self, wall: Wall) -> list[Opening]:
        """Return the doors and windows of a wall from its start to its end."""
        return self._openings[wall.id]

    def stretch(self, wall: Wall) -> tuple[float, float]:
        """Return from where to where a wall goes along its centre line, lengthened to close corners."""
        i = self._index[wall.id]
        before, after = self._beyond_ends[i].tolist()
        return -before, float(self._lengths[i]) + after

    def faces(self, wall: Wall) -> Floats:
        """Return from where to where the faces of a wall go along its centre line, ((left, right) low, high), metres.

        Two walls that make a corner are mitred: the outer faces meet, the inner faces meet, and none lies close behind
        another, where it would shine through in renderers. Other ends are as in `stretch`, the same for both faces.
        """
        i = self._index[wall.id]
        low, high = self.stretch(wall)
        ends = np.array([[low, low], [high, high]])
        for side, beyond in self._mitres.get(i, {}).items():
            ends[side] = (float(self._lengths[i]) + beyond) if side else -beyond
        inner = [place for each in self._openings[wall.id] for place in (each.low, each.high)]
        if inner and (min(inner) <= ends[0].max() or max(inner) >= ends[1].min()):
            return np.array([[low, low], [high, high]])
        return ends

    def pieces(self, wall: Wall) -> list[tuple[float, float]]:
        """Return the full-height parts of a wall between its openings, lengthened to close corners."""
        reached, end = self.stretch(wall)
        pieces = []
        for opening in self._openings[wall.id]:
            if opening.low > reached + 1e-6:
                pieces.append((reached, opening.low))
            reached = max(reached, opening.high)
        if end > reached + 1e-6:
            pieces.append((reached, end))
        return pieces

    def boxes(self, wall: Wall) -> list[Box]:
        """Return a wall as boxes between, below and above its openings; local x runs along the wall."""
        parts = [(low, high, 0.0, wall.height) for low, high in self.pieces(wall)]
        for opening in self._openings[wall.id]:
            if opening.sill > 0.0:
                parts.append((opening.low, opening.high, 0.0, opening.sill))
            if opening.head < wall.height - 1e-6:
                parts.append((opening.low, opening.high, opening.head, wall.height))
        i = self._index[wall.id]
        (ax, ay), (ux, uy) = self._starts[i].tolist(), self._units[i].tolist()
        rotation = float(np.degrees(np.arctan2(uy, ux)))
        boxes = []
        for low, high, bottom, top in parts:
            middle = (low + high) / 2
            center = (ax + ux * middle, ay + uy * middle, (bottom + top) / 2)
            boxes.append(Box(center, (high - low, wall.thickness, top - bottom), rotation))
        return boxes

    def _extensions(self) -> Floats:
        """Return how far walls go on beyond their ends, (n, 2): to the far face at a corner, to the middle at a T."""
        count = len(self._half)
        found = np.zeros((count, 2))
        if not count:
            return found
        cross = np.outer(self._units[:, 0], self._units[:, 1])
        cross -= np.outer(self._units[:, 1], self._units[:, 0])
        parallel = np.abs(cross) < 0.05
        reach = np.add.outer(self._half, self._half) + NEAR
        for side, (points, sign) in enumerate(((self._starts, -1.0), (self._ends, 1.0))):
            to_start = self._starts[None] - points[:, None]
            to_end = self._ends[None] - points[:, None]
            along = np.clip(-np.einsum("ijk,jk->ij", to_start, self._units), 0.0, self._lengths[None])
            nearest = to_start + along[..., None] * self._units[None]
            gap = np.minimum(np.hypot(*np.moveaxis(to_start, 2, 0)), np.hypot(*np.moveaxis(to_end, 2, 0)))
            goes_on = parallel & (gap < NEAR)
            np.fill_diagonal(goes_on, False)
            close = ~parallel & (np.hypot(nearest[..., 0], nearest[..., 1]) < reach)
            for i in np.flatnonzero(close.any(1) & ~goes_on.any(1)):
                others = np.flatnonzero(close[i])
                found[i, side] = self._beyond(
                    int(i), others, sign * cross[i, others], to_start[i, others], to_end[i, others], sign
                )
        return found

    def _mitred_ends(self, heights: list[float]) -> dict[int, dict[int, Floats]]:
        """Return how far the left and the right face go on beyond an end, by wall and end, where two walls are mitred.

        They are where just these two end, both of one height, at an angle that leaves no long spike.
        """
        points = np.stack([self._starts, self._ends], axis=1)
        found: dict[int, dict[int, Floats]] = {}
        for i in range(len(heights)):
            for side in (0, 1):
                met = self._met_at(points[i, side])
                if len(met) != 2:
                    continue
                j, other = next(end for end in met if end != (i, side))
                ahead = self._units[i] * (1.0 if side else -1.0)
                away = self._units[j] * (-1.0 if other else 1.0)
                cross = float(ahead[0] * away[1] - ahead[1] * away[0])
                if i == j or abs(cross) < SPIKE or heights[i] != heights[j]:
                    continue
                across_i, across_j = np.array([-ahead[1], ahead[0]]), np.array([-away[1], away[0]])
                gap = points[j, other] - points[i, side]
                beyond = []
                for sign in (1.0, -1.0):
                    shift = gap + sign * (self._half[j] * across_j - self._half[i] * across_i)
                    beyond.append(float(shift[0] * away[1] - shift[1] * away[0]) / cross)
                found.setdefault(i, {})[side] = np.array(beyond if side else beyond[::-1])
        return found

    def _met_at(self, point: Floats) -> list[tuple[int, int]]:
        """Return the ends of walls at a point, as wall and end; also walls that pass it, with end -1."""
        to_start, to_end = self._starts - point, self._ends - point
        along = np.clip(-(to_start * self._units).sum(1), 0.0, self._lengths)
        nearest = to_start + along[:, None] * self._units
        met: list[tuple[int, int]] = []
        for i in np.flatnonzero(np.hypot(nearest[:, 0], nearest[:, 1]) < self._half + 2 * NEAR).tolist():
            at = [side for side, to in enumerate((to_start[i], to_end[i])) if np.hypot(*to) < NEAR]
            met.extend((i, side) for side in at or [-1])
        return met

    def _beyond(
        self, i: int, others: npt.NDArray[np.int64], cross: Floats, to_start: Floats, to_end: Floats, sign: float
    ) -> float:
        """Return how far wall `i` continues among the walls that its end meets."""
        ahead = sign * self._units[i]
        # Where this wall's line meets the other's, counted from the end.
        meets = (to_start[:, 0] * self._units[others, 1] - to_start[:, 1] * self._units[others, 0]) / cross
        sides = np.stack([ahead[0] * to[:, 1] - ahead[1] * to[:, 0] for to in (to_start, to_end)])
        wide = float(self._half[i]) + NEAR
        if (sides.max(0) > wide).any() and (sides.min(0) < -wide).any():
            return max(float(meets.max()), 0.0)
        corner = meets + self._half[others] / np.abs(cross) - SEAM
        return max(float(corner.max()), 0.0)


def wall_surfaces(wall: Wall, bodies: WallBodies) -> list[Surface]:
    """Return a wall's faces, each in the material of its room, and its edges.

    Parameters
    ----------
    wall : Wall
    bodies : WallBodies
        Bodies of the floor's walls: where this one is cut, and how far it continues at corners.

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
    along = _along_faces(bodies.faces(wall), openings)
    up = _cuts((0.0, wall.height), [(each.sill, each.head) for each in openings])
    solid = _solid(along, up, openings)
    vertices = _vertices(wall, along, up)
    flat = _unrolled(wall, along, up)
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
    return [
        _surface(vertices, flat, quads, material) for quads, material in zip((left, right, core), materials) if quads
    ]


def _along_faces(ends: Floats, openings: list[Opening]) -> npt.NDArray[np.float64]:
    """Return where the left and the right face are cut along the wall, (n, 2); they differ in their ends alone."""
    cuts = _cuts((float(ends[0].max()), float(ends[1].min())), [(each.low, each.high) for each in openings])
    along = np.stack([cuts, cuts], axis=1)
    along[[0, -1]] = ends
    return along


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
    along = along.mean(1)
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
    grid[..., :2] = (start + along[..., None] * unit)[:, None]
    grid[:, :, 0, :2] += to_left
    grid[:, :, 1, :2] -= to_left
    grid[..., 2] = up[None, :, None]
    return grid.reshape(-1, 3)


def _unrolled(wall: Wall, along: npt.NDArray[np.float64], up: npt.NDArray[np.float64]) -> Floats:
    """Return the corners of `_vertices` in the wall's frame: along it, to its left, up.

    Places along it count from where its line passes the origin, so that courses go on where walls do.
    """
    start, end = np.array(wall.segment[0], dtype=float), np.array(wall.segment[1], dtype=float)
    unit = (end - start) / max(float(np.hypot(*(end - start))), 1e-9)
    grid = np.zeros((len(along), len(up), 2, 3))
    grid[..., 0] = (along + float(start @ unit))[:, None]
    grid[..., 1] = np.array([0.5, -0.5]) * wall.thickness
    grid[..., 2] = up[None, :, None]
    return grid.reshape(-1, 3)


def _surface(vertices: npt.NDArray[np.float64], flat: Floats, quads: list[Quad], material: Material) -> Surface:
    """Cut quads into triangles and drop the corners that none uses."""
    corners = np.array(quads, dtype=np.int64)
    faces = corners[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)
    used, compact = np.unique(faces, return_inverse=True)
    coordinates = box_coordinates(flat, faces, np.zeros(1, dtype=np.int64), turned=False)
    return Surface(material, vertices[used], compact.reshape(faces.shape), coordinates)

"""The geometric model of a room for the solver: boundary edges, walls, door and window areas, axes."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry import LineString, Polygon

from mansion_geometry.boxes import point_inside
from mansion_geometry.compiled import Bools, Floats
from mansion_geometry.free_space import FreeGrid
from mansion_geometry.wall_sizes import DOORWAY_DEPTH, doorway_depth
from mansion_knowledge import kin_of
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.placement import PlacementOpening, PlacementRoom
from mansion_scene.placement.options import PlacementOptions
from mansion_scene.placement.roles import is_public_room

__all__ = ["RoomModel", "Wall", "build_room", "wall_array"]


_SNAP = 0.35
"""A door is moved to the boundary from at most this far (a segment on the wall's centre line), metres."""


@dataclass(frozen=True)
class Wall:
    """A straight side of the boundary.

    Attributes
    ----------
    start, along, inward : (2,) arrays
        First point, unit direction, unit normal into the room.
    length : float
    """

    start: Floats
    along: Floats
    inward: Floats
    length: float


def wall_array(walls: Sequence[Wall]) -> Floats:
    """Return walls as rows (start, direction, inward normal, length), shape (w, 7)."""
    rows = [(*wall.start, *wall.along, *wall.inward, wall.length) for wall in walls]
    return np.array(rows, dtype=float).reshape(-1, 7)


@dataclass(frozen=True)
class RoomModel:
    """Geometry of one room in the arrays that the kernels take.

    Attributes
    ----------
    edges : (e, 4) array
        Boundary with the interior on the left.
    open_walls : (w, 4) array
        The same without door openings.
    walls : list of Wall
    wall_rows : (w, 7) array
        The same walls as `wall_array` gives them.
    doors : list of (4,) arrays
        Door segments on the boundary.
    door_zones, window_zones : (d, 7) arrays
        Boxes kept clear, the last column the height up to which they are not.
    door_points : (d, 2) array
        Middle of each door.
    outer_doors : (d,) array
        Whether each leads outside.
    angles : list of float
        Directions of the walls modulo 90 degrees: the one most walls have, and a second if nearly as many have it.
    area : float
    bounds : (4,) array
    aisle : float
        Aisle width aimed at, metres.
    public : bool
        Whether it needs the wider public aisle.
    garage : bool
        Whether cars stand in it behind their door.
    """

    edges: Floats
    open_walls: Floats
    walls: list[Wall]
    wall_rows: Floats
    doors: list[Floats]
    door_zones: Floats
    window_zones: Floats
    door_points: Floats
    outer_doors: Bools
    angles: list[float]
    area: float
    bounds: Floats
    aisle: float
    public: bool
    garage: bool

    def zones(self, *, roomy: bool) -> Floats:
        """Return all areas kept clear; `roomy` doors are as deep as their leaf is wide."""
        doors = self.door_zones
        if roomy and len(doors):
            doors = doors.copy()
            for zone in doors:
                deeper = min(max(2 * zone[5], 2 * zone[4]), 1.0) / 2 - zone[5]
                # Shallower zones are those of openings without a leaf.
                if deeper > 0 and 2 * zone[5] > DOORWAY_DEPTH:
                    zone[0] += -zone[3] * deeper
                    zone[1] += zone[2] * deeper
                    zone[5] += deeper
        return np.concatenate([doors, self.window_zones])

    def grid(self, options: PlacementOptions, *, roomy: bool) -> FreeGrid:
        """Return the free space of the empty room."""
        margin = options.margin if roomy else 0.0
        return FreeGrid(
            self.edges,
            self.open_walls,
            self.doors,
            radius=options.robot_radius + margin,
            reach=options.reach - 2 * margin,
            cell=options.cell,
            stand=0.10 + margin,
        )


def build_room(room: PlacementRoom, options: PlacementOptions) -> RoomModel:
    """Return the model of a room.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` where the polygon crosses itself or has no area.
    """
    polygon = Polygon(room.polygon, [hole for hole in room.holes if len(hole) >= 3])
    if not polygon.is_valid or polygon.area <= 0.0:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"room {room.room_id!r}: polygon must be simple with a positive area and holes inside it"
            f" ({shapely.is_valid_reason(polygon)})",
            path="$.polygon",
        )
    polygon = shapely.geometry.polygon.orient(polygon)
    edges = np.concatenate([_ring_edges(ring) for ring in (polygon.exterior, *polygon.interiors)])
    doors = [_snapped(door, polygon) for door in room.doors]
    windows = [_snapped(window, polygon) for window in room.windows]
    openings = [LineString([d[:2], d[2:]]).buffer(0.01, cap_style="flat") for d in doors]
    walled = polygon.boundary
    if openings:
        walled = walled.difference(shapely.union_all(openings))
    walls = [_wall(edge) for edge in edges]
    long_walls = [wall for wall in walls if wall.length > 0.05]
    return RoomModel(
        edges=edges,
        open_walls=_line_edges(walled),
        walls=long_walls,
        wall_rows=wall_array(long_walls),
        doors=doors,
        door_zones=_zones(doors, [-1.0] * len(doors), _depths(room.doors, options), edges),
        window_zones=_zones(windows, [w.sill for w in room.windows], [options.window_depth] * len(windows), edges),
        door_points=np.array([(d[:2] + d[2:]) / 2 for d in doors]).reshape(-1, 2),
        outer_doors=np.array([door.is_outer for door in room.doors], dtype=np.bool_),
        angles=_angles(walls),
        area=float(polygon.area),
        bounds=np.array(polygon.bounds),
        aisle=options.public_aisle if is_public_room(room.room_type) else options.aisle,
        public=is_public_room(room.room_type),
        garage=kin_of(room.room_type) == "garage",
    )


def _ring_edges(ring: shapely.LinearRing) -> Floats:
    """Return a ring's edges, collinear neighbours joined."""
    points = np.array(ring.coords)[:-1]
    before, after = points - np.roll(points, 1, axis=0), np.roll(points, -1, axis=0) - points
    cross = before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0]
    scale = np.hypot(*before.T) * np.hypot(*after.T)
    points = points[np.abs(cross) > 1e-9 * np.maximum(scale, 1e-12)]
    return np.hstack([points, np.roll(points, -1, axis=0)])


def _line_edges(lines: shapely.Geometry) -> Floats:
    """Return the segments of a (multi) line string, shape (n, 4)."""
    parts = [np.array(line.coords) for line in shapely.get_parts(lines)]
    if not parts:
        return np.zeros((0, 4))
    return np.concatenate([np.hstack([p[:-1], p[1:]]) for p in parts])


def _wall(edge: Floats) -> Wall:
    vector = edge[2:] - edge[:2]
    length = float(np.hypot(*vector))
    along = vector / max(length, 1e-12)
    return Wall(edge[:2].copy(), along, np.array([-along[1], along[0]]), length)


def _snapped(opening: PlacementOpening, polygon: Polygon) -> Floats:
    """Return an opening's segment, moved to the boundary where it lies next to it."""
    ends = [shapely.Point(p) for p in opening.segment]
    boundary = polygon.boundary
    near = [boundary.interpolate(boundary.project(p)) for p in ends]
    if all(1e-3 < a.distance(b) <= _SNAP or a.distance(b) <= 1e-3 for a, b in zip(ends, near)):
        moved = [p if p.distance(q) <= 1e-3 else q for p, q in zip(ends, near)]
        if moved[0].distance(moved[1]) > 0.5 * ends[0].distance(ends[1]):
            ends = moved
    return np.array([ends[0].x, ends[0].y, ends[1].x, ends[1].y])


def _depths(doors: Sequence[PlacementOpening], options: PlacementOptions) -> list[float]:
    """Return how deep the floor is kept clear behind each door, metres."""
    beyond = options.door_depth - DOORWAY_DEPTH
    return [max(beyond + doorway_depth(math.dist(*door.segment), is_open=door.is_open), 0.0) for door in doors]


def _zones(segments: list[Floats], heights: list[float], depths: list[float], edges: Floats) -> Floats:
    """Return the box before each opening, on the side of its wall that lies in the room."""
    rows = []
    for seg, height, depth in zip(segments, heights, depths):
        vector = seg[2:] - seg[:2]
        length = float(np.hypot(*vector))
        if length < 1e-6:
            continue
        u = vector / length
        middle = (seg[:2] + seg[2:]) / 2
        v = np.array([-u[1], u[0]])
        (mx, my), (ux, uy) = middle.tolist(), u.tolist()
        inside = [
            sum(
                point_inside(
                    mx - sign * uy * depth * t + ux * length * s, my + sign * ux * depth * t + uy * length * s, edges
                )
                for t in (0.1, 0.5, 0.9)
                for s in (-0.4, 0.0, 0.4)
            )
            for sign in (1.0, -1.0)
        ]
        if inside[1] > inside[0]:
            u, v = -u, -v
        x, y = middle + v * depth / 2
        rows.append((x, y, u[0], u[1], length / 2, depth / 2, height))
    return np.array(rows, dtype=float).reshape(-1, 7)


def _angles(walls: list[Wall]) -> list[float]:
    """Return wall directions modulo 90 degrees: the prevailing one, and another at least half as frequent."""
    lengths: dict[float, float] = {}
    for wall in walls:
        angle = round(float(np.degrees(np.arctan2(wall.along[1], wall.along[0]))) % 90.0, 3) % 90.0
        lengths[angle] = lengths.get(angle, 0.0) + wall.length
    ranked = sorted(lengths, key=lambda a: (-round(lengths[a], 6), a))
    return [a for a in ranked[:2] if lengths[a] >= 0.5 * lengths[ranked[0]]]

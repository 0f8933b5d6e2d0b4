"""Evaluation of placements from their geometry alone, with exact polygons; the solver uses nothing of it.

Tolerances: a footprint is out of bounds with more than 1% of its area outside; a collision or an object in a door's
area (0.8 m deep) is more than 1 cm2; a back is at a wall within 0.15 m; pairs and seats belong within 0.5 m.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import LineString, Polygon

from mansion_geometry.free_space import connected_components
from mansion_geometry.object_footprints import footprint_at
from mansion_geometry.robot_body import ROBOT_RADIUS, ROBOT_REACH
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.placement import (
    MatrixStructure,
    PairedStructure,
    PlacedObject,
    PlacementObject,
    PlacementResult,
    PlacementRoom,
)
from mansion_scene.placement.files import place_timed
from mansion_scene.placement.options import PlacementOptions

__all__ = ["Footprint", "Measures", "approachable", "bench", "measure", "table"]

Indices = npt.NDArray[np.int64]

_EPS = 1e-9


def approachable(
    room: PlacementRoom,
    shapes: Sequence[Polygon],
    *,
    radius: float = ROBOT_RADIUS,
    reach: float = ROBOT_REACH,
    cell: float = 0.05,
) -> list[bool]:
    """Tell which footprints have a free cell within reach that is connected to a door.

    Parameters
    ----------
    room : PlacementRoom
    shapes : sequence of Polygon
        Footprints, obstacles all of them.
    radius, reach, cell : float
        The robot's radius, its reach beyond its body, the raster's cell, metres.
    """
    if not shapes:
        return []
    outline = Polygon(room.polygon, room.holes)
    doors = [LineString(door.segment) for door in room.doors]
    walls = outline.boundary
    for door in doors:
        walls = walls.difference(door.buffer(0.01, cap_style="flat"))
    x0, y0, x1, y1 = outline.bounds
    gx, gy = np.meshgrid(np.arange(x0 + cell / 2, x1, cell), np.arange(y0 + cell / 2, y1, cell))
    points = shapely.points(gx.ravel(), gy.ravel())
    free = shapely.contains_xy(outline, gx.ravel(), gy.ravel())
    free[free] = shapely.distance(walls, points[free]) >= radius - _EPS
    tree = shapely.STRtree(points)
    blocked, _ = _within(tree, shapes, radius - 2 * _EPS)
    free[blocked] = False
    labels, _ = connected_components((~free.reshape(gx.shape)).astype(np.int16))
    flat = labels.ravel()
    thresholds, _ = _within(tree, doors, 0.10 + _EPS)
    entered = np.unique(flat[thresholds])
    inside = np.isin(flat, entered[entered > 0])
    cells, owners = _within(tree, shapes, radius + reach + _EPS)
    reached = set(owners[inside[cells]].tolist())
    return [i in reached for i in range(len(shapes))]


def _within(tree: shapely.STRtree, shapes: Sequence[shapely.Geometry], distance: float) -> tuple[Indices, Indices]:
    """Return the points of `tree` within a distance of each shape, and which shape that is."""
    if not shapes:
        return np.zeros(0, dtype=int), np.zeros(0, dtype=int)
    owners, cells = tree.query(np.array(shapes), predicate="dwithin", distance=distance)
    return cells, owners


_AREA = 1e-4


class Footprint:
    """A placed object's rectangle with its local frame."""

    def __init__(self, item: PlacedObject) -> None:
        turn = np.radians(item.rotation)
        self.name = item.name
        self.centre = np.array(item.center)
        self.u = np.array([np.cos(turn), np.sin(turn)])
        self.v = np.array([-self.u[1], self.u[0]])
        self.width, self.depth = item.size[:2]
        self.shape = footprint_at(item.center, item.size, item.rotation)

    def back(self) -> list[shapely.Point]:
        """Return both ends and the middle of the back edge."""
        middle, half = self.centre - self.v * self.depth / 2, self.u * self.width / 2
        return [shapely.Point(middle + k * half) for k in (-1, 0, 1)]


@dataclass(frozen=True)
class Measures:
    """Measures of one placement of one room, as counts, so that rooms and runs can be added up.

    Attributes
    ----------
    asked, placed : int
    outside, collisions, blocked : int
        Objects out of bounds, overlapping pairs, doors with something in their area.
    reachable : int
        Placed objects that a disc robot from a door can approach.
    usable : int
        Placed, in bounds, free of collisions and door areas, reachable.
    pairs, pairs_near, around, around_near, relations, relations_held : int
    edges, edges_backed : int
    row_deviation, column_deviation : float
        Standard deviation of the pitch, mean over the room's matrices, metres.
    seconds : float
    """

    asked: int
    placed: int
    outside: int
    collisions: int
    blocked: int
    reachable: int
    usable: int
    pairs: int
    pairs_near: int
    around: int
    around_near: int
    relations: int
    relations_held: int
    edges: int
    edges_backed: int
    row_deviation: float
    column_deviation: float
    seconds: float


def measure(room: PlacementRoom, result: PlacementResult) -> Measures:
    """Return the measures of one placement."""
    shape = Polygon(room.polygon, room.holes)
    items = [Footprint(item) for item in result.placements]
    by_name = {o.name: [i for i in items if i.name == o.name] for o in room.objects}
    areas = [_door_area(shape, np.array(d.segment)) for d in room.doors]
    outside = [i.shape.difference(shape).area > 0.01 * i.shape.area for i in items]
    hits = _collisions([i.shape for i in items])
    struck = {i for pair in hits for i in pair}
    doors = [[i.shape.intersection(a).area > _AREA for a in areas] for i in items]
    reached = approachable(room, [i.shape for i in items])
    usable = sum(
        not out and k not in struck and not any(door) and near
        for k, (out, door, near) in enumerate(zip(outside, doors, reached))
    )
    pairs, around, relations = (_sums(room, by_name, kind) for kind in ("pair", "around", "all"))
    edges = [i for o in room.objects if o.global_ == "edge" for i in by_name[o.name]]
    backed = sum(all(shape.boundary.distance(p) <= 0.15 for p in i.back()) for i in edges)
    deviations = [
        _pitch_deviation(by_name[o.name], o.structure)
        for o in room.objects
        if isinstance(o.structure, MatrixStructure) and len(by_name[o.name]) > 1
    ]
    return Measures(
        asked=sum(_quantity(o) for o in room.objects),
        placed=len(items),
        outside=sum(outside),
        collisions=len(hits),
        blocked=sum(any(row[k] for row in doors) for k in range(len(areas))),
        reachable=sum(reached),
        usable=usable,
        pairs=pairs[0],
        pairs_near=pairs[1],
        around=around[0],
        around_near=around[1],
        relations=relations[0],
        relations_held=relations[1],
        edges=len(edges),
        edges_backed=backed,
        row_deviation=float(np.mean([d[0] for d in deviations])) if deviations else 0.0,
        column_deviation=float(np.mean([d[1] for d in deviations])) if deviations else 0.0,
        seconds=result.seconds,
    )


def _quantity(obj: PlacementObject) -> int:
    if isinstance(obj.structure, MatrixStructure):
        return obj.structure.rows * obj.structure.cols
    return obj.quantity


def _door_area(room: Polygon, segment: npt.NDArray[np.float64]) -> Polygon:
    """Return the part of the room at most 0.8 m before a door."""
    a, b = segment
    normal = 0.8 * np.array([-(b - a)[1], (b - a)[0]]) / np.linalg.norm(b - a)
    sides = [Polygon([a, b, b + s * normal, a + s * normal]).intersection(room) for s in (1, -1)]
    return max(sides, key=lambda side: side.area)


def _collisions(shapes: Sequence[Polygon]) -> list[tuple[int, int]]:
    if not shapes:
        return []
    tree = shapely.STRtree(shapes)
    left, right = tree.query(shapes, predicate="intersects")
    return [(int(i), int(j)) for i, j in zip(left, right) if i < j and shapes[i].intersection(shapes[j]).area > _AREA]


def _sums(room: PlacementRoom, by_name: Mapping[str, list[Footprint]], kind: str) -> tuple[int, int]:
    """Return how many pairs, seats around something, or relations are asked, and how many hold."""
    asked = held = 0
    sizes = {o.name: _quantity(o) for o in room.objects}
    for obj in room.objects:
        own = by_name[obj.name]
        if kind == "pair" and isinstance(obj.structure, PairedStructure):
            asked += _quantity(obj)
            held += _matched(own, by_name[obj.structure.with_], 1)
        for relation in obj.relative:
            targets = by_name[relation.target]
            if kind == "all":
                asked += _quantity(obj)
                held += sum(_holds(relation.kind, item, targets) for item in own)
            elif kind == "around" and relation.kind == "around":
                asked += _quantity(obj)
                held += _matched(own, targets, -(-_quantity(obj) // sizes[relation.target]))
    return asked, held


def _matched(own: Sequence[Footprint], anchors: Sequence[Footprint], capacity: int) -> int:
    """Count accessories within 0.5 m of an anchor, nearest first, an anchor taking `capacity`."""
    pairs = sorted((a.shape.distance(b.shape), i, j) for i, a in enumerate(own) for j, b in enumerate(anchors))
    used: set[int] = set()
    load = [0] * len(anchors)
    for gap, i, j in pairs:
        if gap <= 0.5 and i not in used and load[j] < capacity:
            used.add(i)
            load[j] += 1
    return len(used)


def _holds(kind: str, item: Footprint, targets: Sequence[Footprint]) -> bool:
    if kind == "far":
        return bool(targets) and all(item.shape.distance(t.shape) >= 1.5 for t in targets)
    return any(_holds_to(kind, item, target) for target in targets)


def _holds_to(kind: str, item: Footprint, target: Footprint) -> bool:
    gap = item.shape.distance(target.shape)
    offset = item.centre - target.centre
    aside, ahead = abs(float(offset @ target.u)), float(offset @ target.v)
    if kind == "in_front_of":
        near = aside <= max(target.width / 2, 0.3)
        return gap <= 1.5 and ahead > target.depth / 2 and near
    if kind == "side_of":
        return gap <= 1.0 and aside > target.width / 2 and abs(ahead) <= target.depth / 2
    if kind == "center_aligned":
        return min(aside, abs(ahead)) <= 0.10
    return bool(gap <= {"near": 1.0, "around": 0.5}[kind])


def _pitch_deviation(items: Sequence[Footprint], matrix: MatrixStructure) -> tuple[float, float]:
    """Return the standard deviations of the pitch between rows and between columns, read in either direction."""
    u, v = items[0].u, items[0].v
    points = np.array([(i.centre @ u, i.centre @ v) for i in items])
    whole = len(items) == matrix.rows * matrix.cols
    shapes = [(matrix.rows, matrix.cols)] if whole else []
    shapes += [(r, len(items) // r) for r in range(1, len(items) + 1) if len(items) % r == 0]
    best = (np.inf, np.inf)
    for rows, cols in shapes if not whole else shapes[:1]:
        for axes in (points[:, ::-1], points):
            lines = axes[np.argsort(axes[:, 0], kind="stable")].reshape(rows, cols, 2)
            lines = np.stack([line[np.argsort(line[:, 1], kind="stable")] for line in lines])
            across = np.std(np.diff(lines[..., 0], axis=0)) if rows > 2 else 0.0
            along = np.std(np.diff(lines[..., 1], axis=1)) if cols > 2 else 0.0
            best = min(best, (float(across), float(along)), key=sum)
    return float(best[0]), float(best[1])


_COLUMNS = (
    *("asked", "placed", "cover%", "usable%", "reach%", "out", "hit", "door"),
    *("pair%", "arnd%", "rel%", "back%", "rowdev", "coldev", "cpu s", "worst"),
)


def bench(
    rooms: Sequence[PlacementRoom], seeds: Iterable[int], options: PlacementOptions | None = None
) -> dict[str, list[tuple[PlacementResult, Measures]]]:
    """Place every room with every seed in this process.

    Returns
    -------
    dict
        Placement and measures of each run, by room id.
    """
    with importing:
        from mansion_scene.placement import warm

    warm()
    chosen = options or PlacementOptions()
    numbers = list(seeds)
    runs: dict[str, list[tuple[PlacementResult, Measures]]] = {}
    for room in rooms:
        results = [place_timed(room, seed, chosen) for seed in numbers]
        runs[room.room_id] = [(result, measure(room, result)) for result in results]
    return runs


def table(measures: dict[str, list[Measures]]) -> str:
    """Return a text table: a line for each room, its runs averaged, and one over all rooms."""
    lines = [f"{'room':<20}" + "".join(f"{name:>8}" for name in _COLUMNS)]
    for name, runs in measures.items():
        lines.append(_line(name, runs, len(runs)))
    every = [run for runs in measures.values() for run in runs]
    count = max((len(runs) for runs in measures.values()), default=1)
    lines.append(_line("all rooms", every, count))
    return "\n".join(lines)


def _line(name: str, runs: Sequence[Measures], count: int) -> str:
    def total(field: str) -> float:
        return float(sum(getattr(run, field) for run in runs))

    def percent(part: str, whole: str) -> str:
        return f"{100.0 * total(part) / total(whole):.1f}" if total(whole) else "-"

    cells = [
        f"{total('asked') / count:.0f}",
        f"{total('placed') / count:.1f}",
        percent("placed", "asked"),
        percent("usable", "asked"),
        percent("reachable", "placed"),
        f"{total('outside'):.0f}",
        f"{total('collisions'):.0f}",
        f"{total('blocked'):.0f}",
        percent("pairs_near", "pairs"),
        percent("around_near", "around"),
        percent("relations_held", "relations"),
        percent("edges_backed", "edges"),
        f"{np.mean([run.row_deviation for run in runs]):.2f}",
        f"{np.mean([run.column_deviation for run in runs]):.2f}",
        f"{np.mean([run.seconds for run in runs]):.3f}",
        f"{max(run.seconds for run in runs):.3f}",
    ]
    return f"{name[:20]:<20}" + "".join(f"{cell:>8}" for cell in cells)

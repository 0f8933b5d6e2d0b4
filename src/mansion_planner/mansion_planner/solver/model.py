"""A floor problem made ready for the solver: checked, turned to its main direction, with scaled areas."""

from dataclasses import dataclass, field

import networkx as nx
import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import LineString, MultiPolygon, Polygon

from mansion_geometry.rings import as_polygon, dominant_angle, polygon_parts, rotated
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorProblem, ProblemNode
from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.zones import Link, resolve_zones

__all__ = ["FloorModel", "Obstacle", "make_model"]

SIDES = {"north": 1, "east": 2, "south": 3, "west": 4}
LEAST_AREA = 1e-3
WALL_OFFSET = 0.05


@dataclass(frozen=True)
class Obstacle:
    """Ground that no room may take: a core or a fixed room, in the model's frame."""

    id: str
    polygon: Polygon
    side: int = 0
    fixed_room: bool = False


@dataclass(frozen=True)
class FloorModel:
    """What the search works on. Coordinates are turned by ``-angle`` about the origin.

    Attributes
    ----------
    rooms : tuple of ProblemNode
        Rooms to be laid out; the hub first.
    targets : (n,) array
        Their areas, scaled to fill the free region, square metres.
    region : Polygon or MultiPolygon
        Boundary less holes, cores and fixed rooms.
    links : tuple of Link
        Edges between surviving ids; labels of `obstacles` follow those of the rooms.
    seeds, extents : (n, 2) arrays
        Wished centroids and sizes, NaN where none is given.
    """

    problem: FloorProblem
    rooms: tuple[ProblemNode, ...]
    zones: tuple[str, ...]
    targets: NDArray[np.float64]
    area_scale: float
    region: Polygon | MultiPolygon
    outline: Polygon
    obstacles: tuple[Obstacle, ...]
    walls: tuple[LineString, ...]
    links: tuple[Link, ...]
    seeds: NDArray[np.float64]
    extents: NDArray[np.float64]
    min_widths: NDArray[np.float64]
    angle: float
    graph: "nx.Graph[str]"
    messages: list[str] = field(default_factory=list)

    @property
    def index(self) -> dict[str, int]:
        """Label of each surviving id."""
        ids = [room.id for room in self.rooms] + [o.id for o in self.obstacles]
        return {name: k for k, name in enumerate(ids)}

    @property
    def hub(self) -> str:
        """Id of the hub."""
        return self.rooms[0].id


def _refuse(message: str, path: str, **details: object) -> MansionError:
    return MansionError(ErrorCode.INFEASIBLE, message, path=path, details=dict(details))


def _shape(ring: list[tuple[float, float]], path: str, angle: float = 0.0) -> Polygon:
    """Return one valid polygon or refuse."""
    if not np.isfinite(np.asarray(ring, dtype=float)).all():
        raise _refuse("coordinates must be finite numbers", path)
    parts = polygon_parts(as_polygon(rotated(ring, angle)))
    parts = [part for part in parts if part.area > LEAST_AREA]
    if len(parts) != 1:
        raise _refuse("a simple polygon with an area is needed here", path, parts=len(parts))
    return parts[0]


def _obstacles(problem: FloorProblem, angle: float) -> list[Obstacle]:
    found = []
    for k, core in enumerate(problem.cores):
        shape = _shape(core.polygon, f"$.cores[{k}].polygon", angle)
        found.append(Obstacle(core.id, shape, SIDES.get(core.door_side or "", 0)))
    for k, room in enumerate(problem.fixed_rooms):
        shape = _shape(room.polygon, f"$.fixed_rooms[{k}].polygon", angle)
        found.append(Obstacle(room.id, shape, fixed_room=True))
    return found


def _walls(problem: FloorProblem, region: Polygon | MultiPolygon, angle: float) -> tuple[LineString, ...]:
    """Return the structural walls, straightened where they are nearly parallel to the building's directions.

    Raises
    ------
    MansionError
        For a slanted wall inside the free region: inner walls of a layout are never slanted.
    """
    found = []
    inside = region.buffer(-WALL_OFFSET)
    for k, wall in enumerate(problem.structural_walls):
        line = LineString(rotated(wall, angle))
        if not np.isfinite(shapely.get_coordinates(line)).all():
            raise _refuse("coordinates must be finite numbers", f"$.structural_walls[{k}]")
        (x0, y0), (x1, y1) = line.coords
        if line.length < 1e-6 or inside.intersection(line).length < WALL_OFFSET:
            continue
        if abs(y1 - y0) <= WALL_OFFSET:
            line = LineString([(x0, (y0 + y1) / 2), (x1, (y0 + y1) / 2)])
        elif abs(x1 - x0) <= WALL_OFFSET:
            line = LineString([((x0 + x1) / 2, y0), ((x0 + x1) / 2, y1)])
        else:
            raise _refuse(
                "a structural wall inside the free region must run along one of the building's two main "
                f"directions ({np.degrees(-angle):.1f} degrees and at right angles to it), because rooms "
                "get no slanted walls inside",
                f"$.structural_walls[{k}]",
            )
        found.append(line)
    return tuple(found)


def _targets(rooms: list[ProblemNode], free: float) -> tuple[NDArray[np.float64], float]:
    """Scale the areas to the free region; rooms without an area share what the others leave."""
    given = sum(room.area or 0.0 for room in rooms)
    missing = sum(room.area is None for room in rooms)
    if missing:
        share = max((free - given) / missing, 0.2 * free / len(rooms))
        areas = np.array([share if room.area is None else room.area for room in rooms])
    else:
        areas = np.array([room.area or 0.0 for room in rooms])
    scale = free / float(areas.sum())
    return areas * scale, scale


def _seeds(
    problem: FloorProblem, rooms: list[ProblemNode], angle: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Collect seed points and extents: a node's own, else those of the seed plan (Fig. 25)."""
    plan = {box.room_id: box for box in problem.seeds.boxes} if problem.seeds else {}
    seeds = np.full((len(rooms), 2), np.nan)
    extents = np.full((len(rooms), 2), np.nan)
    for k, room in enumerate(rooms):
        box = room.seed_box or plan.get(room.id)
        point = room.seed
        if box is not None:
            extents[k] = abs(box.x[1] - box.x[0]), abs(box.y[1] - box.y[0])
            point = point or ((box.x[0] + box.x[1]) / 2, (box.y[0] + box.y[1]) / 2)
        if point is not None and np.isfinite(point).all():
            seeds[k] = rotated([point], angle)[0]
    return seeds, extents


def _min_widths(rooms: list[ProblemNode], targets: NDArray[np.float64], options: SolverOptions) -> NDArray[np.float64]:
    """Return each room's minimum width: given, or the default capped for rooms too small for it."""
    default = np.minimum(options.min_width, 0.75 * np.sqrt(targets))
    given = np.array([room.min_width or np.nan for room in rooms], dtype=float)
    return np.where(np.isnan(given), default, given)


def make_model(problem: FloorProblem, options: SolverOptions) -> FloorModel:
    """Check `problem` and return what the solver works on.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with the place and the reason when no layout can exist.
    """
    outline = _shape(problem.boundary, "$.boundary")
    angle = -dominant_angle([problem.boundary])
    if angle != 0.0:
        outline = _shape(problem.boundary, "$.boundary", angle)
    region: Polygon | MultiPolygon = outline
    for k, hole in enumerate(problem.holes):
        region = region.difference(_shape(hole, f"$.holes[{k}]", angle))
    obstacles = _obstacles(problem, angle)
    for obstacle in obstacles:
        region = region.difference(obstacle.polygon)
    parts = [part for part in polygon_parts(region) if part.area > LEAST_AREA]
    if not parts:
        raise _refuse("cores, holes and fixed rooms leave no free region", "$.boundary")
    region = parts[0] if len(parts) == 1 else MultiPolygon(parts)

    known = {o.id for o in obstacles}
    ids = [node.id for node in problem.nodes]
    if len(set(ids)) != len(ids):
        twice = sorted({i for i in ids if ids.count(i) > 1})
        raise _refuse("node ids must differ", "$.nodes", repeated=twice)
    rooms, zones, links, graph, messages = resolve_zones(problem, known)
    if not rooms:
        raise _refuse("there is no room to lay out: every node is a core or a fixed room", "$.nodes")
    targets, scale = _targets(rooms, float(region.area))
    if abs(scale - 1.0) > 0.01:
        messages.append(f"node areas were scaled by {scale:.3f} to fill the free region")
    seeds, extents = _seeds(problem, rooms, angle)
    walls = _walls(problem, region, angle)
    return FloorModel(
        problem,
        tuple(rooms),
        tuple(zones),
        targets,
        scale,
        shapely.normalize(region),
        outline,
        tuple(obstacles),
        walls,
        tuple(links),
        seeds,
        extents,
        _min_widths(rooms, targets, options),
        angle,
        graph,
        messages,
    )

"""The floor problem as the search works on it: checked, aligned, areas scaled, goals as arrays."""

from collections.abc import Iterable, Sequence
from dataclasses import astuple, dataclass, field
from typing import NamedTuple

import msgspec
import networkx as nx
import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import LineString, MultiPolygon, Polygon

from mansion_geometry.compiled import Bools, Floats, Ints
from mansion_geometry.rings import as_polygon, dominant_angle, polygon_parts, rotated
from mansion_geometry.shared_walls import SharedWall, edge_array, shared_walls
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorProblem, ProblemNode
from mansion_msgs_py.limits import MAX_FLOOR_AREA
from mansion_msgs_py.topology import SeedPlan
from mansion_planner.solver.options import ANY, SolverOptions, shape_of
from mansion_planner.solver.room_graph import Link, breadth_first_parents, resolve_zones

__all__ = [
    "ACCESS",
    "CORNER_WEIGHT",
    "DETOUR",
    "FACADE",
    "FloorModel",
    "Goal",
    "MIN_WIDTH",
    "Obstacle",
    "RelaxedLink",
    "SEED_WEIGHT",
    "SEED_X",
    "SEED_Y",
    "SHAPE_WEIGHT",
    "TARGET",
    "WALL_WEIGHT",
    "make_goal",
    "make_model",
    "mostly_seeded",
    "planned_shares",
    "relaxed_links",
]

SIDES = ("any", "north", "east", "south", "west")
"""Sides on which a core may be entered, by their code in `Obstacle.side` and `Goal.side`."""

LEAST_AREA = 1e-3
"""Area, m2, up to which a part of the free region is left out."""

LEAST_WIDTH = 0.5
"""Width, metres, below which everywhere a part of the free region that is cut off has no room."""

WALL_OFFSET = 0.05
"""Distance, metres, by which the ends of a straight structural wall may differ across it."""


@dataclass(frozen=True)
class Obstacle:
    """Ground that no room may take: a core or a fixed room, in the model's frame."""

    id: str
    polygon: Polygon
    side: int = 0
    fixed_room: bool = False

    def is_entered_through(self, wall: SharedWall) -> bool:
        """Tell whether a wall, running along the adjoining room's boundary, lies on the obstacle's door side.

        The room is on the wall's left, the obstacle on its right, so a room north of the core sees a wall running east.
        """
        if self.side == 0:
            return True
        dx, dy = wall.end[0] - wall.start[0], wall.end[1] - wall.start[1]
        along = (dx, -dy, -dx, dy)[self.side - 1]
        return along > 0.7 * float(np.hypot(dx, dy))


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
    seeds : (n, 2) array
        Wished centroids, metres, NaN where none is given.
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
        found.append(Obstacle(core.id, shape, SIDES.index(core.door_side or "any")))
    for k, room in enumerate(problem.fixed_rooms):
        shape = _shape(room.polygon, f"$.fixed_rooms[{k}].polygon", angle)
        shape = Polygon(shape.exterior, [rotated(hole, angle) for hole in room.holes])
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


def planned_shares(plan: SeedPlan | None) -> dict[str, float]:
    """Return the fraction of its parent's area that a seed plan gives each room, ``alpha_r`` of Algorithm 3."""
    return {box.room_id: box.area for box in plan.boxes if box.area} if plan is not None else {}


def _with_planned_areas(
    problem: FloorProblem,
    rooms: list[ProblemNode],
    zones: list[str],
    graph: "nx.Graph[str]",
    barred: set[str],
    free: float,
) -> list[ProblemNode]:
    """Give rooms without an area their fraction of their parent's, less what is cut from them."""
    shares = planned_shares(problem.seeds)
    if not shares or all(room.area is not None for room in rooms):
        return rooms
    hub = rooms[0].id
    parents = breadth_first_parents(graph, hub, [*(room.id for room in rooms), *zones], barred)
    whole = {hub: free}
    for name, parent in parents.items():
        if name in shares and parent in whole:
            whole[name] = shares[name] * whole[parent]
    kept = dict(whole)
    for name, parent in parents.items():
        if name in whole:
            kept[parent] -= whole[name]
    return [
        msgspec.structs.replace(room, area=max(kept[room.id], 0.1 * whole[room.id]))
        if room.area is None and room.id in whole and room.id != hub
        else room
        for room in rooms
    ]


def _seeds(problem: FloorProblem, rooms: list[ProblemNode], angle: float) -> Floats:
    """Return each room's seed: its node's own point, else the centre of its seed box (Fig. 25), else NaN."""
    plan = {box.room_id: box for box in problem.seeds.boxes} if problem.seeds else {}
    seeds = np.full((len(rooms), 2), np.nan)
    for k, room in enumerate(rooms):
        box = room.seed_box or plan.get(room.id)
        point = room.seed
        if box is not None:
            point = point or ((box.x[0] + box.x[1]) / 2, (box.y[0] + box.y[1]) / 2)
        if point is not None and np.isfinite(point).all():
            seeds[k] = rotated([point], angle)[0]
    return seeds


def _min_widths(rooms: list[ProblemNode], targets: NDArray[np.float64], options: SolverOptions) -> NDArray[np.float64]:
    """Return each room's minimum width: given, or the default capped for rooms too small for it."""
    default = np.minimum(options.min_width, 0.75 * np.sqrt(targets))
    given = np.array([room.min_width or np.nan for room in rooms], dtype=float)
    return np.where(np.isnan(given), default, given)


def _free_parts(outline: Polygon, taken: Sequence[Polygon | MultiPolygon]) -> tuple[list[Polygon], list[Polygon]]:
    """Return the parts of the outline that rooms may have, and those that are cut off and narrower than any room."""
    region: Polygon | MultiPolygon = outline
    for shape in taken:
        region = region.difference(shape)
    parts = [part for part in polygon_parts(region) if part.area > LEAST_AREA]
    if not parts:
        raise _refuse("cores, holes and fixed rooms leave no free region", "$.boundary")
    wide = [part for part in parts if not shapely.buffer(part, -LEAST_WIDTH / 2, join_style="mitre").is_empty]
    kept = wide or [max(parts, key=lambda part: part.area)]
    return kept, [part for part in parts if part not in kept]


def _lost_part_message(part: Polygon, angle: float) -> str:
    """Say where a part that no room can have lies."""
    ((x, y),) = rotated(shapely.get_coordinates(part.representative_point()).tolist(), -angle)
    return f"{part.area:.2f} m2 at ({x:.2f}, {y:.2f}) are cut off and narrower than a room, and stay without one"


def _outline(problem: FloorProblem) -> tuple[Polygon, float]:
    """Return the outline, turned so that most of its walls are upright, and the angle that it was turned by."""
    outline = _shape(problem.boundary, "$.boundary")
    if outline.area > MAX_FLOOR_AREA:
        raise _refuse(
            f"the outline holds {outline.area:.4g} m2; at most {MAX_FLOOR_AREA:.0f} m2 are laid out", "$.boundary"
        )
    angle = -dominant_angle([problem.boundary])
    return (outline if angle == 0.0 else _shape(problem.boundary, "$.boundary", angle)), angle


def _refuse_repeated_ids(problem: FloorProblem) -> None:
    """Raise where two nodes have the same id."""
    ids = [node.id for node in problem.nodes]
    if len(set(ids)) != len(ids):
        twice = sorted({i for i in ids if ids.count(i) > 1})
        raise _refuse("node ids must differ", "$.nodes", repeated=twice)


def make_model(problem: FloorProblem, options: SolverOptions) -> FloorModel:
    """Check `problem` and return what the solver works on.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with the place and the reason when no layout can exist.
    """
    outline, angle = _outline(problem)
    obstacles = _obstacles(problem, angle)
    holes = [_shape(hole, f"$.holes[{k}]", angle) for k, hole in enumerate(problem.holes)]
    parts, lost = _free_parts(outline, [*holes, *(obstacle.polygon for obstacle in obstacles)])
    region = parts[0] if len(parts) == 1 else MultiPolygon(parts)

    known = {o.id for o in obstacles}
    _refuse_repeated_ids(problem)
    rooms, zones, links, graph, messages = resolve_zones(problem, known)
    if not rooms:
        raise _refuse("there is no room to lay out: every node is a core or a fixed room", "$.nodes")
    rooms = _with_planned_areas(problem, rooms, zones, graph, known, float(region.area))
    targets, scale = _targets(rooms, float(region.area))
    messages += [_lost_part_message(part, angle) for part in lost]
    if abs(scale - 1.0) > 0.01:
        messages.append(f"node areas were scaled by {scale:.3f} to fill the free region")
    seeds = _seeds(problem, rooms, angle)
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
        _min_widths(rooms, targets, options),
        angle,
        graph,
        messages,
    )


@dataclass(frozen=True)
class RelaxedLink:
    """A link that the search leaves out because no layout can realise it, and the reason."""

    link: Link
    reason: str


def _core_without_wall(model: FloorModel, link: Link) -> str:
    """Return why a core cannot be entered at all, or an empty string."""
    if link.kind != "access":
        return ""
    for obstacle in model.obstacles:
        if obstacle.id not in (link.source, link.target):
            continue
        region = edge_array(model.region)
        walls = shared_walls(region, edge_array(obstacle.polygon), 1e-3)
        walls = [wall for wall in walls if obstacle.is_entered_through(wall)]
        longest = max((wall.length for wall in walls), default=0.0)
        if longest < model.problem.min_access_wall - 1e-3:
            side = f"the {SIDES[obstacle.side]}" if obstacle.side else "a"
            return (
                f"{obstacle.id} has {longest:.2f} m of straight wall to the free region on "
                f"{side} side, {model.problem.min_access_wall:g} m are needed"
            )
    return ""


def _too_small(model: FloorModel, link: Link) -> str:
    """Return why a room is too small for a door wall, or an empty string."""
    if link.kind != "access":
        return ""
    for room, target in zip(model.rooms, model.targets.tolist()):
        need = model.problem.min_access_wall
        if room.id in (link.source, link.target) and target < 0.05 * need * need:
            return f"{room.id} has {target:.3g} m2, too little for a wall of {need:g} m"
    return ""


def relaxed_links(model: FloorModel) -> list[RelaxedLink]:
    """Return the links that no layout can realise together with the rest.

    Touching regions form a planar graph, so of a non-planar room graph some edges have to go: access edges are kept
    first, then adjacent ones, each as long as the graph stays planar.
    """
    relaxed: list[RelaxedLink] = []
    alive: list[Link] = []
    for link in model.links:
        reason = _core_without_wall(model, link) or _too_small(model, link)
        if reason:
            relaxed.append(RelaxedLink(link, reason))
        else:
            alive.append(link)
    graph: nx.Graph[str] = nx.Graph()
    graph.add_edges_from((link.source, link.target) for link in alive)
    if nx.check_planarity(graph)[0]:
        return relaxed
    kept: nx.Graph[str] = nx.Graph()
    for link in sorted(alive, key=lambda link: link.kind != "access"):
        kept.add_edge(link.source, link.target)
        if not nx.check_planarity(kept)[0]:
            kept.remove_edge(link.source, link.target)
            reason = "the room graph is not planar; regions of a floor cannot all touch like that"
            relaxed.append(RelaxedLink(link, reason))
    return relaxed


(TARGET, SEED_X, SEED_Y, SEED_WEIGHT, MIN_WIDTH, SHAPE_WEIGHT, CORNER_WEIGHT, WALL_WEIGHT, DETOUR, FACADE) = range(10)
"""Last index of `Goal.rooms`."""

ACCESS, ADJACENT = range(2)
"""Kinds of links, the last index of `Goal.links`."""


class Goal(NamedTuple):
    """The goal of the search as arrays.

    ``rooms[r]`` holds target area, seed, weights, minimum width and the shape that is wanted (`RoomShape`); ``links``
    are rows of two labels and a kind (0 access, 1 adjacent) and the wall length they ``need``; ``side`` gives, for each
    label, the side on which a core may be entered (0 any, 1 north, 2 east, 3 south, 4 west); ``apart`` lists pairs that
    should not touch.
    """

    rooms: Floats
    links: Ints
    need: Floats
    side: Ints
    apart: Ints
    weights: Floats


def make_goal(model: FloorModel, options: SolverOptions, relaxed: Iterable[Link] = ()) -> Goal:
    """Return the goal arrays of the wall search; links that are `relaxed` are left out."""
    n = len(model.rooms)
    total = n + len(model.obstacles) + 1
    index = model.index
    dropped = set(relaxed)
    links = [link for link in model.links if link not in dropped]
    pairs = np.array([(index[k.source], index[k.target]) for k in links], np.int64)
    pairs = pairs.reshape(-1, 2)
    kind = np.array([ACCESS if k.kind == "access" else ADJACENT for k in links], np.int64)
    need = np.where(kind == ACCESS, model.problem.min_access_wall, options.adjacent_wall).astype(float)
    side = np.zeros(total, np.int64)
    for k, obstacle in enumerate(model.obstacles):
        side[n + k] = obstacle.side
    known = ~np.isnan(model.seeds[:, 0])
    linked = {(min(a, b), max(a, b)) for a, b in pairs.tolist()}
    apart = np.array(
        [(a, b) for a in range(n) for b in range(a + 1, n) if (a, b) not in linked] if (kind == ADJACENT).any() else [],
        np.int64,
    ).reshape(-1, 2)
    hub = np.arange(n) == 0
    weights = options.seeded if mostly_seeded(model) else options.unseeded
    rooms = np.stack(
        [
            model.targets,
            np.nan_to_num(model.seeds[:, 0]),
            np.nan_to_num(model.seeds[:, 1]),
            np.where(known, np.where(hub, 0.5, 1.0), 0.0),
            model.min_widths,
            *_shape_columns(model, known, hub),
        ],
        axis=1,
    )
    return Goal(
        rooms=np.ascontiguousarray(rooms),
        links=np.column_stack([pairs, kind]),
        # Walls a little longer than needed survive the rounding of the final polygons.
        need=need + 1e-3,
        side=side,
        apart=apart,
        weights=np.array(astuple(weights), dtype=float),
    )


def _shape_columns(model: FloorModel, known: Bools, hub: Bools) -> tuple[Floats, ...]:
    """Return the columns of `Goal.rooms` from `SHAPE_WEIGHT` on.

    Where most rooms have a seed, and for those that have one, the seeds say enough of where a room lies and how large
    it is. The hub takes what the others leave.
    """
    seeded = mostly_seeded(model)
    shapes = [ANY if seeded or fixed else shape_of(room.room_type) for room, fixed in zip(model.rooms, known | hub)]
    return (
        np.where(hub, 0.2, [shape.compact for shape in shapes]),
        np.where(hub, 0.5 if seeded else 1.0, [shape.corner for shape in shapes]),
        np.where(known | hub, 0.0, [shape.wall for shape in shapes]),
        np.array([shape.detour for shape in shapes]),
        np.array([shape.facade for shape in shapes]),
    )


def mostly_seeded(model: FloorModel) -> bool:
    """Tell whether most rooms besides the hub have a seed."""
    known = ~np.isnan(model.seeds[1:, 0])
    return bool(known.size and known.mean() > 0.6)

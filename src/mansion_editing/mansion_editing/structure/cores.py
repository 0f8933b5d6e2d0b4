"""One more stair or lift, at one place through all storeys, on floor that a room of each gives."""

import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Final, Literal

import msgspec
from shapely import Polygon, box

from mansion_editing.structure.attempts import Change, attempt
from mansion_editing.structure.rebuilding import passages_of_scene
from mansion_editing.structure.room_shapes import is_circulation, limits_of, tidied
from mansion_editing.structure.storey_documents import (
    Reshaped,
    Storey,
    Workshop,
    added_access,
    node_of,
    region_shapes,
    with_shapes,
)
from mansion_geometry.shared_walls import edge_array, longest_wall, shared_walls
from mansion_geometry.stair_landings import with_landings
from mansion_geometry.wall_sizes import ACCESS_WALL
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import BuildingProgram, CorePlan
from mansion_msgs_py.scene import FloorScene, SceneRoom
from mansion_msgs_py.shapes import CompassSide, Point
from mansion_msgs_py.topology import FloorTopology, TopologyNode
from mansion_msgs_py.wording import listed
from mansion_scene.structure.access import Passage, pair_key

__all__ = ["CoreKind", "JudgeAll", "add_core"]

CoreKind = Literal["stair", "elevator"]

JudgeAll = Callable[[Mapping[int, FloorScene]], Sequence[str]]
"""Returns the faults that a building would have with these storeys, and has not now."""

_SIZES: Final[Mapping[str, tuple[tuple[float, float], ...]]] = {
    "stair": ((3.0, 6.0), (6.0, 3.0)),
    "elevator": ((2.0, 2.0),),
}
"""Length along the wall with the door, and depth behind it, metres: the sizes that the planner gives cores."""

_SIDES: Final[Mapping[tuple[int, int], CompassSide]] = {
    (0, 1): "north",
    (0, -1): "south",
    (1, 0): "east",
    (-1, 0): "west",
}
_STEP = 0.5
_MOST_PLACES = 8


@dataclass(frozen=True)
class _Place:
    """A place for a core: its plan, and on each storey the room that gives it and the passage that it opens to."""

    core: CorePlan
    rooms: tuple[tuple[SceneRoom, SceneRoom], ...]
    price: float


def add_core(
    storeys: Sequence[Storey], kind: CoreKind, workshop: Workshop, judge: JudgeAll, *, room_id: str = ""
) -> list[Reshaped]:
    """Add a stair or a lift that serves all storeys.

    Parameters
    ----------
    storeys : sequence of Storey
        All storeys of the building, from below.
    kind : {"stair", "elevator"}
    workshop : Workshop
        Its own judge is not asked: a core is sound only when it is on all storeys.
    judge : callable
    room_id : str
        Room that gives the floor on its storey; any when empty.

    Returns
    -------
    list of Reshaped
        Each storey, in the order given; all have the program of the last.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` where the building has one storey, or no place that a room of each storey beside a passage can
        give.
    """
    if len(storeys) < 2:
        raise MansionError(ErrorCode.INFEASIBLE, f"a building of one storey needs no {kind}", path="$.what")
    places = sorted(_places(storeys, kind, room_id), key=lambda place: place.price)
    reason = ""
    for place in itertools.islice(_apart(places), _MOST_PLACES):
        try:
            return _built(storeys, place, workshop, judge)
        except MansionError as error:
            reason = reason or error.info.message
    where = f"in {room_id} " if room_id else ""
    if room_id and not reason:
        elsewhere = dict.fromkeys(room.id for place in _places(storeys, kind, "") for room, _ in place.rooms[:1])
        reason = f"there may be one in {listed(list(elsewhere))}" if elsewhere else ""
    elif reason:
        reason = f"where there nearly is one, {reason}"
    raise MansionError(
        ErrorCode.INFEASIBLE,
        f"there is no place {where}for a further {kind} that on every storey lies within one room beside a passage and "
        f"leaves that room its shape" + (f"; {reason}" if reason else ""),
        path="$.room_id",
    )


def _apart(places: Sequence[_Place]) -> Iterator[_Place]:
    """Yield places that are at least a metre from those before."""
    seen: list[Point] = []
    for place in places:
        here = place.core.x[0], place.core.y[0]
        if all(math.dist(here, other) >= 1.0 for other in seen):
            seen.append(here)
            yield place


def _places(storeys: Sequence[Storey], kind: CoreKind, room_id: str) -> Iterator[_Place]:
    lead = next((s for s in storeys if any(room.id == room_id for room in s.scene.rooms)), storeys[0])
    name = next(n for n in (f"{kind}_{k}" for k in range(1, 100)) if n not in _core_names(lead))
    for giver, wall in _walls(lead, room_id):
        for along, depth in _SIZES[kind]:
            for shape, side in _boxes(wall, along, depth):
                if not giver.buffer(1e-6).covers(shape):
                    continue
                found = [_room_at(storey, shape, side) for storey in storeys]
                rooms = tuple(pair for pair in found if pair is not None)
                if len(rooms) == len(storeys):
                    x0, y0, x1, y1 = shape.bounds
                    core = CorePlan(id=name, type=kind, x=(x0, x1), y=(y0, y1), door_side=side)
                    yield _Place(core, rooms, round(sum(shape.area / room.area for room, _ in rooms), 6))


def _core_names(storey: Storey) -> set[str]:
    return {core.id for core in storey.program.vertical_connectivity.cores}


def _walls(storey: Storey, room_id: str) -> Iterator[tuple[Polygon, tuple[Point, Point]]]:
    """Yield the walls between rooms that may give floor and passages, the room to the left."""
    shapes = region_shapes(storey, storey.layout)
    passages = [edge_array(shapes[node_of(room)]) for room in storey.scene.rooms if is_circulation(room)]
    for room in storey.scene.rooms:
        if is_circulation(room) or room.kind == "main" or (room_id and room.id != room_id):
            continue
        shape = shapes[node_of(room)]
        for passage in passages:
            for wall in shared_walls(edge_array(shape), passage, 1e-3):
                yield shape, (wall.start, wall.end)


def _boxes(wall: tuple[Point, Point], along: float, depth: float) -> Iterator[tuple[Polygon, CompassSide]]:
    """Yield boxes behind an axis-parallel wall, from end to end, each with the side of its door."""
    (ax, ay), (bx, by) = wall
    length = math.dist(*wall)
    ux, uy = (bx - ax) / length, (by - ay) / length
    side = _SIDES.get((round(uy), round(-ux))) if max(abs(ux), abs(uy)) > 1 - 1e-6 else None
    if side is None:
        return
    slack = max(length - along, 0.0)
    for k in range(int(slack / _STEP) + 2):
        start = min(k * _STEP, slack)
        x, y = ax + ux * start, ay + uy * start
        far = x + ux * along - uy * depth, y + uy * along + ux * depth
        corners = [round(v, 4) for v in (min(x, far[0]), min(y, far[1]), max(x, far[0]), max(y, far[1]))]
        yield box(*corners), side


def _room_at(storey: Storey, shape: Polygon, side: CompassSide) -> tuple[SceneRoom, SceneRoom] | None:
    """Return the room of a storey that can give a box, and the passage at the box's door side."""
    shapes = region_shapes(storey, storey.layout)
    giver = next((r for r in storey.scene.rooms if shapes[node_of(r)].buffer(1e-6).covers(shape)), None)
    if giver is None or is_circulation(giver) or giver.kind == "main":
        return None
    whole = shapes[node_of(giver)]
    left = tidied(whole.difference(shape))
    if left is None or limits_of(whole, giver.room_type, storey.floor.structural_walls).fault(left):
        return None
    for room in storey.scene.rooms:
        if is_circulation(room) and _opens(shape, side, shapes[node_of(room)]):
            return giver, room
    return None


def _opens(shape: Polygon, side: CompassSide, passage: Polygon) -> bool:
    """Whether a box has wall enough for its door in common with a passage, on one side."""
    x0, y0, x1, y1 = shape.bounds
    edges = {"north": box(x0, y1 - 0.1, x1, y1), "south": box(x0, y0, x1, y0 + 0.1)}
    edges |= {"east": box(x1 - 0.1, y0, x1, y1), "west": box(x0, y0, x0 + 0.1, y1)}
    longest = longest_wall(shared_walls(edge_array(edges[side]), edge_array(passage), 1e-3))
    return longest is not None and longest.length >= ACCESS_WALL


def _built(storeys: Sequence[Storey], place: _Place, workshop: Workshop, judge: JudgeAll) -> list[Reshaped]:
    """Put a core in its place on all storeys; rooms whose furniture then is in the way are furnished again.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with what would be wrong.
    """
    faults: Sequence[str] = ()
    for refurnished in (False, True):
        done: list[Reshaped] = []
        program = _with_core(storeys[0], place.core)
        for storey, (giver, passage) in zip(storeys, place.rooms, strict=True):
            change = _change(replace(storey, program=program), storey, place.core, giver, passage)
            if refurnished:
                change = replace(change, refurnished={giver.id})
            done.append(attempt(change, replace(workshop, judge=lambda scene: ())).reshaped)
            program = done[-1].storey.program
        faults = judge({one.storey.number: one.storey.scene for one in done})
        if not faults:
            return [replace(one, storey=replace(one.storey, program=program)) for one in done]
    raise MansionError(ErrorCode.INFEASIBLE, f"the building would have a fault: {faults[0]}")


def _with_core(storey: Storey, core: CorePlan) -> BuildingProgram:
    connectivity = storey.program.vertical_connectivity
    cores = [*connectivity.cores, core]
    kinds = {entry.type for entry in cores}
    method = "stair_and_elevator" if len(kinds) == 2 else core.type
    changed = msgspec.structs.replace(connectivity, cores=cores, method=method)
    return with_landings(msgspec.structs.replace(storey.program, vertical_connectivity=changed))


def _change(after: Storey, before: Storey, core: CorePlan, giver: SceneRoom, passage: SceneRoom) -> Change:
    shape = box(core.x[0], core.y[0], core.x[1], core.y[1])
    name = node_of(giver)
    left = tidied(region_shapes(before, before.layout)[name].difference(shape))
    assert left is not None
    graph = added_access(_with_node(after.topology, core, shape.area), node_of(passage), core.id)
    return Change(
        before=before,
        after=with_shapes(replace(after, topology=graph), {name: left}),
        passages=[*passages_of_scene(before.scene), Passage(pair_key(passage.id, core.id))],
        may_change={giver.id, passage.id},
    )


def _with_node(topology: FloorTopology, core: CorePlan, area: float) -> FloorTopology:
    alike = next((node for node in topology.nodes if node.type in ("stair", "elevator")), None)
    node = TopologyNode(
        id=core.id,
        type=core.type,
        area=round(area, 3),
        room_type=core.type,
        floor_material=alike.floor_material if alike else "",
        wall_material=alike.wall_material if alike else "",
    )
    return msgspec.structs.replace(topology, nodes=[*topology.nodes, node])

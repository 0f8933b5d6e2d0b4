"""CheckPath: the topological path graph of the parts of rooms that a robot fits into, doors, stairs and lifts."""

from collections import deque
from collections.abc import Mapping, Sequence

import numpy as np
import numpy.typing as npt

from mansion_editing.state import SceneState
from mansion_editing.tools.perception import place_named
from mansion_geometry.object_footprints import WALKABLE_HEIGHT
from mansion_geometry.robot_body import CLEARANCE, ROBOT_RADIUS
from mansion_msgs_py.editing.questions import CheckPathArgs, PathReport, PathStep
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import Door

__all__ = ["blocked_doors", "check_path"]

Place = tuple[int, str]
Node = tuple[int, str, int]
"""Floor, room or core, and which part of the room's free floor."""

Graph = dict[Node, list[tuple[Node, str]]]

ROBOT_WIDTH = 2 * ROBOT_RADIUS
APPROACH = 0.25
"""Depth of the strip on both sides of a door that an object may not fill, metres."""


def check_path(state: SceneState, args: CheckPathArgs) -> PathReport:
    """Say whether a way leads from `start` to `end`, between the furniture, through doors, stairs and lifts.

    A room counts as reached when a part of its floor is; a start in a room is in the largest part of its floor.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` or ``CONFLICT`` for an end that names no place, or several.
    """
    blocked = {d for floor in state.floors for d in blocked_doors(state, floor)}
    graph = _graph(state, blocked)
    sources = [(*place_named(state, args.start, "$.start"), 0)] if args.start else _entrance(state)
    start = sources[0][1]
    came = _search(graph, sources)
    reached = {node[:2]: node for node in reversed(came)}
    rooms = [(floor, room.id) for floor, room in state.rooms()]
    lost = [place[1] for place in rooms if place not in reached]
    cuts = _cuts(state)
    route: list[PathStep] = []
    end = ""
    if args.end:
        goal = place_named(state, args.end, "$.end")
        end = goal[1]
        route = _route(came, reached[goal]) if goal in reached else []
        message = " > ".join(step.place for step in route) or f"no path leads from {start} to {end}"
    elif lost:
        message = f"{len(lost)} of {len(rooms)} rooms cannot be reached from {start}: {', '.join(lost[:8])}"
    else:
        message = f"all {len(rooms)} rooms can be reached from {start}"
    if cuts and not route:
        message += "; " + "; ".join(list(cuts.values())[:4])
    return PathReport(
        message=message,
        reachable=bool(route) if args.end else not lost,
        start=start,
        end=end,
        route=route,
        unreachable=lost,
        blocked_doors=sorted(blocked),
        cut_rooms=sorted(cuts),
    )


def _cuts(state: SceneState) -> dict[str, str]:
    """Say for each room that furniture cuts, or shuts a door of, which objects leave no way."""
    return {
        room: f"in {room}, {', '.join(names[:6]) or 'furniture'} leaves no gap of {ROBOT_WIDTH:g} m"
        for floor in state.floors
        for room, names in state.index(floor).passages.cuts.items()
    }


def _entrance(state: SceneState) -> list[Node]:
    """Return what lies behind the door to the outside, or where the robot starts."""
    for floor in sorted(state.floors, key=lambda number: (number != 1, number)):
        for door in state.scenes[floor].doors:
            if None in door.rooms and door.kind != "balcony":
                parts = state.index(floor).passages.at_door(door.rooms[0], door.id)
                return [(floor, door.rooms[0], part) for part in parts or (0,)]
    for floor in state.floors:
        spawn = state.scenes[floor].spawn
        if spawn is not None:
            part = state.index(floor).passages.at_point(spawn.room, spawn.x, spawn.y)
            return [(floor, spawn.room, part)]
    raise MansionError(ErrorCode.NOT_FOUND, "the building has no entrance; give a start")


def _graph(state: SceneState, blocked: set[str]) -> Graph:
    graph: Graph = {}
    for floor in state.floors:
        scene, passages = state.scenes[floor], state.index(floor).passages
        for door in scene.doors:
            one, other = door.rooms
            if other is None or door.id in blocked:
                continue
            for part in passages.at_door(one, door.id):
                for beyond in passages.at_door(other, door.id):
                    here, there = (floor, one, part), (floor, other, beyond)
                    graph.setdefault(here, []).append((there, door.id))
                    graph.setdefault(there, []).append((here, door.id))
        for core in scene.cores:
            for number in core.floors:
                if number != floor and number in state.scenes:
                    way = ((number, core.id, 0), "")
                    graph.setdefault((floor, core.id, 0), []).append(way)
    return graph


def _search(graph: Graph, sources: Sequence[Node]) -> dict[Node, tuple[Node, str] | None]:
    """Breadth first: each node that can be reached, the nearest first, and from where."""
    came: dict[Node, tuple[Node, str] | None] = dict.fromkeys(sources)
    queue = deque(sources)
    while queue:
        node = queue.popleft()
        for other, door in graph.get(node, []):
            if other not in came:
                came[other] = (node, door)
                queue.append(other)
    return came


def _route(came: Mapping[Node, tuple[Node, str] | None], end: Node) -> list[PathStep]:
    steps: list[PathStep] = []
    node: Node | None = end
    while node is not None:
        before = came[node]
        steps.append(PathStep(place=node[1], floor=node[0], door=before[1] if before else ""))
        node = before[0] if before else None
    return steps[::-1]


def blocked_doors(state: SceneState, floor: int) -> list[str]:
    """Return the doors before which objects leave no gap of a robot's width."""
    index = state.index(floor)
    boxes = index.boxes
    if not len(boxes):
        return []
    standing = np.array([item.mount in ("floor", "wall") for item in index.objects])
    low, high = boxes[:, 2] - boxes[:, 5] / 2, boxes[:, 2] + boxes[:, 5] / 2
    obstacles = boxes[standing & (low < CLEARANCE) & (high > WALKABLE_HEIGHT)]
    return [door.id for door in state.scenes[floor].doors if _is_blocked(door, obstacles)]


def _is_blocked(door: Door, obstacles: npt.NDArray[np.float64]) -> bool:
    (ax, ay), (bx, by) = door.segment
    length = float(np.hypot(bx - ax, by - ay))
    if length < 1e-6:
        return False
    ux, uy = (bx - ax) / length, (by - ay) / length
    turn = np.radians(obstacles[:, 6])
    c = np.abs(np.cos(turn) * ux + np.sin(turn) * uy)
    s = np.sqrt(np.maximum(0.0, 1.0 - c * c))
    half_along = (c * obstacles[:, 3] + s * obstacles[:, 4]) / 2
    half_across = (s * obstacles[:, 3] + c * obstacles[:, 4]) / 2
    dx, dy = obstacles[:, 0] - ax, obstacles[:, 1] - ay
    along, across = dx * ux + dy * uy, -dx * uy + dy * ux
    for side in (1.0, -1.0):
        gap = across * side
        near = (gap - half_across < APPROACH) & (gap + half_across > 0.02)
        near &= (along + half_along > 0) & (along - half_along < length)
        spans = sorted(zip((along - half_along)[near].tolist(), (along + half_along)[near].tolist()))
        free, reach = 0.0, 0.0
        for first, last in spans:
            free = max(free, first - reach)
            reach = max(reach, last)
        if max(free, length - reach) < min(ROBOT_WIDTH, length - 0.05):
            return True
    return False

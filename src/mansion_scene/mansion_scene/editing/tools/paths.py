"""CheckPath: the topological path graph of rooms, doors, stairs and lifts."""

from collections import deque
from collections.abc import Mapping

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.editing import CheckPathArgs, PathReport, PathStep
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import Door, FloorScene
from mansion_scene.editing.references import place_named
from mansion_scene.editing.state import SceneState

__all__ = ["blocked_doors", "check_path"]

Place = tuple[int, str]
Graph = dict[Place, list[tuple[Place, str]]]

ROBOT_WIDTH = 0.4
APPROACH = 0.25
"""Depth of the strip on both sides of a door that an object may not fill, metres."""

LOW = 0.03
"""A thing lower than this is walked over, metres."""


def check_path(state: SceneState, args: CheckPathArgs) -> PathReport:
    """Say whether a way leads from `start` to `end`, from room polygons, doors, stairs and lifts.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` or ``CONFLICT`` for an end that names no place, or several.
    """
    blocked = {d for floor in state.floors for d in blocked_doors(state, floor)}
    graph = _graph(state.scenes, blocked)
    start = place_named(state, args.start, "$.start") if args.start else _entrance(state)
    came = _search(graph, start)
    rooms = [
        (floor, room.id)
        for floor in state.floors
        for room in state.scenes[floor].rooms
        if room.kind not in ("stair", "elevator")
    ]
    lost = [room for place in rooms if place not in came for room in [place[1]]]
    names = sorted(blocked)
    if not args.end:
        message = (
            f"all {len(rooms)} rooms can be reached from {start[1]}"
            if not lost
            else f"{len(lost)} of {len(rooms)} rooms cannot be reached from {start[1]}: {', '.join(lost[:8])}"
        )
        return PathReport(
            message=message,
            reachable=not lost,
            start=start[1],
            unreachable=lost,
            blocked_doors=names,
        )
    end = place_named(state, args.end, "$.end")
    route = _route(came, end) if end in came else []
    way = " > ".join(step.place for step in route)
    return PathReport(
        message=way if route else f"no way leads from {start[1]} to {end[1]}",
        reachable=bool(route),
        start=start[1],
        end=end[1],
        route=route,
        unreachable=lost,
        blocked_doors=names,
    )


def _entrance(state: SceneState) -> Place:
    """Return the room behind the door to the outside, or where the robot starts."""
    for floor in sorted(state.floors, key=lambda number: (number != 1, number)):
        for door in state.scenes[floor].doors:
            if None in door.rooms and door.kind != "balcony":
                return floor, door.rooms[0]
    for floor in state.floors:
        spawn = state.scenes[floor].spawn
        if spawn is not None:
            return floor, spawn.room
    raise MansionError(ErrorCode.NOT_FOUND, "the building has no entrance; give a start")


def _graph(scenes: Mapping[int, FloorScene], blocked: set[str]) -> Graph:
    graph: Graph = {}
    for floor, scene in sorted(scenes.items()):
        for place in [room.id for room in scene.rooms] + [core.id for core in scene.cores]:
            graph.setdefault((floor, place), [])
        for door in scene.doors:
            one, other = door.rooms
            if other is None or door.id in blocked:
                continue
            graph.setdefault((floor, one), []).append(((floor, other), door.id))
            graph.setdefault((floor, other), []).append(((floor, one), door.id))
        for core in scene.cores:
            for number in core.floors:
                if number != floor and number in scenes:
                    graph[floor, core.id].append(((number, core.id), ""))
    return graph


def _search(graph: Graph, start: Place) -> dict[Place, tuple[Place, str] | None]:
    """Breadth first: each place that can be reached, and from where."""
    came: dict[Place, tuple[Place, str] | None] = {start: None}
    queue = deque([start])
    while queue:
        place = queue.popleft()
        for other, door in graph.get(place, []):
            if other not in came:
                came[other] = (place, door)
                queue.append(other)
    return came


def _route(came: Mapping[Place, tuple[Place, str] | None], end: Place) -> list[PathStep]:
    steps: list[PathStep] = []
    place: Place | None = end
    while place is not None:
        before = came[place]
        steps.append(PathStep(place=place[1], floor=place[0], door=before[1] if before else ""))
        place = before[0] if before else None
    return steps[::-1]


def blocked_doors(state: SceneState, floor: int) -> list[str]:
    """Return the doors before which objects leave no gap of a robot's width."""
    index = state.index(floor)
    boxes = index.boxes
    if not len(boxes):
        return []
    standing = np.array([item.mount in ("floor", "wall") for item in index.objects])
    low, high = boxes[:, 2] - boxes[:, 5] / 2, boxes[:, 2] + boxes[:, 5] / 2
    obstacles = boxes[standing & (low < 1.5) & (high > LOW)]
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
        spans = sorted(
            zip((along - half_along)[near].tolist(), (along + half_along)[near].tolist())
        )
        free, reach = 0.0, 0.0
        for first, last in spans:
            free = max(free, first - reach)
            reach = max(reach, last)
        if max(free, length - reach) < min(ROBOT_WIDTH, length - 0.05):
            return True
    return False

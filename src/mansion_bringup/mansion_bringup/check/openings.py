"""Checks that every door is in a wall between its two rooms, and every window in an outer wall."""

import itertools
import math
from collections import defaultdict
from collections.abc import Container, Iterator

from shapely import LineString, Polygon
from shapely.geometry.base import BaseGeometry

from mansion_bringup.check.fault import Fault
from mansion_bringup.check.shapes import along, room_area, segment_length
from mansion_geometry.wall_sizes import CLEAR_WIDTH, MIN_CLEAR_WIDTH
from mansion_msgs_py.scene import Door, FloorScene, Wall, Window

__all__ = ["check_openings"]

GARAGE_WIDTH = 2.4
"""Least clear width of a door for vehicles, metres."""

ASIDE = 0.13
"""How far a door's line may lie from a room's polygon: an outer wall's centre line is half a wall off."""

ROUNDING = 0.005


def check_openings(scene: FloorScene, edges: list[tuple[str, str]]) -> Iterator[Fault]:
    """Yield faults of doors and windows.

    Parameters
    ----------
    edges : list of (str, str)
        Pairs of room or core ids that must have a door between them.
    """
    boundaries = _boundaries(scene)
    walls = {wall.id: wall for wall in scene.walls}
    given = {entry.wish for entry in scene.downgrades if entry.stage == "plan"}
    for door in scene.doors:
        yield from _door(door, boundaries, walls, given)
    for window in scene.windows:
        yield from _window(window, boundaries, walls)
    yield from _crowded(scene, walls)
    joined = {frozenset(name for name in door.rooms if name) for door in scene.doors}
    for source, target in edges:
        if frozenset((source, target)) not in joined:
            yield Fault("DOOR_MISSING", f"{source} and {target}", "should be connected but have no door")


class _Boundary:
    """The boundary of a room or core, and what is near it, which is asked for each of its openings."""

    def __init__(self, area: Polygon) -> None:
        self._line = area.boundary
        self._strips: dict[float, BaseGeometry] = {}

    def beyond(self, line: LineString, aside: float) -> float:
        """Return how much of a line is further from the boundary than `aside`, metres."""
        if aside not in self._strips:
            self._strips[aside] = self._line.buffer(aside)
        return float(line.difference(self._strips[aside]).length)


def _boundaries(scene: FloorScene) -> dict[str, _Boundary]:
    found = {room.id: _Boundary(room_area(room)) for room in scene.rooms}
    return found | {core.id: _Boundary(Polygon(core.polygon)) for core in scene.cores}


def _door(
    door: Door, boundaries: dict[str, _Boundary], walls: dict[str, Wall], given: Container[str]
) -> Iterator[Fault]:
    length = segment_length(door.segment)
    first, second = door.rooms[0], door.rooms[1] or "outside"
    pairs = ((first, second), (second, first))
    narrow = any(f"door of {CLEAR_WIDTH} m between {one} and {other}" in given for one, other in pairs)
    least = GARAGE_WIDTH if door.kind == "garage" else MIN_CLEAR_WIDTH if narrow else CLEAR_WIDTH
    if length < least - ROUNDING:
        yield Fault("DOOR_NARROW", door.id, f"{length:.2f} m clear; at least {least} m are needed")
    if door.kind == "garage" and None not in door.rooms:
        yield Fault("DOOR_ROOMS", door.id, "is a garage door but does not lead outside")
    if abs(length - door.width) > 0.02:
        yield Fault("DOOR_WIDTH", door.id, f"states a width of {door.width:.2f} m, but its opening has {length:.2f} m")
    if door.kind != "open":
        yield from _in_wall(door, walls)
    line = LineString(door.segment)
    for name in door.rooms:
        if name is None:
            continue
        if name not in boundaries:
            yield Fault("DOOR_ROOMS", door.id, f"leads to {name}, which does not exist")
        elif boundaries[name].beyond(line, ASIDE) > ROUNDING:
            yield Fault("DOOR_ROOMS", door.id, f"is not on the boundary of {name}")


def _in_wall(opening: Door | Window, walls: dict[str, Wall]) -> Iterator[Fault]:
    kind = "DOOR_WALL" if isinstance(opening, Door) else "WINDOW_WALL"
    wall = walls.get(opening.wall)
    if wall is None:
        yield Fault(kind, opening.id, f"is in wall {opening.wall!r}, which does not exist")
        return
    length = segment_length(wall.segment)
    for point in opening.segment:
        position, aside = along(wall.segment, point)
        if aside > 0.02 or not -ROUNDING <= position <= length + ROUNDING:
            yield Fault(kind, opening.id, f"is not within wall {wall.id}")
            return
    top = opening.height + (opening.sill if isinstance(opening, Window) else 0.0)
    if top > wall.height + ROUNDING:
        yield Fault(kind, opening.id, f"is higher than wall {wall.id}")


def _window(window: Window, boundaries: dict[str, _Boundary], walls: dict[str, Wall]) -> Iterator[Fault]:
    yield from _in_wall(window, walls)
    if window.sill < -ROUNDING:
        yield Fault("WINDOW_SILL", window.id, f"its sill is {-window.sill:.2f} m below the floor")
    wall = walls.get(window.wall)
    if wall is not None and not wall.exterior:
        yield Fault("WINDOW_WALL", window.id, f"is in the inner wall {wall.id}")
    boundary = boundaries.get(window.room)
    if boundary is None or boundary.beyond(LineString(window.segment), 2 * ASIDE) > ROUNDING:
        yield Fault("WINDOW_ROOM", window.id, f"is not at {window.room}")


def _crowded(scene: FloorScene, walls: dict[str, Wall]) -> Iterator[Fault]:
    by_wall: dict[str, list[tuple[float, float, str]]] = defaultdict(list)
    openings: list[Door | Window] = [*scene.doors, *scene.windows]
    for opening in openings:
        wall = walls.get(opening.wall)
        if wall is not None:
            ends = sorted(along(wall.segment, point)[0] for point in opening.segment)
            by_wall[wall.id].append((ends[0], ends[1], opening.id))
    for spans in by_wall.values():
        spans.sort()
        for (_, end, first), (start, _, second) in itertools.pairwise(spans):
            if start < end - ROUNDING and not math.isclose(start, end, abs_tol=ROUNDING):
                yield Fault("OPENINGS_OVERLAP", f"{first} and {second}", "overlap in their wall")

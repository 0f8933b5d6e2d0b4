"""A storey of a plan with its walls, doors and windows placed, and the main room that the others are reached from."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import msgspec
import shapely
from shapely.geometry import Polygon

from mansion_msgs_py.building_plan import BuildingPlan
from mansion_msgs_py.openings import GivenDoor, GivenOpenings
from mansion_msgs_py.program import CorePlan
from mansion_msgs_py.shapes import Segment
from mansion_planner.given_plan.cores import CoreDoor, landing_door
from mansion_planner.given_plan.door_places import doors_between, placed_doors, placed_windows, wall_room
from mansion_planner.given_plan.faults import Findings
from mansion_planner.given_plan.reachability import complete_doors, entrance_of, main_room, report_unreached
from mansion_planner.given_plan.room_gaps import outline_of
from mansion_planner.given_plan.storey_walls import StoreyWall, storey_walls
from mansion_planner.given_plan.storeys import PlanStorey, StoreyRoom

__all__ = ["GivenFloor", "core_doors", "given_floor", "with_stair_doors"]

_NEARBY = 0.3
"""Metres by which a door may be moved without a word."""


@dataclass(frozen=True)
class GivenFloor:
    """A storey that is ready to be written down; `openings` is absent where the solver draws its rooms."""

    storey: PlanStorey
    outline: Polygon
    doors: list[GivenDoor]
    openings: GivenOpenings | None
    main: StoreyRoom
    walls: list[StoreyWall] = field(default_factory=list)


def given_floor(storey: PlanStorey, plan: BuildingPlan, findings: Findings) -> GivenFloor:
    """Return a storey with its doors and windows on its walls; what cannot be goes to `findings`."""
    adding = "doors" in plan.complete
    if not storey.drawn:
        return _floor_to_draw(storey, findings)
    outline = outline_of(storey)
    shapes = {room.id: room.shape for room in storey.rooms if room.shape is not None}
    walls = storey_walls(shapes, outline)
    doors, failed = placed_doors(storey, walls, findings)
    if adding and not failed:
        doors = complete_doors(storey, doors, wall_room(walls), findings)
    report_unreached(storey, [*doors, *failed], findings)
    windows = placed_windows(storey, walls, doors, findings)
    chosen = "windows" in plan.complete and not storey.windows
    if chosen:
        findings.note(storey.index, "windows", "windows as rooms of each type have them", "the plan has none")
    elif not storey.windows and storey.index >= 1:
        findings.note(
            storey.index, "windows", "none", 'the plan has none; "complete": ["windows"] (--complete windows) adds them'
        )
    openings = GivenOpenings(doors=doors, windows=None if chosen else windows, further_doors=adding)
    return GivenFloor(storey, outline, doors, openings, main_room(storey, doors), walls)


def _floor_to_draw(storey: PlanStorey, findings: Findings) -> GivenFloor:
    """Return a storey of which the solver draws the rooms that have no polygon."""
    if storey.outline is None:
        findings.fault(storey.index, "", "rooms without polygons need the outline of the floor")
    doors = []
    for door, sides in doors_between(storey, findings):
        if sides is None:
            continue
        if len(sides) == 2 and sides[0] is not None and (door.segment is None and door.at is None):
            doors.append(GivenDoor(rooms=(sides[0], sides[1])))
        elif len(sides) == 2 and sides[1] is not None and (door.segment is None and door.at is None):
            doors.append(GivenDoor(rooms=(sides[1], sides[0])))
        else:
            findings.fault(
                storey.index,
                "door",
                "where rooms have no polygons, a door names the two rooms that it joins, and no place",
            )
    if storey.windows:
        findings.fault(storey.index, "window", "where rooms have no polygons, windows are chosen by room type")
    if entrance_of(doors) is None and storey.index == 1:
        doors.append(GivenDoor(rooms=(main_room(storey, doors).id, None)))
    if storey.outline is not None:
        report_unreached(storey, doors, findings)
    outline = storey.outline or shapely.box(0.0, 0.0, 1.0, 1.0)
    entered = entrance_of(doors)
    main = storey.room(entered) if entered is not None else main_room(storey, doors)
    return GivenFloor(storey, outline, doors, None, main)


def core_doors(core: CorePlan, floors: Sequence[GivenFloor]) -> list[CoreDoor]:
    """Return the doors of a core on all floors that are drawn."""
    return [
        CoreDoor(
            floor.storey.index, [wall for wall in floor.walls if wall.rooms == frozenset(door.rooms)], door.segment
        )
        for floor in floors
        for door in floor.doors
        if core.id in door.rooms and floor.openings is not None
    ]


_STAIR_DOOR = 1.1
"""Clear width of a stair's door of which the plan states none, metres."""


def with_stair_doors(floor: GivenFloor, cores: Sequence[CorePlan], findings: Findings) -> GivenFloor:
    """Return a storey whose stairs open on to their landings: a door that is elsewhere is moved there."""
    stairs = {core.id: core for core in cores if core.type == "stair" and core.landing is not None}
    doors = []
    for door in floor.doors:
        core = next((stairs[name] for name in door.rooms if name in stairs), None)
        if core is not None and floor.openings is not None:
            walls = [wall for wall in floor.walls if wall.rooms == frozenset(door.rooms)]
            stated = math.dist(*door.segment) if door.segment else door.width
            place = landing_door(core, CoreDoor(floor.storey.index, walls, door.segment), stated or _STAIR_DOOR)
            name = floor.storey.room(core.id).name
            if place is None or (door.segment is not None and _elsewhere(place, door.segment)):
                got = "beside its flights" if place is None else "moved to its landing"
                findings.note(floor.storey.index, f"door of {name}", got, "steps begin beyond the landing")
            door = GivenDoor(rooms=door.rooms, segment=place or door.segment)
        doors.append(door)
    openings = None if floor.openings is None else msgspec.structs.replace(floor.openings, doors=doors)
    return replace(floor, doors=doors, openings=openings)


def _elsewhere(one: Segment, other: Segment) -> bool:
    middles = [((ax + bx) / 2, (ay + by) / 2) for (ax, ay), (bx, by) in (one, other)]
    return math.dist(*middles) > _NEARBY

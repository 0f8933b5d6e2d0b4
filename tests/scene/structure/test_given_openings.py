"""Doors and windows of a plan are built where and as wide as the plan has them, and no others."""

import math
from typing import Any

import msgspec
import pytest

from mansion_msgs_py.building_plan import BuildingPlan
from mansion_msgs_py.codec import convert
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.openings import GivenDoor, GivenOpenings, GivenWindow
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import FurnishRequest
from mansion_planner.plan import plan_building
from mansion_planner.solver import solve_floor
from mansion_scene.structure import FloorStructure, build_structure

ROOMS: list[dict[str, Any]] = [
    {"name": "Hall", "polygon": [[0, 0], [6, 0], [6, 2], [0, 2]]},
    {"name": "Living room", "polygon": [[0, 2], [6, 2], [6, 7], [0, 7]]},
    {"name": "Garage", "polygon": [[6, 0], [10, 0], [10, 7], [6, 7]]},
]
PLAN: dict[str, Any] = {
    "floors": [{"rooms": ROOMS, "doors": [{"rooms": ["Hall", name]} for name in ("Living room", "Garage", "outside")]}]
}


def request(plan: dict[str, Any]) -> FurnishRequest:
    """Return the furnish request of a plan."""
    reply = plan_building(BuildRequest(description="", plan=convert(BuildingPlan, plan)))
    program = reply.program
    return FurnishRequest(
        building_id=program.building_id,
        floor=program.floors[0],
        floors=[1],
        labels=["1"],
        connectivity=program.vertical_connectivity,
        topology=reply.topologies[0],
        layout=solve_floor(reply.problems[0]),
        building_type=program.kind,
        style=program.style,
    )


def built(openings: GivenOpenings) -> FloorStructure:
    """Return the structure of the three rooms with other openings."""
    plain = request(PLAN)
    floor = msgspec.structs.replace(plain.floor, openings=openings)
    return build_structure(msgspec.structs.replace(plain, floor=floor))


WAYS = [GivenDoor(rooms=("hall", "living_room")), GivenDoor(rooms=("hall", "garage")), GivenDoor(rooms=("hall", None))]


def test_doors_with_a_place_stand_there_and_the_others_find_one() -> None:
    placed = GivenDoor(rooms=("hall", "living_room"), segment=((1.0, 2.0), (1.8, 2.0)))
    structure = built(GivenOpenings(doors=[placed, *WAYS[1:]], windows=[]))
    doors = {frozenset(door.rooms): door for door in structure.doors}
    assert doors.keys() == {
        frozenset(("F1/hall", "F1/living_room")), frozenset(("F1/hall", "F1/garage")), frozenset(("F1/hall", None)),
    }  # fmt: skip
    door = doors[frozenset(("F1/hall", "F1/living_room"))]
    assert sorted(door.segment) == [(1.0, 2.0), (1.8, 2.0)]
    assert door.kind == "single"
    assert [(entry.stage, entry.got) for entry in structure.downgrades] == [("plan", "0.80 m clear")]


def test_a_door_that_its_wall_makes_narrow_is_the_plans_own() -> None:
    rooms = [
        {"name": "Hall", "polygon": [[0, 0], [6, 0], [6, 2], [0, 2]]},
        {"name": "Store", "polygon": [[0, 2], [0.95, 2], [0.95, 4], [0, 4]]},
        {"name": "Living room", "polygon": [[0.95, 2], [6, 2], [6, 4], [0.95, 4]]},
    ]
    doors = [{"rooms": ["Hall", name]} for name in ("Store", "Living room", "outside")]
    structure = build_structure(request({"floors": [{"rooms": rooms, "doors": doors}]}))
    assert {entry.stage for entry in structure.downgrades} == {"plan"}
    door = next(door for door in structure.doors if "F1/store" in door.rooms)
    assert 0.7 <= door.width < 0.9


def test_a_ledge_half_as_deep_as_a_wall_has_none_of_its_own() -> None:
    rooms = [{"name": "Studio", "polygon": [[0, 0], [6, 0], [6, 2], [6.12, 2], [6.12, 5], [6, 5], [6, 7], [0, 7]]}]
    structure = build_structure(request({"floors": [{"rooms": rooms, "doors": [{"rooms": ["Studio", "outside"]}]}]}))
    assert all(math.dist(*wall.segment) > 0.01 for wall in structure.walls)


def test_a_width_without_a_place_is_kept() -> None:
    wide = GivenDoor(rooms=("hall", "living_room"), width=1.6)
    structure = built(GivenOpenings(doors=[wide, *WAYS[1:]], windows=[]))
    door = next(door for door in structure.doors if "F1/living_room" in door.rooms)
    assert (door.kind, door.width) == ("double", 1.6)


def test_an_open_wall_is_left_out() -> None:
    structure = built(
        GivenOpenings(doors=[GivenDoor(rooms=("hall", "living_room"), kind="open"), *WAYS[1:]], windows=[])
    )
    (door,) = (door for door in structure.doors if "F1/living_room" in door.rooms)
    assert door.kind == "open"
    assert door.width > 5.5


@pytest.mark.parametrize(("further", "kinds"), [(False, set()), (True, {"garage"})])
def test_doors_for_vehicles_are_added_on_request_alone(further: bool, kinds: set[str]) -> None:
    structure = built(GivenOpenings(doors=WAYS, windows=[], further_doors=further))
    assert {door.kind for door in structure.doors} & {"garage"} == kinds


def test_windows_are_those_of_the_plan_or_chosen_where_it_leaves_them_open() -> None:
    window = GivenWindow(segment=((0.0, 4.0), (0.0, 6.0)), sill=0.4, height=1.8)
    (made,) = built(GivenOpenings(doors=WAYS, windows=[window])).windows
    assert (made.room, made.sill, made.height) == ("F1/living_room", 0.4, 1.8)
    assert {round(y, 4) for _, y in made.segment} == {4.0, 6.0}
    assert built(GivenOpenings(doors=WAYS, windows=[])).windows == []
    assert len(built(GivenOpenings(doors=WAYS)).windows) > 2


def test_a_window_stays_clear_of_an_outer_door_and_of_the_ceiling() -> None:
    door = GivenDoor(rooms=("hall", None), segment=((2.0, 0.0), (3.0, 0.0)))
    window = GivenWindow(segment=((1.0, 0.0), (2.5, 0.0)), sill=2.9, height=3.0)
    structure = built(GivenOpenings(doors=[*WAYS[:2], door], windows=[window]))
    (made,) = structure.windows
    assert max(x for x, _ in made.segment) <= 2.0
    assert made.sill + made.height <= structure.ceiling


def test_a_door_off_the_walls_is_refused() -> None:
    with pytest.raises(MansionError, match="lies on no wall between F1/hall and F1/garage"):
        built(GivenOpenings(doors=[GivenDoor(rooms=("hall", "garage"), segment=((3.0, 1.0), (4.0, 1.0)))], windows=[]))
    with pytest.raises(MansionError, match="'cellar', which the floor does not have"):
        built(GivenOpenings(doors=[GivenDoor(rooms=("hall", "cellar"))], windows=[]))

"""A plan becomes the program, the room graph and the layout that it shows."""

from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import Polygon

from mansion_msgs_py.building_plan import BuildingPlan, PlanDoor, PlanFloor, PlanRoom
from mansion_msgs_py.codec import convert, decode, encode
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import PlanReply
from mansion_planner.plan import plan_building
from mansion_planner.solver import solve_floor

Plans = Callable[..., PlanReply]


def test_rooms_keep_their_places_names_and_kinds(plan: Plans, flat: dict[str, Any]) -> None:
    reply = plan(flat)
    layout = solve_floor(reply.problems[0])
    shapes = {room.id: Polygon(room.polygon) for room in layout.rooms}
    assert shapes["kitchen"].equals(Polygon([(4, 5), (8, 5), (8, 8), (4, 8)]))
    rooms = {room.id: room for room in reply.program.floors[0].rooms}
    assert rooms["annas_bedroom"].name == "Anna's bedroom"
    assert {name: room.room_type for name, room in rooms.items()} == {
        "hall": "hallway", "living_room": "living_room", "kitchen": "kitchen", "annas_bedroom": "bedroom",
        "bath": "bathroom",
    }  # fmt: skip
    assert layout.hub == "hall"
    assert layout.topology_satisfied


def test_the_building_type_follows_from_the_rooms(plan: Plans, flat: dict[str, Any], house: dict[str, Any]) -> None:
    assert plan(flat).program.building_type == "flat"
    assert plan(house).program.building_type == "house"
    assert plan({**house, "building_type": "villa", "style": "scandinavian"}).program.building_type == "villa"


def test_doors_and_windows_lie_on_the_walls_of_the_layout(plan: Plans, flat: dict[str, Any]) -> None:
    openings = plan(flat).program.floors[0].openings
    assert openings is not None and openings.windows is not None
    doors = {door.rooms: door for door in openings.doors}
    assert doors["hall", None].segment == ((8.0, 3.5), (8.0, 4.5))
    assert doors["hall", "living_room"].segment is None
    assert doors["living_room", "kitchen"].kind == "open"
    assert sorted(window.segment for window in openings.windows) == [
        ((0.0, 2.1), (0.0, 0.9)), ((0.0, 7.0), (0.0, 5.0)), ((6.75, 8.0), (5.25, 8.0)),
    ]  # fmt: skip


def test_a_door_drawn_off_its_wall_is_put_on_to_it(plan: Plans, flat: dict[str, Any]) -> None:
    flat["floors"][0]["doors"][2] = {"segment": [[4.02, 5.1], [4.92, 5.1]], "rooms": ["Hall", "Kitchen"]}
    openings = plan(flat).program.floors[0].openings
    assert openings is not None
    segment = next(door.segment for door in openings.doors if set(door.rooms) == {"hall", "kitchen"})
    assert segment is not None
    assert {y for _, y in segment} == {5.0}
    assert min(x for x, _ in segment) == pytest.approx(4.06)


def test_two_rooms_of_one_name_are_numbered(plan: Plans, house: dict[str, Any]) -> None:
    house["floors"][0]["rooms"][2]["name"] = "Bedroom"
    house["floors"][0]["doors"] = [{"rooms": ["Landing", name]} for name in ("bedroom_1", "bedroom_2", "Stairs")]
    program = plan(house).program
    assert [room.id for room in program.floors[1].rooms] == ["landing", "bedroom_1", "bedroom_2"]
    assert [wish.value.count for wish in program.wishes if wish.text == "Bedroom"] == [2]


def test_stairs_of_all_floors_are_one_core(plan: Plans, house: dict[str, Any]) -> None:
    house["floors"][0]["rooms"][3] = {"name": "Stairs", "polygon": [[4, 0], [6.1, 0], [6.1, 4], [4, 4]]}
    house["floors"][0]["rooms"][2] = {"name": "Bathroom", "polygon": [[6.1, 0], [10, 0], [10, 8], [6.1, 8]]}
    house["floors"][0]["rooms"][0] = {"name": "Landing", "polygon": [[4, 4], [6.1, 4], [6.1, 8], [4, 8]]}
    program = plan(house).program
    (core,) = program.vertical_connectivity.cores
    assert (core.id, core.x, core.y, core.landing) == ("stair_1", (4.0, 6.0), (0.0, 4.0), "north")
    bath = next(room for room in program.floors[1].rooms if room.id == "bathroom")
    assert bath.area_estimate == pytest.approx(32.0)
    assert [floor.height for floor in program.floors] == [3.0, 3.0]


def test_a_stair_that_is_short_lowers_the_storeys(plan: Plans, house: dict[str, Any]) -> None:
    for floor in house["floors"]:
        floor["rooms"][0]["polygon"] = [[4, 3.25], [6, 3.25], [6, 8], [4, 8]]
        floor["rooms"][3] = {"name": "Stairs", "polygon": [[4, 0], [6, 0], [6, 3.25], [4, 3.25]]}
    assert [floor.height for floor in plan(house).program.floors] == [2.65, 2.65]


def test_the_door_of_a_stair_opens_on_to_its_landing(plan: Plans, house: dict[str, Any]) -> None:
    house["floors"][1]["doors"][2] = {"rooms": ["Living room", "Stairs"], "segment": [[4, 1.5], [4, 2.5]]}
    reply = plan(house)
    openings = reply.program.floors[0].openings
    assert openings is not None
    (door,) = (door for door in openings.doors if "stair_1" in door.rooms)
    assert door.segment is not None
    assert min(y for _, y in door.segment) >= 3.0
    assert any("landing" in entry.got for entry in reply.program.downgrades)


def test_units_angles_and_far_origins_come_to_metres_near_the_origin(plan: Plans, flat: dict[str, Any]) -> None:
    turned = decode(dict, encode(flat))
    for room in turned["floors"][0]["rooms"]:
        room["polygon"] = [[(8 - y) * 1000 + 5e6, x * 1000] for x, y in room["polygon"]]
    turned["floors"][0] |= {"doors": [], "windows": [], "openings": []}
    turned |= {"units": "mm", "complete": ["doors"]}
    floor = plan(turned).program.floors[0]
    assert Polygon(floor.outline).bounds == (0.0, 0.0, 8.0, 8.0)


def test_what_the_plan_lacks_is_added_on_request_and_told(plan: Plans, flat: dict[str, Any]) -> None:
    flat["floors"][0] |= {"doors": [], "windows": [], "openings": []}
    reply = plan({**flat, "complete": ["doors", "windows"]})
    openings = reply.program.floors[0].openings
    assert openings is not None
    assert openings.windows is None
    assert any(None in door.rooms for door in openings.doors)
    assert len({frozenset(door.rooms) for door in openings.doors if None not in door.rooms}) == 4
    got = [entry.got for entry in reply.program.downgrades]
    assert sum("added" in text for text in got) == 5
    assert any(text.startswith("windows as") for text in got)


def test_unknown_words_are_taken_for_the_nearest_kind_and_the_wish_says_so(plan: Plans, flat: dict[str, Any]) -> None:
    flat["floors"][0]["rooms"][3]["name"] = "Zorbium"
    flat["floors"][0]["doors"][4]["rooms"][1] = "Zorbium"
    wish = next(wish for wish in plan(flat).program.wishes if wish.text == "Zorbium")
    assert wish.reason == "no such room is known; furnished like a study room"


def test_a_description_beside_a_plan_says_what_is_wished_for(plan: Plans, flat: dict[str, Any]) -> None:
    program = plan(flat, "A flat in Japanese style with two armchairs in the bedroom").program
    assert program.style == "japanese"
    bedroom = next(room for room in program.floors[0].rooms if room.id == "annas_bedroom")
    assert [(entry.category, entry.count) for entry in bedroom.objects] == [("armchair", 2)]


def test_areas_that_are_rounded_add_up_to_no_more_than_the_floor(plan: Plans) -> None:
    width = 3.3333
    rooms = [
        {
            "name": f"Room {k}",
            "type": "bedroom",
            "polygon": [[k * width, 0], [(k + 1) * width, 0], [(k + 1) * width, 3.335], [k * width, 3.335]],
        }
        for k in range(6)
    ]
    floor = plan({"floors": [{"rooms": rooms}], "complete": ["doors"]}).program.floors[0]
    assert sum(room.area_estimate for room in floor.rooms) <= floor.gross_floor_area


def test_a_plan_and_sizes_exclude_each_other(flat: dict[str, Any]) -> None:
    request = BuildRequest(description="", floors=2, plan=convert(BuildingPlan, flat))
    with pytest.raises(MansionError, match="the plan already gives what floors would"):
        plan_building(request)


def test_rooms_without_polygons_are_drawn_by_the_solver(plan: Plans) -> None:
    graph = {
        "floors": [
            {
                "outline": [[0, 0], [9, 0], [9, 6], [0, 6]],
                "rooms": [
                    {"name": "Hall", "area": 10},
                    {"name": "Living room", "area": 24},
                    {"name": "Bedroom", "area": 14},
                    {"name": "Bath", "polygon": [[0, 0], [3, 0], [3, 2], [0, 2]]},
                ],
                "doors": [{"rooms": ["Hall", name]} for name in ("Living room", "Bedroom", "Bath", "outside")],
            }
        ]
    }
    layout = solve_floor(plan(graph).problems[0])
    assert layout.topology_satisfied
    shapes = {room.id: Polygon(room.polygon) for room in layout.rooms}
    assert shapes["bath"].bounds == (0.0, 0.0, 3.0, 2.0)
    assert sum(shape.area for shape in shapes.values()) == pytest.approx(54.0)


BRIEFS = (
    "a small flat for two",
    "a house with three bedrooms and a garage",
    "a small office with a meeting room",
    "an L-shaped clinic",
    "a kindergarten of one storey",
)


@settings(max_examples=8, deadline=None)
@given(st.sampled_from(BRIEFS), st.integers(0, 50))
def test_what_the_solver_drew_is_read_again_as_it_was(brief: str, seed: int) -> None:
    drawn = plan_building(BuildRequest(description=brief, floors=1, seed=seed))
    layout = solve_floor(drawn.problems[0])
    kinds = {node.id: node.room_type for node in drawn.topologies[0].nodes}
    written = encode(
        BuildingPlan(
            floors=[
                PlanFloor(
                    rooms=[
                        PlanRoom(id=room.id, name=room.id, type=kinds[room.id], polygon=room.polygon, holes=room.holes)
                        for room in layout.rooms
                    ],
                    doors=[
                        PlanDoor(rooms=[edge.source, edge.target])
                        for edge in layout.edges
                        if edge.kind == "access" and edge.satisfied
                    ],
                )
            ],
            complete=["doors"],
        )
    )
    reply = plan_building(BuildRequest(description="", plan=decode(BuildingPlan, written)))
    again = solve_floor(reply.problems[0])
    before = {room.id: Polygon(room.polygon, room.holes) for room in layout.rooms}
    after = {room.id: Polygon(room.polygon, room.holes) for room in again.rooms}
    assert before.keys() == after.keys()
    assert all(before[name].symmetric_difference(after[name]).area < 0.01 for name in before)
    assert {node.id: node.room_type for node in reply.topologies[0].nodes} == kinds

"""What the rooms of a storey are reached from where its type is planned around a main room."""

import pytest

from mansion_msgs_py.program import FloorProgram
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


def floor_of(brief: str) -> FloorProgram:
    return plan_building(BuildRequest(description=brief)).program.floors[0]


@pytest.mark.parametrize(
    ("brief", "hub"),
    [
        ("A flat of 85 m2 with a corridor, a kitchen, a living room, two bedrooms and a bathroom.", "corridor"),
        ("A flat of 70 m2: entrance hall, living room, kitchen, bedroom and shower room.", "hallway"),
        ("A flat of 70 m2 with a living room, a kitchen, two bedrooms and a bathroom.", "living_room"),
    ],
)
def test_the_rooms_of_a_flat_are_reached_from_the_passage_that_the_brief_asks_for(brief: str, hub: str) -> None:
    rooms = floor_of(brief).rooms
    assert rooms[0].room_type == hub
    assert sum(room.room_type in ("hallway", "corridor") for room in rooms) <= 1
    assert sum(room.room_type == "living_room" for room in rooms) == 1


@pytest.mark.parametrize(
    "brief",
    [
        "A shop of 240 m2 with a sales area of 120 m2, a store and an office.",
        "A warehouse of 700 m2 on one storey, with a storage hall of 400 m2, an office and a canteen.",
    ],
)
def test_a_lobby_beside_a_main_room_of_its_own_name_stays_small(brief: str) -> None:
    floor = floor_of(brief)
    rooms = sum(room.area_estimate for room in floor.rooms[1:])
    assert floor.rooms[0].room_type == "lobby" and rooms >= 0.75 * floor.gross_floor_area


def test_stated_rooms_that_fill_a_storey_have_their_areas_before_its_lobby() -> None:
    brief = (
        "A one-storey warehouse of 1000 m2. Storage hall of 680 m2, packing room of 70 m2, dispatch office of 24 m2, "
        "canteen of 30 m2, a goods-in bay of 60 m2."
    )
    problem = plan_building(BuildRequest(description=brief)).problems[0]
    stated = {node.id: node.area for node in problem.nodes}
    assert [stated[name] for name in ("storage_hall", "packing_room")] == pytest.approx([680.0, 70.0], rel=0.02)
    assert sum(area or 0.0 for area in stated.values()) <= 1.05 * 1000.0

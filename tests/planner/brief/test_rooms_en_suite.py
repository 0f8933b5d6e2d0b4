"""Rooms that are called en suite have bathrooms of their own."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("a villa with a pool and five ensuite bedrooms and a study", 5),
        ("a house with two en-suite double bedrooms", 2),
        ("a house with four en suite bedrooms, one bathroom", 4),
        ("a house with three ensuite rooms", 3),
    ],
)
def test_each_bedroom_en_suite_leads_to_a_bathroom(text: str, count: int) -> None:
    reply = plan_building(BuildRequest(description=text))
    rooms = {room.id: room.room_type for floor in reply.program.floors for room in floor.rooms}
    edges = [edge for topology in reply.topologies for edge in topology.edges if edge.kind == "access"]
    baths = [edge.source for edge in edges if rooms.get(edge.target) == "ensuite_bathroom"]
    assert len(baths) == len(set(baths)) == count
    assert {rooms[name] for name in baths} <= {"bedroom", "hotel_room"}


def test_the_rooms_of_a_hotel_have_one_bathroom_each() -> None:
    reply = plan_building(BuildRequest(description="a hotel with 20 ensuite rooms"))
    kinds = [room.room_type for floor in reply.program.floors for room in floor.rooms]
    assert kinds.count("hotel_room") == 20
    assert kinds.count("bathroom") + kinds.count("ensuite_bathroom") == 20


def test_an_ensuite_of_one_of_several_bedrooms_is_that_one_alone() -> None:
    facts = read_brief("a house with three bedrooms, one ensuite", default_knowledge())
    assert sum(len(room.suite) for room in facts.rooms) <= 1


def test_open_plan_is_no_part_of_a_name_and_a_living_area_is_a_living_room() -> None:
    facts = read_brief("a house with an open-plan living area and three bedrooms", default_knowledge())
    assert next((room.name, room.room_type) for room in facts.rooms) == ("living_area", "living_room")

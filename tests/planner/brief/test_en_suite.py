"""Rooms that are called en suite have bathrooms of their own, and those of several that are told to."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import RoomFact
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


def _rooms(text: str) -> list[RoomFact]:
    return read_brief(text, default_knowledge()).rooms


@pytest.mark.parametrize(
    ("text", "without", "with_bathroom"),
    [
        ("Three bedrooms out of which the master bedroom is having attached bathroom, and a hall", 2, 1),
        ("A house with four bedrooms, out of which two are having attached bathroom", 2, 2),
        ("A villa with five bedrooms, of which one with the own bathroom, and a kitchen", 4, 1),
        ("A flat of three bedrooms, of which the main one is with attached toilet", 2, 1),
        ("House with 3 bedrooms, the master one having ensuite bath, single storey", 2, 1),
        ("Flat with two bedrooms, the larger one with its own shower room", 1, 1),
        ("A house with four bedrooms (one with an en-suite bathroom) and a family bathroom", 3, 1),
    ],
)
def test_some_of_the_bedrooms_have_a_bathroom(text: str, without: int, with_bathroom: int) -> None:
    bedrooms = [room for room in _rooms(text) if room.room_type in ("bedroom", "master_bedroom")]
    counts = {bool(room.suite): room.count for room in bedrooms}
    assert counts == {False: without, True: with_bathroom}


@pytest.mark.parametrize(
    "text",
    [
        "A house with three bedrooms, one bathroom and a garage",
        "A house with three bedrooms, a master bedroom and a bathroom",
        "A house with three bedrooms, two of them with a balcony, one bathroom",
    ],
)
def test_other_bedrooms_keep_their_number(text: str) -> None:
    rooms = _rooms(text)
    assert [room.count for room in rooms if room.name == "bedroom"] == [3]
    assert not any(room.suite for room in rooms)


def test_a_second_bathroom_is_one_more() -> None:
    facts = read_brief(
        "A villa with four bedrooms, of which one with the own bathroom, and a second bathroom", default_knowledge()
    )
    assert [room.count for room in facts.rooms if room.room_type == "bathroom"] == [1]
    assert facts.unread == []


def test_a_room_beside_those_that_each_bedroom_has_stands_once() -> None:
    rooms = {room.name: room for room in _rooms("A villa with five bedrooms with their own bathrooms and a sauna.")}
    assert [part.room_type for part in rooms["bedroom"].suite] == ["bathroom"]
    assert rooms["sauna"].count == 1


def test_each_bedroom_has_all_that_is_said_of_each() -> None:
    rooms = {room.name: room for room in _rooms("A house with four bedrooms, each with a bathroom and a closet.")}
    assert [part.name for part in rooms["bedroom"].suite] == ["bathroom", "closet"]


@pytest.mark.parametrize("kind", ["ensuite", "en-suite"])
def test_rooms_with_bathrooms_lie_on_the_storeys_that_are_told_behind(kind: str) -> None:
    rooms = _rooms(f"A hotel with a bar on the ground floor and ten {kind} rooms on each floor above.")
    found = next(room for room in rooms if room.name == "room")
    assert (found.count, found.each, [ref.kind for ref in found.floors]) == (10, True, ["upper"])

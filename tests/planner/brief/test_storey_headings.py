"""Headings of storeys in forms of their own: titles with a bracket, numbers in a row, a dash, an adverb in a clause."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import FloorRef


def where(brief: str) -> dict[str, list[tuple[str, int, int]]]:
    """Return the storeys of each room by its name."""
    facts = read_brief(brief, default_knowledge())

    def storey(ref: FloorRef) -> tuple[str, int, int]:
        return ref.kind, ref.first, ref.last

    return {room.name: [storey(ref) for ref in room.floors] for room in facts.rooms}


@pytest.mark.parametrize(
    ("brief", "room", "storeys"),
    [
        ("School. Workshop level (ground): metal shop. Classroom level (first): six classrooms", "classroom", 2),
        ("Library, 2 floors - ground: lending hall, cafe; upper: reading room", "cafe", 1),
        ("Library, 2 floors, 900 m2 total - ground: reading room; upper: archive", "reading_room", 1),
        ("Mum wants everything down: her bedroom, kitchen. We live up: two bathrooms, a study", "kitchen", 1),
        ("Offices, 5 levels. Level 0 entrance hall and canteen. Level 4 board room", "board_room", 5),
        ("Gym, 2 levels. L1 reception, sauna. L2 weights room", "reception", 1),
    ],
)
def test_rooms_lie_on_the_storey_of_the_heading(brief: str, room: str, storeys: int) -> None:
    assert where(brief)[room] == [("number", storeys, storeys)]


def test_a_title_with_its_storey_in_brackets_is_no_room() -> None:
    rooms = where("School. Workshop level (ground): metal shop. Classroom level (first): six classrooms")
    assert "workshop" not in rooms and len(rooms) == 2


def test_numbers_in_a_row_are_storeys_that_are_alike() -> None:
    facts = read_brief("Offices, 5 levels. Level 1,2,3 same: ten offices. Level 4: board room", default_knowledge())
    offices = facts.rooms[0]
    assert [(ref.kind, ref.first, ref.last) for ref in offices.floors] == [("range", 1, 3)]
    assert (offices.count, offices.each) == (10, True)


def test_ordinals_without_a_noun_head_storeys_beside_a_ground() -> None:
    facts = read_brief("Hotel. Ground has a lobby. First to third each have eight offices.", default_knowledge())
    assert [(ref.kind, ref.first, ref.last) for ref in facts.rooms[1].floors] == [("range", 2, 4)]
    assert facts.rooms[1].each


def test_one_storey_and_one_above_are_two() -> None:
    facts = read_brief("Monastery. One storey for the public, one above for monks.", default_knowledge())
    assert [quantity.value for quantity in facts.floors] == [2.0]


def test_rooms_each_after_storeys_are_on_each_of_them() -> None:
    facts = read_brief("Hotel. Three levels above ground, 16 rooms each, all with shower.", default_knowledge())
    assert [(room.count, room.each, len(room.suite)) for room in facts.rooms] == [(16, True, 1)]
    assert [quantity.value for quantity in facts.floors] == [3.0]


def test_an_attic_in_a_list_of_storeys_is_one() -> None:
    rooms = where("House: ground floor with kitchen; first floor with two bedrooms; attic with maid's room.")
    assert rooms["maid_room"] == [("top", 0, 0)]


def test_the_very_top_is_the_top_storey() -> None:
    rooms = where("Lighthouse, three floors: coal store below; and a watch room at the very top under the lamp.")
    assert rooms["watch_room"][0][0] == "top"


@pytest.mark.parametrize(
    ("brief", "room", "storey"),
    [
        ("Clinic. B1 = morgue. G = lobby. 1 = scrub room, two offices.", "scrub_room", ("number", 2, 2)),
        ("School. Garage ground floor, classrooms and lounge first floor.", "lounge", ("number", 2, 2)),
        ("Day nursery on two storeys. Kitchen, laundry - all ground floor. Gym upstairs.", "laundry", ("number", 1, 1)),
        ("Archive. Lobby, two offices on the ground with a kitchen. Upstairs a store.", "kitchen", ("number", 1, 1)),
        ("College. Two seminar rooms on the upper, cafe on lower, WCs on both levels.", "cafe", ("number", 1, 1)),
    ],
)
def test_storeys_in_forms_of_their_own_place_rooms(brief: str, room: str, storey: tuple[str, int, int]) -> None:
    assert where(brief)[room] == [storey]


def test_what_lies_above_a_room_is_upstairs() -> None:
    facts = read_brief("A bakery. Above the bakery: her apartment, bedroom, bath, kitchen.", default_knowledge())
    flat = next(room for room in facts.rooms if room.unit)
    assert flat.floors[0].kind == "upper"
    assert [room.room_type for room in flat.suite] == ["bedroom", "bathroom", "kitchen"]


def test_flats_of_each_floor_in_a_bracket_are_on_each() -> None:
    facts = read_brief("8 flats of 50 m² on two floors (4 per floor), each: bedroom, shower room.", default_knowledge())
    (flats,) = facts.rooms
    assert (flats.count, flats.each, len(flats.suite)) == (4, True, 2)


def test_typical_floors_after_a_ground_floor_hold_what_follows() -> None:
    brief = "Block of five floors; ground floor with a bike room; 4 typical floors with two flats each."
    assert where(brief)["flat"][0][0] == "upper"


def test_an_unknown_room_keeps_its_storey_to_itself() -> None:
    rooms = where("Fire school. Smoke maze on the basement level, a garage on the ground floor, lounge first floor.")
    assert rooms["garage"] == [("number", 1, 1)]
    assert rooms["lounge"] == [("number", 2, 2)]

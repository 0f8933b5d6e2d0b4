"""Counts that stand after their noun, with a classifier, or in a table."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief


def read(brief: str) -> BriefFacts:
    return read_brief(brief, default_knowledge())


@pytest.mark.parametrize(
    ("brief", "name", "count", "area"),
    [
        ("A school with 8 nos. classrooms", "classroom", 8, None),
        ("A school with classrooms 6 nos. and a library", "classroom", 6, None),
        ("A clinic: consulting rooms 4 nos. of 12 sqm each", "consulting_room", 4, 12.0),
        ("A hotel: guest room 9 rooms, lobby", "guest_room", 9, None),
        ("Kindergarten\nGroup rooms — 4 — 55 m² each\nKitchen — 1 — 25 m²", "group_room", 4, 55.0),
        ("Clinic\nReception | 1 | 20 m2\nExam room | 5 | 12 m2", "exam_room", 5, 12.0),
        ("A school: classrooms: 4 x 55 m2, a library", "classroom", 4, 55.0),
        ("A school: lab (2 x 70 m²), a library", "lab", 2, 70.0),
        ("A court: three courtrooms, 110 m² a courtroom", "courtroom", 3, 110.0),
        ("Data centre: two data halls (200 sq.m. each hall)", "data_hall", 2, 200.0),
        ("An office with 2 WCs", "wc", 2, None),
        ("Town house. Second floor: 3 beds, 1 bathroom.", "bedroom", 3, None),
    ],
)
def test_rooms_are_counted_and_measured(brief: str, name: str, count: int, area: float | None) -> None:
    rooms = {fact.name: fact for fact in read(brief).rooms}
    assert (rooms[name].count, rooms[name].area) == (count, area)


def test_flats_are_counted_with_their_bedrooms() -> None:
    (flat,) = read("G+3. Each floor has 4 nos. of 2BHK flats.").rooms
    assert (flat.count, flat.each, [(child.name, child.count) for child in flat.suite]) == (4, True, [("bedroom", 2)])


@pytest.mark.parametrize("lifts", ["Lift 2 nos.", "Elevator 2.", "2 nos. lifts"])
def test_lifts_are_counted(lifts: str) -> None:
    assert [quantity.value for quantity in read(f"An office of 5 floors. {lifts}").lifts] == [2.0]


def test_a_number_after_a_room_names_it() -> None:
    rooms = {fact.name: fact.area for fact in read("A flat with Bedroom 1 - 14 m2 and Bedroom 2 - 12 m2").rooms}
    assert rooms == {"bedroom_1": 14.0, "bedroom_2": 12.0}


@pytest.mark.parametrize(
    ("brief", "bedrooms"), [("A house, 3LDK, two storeys.", 3), ("A flat of 90 m2, 2BHK, with a balcony.", 2)]
)
def test_the_code_of_a_flat_may_stand_alone(brief: str, bedrooms: int) -> None:
    facts = read(brief)
    assert [(room.name, room.count) for room in facts.rooms if room.room_type == "bedroom"] == [("bedroom", bedrooms)]
    assert not facts.unread


@pytest.mark.parametrize(
    ("brief", "rest"),
    [
        ("A house, 4LDK. 1F: LDK, one tatami room. 2F: three western rooms.", False),
        ("A house, 5LDK. 1F: LDK. 2F: three western rooms.", True),
    ],
)
def test_rooms_that_are_named_are_those_of_the_code(brief: str, rest: bool) -> None:
    facts = read(brief)
    assert [(room.name, room.count) for room in facts.rooms if room.room_type == "bedroom"] == [("western_room", 3)]
    assert bool(facts.unread) == rest


def test_an_area_off_a_room_is_no_count() -> None:
    facts = read("A club: main hall 150, store 20 off the hall, kitchen 12, office 10.")
    assert {room.name: (room.count, room.area) for room in facts.rooms}["store"] == (1, 20)
    assert [room.count for room in read("A club with meeting rooms 4 off and a gym.").rooms if room.count] == [4, 1]


@pytest.mark.parametrize(
    "brief",
    [
        "three bedrooms, a kitchen next to the living room, 9999999999 upstairs",
        "Offices.\n1 to 9999999999: offices. 2: cafe",
        "9999999999 bed 2 bath flat",
        "flats of two bedrooms, 9999999999 on each floor",
        "offices of 14 m2 each, 9999999999 of them",
    ],
)
def test_no_number_counts_more_rooms_than_a_building_can_hold(brief: str) -> None:
    assert all((room.count or 0) < 10_000 for room in read(brief).rooms)

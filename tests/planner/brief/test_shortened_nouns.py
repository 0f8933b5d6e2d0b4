"""What is named without its noun has it: doubles in a dormitory, an open-plan office, "w/" for "with"."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    ("text", "rooms"),
    [
        ("Dorm: 6 floors. Floors 2 to 6: 12 doubles per floor.", [("dorm_room", 12)]),
        ("Headquarters. Floors two to six: open-plan, four meeting rooms.", [("open_office", 1), ("meeting_room", 4)]),
        ("An office with an open-plan office and a lobby.", [("open_office", 1), ("lobby", 1)]),
        ("A house with an open-plan kitchen.", [("open_kitchen", 1)]),
        ("A tennis club with four doubles courts.", []),
    ],
)
def test_the_noun_is_that_of_the_building(text: str, rooms: list[tuple[str, int]]) -> None:
    facts = read_brief(text, default_knowledge())
    assert [(room.room_type, room.count) for room in facts.rooms if room.known] == rooms


def test_with_may_be_a_letter() -> None:
    facts = read_brief("A clinic with 6 single patient rooms w/ en-suite.", default_knowledge())
    assert [(child.room_type, child.count) for child in facts.rooms[0].suite] == [("ensuite_bathroom", 1)]


def test_an_area_at_each_of_some_storeys_is_that_of_a_storey() -> None:
    facts = read_brief("Rehab centre: three floors @ 700 sqm.", default_knowledge())
    assert [quantity.value for quantity in facts.floor_area] == [700.0]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("2 floor house. Up: 3 bed, 1 bath.", {"bedroom": 3, "bathroom": 1}),
        ("Two bedroom flat with a kitchen.", {"bedroom": 2, "kitchen": 1}),
        ("Two bedroom ground floor flat with a kitchen.", {"bedroom": 2, "kitchen": 1}),
    ],
)
def test_short_forms_of_homes(text: str, expected: dict[str, int]) -> None:
    found: dict[str, int | None] = {}
    for fact in read_brief(text, default_knowledge()).rooms:
        found[fact.room_type] = fact.count
    assert {kind: found.get(kind) for kind in expected} == expected


def test_en_suite_rooms_have_a_bathroom_each() -> None:
    facts = read_brief("Student residence with ten en-suite rooms.", default_knowledge())
    assert next((fact.room_type, fact.count) for fact in facts.rooms) == ("dorm_room", 10)


def test_what_a_suite_is_the_sum_of_is_in_each() -> None:
    facts = read_brief("Villa with six bedroom suites; each suite = bedroom + bathroom + sauna.", default_knowledge())
    told = [(fact.room_type, fact.count, [room.room_type for room in fact.suite]) for fact in facts.rooms]
    assert told == [("bedroom", 6, ["bathroom", "sauna"])]


@pytest.mark.parametrize(
    "text",
    [
        "A storage centre with 40 units of 8 m2.",
        "Self-storage with 40 units of 8 m2.",
        "A warehouse with 40 storage units of 8 m2.",
    ],
)
def test_units_of_a_self_storage_are_no_flats(text: str) -> None:
    (units,) = read_brief(text, default_knowledge()).rooms
    assert (units.room_type, units.count, units.area) == ("storage_unit", 40, 8.0)


def test_a_semi_is_a_house() -> None:
    facts = read_brief("3 bed semi. Downstairs loo.", default_knowledge())
    assert [name for name, _ in facts.building] + [facts.building_name] == ["townhouse", "semi_detached_house"]

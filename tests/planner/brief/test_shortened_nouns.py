"""What is named without its noun has it: doubles, open-plan offices, flats named by their type; "w/" is "with"."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building


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


def _flats(text: str) -> dict[str, int]:
    program = plan_building(BuildRequest(description=text)).program
    kinds = ("apartment", "studio_apartment")
    return {w.value.name: w.value.count or 0 for w in program.wishes if w.kind == "room" and w.value.type in kinds}


@pytest.mark.parametrize(
    ("text", "flats"),
    [
        ("An apartment building with four floors, 2 two-bed and 1 studio per floor", {"flat": 2, "studio": 1}),
        (
            "Four-storey building: per storey two one-bedroom flats and a three-bedroom flat",
            {"one_bed_flat": 2, "three_bed_flat": 1},
        ),
        ("Housing, 5 floors, 1 three-bed and 2 one-beds on every floor", {"three_bed_flat": 1, "one_bed_flat": 2}),
        ("Block of flats on three floors: 6 two-beds, 3 studios", {"flat": 6, "studio": 3}),
        (
            "An apartment house of 3 storeys with two 2BR units and one 1BR unit on each floor",
            {"two_bed_flat": 2, "one_bed_flat": 1},
        ),
        ("A residential tower, 6 floors, four two-bedders per floor", {"flat": 4}),
        (
            "Residential block, 3 storeys, each floor two 3-room flats and one 1-room flat",
            {"flat": 2, "one_room_flat": 1},
        ),
        ("A condo building: 8 two-bedroom units, four three-bedroom units", {"two_bed_flat": 8, "three_bed_flat": 4}),
    ],
)
def test_types_name_flats(text: str, flats: dict[str, int]) -> None:
    assert _flats(text) == flats


def test_such_flats_make_an_apartment_building() -> None:
    text = "Four-storey building: per storey two one-bedroom flats and a three-bedroom flat"
    assert plan_building(BuildRequest(description=text)).program.building_type == "apartment_building"


def test_beds_of_a_flat_are_no_furniture() -> None:
    program = plan_building(
        BuildRequest(description="Apartment building, one two-bed flat on each of 3 floors")
    ).program
    assert [wish for wish in program.wishes if wish.kind == "object"] == []


def test_rooms_of_a_flat_are_counted_with_its_living_room() -> None:
    program = plan_building(BuildRequest(description="Residential block of 3 floors, two 3-room flats a floor")).program
    bedrooms = [wish.value.count for wish in program.wishes if wish.value.type == "bedroom"]
    assert bedrooms == [2]


def test_one_flat_is_still_the_building() -> None:
    program = plan_building(BuildRequest(description="A two-bed flat with a kitchen")).program
    assert (program.kind, _flats("A two-bed flat with a kitchen")) == ("flat", {})


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

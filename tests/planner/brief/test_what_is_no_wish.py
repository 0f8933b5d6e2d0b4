"""What a building is for, whose it is and how rooms are told of are no rooms; uses and sites are no styles."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.plan import plan_building


def _facts(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    ("text", "rooms"),
    [
        ("An office of two floors, for trials of lab automation robots. A reception", ["reception"]),
        ("An office for research on school canteens, with a reception", ["reception"]),
        ("Library of the faculty with a reception", ["reception"]),
        ("A flat. Toilet and bathroom are separated rooms", ["toilet", "bathroom"]),
        ("A house where the toilet and the bathroom should be separate rooms", ["toilet", "bathroom"]),
    ],
)
def test_purposes_owners_and_predicates_are_no_rooms(text: str, rooms: list[str]) -> None:
    assert [room.room_type for room in _facts(text).rooms] == rooms


def test_rooms_of_a_building_for_research_are_rooms() -> None:
    rooms = _facts("A building for research with two labs and a canteen").rooms
    assert [room.room_type for room in rooms] == ["laboratory", "cafeteria"]


@pytest.mark.parametrize(
    ("text", "style"),
    [
        ("A factory with a raw material store", []),
        ("An office in an industrial park", []),
        ("An industrial loft with two bedrooms", ["industrial"]),
        ("A neoclassical town hall", ["neoclassical"]),
        ("A mountain hotel in chalet style", ["alpine"]),
    ],
)
def test_uses_and_sites_are_no_styles(text: str, style: list[str]) -> None:
    assert [name for name, _ in _facts(text).styles] == style


@pytest.mark.parametrize(
    ("text", "areas"),
    [
        ("A factory with two offices, one of 12 and one of 20 m2", [12, 20]),
        ("A school with three offices, one of 10, one of 15 and one of 20 m2", [10, 15, 20]),
        ("A factory with two offices, one of 12 m2 and one of 20 m2", [12, 20]),
        ("A factory with two offices, one 12 and the other 20 m2", [12, 20]),
    ],
)
def test_areas_are_shared_out(text: str, areas: list[float]) -> None:
    facts = _facts(text)
    assert [room.area for room in facts.rooms if room.room_type == "private_office"] == areas
    assert facts.unread == []


@pytest.mark.parametrize(
    ("text", "total", "storey"),
    [
        ("A polar station, two floors, in sum 480 sq. meters, a workshop", 480, None),
        ("A house of two floors, summing up to 200 m2", 200, None),
        ("An office with a ground floor and three floors above, of 600 m2 each one", None, 600),
        ("A school, two storeys. A hall of 165 m2 upstairs together with a library", None, None),
    ],
)
def test_whose_an_area_is(text: str, total: float | None, storey: float | None) -> None:
    facts = _facts(text)
    assert [quantity.value for quantity in facts.area] == ([total] if total else [])
    assert [quantity.value for quantity in facts.floor_area] == ([storey] if storey else [])


def test_rooms_are_those_of_the_building() -> None:
    home = plan_building(BuildRequest(description="A nursing home with 16 private rooms")).program
    assert {wish.value.type for wish in home.wishes if wish.kind == "room"} == {"resident_room"}
    library = plan_building(BuildRequest(description="A library with a children's room")).program
    assert {wish.value.type for wish in library.wishes if wish.kind == "room"} == {"childrens_area"}


def test_counted_rooms_are_all_that_there_are() -> None:
    text = "A chocolate factory of two floors with two offices and an R&D lab"
    floors = plan_building(BuildRequest(description=text)).program.floors
    assert not any(room.room_type == "open_office" for floor in floors for room in floor.rooms)


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("A block of flats with an electrical meter room", "electrical_meter_room"),
        ("A small flat, 1LDK type, 42 m2", "bedroom"),
    ],
)
def test_a_unit_of_length_and_a_type_of_flat(text: str, name: str) -> None:
    facts = _facts(text)
    assert [(room.name, room.count) for room in facts.rooms] == [(name, 1)]
    assert facts.unread == []

"""Areas that are bounds, areas of storeys, and areas that belong to a part."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.plan import plan_building


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    ("text", "limit"),
    [
        ("Keep the flat under 60 m2", "most"),
        ("a flat of no more than 60 m2", "most"),
        ("The flat may not exceed 60 m2", "most"),
        ("a flat, total floor area must not pass 60 m2", "most"),
        ("a flat of 60 m2 at most", "most"),
        ("a flat of up to 60 m2", "most"),
        ("a flat of 60 m2 or less", "most"),
        ("a flat, maximum 60 m2", "most"),
        ("a flat of at least 60 m2", "least"),
        ("a flat of more than 60 m2", "least"),
        ("a flat of not less than 60 m2", "least"),
        ("a flat of 60 m2 or more", "least"),
        ("a flat of about 60 m2", ""),
        ("a flat of 60 m2", ""),
    ],
)
def test_an_area_may_be_a_bound(text: str, limit: str) -> None:
    facts = read(text)
    assert [(area.value, area.limit) for area in facts.area] == [(60.0, limit)]
    assert facts.excluded == []


def test_rooms_have_bounds_too() -> None:
    rooms = read("a house. Every bedroom must be larger than 12 m2 and the bath no bigger than 6 m2.").rooms
    assert [(room.name, room.area, room.limit) for room in rooms] == [("bedroom", 12, "least"), ("bath", 6, "most")]


@pytest.mark.parametrize("cap", [55, 60, 80])
def test_a_building_keeps_to_its_bound(cap: int) -> None:
    program = plan_building(BuildRequest(description=f"a flat of no more than {cap} m2 with one bedroom")).program
    assert sum(floor.gross_floor_area for floor in program.floors) <= 1.01 * cap


@pytest.mark.parametrize(
    "text",
    [
        "a clinic of two floors, 320 m2 the floor",
        "a clinic in two floors of each 320 m2",
        "a clinic on two floors, each of them 320 m2",
        "a clinic. Ground floor 320 m2: a lobby. Upper floor 320 m2: three offices.",
    ],
)
def test_the_area_of_each_storey_is_said_in_many_ways(text: str) -> None:
    facts = read(text)
    assert [area.value for area in facts.floor_area] == [320.0]
    assert facts.area == []


def test_storeys_of_unlike_areas_are_told_of() -> None:
    facts = read("a house. Ground floor 120 m2, upper floor 90 m2")
    assert [area.value for area in facts.area] == [210.0]
    assert [span.words for span in facts.unheeded] == ["120 m2", "90 m2"]


def test_an_area_belongs_to_the_room_that_things_stand_in() -> None:
    facts = read("a fire station of 600 m2 with a hall for three fire trucks of about 180 m2")
    assert [(room.name, room.area) for room in facts.rooms] == [("hall", 180.0)]
    assert [area.value for area in facts.area] == [600.0]


def test_the_largest_and_the_others_have_areas_of_their_own() -> None:
    facts = read("five shops, the largest 80 m2, the others 30 m2 each")
    assert facts.area == []
    assert [(room.name, room.count, room.area) for room in facts.rooms] == [("shop", 1, 80.0), ("shop", 4, 30.0)]

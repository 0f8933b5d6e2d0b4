"""Flats that are named by their type alone are flats of as many bedrooms, told apart where there are several types."""

import pytest

from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


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

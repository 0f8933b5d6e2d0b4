"""Rooms to be placed, as a brief names them."""

import pytest

from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


@pytest.mark.parametrize(
    ("brief", "label"),
    [
        ("a townhouse with 2 bedrooms", "bedroom"),
        ("a school with six music practice rooms", "music practice room"),
        ("a home with one Guest Room", "guest room"),
    ],
)
def test_one_of_several_rooms_is_labelled_as_one(brief: str, label: str) -> None:
    program = plan_building(BuildRequest(description=brief)).program
    labels = {room.name.lower() for floor in program.floors for room in floor.rooms if room.name}
    assert label in labels and f"{label}s" not in labels

"""Rooms that each of several units has."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief


@pytest.mark.parametrize(
    ("brief", "name", "suite"),
    [
        (
            "A holiday home with two wings with two bedrooms and a bathroom in each, joined by one big kitchen.",
            "wing",
            {"bedroom": 2, "bathroom": 1},
        ),
        (
            "A villa with two wings, each with three bedrooms and a bathroom, and a shared kitchen.",
            "wing",
            {"bedroom": 3, "bathroom": 1},
        ),
    ],
)
def test_each_of_several_wings_has_what_is_said_of_it(brief: str, name: str, suite: dict[str, int]) -> None:
    rooms = read_brief(brief, default_knowledge()).rooms
    (wing,) = (room for room in rooms if room.name == name)
    assert wing.count == 2
    assert {room.name: room.count for room in wing.suite} == suite

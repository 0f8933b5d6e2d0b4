"""A wing is where rooms are, and no room."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    "words",
    [
        "The east wing has six classrooms, the west wing a gym.",
        "East wing: six classrooms. West wing: gym.",
        "One wing with six classrooms, the other wing with the gym.",
    ],
)
def test_rooms_of_wings_are_rooms_of_the_building(words: str) -> None:
    rooms = read_brief(f"A school on one storey. {words}", default_knowledge()).rooms
    assert [(room.room_type, room.count) for room in rooms] == [("classroom", 6), ("gym", 1)]

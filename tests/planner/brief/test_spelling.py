"""Rooms and storeys in short or joined words are read as if they were written out."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    ("text", "rooms"),
    [
        ("A flat with 2 bedr and a livingroom", [("bedroom", 2), ("living_room", 1)]),
        ("An office with two meetingrooms and a waitingroom", [("meeting_room", 2), ("waiting_room", 1)]),
        ("A flat with a sep. wc", [("toilet", 1)]),
    ],
)
def test_rooms_in_short_are_rooms(text: str, rooms: list[tuple[str, int]]) -> None:
    found = read_brief(text, default_knowledge()).rooms
    assert [(room.room_type, room.count) for room in found] == rooms


def test_a_classroom_stays_one_word() -> None:
    (room,) = read_brief("A school with four classrooms", default_knowledge()).rooms
    assert (room.room_type, room.count) == ("classroom", 4)

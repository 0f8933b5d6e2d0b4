"""The parts of a number of rooms are rooms of that kind."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    ("text", "kind", "counts"),
    [
        ("A hostel. Dorms: 2 with 4 beds, 3 with 6 beds and 1 with 10 beds.", "dorm_room", [2, 3, 1]),
        ("An office with 2 meeting rooms (one for 6 and one for 12 persons).", "meeting_room", [1, 1]),
        ("Self storage. Units: 10 of 3 m2, 8 of 6 m2.", "storage_unit", [10, 8]),
        ("A sports hall with changing rooms for four teams.", "changing_room", [4]),
        ("An office with 3 teams of 8, each team in its own room.", "team_room", [3]),
    ],
)
def test_each_part_is_counted(text: str, kind: str, counts: list[int]) -> None:
    assert [room.count for room in read_brief(text, default_knowledge()).rooms if room.room_type == kind] == counts


def test_what_each_part_holds_is_its_own() -> None:
    facts = read_brief("A hostel. Dorms: 2 with 4 beds and 1 with 10 beds.", default_knowledge())
    assert [(thing.count, thing.each) for thing in facts.objects] == [(4, True), (10, False)]


def test_areas_behind_a_number_are_shared_out() -> None:
    facts = read_brief("A factory with two offices, one of 12 and one of 20 m2.", default_knowledge())
    assert sorted(room.area or 0.0 for room in facts.rooms) == [12.0, 20.0]


def test_more_rooms_for_others_are_of_the_same_kind() -> None:
    rooms = read_brief("A house. One bedroom for us, three for the kids.", default_knowledge()).rooms
    assert [(room.room_type, room.count) for room in rooms] == [("bedroom", 1), ("bedroom", 3)]


def test_of_which_some_have_a_room_is_told_of_as_many() -> None:
    facts = read_brief("A house with four bedrooms of which two have a balcony.", default_knowledge())
    assert [(room.room_type, room.count) for room in facts.rooms] == [("bedroom", 4), ("balcony_room", 2)]
    assert facts.unread == []

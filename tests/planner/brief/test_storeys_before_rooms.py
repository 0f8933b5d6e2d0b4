"""A storey that stands before a room is that room's alone: "a basement gym", "a ground-floor shop"."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.reader import read_brief

PLACES: dict[str, dict[str, str]] = {
    "a hotel of five storeys with a rooftop bar and a basement gym": {"bar": "top", "gym": "basement"},
    "a house with an attic study": {"study": "top"},
    "a ground floor shop with two flats upstairs": {"shop": "number", "flat": "upper"},
    "a ground-floor clinic with flats above": {"clinic": "number"},
    "a hotel with a roof-top restaurant": {"restaurant": "top"},
}


@pytest.mark.parametrize("brief", PLACES)
def test_a_storey_before_a_room_is_where_it_is(brief: str) -> None:
    rooms = read_brief(brief, default_knowledge()).rooms
    assert {room.name: room.floors[0].kind for room in rooms if room.floors} == PLACES[brief]


def test_a_basement_without_a_room_is_a_storey() -> None:
    facts = read_brief("a house with a basement, a gym and a study", default_knowledge())
    assert [count.value for count in facts.basements] == [1.0]
    assert not any(room.floors for room in facts.rooms)

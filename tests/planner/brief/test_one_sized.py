"""The area of one of several rooms is that room's alone, and never the building's."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    ("text", "rooms"),
    [
        ("A house with two bedrooms (the larger about 16 m2).", [(1, None), (1, 16.0)]),
        ("A clinic with five treatment rooms, one of which is larger (25 m2).", [(4, None), (1, 25.0)]),
        ("An office with four meeting rooms, two of them 30 m2, and a lobby.", [(2, None), (2, 30.0), (1, None)]),
        ("A courthouse with two courtrooms, of which one 110 m2 and one 70 m2.", [(1, 110.0), (1, 70.0)]),
        ("A house with two bedrooms of 12 m2 each.", [(2, 12.0)]),
        (
            "A house with three bedrooms - ours 18 m2 with its own bathroom, the two for the boys 13 m2 each.",
            [(1, 18.0), (2, 13.0)],
        ),
    ],
)
def test_one_of_several_rooms_has_the_area_that_is_told_of_it(text: str, rooms: list[tuple[int, float | None]]) -> None:
    facts = read_brief(text, default_knowledge())
    assert [(room.count, room.area) for room in facts.rooms] == rooms
    assert facts.area == facts.unread == []

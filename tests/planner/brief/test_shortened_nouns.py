"""What is named without its noun has it: doubles in a dormitory, an open-plan office, "w/" for "with"."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    ("text", "rooms"),
    [
        ("Dorm: 6 floors. Floors 2 to 6: 12 doubles per floor.", [("dorm_room", 12)]),
        ("Headquarters. Floors two to six: open-plan, four meeting rooms.", [("open_office", 1), ("meeting_room", 4)]),
        ("An office with an open-plan office and a lobby.", [("open_office", 1), ("lobby", 1)]),
        ("A house with an open-plan kitchen.", [("open_kitchen", 1)]),
        ("A tennis club with four doubles courts.", []),
    ],
)
def test_the_noun_is_that_of_the_building(text: str, rooms: list[tuple[str, int]]) -> None:
    facts = read_brief(text, default_knowledge())
    assert [(room.room_type, room.count) for room in facts.rooms if room.known] == rooms


def test_with_may_be_a_letter() -> None:
    facts = read_brief("A clinic with 6 single patient rooms w/ en-suite.", default_knowledge())
    assert [(child.room_type, child.count) for child in facts.rooms[0].suite] == [("ensuite_bathroom", 1)]


def test_an_area_at_each_of_some_storeys_is_that_of_a_storey() -> None:
    facts = read_brief("Rehab centre: three floors @ 700 sqm.", default_knowledge())
    assert [quantity.value for quantity in facts.floor_area] == [700.0]

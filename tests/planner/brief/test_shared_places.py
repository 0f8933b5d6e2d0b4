"""Rooms that have no number are counted by the people that they are for and by how many share one."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    ("words", "name", "count", "people"),
    [
        ("offices for twelve, two in each, and a kitchen", "office", 6, 12),
        ("offices for twelve people, two in each, and a kitchen", "office", 6, 12),
        ("bedrooms for sixteen, four to a room, and a kitchen", "bedroom", 4, 16),
        ("wards for twelve patients, three in each ward, and a kitchen", "ward", 4, 12),
        ("offices for 9 researchers (three in each) and a kitchen", "office", 3, 9),
        ("bedrooms for five, two in each bedroom, and a kitchen", "bedroom", 3, 5),
        ("offices for eight, in pairs, and a kitchen", "office", 4, 8),
        ("bedrooms for six, each shared by two, and a kitchen", "bedroom", 3, 6),
    ],
)
def test_rooms_are_counted_by_those_who_share_them(words: str, name: str, count: int, people: int) -> None:
    facts = read_brief(f"A house with {words}.", default_knowledge())
    assert (facts.rooms[0].name, facts.rooms[0].count) == (name, count)
    assert [occupant.count for occupant in facts.occupants] == [people]
    assert facts.unread == []


def test_a_number_that_contradicts_the_shares_holds() -> None:
    facts = read_brief("A house with three bedrooms for eight, two in each, and a kitchen.", default_knowledge())
    assert facts.rooms[0].count == 3

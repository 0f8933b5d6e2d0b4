"""Areas that are told after rooms, in whatever unit, are theirs and not the building's."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    ("text", "rooms"),
    [
        ("A hotel with 6 floors. On floor 2: twelve rooms each, 22 m2, with bathroom.", [(12, 22.0)]),
        ("A flat. 150 m2 on one floor. One kitchen so that all can eat there (20 m2, with a table).", [(1, 20.0)]),
        ("An office: archive 100, staff canteen 25, copy room 20 (all in m2)", [(1, 100.0), (1, 25.0), (1, 20.0)]),
    ],
)
def test_an_area_is_of_the_rooms_before_it(text: str, rooms: list[tuple[int, float]]) -> None:
    facts = read_brief(text, default_knowledge())
    assert [(room.count, room.area) for room in facts.rooms] == rooms


@pytest.mark.parametrize(
    ("words", "area"), [("45 tsubo", 148.8), ("52 pyeong", 171.9), ("250 square yards", 209.0), ("200 sq yd", 167.2)]
)
def test_areas_have_many_units(words: str, area: float) -> None:
    facts = read_brief(f"A house of {words} with two bedrooms.", default_knowledge())
    assert [round(quantity.value, 1) for quantity in facts.area] == [area]
    assert [room.count for room in facts.rooms] == [2]


def test_people_of_each_room_are_its_seats() -> None:
    facts = read_brief("A school with four classrooms of 60 m2 for 22 pupils each.", default_knowledge())
    assert [(fact.category, fact.count, fact.room, fact.each) for fact in facts.objects] == [
        ("chair", 22, "classroom", True)
    ]
    assert facts.occupants == []


@pytest.mark.parametrize(
    ("text", "area"),
    [("A house. The kitchen is big, 25 m2.", 25.0), ("A house. The kitchen can be small, 10 m2 is enough.", 10.0)],
)
def test_a_word_of_size_before_an_area_leaves_it_to_the_room(text: str, area: float) -> None:
    facts = read_brief(text, default_knowledge())
    assert [(fact.name, fact.area) for fact in facts.rooms] == [("kitchen", area)]
    assert not facts.unread

"""Sums, work at home and what people do in a room order nothing a second time."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


@pytest.mark.parametrize(
    ("text", "rooms", "objects"),
    [
        ("A hostel with four dorms with 3 bunk beds each. That makes 12 dorm beds.", ["dorm"], ["bunk_bed"]),
        ("A house with a small office because I work from home.", ["office"], []),
        ("A gym with a reception where people rent shoes, and an office.", ["reception", "office"], []),
        ("After years abroad we come home and want a flat with a kitchen.", ["kitchen"], []),
        ("A clinic with a reception. Nobody likes long corridors. I'm 1.90 m tall.", ["reception"], []),
        ("An office with a shower because some of us cycle. The forklifts run on Sundays.", ["shower"], []),
        ("An office where you'll put a reception and a canteen.", ["reception", "canteen"], []),
        ("A flat of 68 m2. Living/kitchen open plan, 28 m2, and a bedroom.", ["living_kitchen", "bedroom"], []),
    ],
)
def test_what_only_tells_again_orders_nothing(text: str, rooms: list[str], objects: list[str]) -> None:
    facts = read_brief(text, default_knowledge())
    assert [room.name for room in facts.rooms] == rooms
    assert [fact.category for fact in facts.objects] == objects


def test_a_sum_of_square_metres_is_the_area() -> None:
    facts = read_brief("A house with two floors of 60 m2. That makes 120 m2 in total.", default_knowledge())
    assert [quantity.value for quantity in facts.area] == [120.0]

"""The number that a brief gives last holds, and its words are part of the statement that it is in."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.plan import plan_building


def _facts(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    ("text", "count"),
    [
        ("A house with three bedrooms, make that four, and a kitchen", 4),
        ("A house with two, no, three bedrooms", 3),
        ("A house with two bedrooms (oops, four) and a garage", 4),
        ("A house with five bedrooms - correction: 6 bedrooms - and a bath", 6),
        ("A house with two bedrooms... no wait, one bedroom, and a kitchen", 1),
        ("A house with two or rather three bedrooms", 3),
        ("A house with two bedrooms. Make that three. And a study.", 3),
        ("A house with two bedrooms. No, wait: three bedrooms.", 3),
        ("A house with three bedrooms on 2 floors... wait, my wife says four bedrooms.", 4),
        ("A house with two bedrooms. Sorry, I was wrong, the bank allows only one.", 1),
        ("A house with two bedrooms. My wife says 3 garages are too many.", 2),
        ("A house with two bedrooms. No 3D cinema.", 2),
        ("A house with two bedrooms, no 3 garages", 2),
        ("A house with two bedrooms, make it 3 storeys", 2),
    ],
)
def test_a_count_is_the_one_that_is_told_last(text: str, count: int) -> None:
    assert [fact.count for fact in _facts(text).rooms if fact.room_type == "bedroom"] == [count]


@pytest.mark.parametrize("sign", ["– sorry, counted wrong, six", "(sorry, six)", "– I miscounted, 6"])
def test_a_miscount_takes_back_a_count_and_no_area(sign: str) -> None:
    (rooms,) = _facts(f"An office with five private offices of 12 m2 {sign}.").rooms
    assert (rooms.count, rooms.area) == (6, 12.0)


@pytest.mark.parametrize(
    ("text", "area"),
    [
        ("A flat of 80 m2, no, 92 m2, with two bedrooms", 92.0),
        ("A cafe of 100 sqm, wait, make it 120 sqm", 120.0),
        ("A house of 140 m2, make it 3 storeys", 140.0),
    ],
)
def test_an_area_is_the_one_that_is_told_last(text: str, area: float) -> None:
    assert [quantity.value for quantity in _facts(text).area] == [area]


@pytest.mark.parametrize(
    "text",
    [
        "A two-storey house, I mean three-storey",
        "A library on two floors, actually three floors",
        "A clinic with 4 storeys. Sorry, I was wrong, the city allows only three.",
    ],
)
def test_storeys_are_those_that_are_told_last(text: str) -> None:
    facts = _facts(text)
    assert [quantity.value for quantity in facts.floors] == [3.0]
    assert facts.unread == []


def test_a_wish_shows_the_words_that_take_a_number_back() -> None:
    plan = plan_building(BuildRequest(description="An office with two meeting rooms, sorry, three, and a kitchen"))
    wish = next(wish for wish in plan.program.wishes if wish.value.name == "meeting_room")
    assert (wish.text, wish.value.count) == ("two meeting rooms, sorry, three", 3)

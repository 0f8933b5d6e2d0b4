"""Rooms that have a wall in common, or none; away from several rooms; toilets of every type."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts

_FLAT = "Flat: living room, bedroom, study, kitchen, bathroom. "


def _facts(text: str) -> BriefFacts:
    return read_brief(_FLAT + text, default_knowledge())


@pytest.mark.parametrize(
    "text",
    [
        "The bedroom shares no wall with the kitchen",
        "The bedroom mustn't share a wall with the kitchen",
        "There must be no shared wall between the bedroom and the kitchen",
        "No common wall between bedroom and kitchen, please",
        "The bedroom should not be wall to wall with the kitchen",
        "The bedroom must not have a wall in common with the kitchen",
    ],
)
def test_rooms_without_a_wall_in_common_lie_apart(text: str) -> None:
    facts = _facts(text)
    assert [{fact.first, fact.second} for fact in facts.apart] == [{"bedroom", "kitchen"}]
    assert facts.adjacent == []
    assert facts.unread == []


@pytest.mark.parametrize(
    "text", ["The kitchen and the bathroom have a common wall", "A common wall between the kitchen and the bathroom"]
)
def test_rooms_with_one_lie_side_by_side(text: str) -> None:
    assert [{fact.first, fact.second} for fact in _facts(text).adjacent] == [{"kitchen", "bathroom"}]


def test_no_wall_at_all_is_neither() -> None:
    facts = _facts("No wall between the kitchen and the living room")
    assert facts.apart == facts.adjacent == []


@pytest.mark.parametrize(
    ("text", "others"),
    [
        ("The study must not be next to the kitchen, the bathroom or the living room", 3),
        ("The study away from the kitchen or bathroom", 2),
        ("The study must not border on the kitchen, nor on the bathroom", 2),
        ("The study away from the kitchen, a nursery or a playroom", 1),
    ],
)
def test_a_room_is_apart_from_all_that_are_named(text: str, others: int) -> None:
    assert len(_facts(text).apart) == others


def test_a_relation_is_told_in_its_own_words() -> None:
    (fact,) = _facts("The bedroom must not adjoin the kitchen").apart
    assert fact.span.words == "bedroom must not adjoin the kitchen"


@pytest.mark.parametrize(
    ("text", "pair"),
    [
        ("A school with four classrooms together with a hall and a dining room that has the kitchen right beside it",
         {"kitchen", "dining_room"}),
        ("A clinic with two offices, a cold storage room directly beside one of them",
         {"cold_storage", "private_office"}),
    ],
)  # fmt: skip
def test_it_is_the_room_that_has_the_other(text: str, pair: set[str]) -> None:
    (fact,) = read_brief(text, default_knowledge()).adjacent
    assert {fact.first, fact.second} == pair

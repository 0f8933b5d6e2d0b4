"""Words of when, why and how people do things are no wishes; places and things that are not known stay told."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief


def _unread(text: str) -> list[str]:
    return [span.words for span in read_brief(text, default_knowledge()).unread]


@pytest.mark.parametrize(
    "text",
    [
        "A house with two bedrooms. The old school, by the way, was built in 1911 and leaks.",
        "A bungalow with a kitchen. She's 81 and still plays cards every Thursday, bless her.",
        "A house with a library (don't ask how long that took).",
        "An office of 200 m2. Right, my accountant says I'm mad.",
        "A clinic with three treatment rooms (maybe a fourth one some day, not now).",
        "We just had our second baby, so the flat is bursting. A house with four bedrooms.",
        "A house for three generations under one roof with a hall.",
        "A cinema with a foyer. The city gave us money for it.",
        "Our family is moving back to Ireland and wants a house. The kids go to school across the road.",
        "A police station. It is cold there nine months a year.",
    ],
)
def test_what_people_tell_of_themselves_asks_for_nothing(text: str) -> None:
    assert _unread(text) == []


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("A fire station. A sliding pole would be cool.", "sliding pole"),
        ("A house with a cloakroom at the front.", "front"),
        ("A bedroom looking onto the garden of a house.", "looking"),
        ("A gym with a wall that moves.", "moves"),
    ],
)
def test_what_may_ask_for_something_is_told(text: str, told: str) -> None:
    assert any(told in words for words in _unread(text))


def test_the_place_that_people_leave_is_no_part_of_the_building() -> None:
    facts = read_brief("The flat is bursting. Draw us a two-storey house. I write novels.", default_knowledge())
    assert [name for name, _ in facts.building] == ["house"]
    assert facts.rooms == facts.objects == []

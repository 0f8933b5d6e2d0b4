"""For how many people a building is, as people say it."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building


def occupants(brief: str) -> list[tuple[str, int]]:
    wishes = plan_building(BuildRequest(description=brief)).program.wishes
    return [(wish.text, wish.value.count or 0) for wish in wishes if wish.kind == "occupants"]


@pytest.mark.parametrize(
    ("brief", "text", "count"),
    [
        ("a small flat for two", "for two", 2),
        ("A house for five, with a garage", "for five", 5),
        ("an office for twelve with a kitchen", "for twelve", 12),
        ("we need a flat for 3.", "for 3", 3),
    ],
)
def test_a_number_after_the_building_says_for_how_many_people_it_is(brief: str, text: str, count: int) -> None:
    assert occupants(brief) == [(text, count)]


@pytest.mark.parametrize("brief", ["a flat for two cats", "a house with a garage for two", "a hotel for two storeys"])
def test_a_number_of_something_else_says_nothing_of_people(brief: str) -> None:
    assert occupants(brief) == []


def test_a_flat_for_two_has_one_bedroom() -> None:
    program = plan_building(BuildRequest(description="a small flat for two")).program
    assert [room.room_type for floor in program.floors for room in floor.rooms].count("bedroom") == 1


def test_people_may_be_counted_right_before_a_list() -> None:
    facts = read_brief("Student flat for three: three bedrooms, kitchen", default_knowledge())
    assert [(fact.count, fact.noun) for fact in facts.occupants] == [(3, "person")]

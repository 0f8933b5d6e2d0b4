"""One of several rooms that is told by its size is a room of its own, and there are no more rooms for it."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief.reader import read_brief


def read(brief: str) -> BriefFacts:
    return read_brief(brief, default_knowledge())


@pytest.mark.parametrize(
    ("brief", "rooms"),
    [
        ("A flat with two bedrooms. The larger bedroom is 16 m2.", {"bedroom": (1, None), "larger_bedroom": (1, 16.0)}),
        ("Two-bed flat of 74 m2. The larger bedroom is 16 m2.", {"bedroom": (1, None), "larger_bedroom": (1, 16.0)}),
        ("A flat with three bedrooms, the larger one 16 m2", {"bedroom": (2, None), "larger_bedroom": (1, 16.0)}),
        (
            "A flat with two bedrooms, the larger one with a desk. The smaller bedroom has 10 m2.",
            {"larger_bedroom": (1, None), "smaller_bedroom": (1, 10.0)},
        ),
        (
            "A school with four classrooms. The biggest classroom has a piano. The biggest classroom is 70 m2.",
            {"classroom": (3, None), "biggest_classroom": (1, 70.0)},
        ),
    ],
)
def test_it_is_one_of_them(brief: str, rooms: dict[str, tuple[int, float | None]]) -> None:
    assert {fact.name: (fact.count, fact.area) for fact in read(brief).rooms} == rooms


def test_it_alone_has_what_is_said_of_it() -> None:
    facts = read("A flat with two bedrooms; the larger bedroom has its own bathroom and a desk.")
    assert {fact.name: [room.room_type for room in fact.suite] for fact in facts.rooms} == {
        "bedroom": [],
        "larger_bedroom": ["bathroom"],
    }


def test_it_is_on_the_storey_of_the_others() -> None:
    facts = read("A house of two floors with four bedrooms upstairs; the biggest bedroom has a desk.")
    assert {fact.name: fact.floors[0].kind for fact in facts.rooms} == {"bedroom": "upper", "biggest_bedroom": "upper"}


@pytest.mark.parametrize(
    "words",
    [
        "two halls of 90 m2 and 40 m2, the larger one with a piano",
        "two halls, the larger one of 90 m2 and the smaller one of 40 m2",
    ],
)
def test_several_areas_tell_the_rooms_apart_already(words: str) -> None:
    assert [fact.area for fact in read(f"An arts centre: {words}.").rooms] == [90.0, 40.0]

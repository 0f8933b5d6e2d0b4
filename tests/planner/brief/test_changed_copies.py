"""Storeys that are like another one, but for what the brief says."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def counts(text: str, storey: int) -> dict[str, int | None]:
    """Return how many rooms of each name are told for a storey."""
    return {
        fact.name: fact.count
        for fact in read(text).rooms
        if [(ref.first, ref.last) for ref in fact.floors] == [(storey, storey)]
    }


@pytest.mark.parametrize(
    ("last", "held"),
    [
        ("level 3 the same but with three meeting rooms", {"lab": 1, "meeting_room": 3}),
        ("level 3 the same, but without the lab", {"meeting_room": 2}),
        ("level 3 the same plus a gym", {"lab": 1, "meeting_room": 2, "gym": 1}),
        ("level 3 is the same as level 2 but with an archive instead of the lab", {"meeting_room": 2, "archive": 1}),
        ("level 3 as level 2, with an additional lab", {"meeting_room": 2, "lab": 2}),
        ("level 3 like level 2 except for three meeting rooms", {"lab": 1, "meeting_room": 3}),
    ],
)
def test_what_is_not_changed_is_there_again(last: str, held: dict[str, int]) -> None:
    text = f"A building of three levels. Level 2 has a lab and two meeting rooms, {last}."
    assert counts(text, 3) == held
    assert counts(text, 2) == {"lab": 1, "meeting_room": 2}


def test_the_storey_is_no_copy() -> None:
    text = "Three levels. Level 2: a lab and two meeting rooms. Level 3 is the same as level 2 but with a gym."
    assert read(text).copies == []


def test_a_storey_may_be_told_by_its_ordinal() -> None:
    text = "Hotel, 3 floors. Second floor: 12 rooms and a lounge. Third floor like the second, but without the lounge."
    assert counts(text, 3) == {"room": 12}


def test_furniture_of_the_rooms_is_there_again() -> None:
    text = "Three levels. Level 2: an open-plan office with 30 desks and two labs, level 3 the same but with a gym."
    assert [(wanted.count, wanted.floors[0].first) for wanted in read(text).objects] == [(30, 2), (30, 3)]

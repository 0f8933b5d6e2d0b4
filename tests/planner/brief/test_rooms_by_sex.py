"""Toilets and changing rooms that are told apart by short words."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


def counts(text: str) -> dict[str, int | None]:
    """Return how many rooms of each name are told."""
    return {fact.name: fact.count for fact in read(text).rooms}


@pytest.mark.parametrize(
    ("said", "expected"),
    [
        ("WC f, WC m, WC accessible", {"woman_wc": 1, "man_wc": 1, "accessible_wc": 1}),
        ("staff WC m/w", {"woman_staff_wc": 1, "man_staff_wc": 1}),
        ("WC m/f/d", {"woman_wc": 1, "man_wc": 1}),
        ("toilets by sex", {"woman_toilet": 1, "man_toilet": 1}),
        ("toilets for either sex", {"woman_toilet": 1, "man_toilet": 1}),
        ("changing m+f", {"woman_changing_room": 1, "man_changing_room": 1}),
    ],
)
def test_each_has_one(said: str, expected: dict[str, int]) -> None:
    found = counts(f"Sports hall with a lobby, {said}, and a gym.")
    kinds = {name.rpartition("_")[2] for name in expected}
    assert sum(count or 0 for name, count in found.items() if name.rpartition("_")[2] in kinds | {"toilet"}) == len(
        expected
    )


@pytest.mark.parametrize("said", ["toilets incl. disabled", "two toilets and one accessible"])
def test_an_accessible_one_is_among_them(said: str) -> None:
    assert "accessible_toilet" in [fact.room_type for fact in read(f"A hall with {said}.").rooms]


def test_people_are_no_rooms() -> None:
    assert counts("Factory with changing rooms for 20 men and 10 women.").keys() == {"changing_room"}


def test_what_rooms_for_men_and_women_have_each_of_them_has() -> None:
    rooms = read("A gym with changing rooms with showers for men and women, a sauna and a bar.").rooms
    assert {room.name: [part.name for part in room.suite] for room in rooms} == {
        "man_changing_room": ["shower"],
        "woman_changing_room": ["shower"],
        "sauna": [],
        "bar": [],
    }

"""Flats of several sizes that are told one by one."""

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
    ("text", "expected"),
    [
        (
            "Apartment house. Storeys two to five: three flats each, of which one has one bedroom, one has two "
            "bedrooms and one has three.",
            [(1, 1), (1, 2), (1, 3)],
        ),
        (
            "Apartment house, four flats on each floor; the two on the yard side have one bedroom each, the two on the "
            "park side two.",
            [(2, 1), (2, 2)],
        ),
    ],
)
def test_each_share_has_its_bedrooms(text: str, expected: list[tuple[int, int]]) -> None:
    flats = [fact for fact in read(text).rooms if fact.unit]
    beds = [next(room.count for room in fact.suite if room.room_type == "bedroom") for fact in flats]
    assert [(fact.count, bed) for fact, bed in zip(flats, beds, strict=True)] == expected

"""A storey that is told beside a first one."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts


def read(text: str) -> BriefFacts:
    return read_brief(text, default_knowledge())


@pytest.mark.parametrize(
    "words",
    [
        "one storey plus a mezzanine-like second storey",
        "one storey and a second floor",
        "one level with an additional level",
        "one floor plus an upper floor",
        "a single storey plus one extra storey",
    ],
)
def test_there_are_two(words: str) -> None:
    assert [quantity.value for quantity in read(f"A car dealership, {words} for the offices.").floors] == [2.0]


def test_one_storey_stays_one() -> None:
    assert [quantity.value for quantity in read("A shop on one storey with a store.").floors] == [1.0]

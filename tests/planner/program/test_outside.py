"""What a brief decides of the outside: the first of each part, and the form that a covering needs."""

import msgspec
import pytest

from mansion_msgs_py.outside import Outside
from mansion_planner.brief.facts import OutsideFact, Span
from mansion_planner.program.outside import outside_of

WORDS = Span("", 0, 0)


def test_nothing_is_decided_where_nothing_is_said() -> None:
    assert outside_of([], "house", "modern") is msgspec.UNSET


@pytest.mark.parametrize(
    ("building", "covering", "forms"),
    [("house", "slate_roof", {"gable", "hip"}), ("office", "clay_roof_tiles", {"gable"}), ("house", "lawn", {"flat"})],
)
def test_a_covering_decides_whether_the_roof_slopes(building: str, covering: str, forms: set[str]) -> None:
    outside = outside_of([OutsideFact("roof", "", WORDS, covering=covering)], building, "neutral")
    assert isinstance(outside, Outside)
    assert outside.roof in forms and outside.covering == covering


def test_the_first_facade_counts_and_the_most_places_to_park() -> None:
    facts = [
        OutsideFact("facade", "red_brick", WORDS),
        OutsideFact("facade", "white_render", WORDS),
        OutsideFact("grounds", "", WORDS, use="parking"),
        OutsideFact("grounds", "", WORDS, count=12, use="parking"),
    ]
    outside = outside_of(facts, "office", "neutral")
    assert isinstance(outside, Outside)
    assert outside.facade == "red_brick"
    assert [(wish.use, wish.count) for wish in outside.grounds] == [("parking", 12)]

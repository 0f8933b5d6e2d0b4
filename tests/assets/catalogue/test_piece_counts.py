"""Which categories answer for which."""

import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_assets.catalogue.piece_counts import pieces
from mansion_knowledge.object_kinds import added_for, answers, substitutes

CATALOGUE = load_catalogue()


def test_every_stand_in_and_addition_is_a_category_of_the_catalogue() -> None:
    for category in CATALOGUE.categories:
        named = {*substitutes(category), added_for(category)}
        assert named <= set(CATALOGUE.categories)
        assert category not in substitutes(category)
        assert answers(category, category) and answers(category, added_for(category))


@pytest.mark.parametrize(
    "requested, category, expected",
    [
        ("chair", "office_chair", True),
        ("chair", "cinema_seat", True),
        ("office_chair", "chair", False),
        ("bed", "single_bed", True),
        ("bed", "crib", False),
        ("desk", "office_desk", True),
        ("sofa", "bed", False),
    ],
)
def test_a_general_word_is_answered_by_the_kinds_of_it(requested: str, category: str, expected: bool) -> None:
    assert answers(requested, category) is expected


def test_a_row_of_seats_counts_its_seats() -> None:
    row, chair = CATALOGUE.by_category("cinema_seat")[0], CATALOGUE.by_category("meeting_chair")[0]
    assert pieces("chair", row) == 3 and pieces("chair", chair) == 1 and pieces("sofa", row) == 0

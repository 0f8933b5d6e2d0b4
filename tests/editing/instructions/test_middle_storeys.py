"""The storey in the middle."""

import pytest

from mansion_editing.instructions.phrases.storeys import read_storeys
from mansion_editing.instructions.phrases.words import split_words
from mansion_language.spelling import Speller


@pytest.mark.parametrize(("floors", "middle"), [((1, 2, 3), (2,)), ((0, 1, 2), (1,)), ((1, 2, 3, 4, 5), (3,))])
def test_the_middle_floor_is_that_of_an_odd_number(floors: tuple[int, ...], middle: tuple[int, ...]) -> None:
    words = split_words("the middle floor", Speller(set(), set()), frozenset())
    assert read_storeys(words, 0, floors) == (middle, False, 3)


def test_an_even_number_of_floors_has_none_in_the_middle() -> None:
    words = split_words("the middle floor", Speller(set(), set()), frozenset())
    assert read_storeys(words, 0, (1, 2)) is None

"""Words for the outside: each phrase stands for one thing, as the reader writes its words."""

from collections import Counter

import pytest

from mansion_knowledge.outside_words import outside_words
from mansion_language import tokenize

TABLES = {name: getattr(outside_words(), name) for name in outside_words().__dataclass_fields__}


def test_a_colour_before_a_finish_is_that_of_render() -> None:
    assert outside_words().substances["light grey stucco"] == outside_words().colours["light grey"]


@pytest.mark.parametrize("name", sorted(TABLES))
def test_phrases_are_written_as_the_reader_sees_them(name: str) -> None:
    for phrase in TABLES[name]:
        assert " ".join(token.text for token in tokenize(phrase)) == phrase


def test_no_ground_is_both_a_room_and_none() -> None:
    counts = Counter([*outside_words().grounds, *outside_words().outdoor])
    assert [phrase for phrase, count in counts.items() if count > 1] == []

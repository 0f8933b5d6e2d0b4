"""Singular and plural of the nouns that people use for buildings and what stands in them."""

import pytest

from mansion_language import is_plural, plural, singular

PLURALS = {
    "knives": "knife", "shelves": "shelf", "glasses": "glass", "boxes": "box", "benches": "bench", "lobbies": "lobby",
    "storeys": "storey", "stories": "story", "houses": "house", "offices": "office", "buses": "bus", "sofas": "sofa",
    "pianos": "piano", "potatoes": "potato", "gloves": "glove", "leaves": "leaf", "studies": "study",
    "children": "child", "women": "woman", "mice": "mouse", "atria": "atrium", "stairs": "stair", "dishes": "dish",
    "movies": "movie",
}  # fmt: skip


@pytest.mark.parametrize(("many", "one"), PLURALS.items())
def test_a_plural_and_its_singular_lead_to_each_other(many: str, one: str) -> None:
    assert singular(many) == one
    assert is_plural(many)
    assert plural(one) in (many, "axes")


@pytest.mark.parametrize(
    "noun", ["gas", "bus", "glass", "lens", "access", "tennis", "canvas", "chess", "fitness", "campus", "series"]
)
def test_a_singular_in_s_stays_as_it_is(noun: str) -> None:
    assert singular(noun) == noun
    assert not is_plural(noun)


def test_the_last_word_of_a_name_takes_the_plural() -> None:
    assert plural("meeting room") == "meeting rooms"
    assert plural("wine glass") == "wine glasses"

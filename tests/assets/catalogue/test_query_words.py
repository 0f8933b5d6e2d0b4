"""Which words of a query count, and how much."""

import pytest

from mansion_assets.catalogue.query_words import query_words, stem


def weights(query: str) -> dict[str, float]:
    """Return the weight of each word that counts."""
    return {word.text: word.weight for word in query_words(query)}


@pytest.mark.parametrize(
    ("query", "head"),
    [
        ("table for examining patients", "table"),
        ("boxing practice target", "target"),
        ("rack full of network servers", "rack"),
        ("to cut bread with", "cut"),
        ("mirror above the basin", "mirror"),
    ],
)
def test_the_head_of_a_query_counts_most(query: str, head: str) -> None:
    found = weights(query)
    assert found[head] == max(found.values())
    assert [word for word, weight in found.items() if weight == found[head]] == [head]


def test_a_colour_counts_less_than_what_it_is_the_colour_of() -> None:
    assert weights("blue chair")["blue"] < 0.5 * weights("blue chair")["chair"]
    assert weights("an orange") == {"orange": weights("chair")["chair"]}


def test_what_is_not_wanted_does_not_count() -> None:
    assert list(weights("a chair without armrests")) == ["chair"]


def test_a_word_counts_once() -> None:
    assert list(weights("side by side chairs, chairs")) == ["side", "chair"]


@pytest.mark.parametrize("forms", [("bake", "baking", "bakes", "baked"), ("cut", "cutting"), ("dry", "dryer", "dried")])
def test_forms_of_a_verb_have_one_stem(forms: tuple[str, ...]) -> None:
    assert len({stem(form) for form in forms}) == 1


def test_a_noun_that_ends_like_a_form_of_a_verb_is_left_whole() -> None:
    assert stem("boxing") != stem("box")
    assert stem("ceiling") == "ceiling"

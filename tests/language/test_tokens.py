"""Tokens of a text: words, numbers, units and marks with their places."""

import itertools

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_language import Token, tokenize


def numbers(text: str) -> list[float]:
    return [token.value for token in tokenize(text) if token.kind == "number"]


@pytest.mark.parametrize(
    ("text", "value", "unit"),
    [
        ("120m2", 120, "m2"),
        ("85sqm", 85, "m2"),
        ("1.5k sqft", 1500, "ft2"),
        ("3,800 sq ft", 3800, "ft2"),
        ("20 000 m²", 20000, "m2"),
        ("32 square metres", 32, "m2"),
        ("140 qm", 140, "m2"),
        ("60 kvm", 60, "m2"),
        ("90mq", 90, "m2"),
        ("2,5 m", 2.5, "m"),
    ],
)
def test_a_number_and_its_unit_are_two_tokens(text: str, value: float, unit: str) -> None:
    assert [(token.kind, token.value or token.text) for token in tokenize(text)] == [("number", value), ("unit", unit)]


@pytest.mark.parametrize(
    ("text", "value"),
    [("twenty-five", 25), ("two hundred and forty", 240), ("a dozen", 12), ("three thousand", 3000), ("twelve", 12)],
)
def test_numbers_in_words(text: str, value: float) -> None:
    assert numbers(text) == [value]


def test_a_full_stop_after_a_unit_ends_the_sentence() -> None:
    assert [token.text for token in tokenize("32 square metres. Two")] == ["32", "m2", ".", "two"]


def test_storeys_in_short_form() -> None:
    assert [(token.kind, token.value) for token in tokenize("L2 4F")] == [("level", 2.0), ("level", 4.0)]


def test_genitives_and_contractions_are_opened() -> None:
    assert [token.text for token in tokenize("director's office, don't")] == ["director", "office", ",", "not"]


def places(tokens: list[Token]) -> list[tuple[int, int]]:
    return [(token.start, token.end) for token in tokens]


@given(st.text(max_size=200))
@settings(max_examples=100, deadline=None)
def test_tokens_keep_their_order_and_place(text: str) -> None:
    spans = places(tokenize(text))
    assert all(first[1] <= second[0] for first, second in itertools.pairwise(spans))
    assert all(0 <= start < end <= len(text) for start, end in spans)

"""JSON is found alone, fenced, or amid prose; nothing is made up."""

import json

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_llm.extraction import json_candidates

VALUE = {"floors": 2, "note": 'a "}" in words', "rooms": [{"id": "hall"}]}
TEXT = json.dumps(VALUE)


@pytest.mark.parametrize(
    "answer",
    [
        TEXT,
        f"```json\n{TEXT}\n```",
        f"Sure, here it is:\n```\n{TEXT}\n```\nAnything else?",
        f"I considered {{a set}} first. {TEXT} That is all [1].",
        f'<think>maybe {{"floors": 9}}</think>{TEXT}',
        TEXT[:-1] + ",}",
        "\ufeff" + TEXT,
    ],
)
def test_the_value_is_found(answer: str) -> None:
    found = []
    for candidate in json_candidates(answer):
        try:
            found.append(json.loads(candidate))
        except ValueError:
            continue
    assert VALUE in found
    assert found[0] == VALUE


def test_a_cut_answer_gives_no_whole_value() -> None:
    for candidate in json_candidates(TEXT[:-20]):
        with pytest.raises(ValueError):
            json.loads(candidate)


@settings(deadline=None, max_examples=150)
@given(st.text(alphabet='{}[]",:\\ab1 \n`', max_size=300))
def test_no_answer_breaks_it(answer: str) -> None:
    assert len(list(json_candidates(answer))) <= 24


def test_a_flood_of_brackets_ends() -> None:
    assert len(list(json_candidates("[{" * 20_000))) <= 24

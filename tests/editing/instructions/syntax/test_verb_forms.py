"""Forms of verbs: which verb a word may be."""

import pytest

from mansion_editing.instructions.syntax.verb_forms import VerbForm, verb_forms


@pytest.mark.parametrize(
    ("word", "verb", "form"),
    [
        ("put", "put", "base"),
        ("puts", "put", "third"),
        ("carried", "carry", "past"),
        ("dropping", "drop", "gerund"),
        ("taken", "take", "participle"),
        ("lying", "lie", "gerund"),
        ("wobbles", "wobble", "third"),
        ("squeezed", "squeeze", "past"),
    ],
)
def test_a_form_belongs_to_its_verb(word: str, verb: str, form: str) -> None:
    assert VerbForm(verb, form) in verb_forms(word)  # type: ignore[arg-type]


def test_a_noun_is_no_form_of_a_verb() -> None:
    assert verb_forms("sofa") == ()

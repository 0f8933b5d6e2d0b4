"""Where the clauses of an instruction begin and end, and how each is built."""

import pytest

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.syntax.clauses import clauses_of
from mansion_editing.instructions.syntax.tagged_words import tagged, text_of
from mansion_editing.state import SceneState


def _clauses(text: str, state: SceneState) -> list[tuple[str, str]]:
    words = tagged(text, Lexicon(state))
    return [(clause.form, text_of(words[clause.start : clause.end], text)) for clause in clauses_of(words)]


@pytest.mark.parametrize(
    ("text", "clauses"),
    [
        ("Put a mug on the table and open the fridge.", ["Put a mug on the table", "open the fridge"]),
        ("Move the sofa and the chair to the kitchen.", ["Move the sofa and the chair to the kitchen"]),
        ("The sofa is old, so take it away.", ["The sofa is old", "take it away"]),
        ("The chair wobbles and has to go.", ["The chair wobbles", "has to go"]),
        ("Could the sofa and the table trade places?", ["Could the sofa and the table trade places"]),
        ("The mug, which nobody uses, can go.", ["The mug, which nobody uses, can go"]),
        (
            "The mug that somebody left in the hall belongs here.",
            ["The mug that somebody left in the hall belongs here"],
        ),
        ("As we have guests, open the fridge.", ["As we have guests", "open the fridge"]),
    ],
)
def test_a_clause_ends_where_another_begins(furnished_state: SceneState, text: str, clauses: list[str]) -> None:
    assert [said for _, said in _clauses(text, furnished_state)] == clauses


@pytest.mark.parametrize(
    ("text", "form"),
    [
        ("Take the mug away.", "order"),
        ("Frobnicate the mug.", "order"),
        ("In the hall, put a plant.", "order"),
        ("The mug belongs in the kitchen.", "statement"),
        ("There is a mug in the hall.", "existence"),
        ("Could you take the mug away?", "question"),
        ("Because the mug is dirty", "dependent"),
        ("two mugs on the table", "fragment"),
    ],
)
def test_a_clause_has_a_form(furnished_state: SceneState, text: str, form: str) -> None:
    assert [found for found, _ in _clauses(text, furnished_state)] == [form]

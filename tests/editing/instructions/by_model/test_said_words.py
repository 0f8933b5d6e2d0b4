"""A statement passes where it says what its quote says: what the rules read does, what was changed in it does not."""

from typing import Any

import msgspec
import pytest

from mansion_editing.instructions.by_model.accounted_words import AccountedWords
from mansion_editing.instructions.by_model.said_words import SaidWords, Span
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import (
    Amount,
    Ensure,
    Forbid,
    Keep,
    Mention,
    Place,
    Remove,
    Rooms,
    Statement,
    Things,
)
from mansion_editing.state import SceneState
from mansion_llm.quotes import find_quote

TRAINING_LIST = [
    "put two red mugs on the dining table in the kitchen",
    "remove two of the three chairs in the hall",
    "take all the mugs off the dining table upstairs",
    "open the fridge, and switch off the ceiling lights in the kitchen",
    "In the kitchen, add a plate and three apples to the dining table.",
    "move the plate to the dining table in the private office",
    "paint the sofa in the hall green",
    "rename the kitchen to Canteen",
    "there should be exactly four chairs in the hall",
    "don't put a chair in the kitchen",
    "put a plant between the sofa and the chairs in the hall",
    "swap the sofa and the dining table in the kitchen",
    "stand the floor lamp within 1 metre of the desk",
    "leave the sofa alone but clear the dining table in the kitchen",
    "is the fridge closed?",
    "replace the sofa with an armchair",
    "Please turn the floor lamp upstairs on and bring another chair to the hall, thanks a lot!",
    "put an apple in a bowl on the dining table in the kitchen",
]


def placed(text: str, state: SceneState) -> list[tuple[Statement, Span]]:
    """Return the rules' statements of a text with the places of their quotes."""
    read = read_instruction(text, state)
    assert not read.not_understood, read
    found = [(statement, find_quote(text, statement.quote)) for statement in read.statements]
    return [(statement, span) for statement, span in found if span is not None]


@pytest.mark.parametrize("text", TRAINING_LIST)
def test_what_the_rules_read_is_said_and_accounts_for_all_words(text: str, furnished_state: SceneState) -> None:
    words = SaidWords(text, furnished_state)
    statements = placed(text, furnished_state)
    accounted = AccountedWords(words, statements)
    assert words.is_english and statements
    assert [words.fault(statement, span) for statement, span in statements] == [""] * len(statements)
    assert [accounted.left(span) for _, span in statements] == [[]] * len(statements)
    assert accounted.uncovered([]) == []


CHANGES: dict[str, Any] = {
    "number": {"amount": Amount(number=3)},
    "whole": {"amount": Amount(number=2, of=5)},
    "noun": {"noun": "plate"},
    "id": {"noun": "F1/kitchen/mug_1"},
    "colour": {"colour": "green"},
    "place": {"place": Place(rooms=Rooms(words="hall"))},
    "exception": {"beside": (Things(noun="sofa"),)},
}


@pytest.mark.parametrize("change", CHANGES.values(), ids=CHANGES)
def test_what_is_changed_in_it_is_not_said(change: dict[str, Any], furnished_state: SceneState) -> None:
    text = "put two red mugs on the dining table in the kitchen"
    words = SaidWords(text, furnished_state)
    ((statement, span),) = placed(text, furnished_state)
    things = msgspec.structs.replace(statement.things, **change)  # type: ignore[union-attr]
    assert words.fault(msgspec.structs.replace(statement, things=things), span)


@pytest.mark.parametrize(
    ("text", "left"),
    [
        ("put two red mugs on the table", ["red"]),
        ("put two mugs and a plate on the table", ["plate"]),
        ("put two mugs on the table next to the fridge", ["fridge"]),
        ("put two mugs on the table by 5 pm", ["5", "pm"]),
    ],
)
def test_words_of_a_quote_that_no_statement_says_are_named(
    text: str, left: list[str], furnished_state: SceneState
) -> None:
    ((statement, _),) = placed("put two mugs on the table", furnished_state)
    span = (0, len(text))
    assert AccountedWords(SaidWords(text, furnished_state), [(statement, span)]).left(span) == left


@pytest.mark.parametrize(
    ("text", "pieces"),
    [
        ("In the hall: put two mugs on the table", ["In the hall"]),
        ("put two mugs on the table, then remove it", ["then remove it"]),
        ("put two mugs on the table but not there", ["but not there"]),
        ("please put two mugs on the table. Thank you very much!", []),
        ("Table: put two mugs on the table", []),
    ],
)
def test_words_beside_the_quotes_that_ask_for_something_are_named(
    text: str, pieces: list[str], furnished_state: SceneState
) -> None:
    quote = "put two mugs on the table"
    ((statement, _),) = placed(quote, furnished_state)
    span = (text.index(quote), text.index(quote) + len(quote))
    assert AccountedWords(SaidWords(text, furnished_state), [(statement, span)]).uncovered([]) == pieces


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("put two mugs on the sideboardish thing", Forbid),
        ("put two mugs on the sideboardish thing", Keep),
        ("put two mugs on the sideboardish thing", Mention),
        ("please remove the mugs", Keep),
        ("could you take away the mugs", Mention),
        ("switch the floor lamp on", Ensure),
        ("is there a mug on the dining table", Ensure),
        ("move the mug to the hall", Remove),
    ],
)
def test_a_deed_that_the_verb_does_not_ask_for_is_told(text: str, kind: type[Any], furnished_state: SceneState) -> None:
    parts = {"things": {"type": "Things", "noun": "mug"}, "place": {}}
    statement = msgspec.convert({name: parts[name] for name in kind.__struct_fields__ if name in parts}, kind)
    assert SaidWords(text, furnished_state).wrong_sense(statement, (0, len(text)))

"""A clause that asks for nothing is passed over and named; what it names must then be as it was."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Clear, Ensure, Keep, Mention, SetState, Statement
from mansion_editing.state import SceneState


def _statements(text: str, state: SceneState) -> list[Statement]:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return instruction.statements


@pytest.mark.parametrize(
    "aside",
    [
        "The dining table was expensive.",
        "The cat sleeps on the dining table.",
        "My mother sits in a wheelchair since the summer.",
        "Dinner at eight!",
        "World cup final!",
        "This is a kitchen and not a night club.",
        "What is a chair doing in here?!",
        "The dining table isn't hers.",
        "The chairs in the hall have been repaired.",
        "The air becomes bad.",
    ],
)
def test_what_asks_for_nothing_is_passed_over(furnished_state: SceneState, aside: str) -> None:
    for text in (f"Open the fridge. {aside}", f"{aside} Open the fridge."):
        kinds = [type(s) for s in _statements(text, furnished_state)]
        assert kinds.count(SetState) == 1 and set(kinds) == {SetState, Mention}


@pytest.mark.parametrize(
    "request_",
    [
        "The plant shall come into the study soon.",
        "The chairs stand around the table.",
        "Every table carries exactly one candle.",
        "The plant moves to the study.",
        "The sofa no longer fits.",
        "The study becomes a library.",
        "The kitchen becomes a movement room.",
        "Ten chairs!",
        "Lights!",
        "The table fits well and remove the plates",
    ],
)
def test_what_may_ask_for_something_is_not(furnished_state: SceneState, request_: str) -> None:
    instruction = read_instruction(f"Open the fridge. {request_}", furnished_state)
    passed = [s for s in instruction.statements if isinstance(s, Mention) and s.passed_over]
    assert instruction.not_understood or not passed


def test_the_answer_names_what_was_passed_over(editor: SceneEditor) -> None:
    report = instruct(editor, "Open the fridge. World cup final!")
    assert report.done and "not acted on: 'World cup final'" in report.message


def test_what_was_only_mentioned_must_be_as_it_was(editor: SceneEditor) -> None:
    before = {item.id: item for _, item in editor.state.objects()}
    report = instruct(editor, "Remove all chairs in the hall. The chairs were expensive.")
    assert not report.done and "only mentioned" in report.message
    assert {item.id: item for _, item in editor.state.objects()} == before


def test_a_request_may_go_on_with_what_was_told(editor: SceneEditor) -> None:
    assert instruct(editor, "The chairs in the hall were expensive. Remove them.").done
    assert not [item for _, item in editor.state.objects() if item.id.startswith("F1/hall/chair")]


@pytest.mark.parametrize("purpose", ["so that she gets past", "so that it can dry", "so that people can see it"])
def test_a_purpose_asks_for_nothing(furnished_state: SceneState, purpose: str) -> None:
    statements = _statements(f"Open the fridge {purpose}.", furnished_state)
    assert [type(s) for s in statements] == [SetState, Mention]


@pytest.mark.parametrize(
    "staying",
    [
        "The chairs - don't touch.",
        "The chairs are not to be moved.",
        "The chairs are not for moving.",
        "The chairs in the hall aren't affected.",
        "The dining table isn't part of it.",
        "The chairs in the hall we do need.",
        "What lies on the dining table should still lie there afterwards.",
        "The chairs stay dark.",
        "In the kitchen everything stays as it is.",
    ],
)
def test_what_is_not_meant_is_kept(furnished_state: SceneState, staying: str) -> None:
    statements = _statements(f"Open the fridge. {staying}", furnished_state)
    assert [type(s) for s in statements] == [SetState, Keep]


def test_what_stays_is_kept_with_what_is_named_on_it(furnished_state: SceneState) -> None:
    statements = _statements("Open the fridge. The dining table with the plates can stay.", furnished_state)
    assert [s.things.noun for s in statements if isinstance(s, Keep)] == ["dining table", "plate"]


def test_what_stays_in_a_state_needs_no_article(furnished_state: SceneState) -> None:
    statements = _statements("Switch off the ceiling lights. Fridge and oven stay shut.", furnished_state)
    assert [type(s) for s in statements] == [SetState] * 3


@pytest.mark.parametrize(
    "once",
    [
        ". Those which have one already don't need another.",
        ". Who has one, has one.",
        ". Those with one are fine.",
        ", those which already have one don't need another",
        ", but tables with a mug don't get a second",
        "; the ones that already have one can do without another one",
        ", skip those that have one",
        ", where there is one already that is enough",
    ],
)
def test_what_has_one_gets_no_other(furnished_state: SceneState, once: str) -> None:
    (request_, _) = _statements(f"Each dining table needs a mug{once}", furnished_state)
    assert isinstance(request_, Ensure) and request_.each


@pytest.mark.parametrize(
    "text",
    [
        "Put two mugs on each dining table; those which have one don't need another.",
        "Put a red mug on each dining table; those which have one don't need another.",
        "Put a mug on the dining table; those which have one don't need another.",
        "Each dining table needs a mug, those with a plate don't need another.",
    ],
)
def test_who_has_which_is_not_guessed(furnished_state: SceneState, text: str) -> None:
    assert read_instruction(text, furnished_state).not_understood


def test_what_is_cleared_keeps_what_remains(furnished_state: SceneState) -> None:
    text = "Clear the dining table, everything goes, only the plate remains."
    (cleared,) = _statements(text, furnished_state)
    assert isinstance(cleared, Clear) and [things.noun for things in cleared.spare] == ["plate"]

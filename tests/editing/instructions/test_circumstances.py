"""Clauses about people and what happens are the occasion of a request, and ask for nothing themselves."""

import pytest

from mansion_editing.instructions.sentences.circumstances import is_circumstance
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Mention, SetState
from mansion_editing.state import SceneState


def _is_circumstance(text: str, state: SceneState) -> bool:
    progress = Progress(text, state)
    return is_circumstance(progress.words, progress.lexicon, followed=True)


@pytest.mark.parametrize(
    "clause",
    [
        "We're collecting navigation data on Thursday",
        "A couple with twins has booked a table for lunch",
        "A new colleague starts on Monday",
        "From August we'll have a pupil in a wheelchair",
        "she'll sit in the study",
        "The auditors are coming at nine",
        "the guests are leaving too much paper",
        "duty manager here",
        "Open day on Saturday",
        "Nobody can find anything",
        "We have a photo shoot at ten",
        "the gripper cannot reach that high",
        "the cleaners leave them open all the time",
    ],
)
def test_what_people_do_and_what_happens_is_a_circumstance(furnished_state: SceneState, clause: str) -> None:
    assert _is_circumstance(clause, furnished_state)


@pytest.mark.parametrize(
    "clause",
    [
        "The kitchen should have two more chairs",
        "The chairs are in the wrong room",
        "Mum wants a vase on the table",
        "We could do with a lamp",
        "we need a plumbus",
        "two flurbs please",
        "it must go",
        "I want it gone",
        "I'd have the sofa in the study",
        "we'll take the chair to the study",
        "the plant goes to the study",
        "not the ones in the kitchen",
        "dim it",
        "Our guests get two towels each",
    ],
)
def test_what_may_be_a_request_is_none(furnished_state: SceneState, clause: str) -> None:
    assert not _is_circumstance(clause, furnished_state)


@pytest.mark.parametrize(
    "text",
    [
        "The inspector comes at nine and she hates dust, so open the fridge.",
        "We're shooting a film on Thursday and the crew arrives early: open the fridge.",
        "A colleague starts on Monday; the caretaker is on holiday. Open the fridge.",
    ],
)
def test_several_circumstances_stand_beside_one_request(furnished_state: SceneState, text: str) -> None:
    read = read_instruction(text, furnished_state)
    assert read.not_understood == []
    kinds = [type(statement) for statement in read.statements]
    assert kinds.count(SetState) == 1 and set(kinds) == {SetState, Mention}


def test_a_circumstance_with_a_request_in_it_is_not_set_aside(furnished_state: SceneState) -> None:
    read = read_instruction(
        "The inspector comes at nine and needs a plumbus in the kitchen. Open the fridge.", furnished_state
    )
    assert read.not_understood


@pytest.mark.parametrize("clause", ["without touching what is on it", "put file:///etc/hosts", "///etc/hosts is here"])
def test_what_limits_a_request_and_what_is_no_english_is_none(furnished_state: SceneState, clause: str) -> None:
    assert not _is_circumstance(clause, furnished_state)


def test_the_room_that_an_occasion_names_is_where_the_next_request_is(furnished_state: SceneState) -> None:
    read = read_instruction("Two trainees arrive in the study on Monday. Switch the lamp on.", furnished_state)
    told = read.statements[0]
    assert isinstance(told, Mention) and told.rooms is not None and told.rooms.words == "study"


@pytest.mark.parametrize(
    "told",
    [
        "A client in a wheelchair comes tomorrow",
        "A visitor with a walker arrives at noon",
        "The new doctor with the guide dog is coming on Monday",
    ],
)
def test_what_a_person_comes_with_asks_for_nothing(furnished_state: SceneState, told: str) -> None:
    read = read_instruction(f"{told}. Open the fridge.", furnished_state)
    assert read.not_understood == []
    assert [type(statement) for statement in read.statements] == [Mention, SetState]


def test_what_a_person_in_a_wheelchair_needs_is_not_passed_over(furnished_state: SceneState) -> None:
    assert read_instruction("A client in a wheelchair needs a desk. Open the fridge.", furnished_state).not_understood


@pytest.mark.parametrize(
    "told",
    [
        "We're four for dinner tonight, so",
        "There will be five of us for lunch;",
        "There are eight of us in the house now.",
        "There are six guests tonight, so",
        "We'll be ten at the table:",
        "We are six at breakfast tomorrow,",
    ],
)
def test_a_number_of_people_asks_for_nothing(furnished_state: SceneState, told: str) -> None:
    instruction = read_instruction(f"{told} put two plates on the dining table in the kitchen.", furnished_state)
    assert instruction.not_understood == []
    (asked,) = [statement for statement in instruction.statements if not isinstance(statement, Mention)]
    assert isinstance(asked, Add) and asked.things.amount.number == 2


@pytest.mark.parametrize(
    "told", ["We're two short in the kitchen", "We are two chairs short", "There should be six of us"]
)
def test_a_number_that_is_missing_is_not_passed_over(furnished_state: SceneState, told: str) -> None:
    assert read_instruction(f"{told}. Open the fridge.", furnished_state).not_understood

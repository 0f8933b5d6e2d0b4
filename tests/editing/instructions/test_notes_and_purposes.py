"""Lists without articles, purposes of rooms, and clauses that only repeat what is asked for."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Amount, Ensure, Keep, Mention, Place, Reach, Remove, Rooms
from mansion_editing.state import SceneState

KITCHEN = Place(rooms=Rooms(words="kitchen"))


def _asked(text: str, state: SceneState) -> list[object]:
    read = read_instruction(text, state)
    assert not read.not_understood
    return [statement for statement in read.statements if not isinstance(statement, Mention)]


@pytest.mark.parametrize(("said", "left"), [("There are three chairs", 2), ("There are chairs", 2)])
def test_half_of_what_was_told_goes(said: str, left: int, editor: SceneEditor) -> None:
    report = instruct(editor, f"{said} in the hall, take out half of them.")
    assert report.done and sum(i.id.startswith("F1/hall/chair") for _, i in editor.state.objects()) == left


def test_half_of_a_number_that_is_not_there_is_refused(editor: SceneEditor) -> None:
    assert not instruct(editor, "There are ten chairs in the hall, take out half of them.").done


def test_a_list_without_articles_is_the_subject(state: SceneState) -> None:
    (plate, mug) = _asked("Plate and mug have no business in the kitchen.", state)
    assert isinstance(plate, Remove) and isinstance(mug, Remove)
    assert plate.things.definite and plate.things.place == mug.things.place == KITCHEN
    kept = _asked("Sofa and mug may stay.", state)
    assert [s.things.noun for s in kept if isinstance(s, Keep)] == ["sofa", "mug"]


def test_what_shall_not_stay_is_not_kept(state: SceneState) -> None:
    assert read_instruction("The sofa should not stay in the hall.", state).not_understood


@pytest.mark.parametrize("filled", [", fill in whatever is missing", ". Add the missing ones", ", add what's missing"])
def test_filling_in_what_is_missing_is_what_a_wish_asks_for(filled: str, state: SceneState) -> None:
    (wish,) = _asked(f"Every dining table should have a plate{filled}.", state)
    assert isinstance(wish, Ensure) and wish.things.noun == "plate"


def test_filling_in_is_no_wish_of_its_own(state: SceneState) -> None:
    assert read_instruction("Remove the sofa, fill in whatever is missing.", state).not_understood


def test_a_room_that_somebody_wants_to_use_is_what_comes_next_is_about(state: SceneState) -> None:
    (gone, new) = _asked("We want to use the kitchen as a reading corner. Take out the fridge. Put in a rug.", state)
    assert isinstance(gone, Remove) and gone.things.place == KITCHEN
    assert isinstance(new, Add) and new.place == KITCHEN
    assert read_instruction("We want to use the kitchen as a reading corner.", state).not_understood


def test_a_limit_may_follow_its_number(state: SceneState) -> None:
    (least,) = _asked("There should be six or more plates in the kitchen.", state)
    (most,) = _asked("There should be two or fewer plates in the kitchen.", state)
    assert isinstance(least, Ensure) and least.things.amount == Amount(kind="at_least", number=6)
    assert isinstance(most, Ensure) and most.things.amount == Amount(kind="at_most", number=2)


def test_a_mood_before_a_colon_asks_for_nothing_but_its_room_counts(state: SceneState) -> None:
    (lamps,) = _asked("For the evening we want it cosy in the kitchen: all ceiling lights off.", state)
    assert getattr(lamps, "things").place == KITCHEN  # noqa: B009
    assert read_instruction("We want it empty in the kitchen: all ceiling lights off.", state).not_understood


def test_a_way_on_wheels_and_with_nothing_on_it(state: SceneState) -> None:
    (_, rolled) = _asked("Put a cart in the kitchen and make sure it can be rolled from there to the hall.", state)
    assert isinstance(rolled, Reach) and rolled.start == Rooms(same=True) and rolled.end == Rooms(words="hall")
    (free,) = _asked("Guests should be able to walk from the hall to the kitchen without anything in the way.", state)
    assert isinstance(free, Reach)


@pytest.mark.parametrize(
    "denied",
    [
        "A robot must not be able to get from the hall to the kitchen.",
        "Make sure nobody can walk from the hall to the kitchen.",
    ],
)
def test_a_way_that_shall_not_be_is_refused(denied: str, state: SceneState) -> None:
    assert read_instruction(denied, state).not_understood


def test_a_thing_without_an_article_that_goes_is_a_certain_one(editor: SceneEditor) -> None:
    report = instruct(editor, "Chair in the hall goes.")
    assert not report.done and len(report.candidates) == 3
    assert instruct(editor, "Sofa in the hall goes.").done and editor.state.find("F1/hall/sofa_1") is None

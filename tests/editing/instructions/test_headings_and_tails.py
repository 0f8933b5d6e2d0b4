"""Headings before a colon, and what may follow a clause."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Clear, Ensure, Keep, Mention, Remove, Replace, SetState, Statement
from mansion_editing.state import SceneState


def _statements(text: str, state: SceneState) -> list[Statement]:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return [s for s in instruction.statements if not isinstance(s, Mention)]


def test_a_room_with_an_occasion_is_where_all_of_it_is(furnished_state: SceneState) -> None:
    told = _statements("Kitchen, evening mode: fridge open, ceiling lights off.", furnished_state)
    rooms = [s.things.place.rooms for s in told if isinstance(s, SetState) and s.things.place is not None]
    assert [found.words for found in rooms if found is not None] == ["kitchen", "kitchen"]


@pytest.mark.parametrize(
    "text",
    [
        "Kitchen: plates gone.",
        "Kitchen on the first floor: plates gone.",
        "In the kitchen on the first floor: plates out.",
    ],
)
def test_what_shall_be_gone_after_a_room_is_that_of_the_room(furnished_state: SceneState, text: str) -> None:
    (gone,) = _statements(text, furnished_state)
    assert isinstance(gone, Remove) and gone.things.place is not None and gone.things.place.rooms is not None
    assert gone.things.place.rooms.words == "kitchen"


def test_what_is_emptied_or_cleared_out_of_a_room_leaves_it(furnished_state: SceneState) -> None:
    (gone,) = _statements("Empty the plate out of the kitchen.", furnished_state)
    assert isinstance(gone, Remove) and gone.things.noun == "plate"


def test_what_holds_things_is_emptied_where_it_is_cleared_out(furnished_state: SceneState) -> None:
    (emptied,) = _statements("Clear out the fridge in the kitchen.", furnished_state)
    assert isinstance(emptied, Clear)
    (gone,) = _statements("Clear out the fridge from the kitchen.", furnished_state)
    assert isinstance(gone, Remove)


def test_new_things_at_their_place_stay_where_another_thing_goes_out(furnished_state: SceneState) -> None:
    there, gone = _statements("Two mugs on the dining table in the kitchen, the plate out.", furnished_state)
    assert isinstance(there, Ensure) and there.things.noun == "mug"
    assert isinstance(gone, Remove) and gone.things.noun == "plate"


def test_a_heading_is_passed_over_and_a_place_after_it_read(furnished_state: SceneState) -> None:
    (there,) = _statements("Preparing the workshop: in the kitchen there must be exactly one mug.", furnished_state)
    assert isinstance(there, Ensure) and there.place.rooms is not None and there.place.rooms.words == "kitchen"


@pytest.mark.parametrize("heading", ["Fire hazard: ", ""])
def test_an_amount_at_the_beginning_is_no_place(furnished_state: SceneState, heading: str) -> None:
    (there,) = _statements(f"{heading}At most one mug may remain in the kitchen.", furnished_state)
    assert isinstance(there, Ensure) and (there.things.noun, there.things.amount.kind) == ("mug", "at_most")


@pytest.mark.parametrize("text", ["Mugs out: open the fridge.", "Kitchen, everything out: open the fridge."])
def test_a_heading_that_asks_for_something_is_none(furnished_state: SceneState, text: str) -> None:
    read = read_instruction(text, furnished_state)
    assert read.not_understood or any(isinstance(s, Remove) for s in read.statements)


@pytest.mark.parametrize("verb", ["so does", "and so does", "so shall"])
def test_so_does_what_comes_after(furnished_state: SceneState, verb: str) -> None:
    text = f"Open the fridge. The chairs stay as they are, {verb} the dining table in the kitchen."
    kept = [s.things.noun for s in _statements(text, furnished_state) if isinstance(s, Keep)]
    assert kept == ["chair", "dining table"]


def test_what_keeps_running_is_on(furnished_state: SceneState) -> None:
    first, last = _statements("Switch off the TV. The ceiling lights keep running.", furnished_state)
    assert isinstance(first, SetState) and isinstance(last, SetState)
    assert (first.value, last.value, last.things.noun) == (False, True, "ceiling light")


def test_those_there_are_counted(furnished_state: SceneState) -> None:
    text = "Put three mugs on the dining table in the kitchen, counting the ones already there."
    (there,) = _statements(text, furnished_state)
    assert isinstance(there, Ensure) and there.things.amount.number == 3


def test_in_exchange_for_is_instead_of(furnished_state: SceneState) -> None:
    (found,) = _statements("Put an armchair in the hall in exchange for the first chair.", furnished_state)
    assert isinstance(found, Replace)


def test_neither_more_nor_less_is_exactly(furnished_state: SceneState) -> None:
    (there,) = _statements("I want two mugs on the dining table, not more and not less.", furnished_state)
    assert isinstance(there, Ensure) and there.things.amount.kind == "exactly"


def test_what_stays_in_a_room_is_kept_there(furnished_state: SceneState) -> None:
    told = _statements("Open the fridge. In the kitchen the lights remain as they are.", furnished_state)
    (kept,) = [s for s in told if isinstance(s, Keep)]
    assert kept.things.place is not None and kept.things.place.rooms is not None


def test_the_others_are_those_that_were_not_removed(editor: SceneEditor) -> None:
    report = instruct(editor, "Remove the first chair in the hall. The others stay.")
    assert report.done
    assert len([item for _, item in editor.state.objects() if item.id.startswith("F1/hall/chair")]) == 2


def test_at_once_says_when(furnished_state: SceneState) -> None:
    assert [type(s) for s in _statements("Remove the plate at once, please.", furnished_state)] == [Remove]


@pytest.mark.parametrize(
    "heading",
    [
        "Client meeting at ten in the kitchen",
        "Interview in the kitchen at 2 pm",
        "Kitchen, tomorrow at nine, audit",
        "Partner meeting tomorrow, 8 am, kitchen",
        "Kitchen, ground floor",
        "Training from 9 to 12 in the kitchen downstairs",
        "Board meeting at 14:30 in the kitchen",
    ],
)
def test_a_heading_may_tell_a_time_and_a_storey(furnished_state: SceneState, heading: str) -> None:
    (switched,) = _statements(f"{heading}: ceiling lights off.", furnished_state)
    assert isinstance(switched, SetState) and switched.things.place is not None
    rooms = switched.things.place.rooms
    assert rooms is not None and rooms.words == "kitchen"


def test_a_number_of_things_is_no_time(furnished_state: SceneState) -> None:
    assert read_instruction("Kitchen, ten chairs: open the fridge.", furnished_state).not_understood

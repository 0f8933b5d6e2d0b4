"""Reasons, owners and rooms told around a request; exceptions, half turns and numbers in other words."""

import msgspec
import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import (
    Add,
    Ensure,
    Finish,
    Furnish,
    Mention,
    Move,
    Remove,
    Replace,
    SetState,
    Statement,
    Turn,
)
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return [
        msgspec.structs.replace(statement, quote="")
        for statement in instruction.statements
        if not isinstance(statement, Mention)
    ]


@pytest.mark.parametrize(
    "text",
    [
        "Put a bench in the hall. There is nowhere to wait in there.",
        "There's nowhere to sit in the hall. Put a bench there.",
        "There is no place to rest in the hall, so put a bench in the hall.",
        "The sofa in the hall is Ann's. Put a bench in the hall.",
        "Put a bench in the hall so they can wait.",
    ],
)
def test_a_reason_asks_for_nothing(furnished_state: SceneState, text: str) -> None:
    (added,) = _asked(text, furnished_state)
    assert isinstance(added, Add) and added.things.noun == "bench"


@pytest.mark.parametrize(
    "text",
    ["There is nowhere to wait in the hall.", "It's Ann's.", "There is no chair in the hall, so it can stay open."],
)
def test_a_reason_alone_is_not_understood(editor: SceneEditor, text: str) -> None:
    assert not instruct(editor, text).done


@pytest.mark.parametrize(
    "text",
    [
        "The kitchen can go. Turn it into an office.",
        "We no longer need the kitchen. Make it an office.",
        "The kitchen is no longer used. Convert it into an office.",
        "We stopped cooking so the kitchen can go. Turn it into an office.",
    ],
)
def test_a_room_that_is_given_up_becomes_another(furnished_state: SceneState, text: str) -> None:
    statements = read_instruction(text, furnished_state).statements
    (furnished,) = [s for s in statements if not isinstance(s, Mention)]
    assert isinstance(furnished, Furnish) and furnished.kind == "office"
    told = [s.rooms.words for s in statements if isinstance(s, Mention) and s.rooms is not None]
    assert "kitchen" in [*told, furnished.rooms.words]


@pytest.mark.parametrize(
    "text",
    [
        "Bring one of the chairs down from the hall and put it in the kitchen.",
        "Fetch two chairs up from the hall and leave them in the kitchen.",
    ],
)
def test_what_is_brought_from_somewhere_goes_where_the_next_clause_says(furnished_state: SceneState, text: str) -> None:
    (moved,) = _asked(text, furnished_state)
    assert isinstance(moved, Move) and moved.place.rooms is not None and moved.place.rooms.words == "kitchen"


@pytest.mark.parametrize(
    "text",
    [
        "Get the lights in the kitchen going.",
        "get the lights on in the kitchen",
        "Get the kitchen lights started, guests are coming",
    ],
)
def test_what_is_got_going_is_switched_on(furnished_state: SceneState, text: str) -> None:
    (lit,) = _asked(text, furnished_state)
    assert isinstance(lit, SetState) and (lit.state, lit.value) == ("on", True)


def test_what_is_left_open_is_told_with_its_room(furnished_state: SceneState) -> None:
    (opened,) = _asked("Leave the fridge standing open in the kitchen so it can defrost.", furnished_state)
    assert isinstance(opened, SetState) and opened.value and opened.things.place is not None


@pytest.mark.parametrize(
    "text",
    [
        "Turn the sofa in the hall right around so that it faces the other way.",
        "Turn the sofa in the hall the other way round.",
        "Turn the sofa in the hall all the way around.",
        "Turn the sofa in the hall so it faces the opposite direction.",
    ],
)
def test_a_half_turn(furnished_state: SceneState, text: str) -> None:
    (turned,) = _asked(text, furnished_state)
    assert isinstance(turned, Turn) and turned.degrees == 180.0 and turned.facing is None


def test_around_something_is_no_half_turn(furnished_state: SceneState) -> None:
    assert read_instruction("Turn the chairs in the hall around the sofa.", furnished_state).not_understood


@pytest.mark.parametrize(
    "text", ["I'd love the walls of the kitchen to be a light green.", "We want the kitchen walls painted green."]
)
def test_walls_of_a_wished_colour(furnished_state: SceneState, text: str) -> None:
    (painted,) = _asked(text, furnished_state)
    assert isinstance(painted, Finish) and (painted.part, painted.colour) == ("walls", "green")


def test_rooms_painted_one_after_the_other(furnished_state: SceneState) -> None:
    painted = _asked("Paint private office 1 light blue and the kitchen white.", furnished_state)
    assert [s.colour for s in painted if isinstance(s, Finish)] == ["blue", "white"]


@pytest.mark.parametrize("said", ["half a dozen", "a half dozen", "half dozen"])
def test_half_a_dozen_are_six(furnished_state: SceneState, said: str) -> None:
    (added,) = _asked(f"Set out {said} mugs on the dining table in the kitchen.", furnished_state)
    assert isinstance(added, Add) and added.things.amount.number == 6


@pytest.mark.parametrize(
    "text",
    [
        "We've too many chairs in the hall. Take two of them out.",
        "We have got too many chairs in the hall, take two of them out.",
    ],
)
def test_of_too_many_some_go(furnished_state: SceneState, text: str) -> None:
    (gone,) = _asked(text, furnished_state)
    assert isinstance(gone, Remove) and (gone.things.noun, gone.things.amount.number) == ("chair", 2)


@pytest.mark.parametrize("but", ["except for one", ", apart from one", "but one"])
def test_a_number_excepted_at_the_end(furnished_state: SceneState, but: str) -> None:
    (moved,) = _asked(
        f"Move all chairs in the hall to the kitchen{but if but[0] == ',' else ' ' + but}.", furnished_state
    )
    assert isinstance(moved, Move) and (moved.things.amount.kind, moved.things.amount.number) == ("all_but", 1)


def test_all_that_are_not_there_are_all_but_those_there(furnished_state: SceneState) -> None:
    (gone,) = _asked("Remove all mugs in the kitchen that aren't on the dining table.", furnished_state)
    assert isinstance(gone, Remove) and gone.things.beside


@pytest.mark.parametrize(
    "tail", ["apart from the wall lamp which must stay on", "except the wall lamp, which stays on"]
)
def test_what_is_excepted_and_must_stay_so_is_kept_so(furnished_state: SceneState, tail: str) -> None:
    off, on = _asked(f"Switch off all lights in the kitchen, {tail}.", furnished_state)
    assert isinstance(off, SetState) and not off.value and off.things.beside
    assert isinstance(on, SetState) and on.value and on.things.noun == "wall lamp"


@pytest.mark.parametrize("tail", ["over the weekend", "for the weekend", "during the night"])
def test_for_how_long_is_left_out(furnished_state: SceneState, tail: str) -> None:
    plain = _asked("Switch off the lights in the kitchen.", furnished_state)
    assert _asked(f"Switch off the lights in the kitchen {tail}.", furnished_state) == plain


@pytest.mark.parametrize("tail", ["so that each table has one", "so every table has its own"])
def test_so_that_each_has_one_counts_those_there(furnished_state: SceneState, tail: str) -> None:
    (given,) = _asked(f"Put a mug on each dining table {tail}.", furnished_state)
    assert isinstance(given, Ensure) and given.each


@pytest.mark.parametrize("remark", ["the kitchen has its own", "most of them have theirs already"])
def test_who_has_one_already_gets_no_second(furnished_state: SceneState, remark: str) -> None:
    (given,) = _asked(f"Every kitchen needs a clock; {remark}.", furnished_state)
    assert isinstance(given, Ensure)


def test_and_nothing_else_after_a_removal(furnished_state: SceneState) -> None:
    assert isinstance(_asked("Remove the mug in the kitchen and nothing else.", furnished_state)[0], Remove)
    put = read_instruction("Put a mug on the dining table in the kitchen and nothing else.", furnished_state)
    assert put.not_understood


def test_what_goes_for_something_new_is_replaced(furnished_state: SceneState) -> None:
    (replaced,) = _asked("The sofa in the hall goes for an armchair.", furnished_state)
    assert isinstance(replaced, Replace) and replaced.by.noun == "armchair"
    assert read_instruction("The sofa in the hall goes for the fridge.", furnished_state).not_understood


@pytest.mark.parametrize("said", ["used to be", "stood", "was before"])
def test_where_something_was_is_what_it_came_from(furnished_state: SceneState, said: str) -> None:
    text = f"Move the mug from the dining table to the sofa and put a plate where the mug {said}."
    moved, added = _asked(text, furnished_state)
    assert isinstance(moved, Move) and isinstance(added, Add)
    assert added.place.anchor is not None and added.place.anchor.noun == "dining table"


def test_the_thing_of_the_room_that_was_told_before(editor: SceneEditor) -> None:
    report = instruct(editor, "Move the plate from the kitchen to the hall and put a mug on the dining table.")
    assert report.done and any(name.startswith("F1/kitchen/mug") for name in report.object_ids)


@pytest.mark.parametrize(
    "text",
    [
        "Turn the lights in the hall off and those in the kitchen on.",
        "Switch off the lights in the hall. Those in the kitchen stay on.",
    ],
)
def test_those_elsewhere_are_of_the_same_kind(furnished_state: SceneState, text: str) -> None:
    _, lit = _asked(text, furnished_state)
    assert isinstance(lit, SetState) and lit.value and lit.things.noun == "light" and not lit.things.refers


@pytest.mark.parametrize("where", ["everywhere", "everywhere except the hall", "everywhere but in the hall"])
def test_everywhere_is_in_all_rooms(furnished_state: SceneState, where: str) -> None:
    (off,) = _asked(f"Turn off the lights {where}.", furnished_state)
    assert isinstance(off, SetState) and off.things.place is not None and off.things.place.rooms is not None
    assert off.things.place.rooms.every and bool(off.things.beside) == (where != "everywhere")

"""The check reads statements anew on the scenes before and after, and lets no other change pass."""

import random
from collections.abc import Callable

import msgspec
import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.checking.faults import Step, fault, faults
from mansion_editing.instructions.conversation import context_of
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.run import carry_out
from mansion_editing.instructions.statements import (
    Add,
    Amount,
    Ask,
    Clear,
    Ensure,
    Instruction,
    Keep,
    Mention,
    Move,
    Paint,
    Place,
    Remove,
    Replace,
    Rooms,
    SetState,
    Statement,
    Swap,
    Things,
    Turn,
)
from mansion_editing.state import SceneState
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.scene import SceneObject

HERE = Context()


def copied(state: SceneState) -> SceneState:
    return SceneState(list(state.scenes.values()), state.catalogue)


def everything(state: SceneState) -> list[bytes]:
    return [encode_bytes(item) for _, item in state.objects()]


def the(noun: str, **more: object) -> Things:
    return Things(noun=noun, definite=True, **more)  # type: ignore[arg-type]


def with_change(state: SceneState, name: str, change: Callable[[SceneObject], SceneObject] | None = None) -> SceneState:
    """Return the state with one object changed, or gone."""
    after = copied(state)
    floor, item = after.get(name)
    if change is None:
        after.remove(floor, item)
    else:
        after.replace(floor, item, change(item))
    return after


def test_nothing_done_is_a_fault_where_something_was_asked(furnished_state: SceneState) -> None:
    hall = Place(rooms=Rooms(words="hall"))
    asked: list[Statement] = [
        Add(things=Things(noun="plant"), place=hall),
        Remove(things=the("sofa")),
        Clear(place=Place(relation="on", anchor=the("dining table"), rooms=Rooms(words="kitchen"))),
        Move(things=the("plate"), place=hall),
        Swap(one=the("sofa"), other=the("fridge")),
        Replace(things=the("sofa"), by=Things(noun="armchair")),
        SetState(things=the("fridge"), state="open", value=True),
        Paint(things=the("sofa"), colour="red"),
        Turn(things=the("sofa"), degrees=90.0),
        Ensure(things=Things(noun="chair", plural=True, amount=Amount(number=4)), place=hall),
    ]
    assert [type(one).__name__ for one in asked if not fault(one, furnished_state, copied(furnished_state), HERE)] == []


def test_adding_none_is_a_fault_even_where_none_came(furnished_state: SceneState) -> None:
    none = Add(things=Things(noun="laptop", amount=Amount(kind="none")), place=Place(rooms=Rooms(words="hall")))
    assert "say what is to be removed" in fault(none, furnished_state, copied(furnished_state), HERE)


def test_what_holds_already_needs_nothing(furnished_state: SceneState) -> None:
    hall = Place(rooms=Rooms(words="hall"))
    asked: list[Statement] = [
        Ensure(things=Things(noun="chair", plural=True, amount=Amount(number=3)), place=hall),
        SetState(things=the("fridge"), state="open", value=False),
        Move(things=the("sofa"), place=hall),
        Ask(about="count", things=Things(noun="chair")),
        Mention(),
    ]
    assert [fault(one, furnished_state, copied(furnished_state), HERE) for one in asked] == [""] * len(asked)


def _opened(item: SceneObject) -> SceneObject:
    return msgspec.structs.replace(item, states={**item.states, "open": True})


def _shifted(item: SceneObject) -> SceneObject:
    x, y, z = item.position
    return msgspec.structs.replace(item, position=(x + 0.2, y, z))


@pytest.mark.parametrize(
    "other", [("F1/hall/sofa_1", None), ("F1/hall/chair_2", _shifted), ("F1/kitchen/plate_1", None)]
)
def test_a_change_besides_what_was_asked_is_found(
    furnished_state: SceneState, other: tuple[str, Callable[[SceneObject], SceneObject] | None]
) -> None:
    opening = SetState(things=the("fridge"), state="open", value=True)
    done = with_change(furnished_state, "F1/kitchen/fridge_1", _opened)
    assert fault(opening, furnished_state, done, HERE) == ""
    assert other[0] in fault(opening, furnished_state, with_change(done, *other), HERE)


def test_one_more_removed_than_meant_is_found(furnished_state: SceneState) -> None:
    two = Remove(things=Things(noun="chair", plural=True, amount=Amount(number=2)))
    after = with_change(with_change(furnished_state, "F1/hall/chair_1"), "F1/hall/chair_2")
    assert fault(two, furnished_state, after, HERE) == ""
    assert fault(two, furnished_state, with_change(after, "F1/hall/chair_3"), HERE)


def test_what_shall_stay_is_compared_over_the_whole_instruction(furnished_state: SceneState) -> None:
    after = with_change(furnished_state, "F1/hall/sofa_1")
    keep, remove = Keep(things=the("sofa"), quote="leave the sofa"), Remove(things=the("sofa"))
    steps = [Step(keep, HERE, furnished_state, copied(furnished_state)), Step(remove, HERE, furnished_state, after)]
    (found,) = faults(steps)
    assert found.startswith("leave the sofa: F1/hall/sofa_1")


NOUNS = ("mug", "chair", "sofa", "plate", "fridge", "lamp", "light", "table", "seat", "plant", "book", "", "furniture")
ROOMS = ("kitchen", "hall", "office", "corridor", "room")


def _random_statement(pick: random.Random) -> Statement:
    def things(*, new: bool = False) -> Things:
        kind = pick.choice(["some", "some", "some", "all", "exactly", "at_most", "all_but", "more"])
        number = pick.choice([0, 1, 1, 1, 2, 3])
        return Things(
            noun=pick.choice(NOUNS[:-2] if new else NOUNS),
            amount=Amount(kind="some" if new else kind, number=number),  # type: ignore[arg-type]
            plural=number != 1,
            definite=not new and pick.random() < 0.6,
            colour=pick.choice(["", "", "", "red"]),
            ordinal=pick.choice([0, 0, 0, 1, -1]) if not new else 0,
            place=place() if not new and pick.random() < 0.4 else None,
        )

    def place() -> Place:
        rooms = Rooms(words=pick.choice(ROOMS), every=pick.random() < 0.3, floors=pick.choice([(), (), (1,), (2,)]))
        relation = pick.choice(["", "on", "in", "beside", "left", "near", "under"])
        anchor = Things(noun=pick.choice(NOUNS[:8]), definite=pick.random() < 0.7) if relation else None
        return Place(
            relation=relation,  # type: ignore[arg-type]
            anchor=anchor,
            rooms=rooms if anchor is None or pick.random() < 0.5 else None,
            spot=pick.choice(["", "", "", "wall", "corner"]) if anchor is None else "",  # type: ignore[arg-type]
        )

    made: list[Callable[[], Statement]] = [
        lambda: Add(things=things(new=True), place=place(), each=pick.random() < 0.3),
        lambda: Ensure(things=things(), place=place(), each=pick.random() < 0.3),
        lambda: Remove(things=things()),
        lambda: Clear(place=place(), spare=(things(),) if pick.random() < 0.3 else ()),
        lambda: Move(things=things(), place=place(), or_new=pick.random() < 0.3),
        lambda: Swap(one=things(), other=things()),
        lambda: Replace(things=things(), by=things(new=True)),
        lambda: SetState(things=things(), state=pick.choice(["open", "on"]), value=pick.random() < 0.5),  # type: ignore[arg-type]
        lambda: Paint(things=things(), colour=pick.choice(["red", "blue"])),
        lambda: Turn(things=things(), degrees=pick.choice([90.0, 180.0])),
        lambda: Ask(about=pick.choice(["count", "where", "exists", "what", "state", "colour"]), things=things()),  # type: ignore[arg-type]
    ]
    return pick.choice(made)()


@pytest.mark.parametrize("seed", range(24))
def test_no_statement_changes_what_the_check_does_not_account_for(editor: SceneEditor, seed: int) -> None:
    pick = random.Random(seed)
    for _ in range(5):
        before, objects, context = copied(editor.state), everything(editor.state), context_of(editor)
        statement = _random_statement(pick)
        report = carry_out(editor, Instruction(statements=[statement]), "at random")
        if not report.done or isinstance(statement, Ask):
            assert everything(editor.state) == objects
        else:
            assert fault(statement, before, copied(editor.state), context) == ""
        assert report.message and not any("besides what was asked" in reason for reason in report.failed), report

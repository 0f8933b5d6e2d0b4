"""A number for several pieces of furniture together, and one for each of them."""

import msgspec
import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.meaning.numbers import is_shared_out, of_one_kind
from mansion_editing.instructions.statements import Amount, Place, Things
from mansion_editing.state import SceneState

MUGS = Things(noun="mug", plural=True, amount=Amount(number=3))
TABLES = Things(noun="table", plural=True, definite=True, amount=Amount(number=0))


def test_so_many_on_the_tables_are_so_many_together() -> None:
    assert is_shared_out(MUGS, Place(relation="on", anchor=TABLES), each=False)


@pytest.mark.parametrize(
    ("things", "anchor", "each"),
    [
        (MUGS, TABLES, True),
        (MUGS, msgspec.structs.replace(TABLES, amount=Amount(kind="all", number=0)), False),
        (Things(noun="mug"), TABLES, False),
        (MUGS, Things(noun="table", definite=True), False),
    ],
)
def test_on_each_table_they_are_for_each(things: Things, anchor: Things, each: bool) -> None:
    assert not is_shared_out(things, Place(relation="on", anchor=anchor), each=each)


def test_three_mugs_for_two_tables_are_three(editor: SceneEditor) -> None:
    before = sum(item.category == "plate" for _, item in editor.state.objects())
    assert instruct(editor, "Put three plates on the dining tables.").done
    there = [item for _, item in editor.state.objects() if item.category == "plate"]
    assert len(there) == before + 3
    assert len({item.parent for item in there}) == 2


def test_each_table_gets_its_own(editor: SceneEditor) -> None:
    before = sum(item.category == "plate" for _, item in editor.state.objects())
    assert instruct(editor, "Put two plates on each of the dining tables.").done
    assert sum(item.category == "plate" for _, item in editor.state.objects()) == before + 4


def test_a_number_tells_the_kind(furnished_state: SceneState) -> None:
    items = [item for _, item in furnished_state.objects() if item.category in ("chair", "plate")]
    assert [item.category for item in of_one_kind(items, 3) or []] == ["chair"] * 3
    assert of_one_kind(items, 2) is None


def test_two_kinds_of_that_number_tell_nothing(furnished_state: SceneState) -> None:
    items = [item for _, item in furnished_state.objects() if item.category in ("chair", "mug")]
    assert len(items) == 6 and of_one_kind(items, 3) is None

"""Arrows of notes, which say what goes where."""

import pytest

from mansion_editing.instructions.syntax.marks import without_arrows


@pytest.mark.parametrize(
    ("note", "order"),
    [
        ("lemons: pantry -> kitchen counter", "move the lemons from the pantry to the kitchen counter"),
        ("mug from the sink -> on the shelf", "put the mug from the sink on the shelf"),
        ("filing cabinet => private office", "move the filing cabinet to the private office"),
    ],
)
def test_an_arrow_points_to_where_a_thing_goes(note: str, order: str) -> None:
    assert without_arrows(note) == order


@pytest.mark.parametrize("note", ["lamp -> off", "armchairs -> blue", "chairs 3 -> 4", "put a mug on the table"])
def test_other_arrows_are_left(note: str) -> None:
    assert without_arrows(note) == note

"""Objects change colour and material as new ones get them."""

import pytest

from mansion_editing.state import SceneState
from mansion_editing.tools.painting import paint_object
from mansion_msgs_py.editing.objects import PaintObjectArgs
from mansion_msgs_py.errors import ErrorCode, MansionError

SOFA = "F1/hall/sofa_1"


def test_a_colour_keeps_the_material(state: SceneState) -> None:
    family = state.get(SOFA)[1].material.split("_")[0]
    painted = paint_object(state, PaintObjectArgs(object_id=SOFA, color="crimson"))
    assert painted.material == f"{family}_red" and painted.color == "#b2382f"
    assert state.get(SOFA)[1] == painted


def test_a_material_comes_in_its_natural_colour_or_in_the_one_asked_for(state: SceneState) -> None:
    assert paint_object(state, PaintObjectArgs(object_id=SOFA, material="wooden")).material == "wood_oak"
    both = paint_object(state, PaintObjectArgs(object_id=SOFA, material="leather", color="black"))
    assert both.material == "leather_black"


def test_painting_in_its_own_colour_changes_nothing(state: SceneState) -> None:
    paint_object(state, PaintObjectArgs(object_id=SOFA, color="red"))
    count = len(state.pending)
    paint_object(state, PaintObjectArgs(object_id=SOFA, color="red"))
    assert len(state.pending) == count


@pytest.mark.parametrize("wrong", [{}, {"color": "plaid"}, {"material": "cheese"}])
def test_a_word_that_names_no_paint_is_refused(state: SceneState, wrong: dict[str, str]) -> None:
    with pytest.raises(MansionError) as error:
        paint_object(state, PaintObjectArgs(object_id=SOFA, **wrong))
    assert error.value.code == ErrorCode.INVALID_PAYLOAD and state.pending == []

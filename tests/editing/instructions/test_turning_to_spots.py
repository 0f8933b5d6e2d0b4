"""Things turn to a window or a door of their room, not only to other things."""

import math

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.paraphrases.reading import read_in_other_words
from mansion_editing.instructions.statements import Mention, Turn
from mansion_editing.state import SceneState


@pytest.mark.parametrize(
    "text",
    [
        "Turn the sofa in the hall to the window.",
        "Turn the sofa in the hall so that it faces the window.",
        "The sofa in the hall should look out of the window.",
        "I'd like the sofa in the hall turned towards the window.",
        "Could you turn the sofa in the hall so that whoever sits in it looks out of the window?",
    ],
)
def test_fronts_turn_to_windows(furnished_state: SceneState, text: str) -> None:
    read = read_in_other_words(text, furnished_state)
    assert read.not_understood == []
    (turn,) = [s for s in read.statements if not isinstance(s, Mention)]
    assert isinstance(turn, Turn)
    assert (turn.spot, turn.things.noun, turn.facing) == ("window", "sofa", None)


def test_a_chair_turns_to_the_nearest_door(editor: SceneEditor) -> None:
    report = instruct(editor, "Turn the first chair in the hall to face the door.")
    assert report.done, report.message
    (chair,) = [item for _, item in editor.state.objects() if item.id == "F1/hall/chair_1"]
    doors = [door for door in editor.state.scenes[1].doors if "F1/hall" in door.rooms]
    x, y, _ = chair.position
    front = math.radians(chair.rotation)
    looked_at = min(doors, key=lambda door: math.dist((x, y), _middle(door.segment)))
    dx, dy = _middle(looked_at.segment)[0] - x, _middle(looked_at.segment)[1] - y
    along = (-math.sin(front) * dx + math.cos(front) * dy) / math.hypot(dx, dy)
    assert along > math.cos(math.radians(30.0))


def _middle(segment: tuple[tuple[float, float], tuple[float, float]]) -> tuple[float, float]:
    (x, y), (to_x, to_y) = segment
    return (x + to_x) / 2, (y + to_y) / 2

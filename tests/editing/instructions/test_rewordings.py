"""Set phrases and slips of the pen are read as what they stand for."""

import pytest

from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Clear, Statement
from mansion_editing.state import SceneState


def _bare(text: str, state: SceneState) -> list[Statement]:
    read = read_instruction(text, state)
    assert read.not_understood == []
    return [type(s)(**{f: getattr(s, f) for f in s.__struct_fields__ if f != "quote"}) for s in read.statements]


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("switch of the lamp in the study", "switch off the lamp in the study"),
        ("put a plant in between the sofa and the desk", "put a plant between the sofa and the desk"),
        ("if you could open the fridge", "please open the fridge"),
        ("close the fridge afterwards", "close the fridge"),
        (
            "we would appreciate it if there were a vase on the desk",
            "it would be good if there were a vase on the desk",
        ),
        ("I would be happy if the sofa were in the hall", "it would be good if the sofa were in the hall"),
        ("remove all chairs in the kitchen but one", "remove all but one of the chairs in the kitchen"),
        ("turn the sofa around by 180 degrees", "turn the sofa by 180 degrees"),
        ("under no circumstances remove the sofa", "never remove the sofa"),
        ("on no account remove the sofa", "never remove the sofa"),
        ("get shot of the sofa", "get rid of the sofa"),
        ("Hall: three chairs are too many, cut down to two", "Hall: three chairs are too many, reduce them to two"),
        (
            "remove everything on the desk with the exception of the lamp",
            "remove everything on the desk except for the lamp",
        ),
    ],
)
def test_a_set_phrase_is_read_as_the_plain_one(furnished_state: SceneState, said: str, meant: str) -> None:
    assert _bare(said, furnished_state) == _bare(meant, furnished_state)


def test_top_up_to_a_number_raises_it(furnished_state: SceneState) -> None:
    words = Progress("top them up to four, on the top floor", furnished_state).words
    assert [word.text for word in words] == ["increase", "them", "up", "to", "four", ",", "on", "the", "top", "floor"]


def test_leaving_only_one_thing_clears_the_rest(furnished_state: SceneState) -> None:
    (statement,) = _bare("leave only the lamp on the desk", furnished_state)
    assert isinstance(statement, Clear)
    assert [things.noun for things in statement.spare] == ["lamp"]
    assert statement.place.anchor is not None and statement.place.anchor.noun == "desk"

"""How things shall look or be, without words that oblige."""

import pytest

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.syntax.tagged_words import joined, tagged
from mansion_editing.instructions.syntax.wished_states import with_wished_colour, with_wished_states
from mansion_editing.state import SceneState


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("I would prefer the chair in grey", "the chair should be grey"),
        ("we want the chairs in the hall dark red", "the chairs in the hall should be dark red"),
        ("I want a chair in the hall", "I want a chair in the hall"),
    ],
)
def test_a_colour_is_wished_for(furnished_state: SceneState, text: str, plain: str) -> None:
    lexicon = Lexicon(furnished_state)
    assert joined(with_wished_colour(tagged(text, lexicon), lexicon)) == plain


@pytest.mark.parametrize(
    ("text", "plain"),
    [
        ("Laptop on the table: open and switched on.", "Laptop on the table should be open and switched on."),
        ("Kitchen: remove the mugs.", "Kitchen: remove the mugs."),
    ],
)
def test_states_are_told_after_a_colon(furnished_state: SceneState, text: str, plain: str) -> None:
    assert joined(with_wished_states(tagged(text, Lexicon(furnished_state)))) == plain

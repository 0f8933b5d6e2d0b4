"""Words for colours."""

from mansion_language.colours import COLOUR_WORDS, COLOURS


def test_every_colour_of_a_material_is_a_word_for_itself() -> None:
    assert {name: COLOUR_WORDS[name] for name in COLOURS} == {name: name for name in COLOURS}
    assert set(COLOUR_WORDS.values()) == set(COLOURS)
    assert len(COLOURS) == len(set(COLOURS))

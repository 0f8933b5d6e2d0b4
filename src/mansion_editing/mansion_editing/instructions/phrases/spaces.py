"""Words for spaces that no room is called by: the building as a whole, the room that was mentioned, a storey's noun."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.words import Word, text_at

__all__ = ["end_of_building", "end_of_same_room", "goes_on_with_noun"]

_BUILDINGS: Final = frozenset("building house office school hotel hospital museum home flat apartment clinic".split())


def end_of_building(words: Sequence[Word], at: int, lexicon: Lexicon) -> int:
    """Return the end of ``this three-storey office``, ``the flat``; 0 where the words name a part of it."""
    place = at + 1
    if text_at(words, at) not in ("this", "our", "the", "my"):
        return 0
    told = False
    while place < len(words) and (
        words[place].kind == "number" or text_at(words, place) in ("floor", "whole", "entire")
    ):
        told = True
        place += 1
    said = text_at(words, place)
    plain = said == "building" or ((told or text_at(words, at) == "this") and said in _BUILDINGS)
    alone = not goes_on_with_noun(words, place + 1, lexicon) and not (place < len(words) and words[place].plural)
    return place + 1 if plain or (lexicon.is_building(said) and alone) else 0


def end_of_same_room(words: Sequence[Word], at: int) -> int:
    """Return the end of ``the same room``, ``that floor``; 0 where there is none."""
    place = at
    place += text_at(words, place) in ("the", "that", "this")
    same = text_at(words, place) == "same"
    place += same
    named = text_at(words, place) in ("room", "place")
    said = same or (place > at and words[at].text in ("that", "this"))
    return place + 1 if said and named else 0


def goes_on_with_noun(words: Sequence[Word], at: int, lexicon: Lexicon) -> bool:
    """Whether a storey is only the modifier of a noun ("in the ground floor kitchen", "on the top floor guest bed")."""
    if at >= len(words) or words[at].kind == "mark" or words[at].text in ("on", "in"):
        return False
    if words[at].text == "one":
        return True
    spans = [tuple(word.text for word in words[at : at + count]) for count in (1, 2, 3) if at + count <= len(words)]
    return any(lexicon.is_object(span) or lexicon.is_room(span) for span in spans)

"""Places that no name tells: the building, the room that was mentioned, a noun of a storey, where something stood."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.noun_phrases import noun_phrase
from mansion_editing.instructions.phrases.words import Word, text_at
from mansion_editing.instructions.statements import Amount, Things

__all__ = ["end_of_building", "end_of_same_room", "goes_on_with_noun", "read_former_spot"]

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


_STANDING: Final = (
    ("used", "to", "be"), ("used", "to", "stand"), ("used", "to", "hang"), ("used", "to", "lie"), ("has", "been"),
    ("had", "been"), ("was", "standing"), ("is", "standing"), ("was", "hanging"), ("is", "hanging"), ("was",),
    ("were",), ("is",), ("are",), ("stood",), ("stands",), ("hung",), ("hangs",), ("lay",), ("lies",), ("sat",),
    ("stand",), ("hang",), ("lie",),
)  # fmt: skip
_SPOTS: Final = frozenset(["spot", "place", "position", "location"])
_FORMER: Final = frozenset(["old", "former", "previous", "original"])
_AFTER: Final = frozenset(["now", "before", "previously", "until", "right"])
_LAST: Final = Things(refers="last", definite=True, amount=Amount(number=0))


def read_former_spot(
    words: Sequence[Word], at: int, lexicon: Lexicon, floors: Sequence[int]
) -> tuple[Things, int] | None:
    """Read a place by what stood there; return that and the end, None for other places.

    Parameters
    ----------
    at : int
        Of the preposition, or of ``where``.
    """
    place = at
    while text_at(words, place) in ("to", "in", "into", "on", "at", "onto", "exactly", "just", "right"):
        place += 1
    if place > at:
        own = place < len(words) and words[place].raw in ("its", "their")
        spot = place + 1 + (text_at(words, place + 1) in _FORMER)
        if own and text_at(words, spot) in _SPOTS | {"stead"}:
            return _LAST, spot + 1
        if text_at(words, place) in ("the", "that") and text_at(words, spot) in _SPOTS:
            place = spot + 1
            again = text_at(words, place) == "in" and words[place + 1].raw in ("its", "their")
            if again and text_at(words, place + 2) in _SPOTS:
                return _LAST, place + 3  # "in the spot where it stood" is read as "in the spot in its place"
            if text_at(words, place) == "of" and text_at(words, spot - 1) in _FORMER:
                stood = noun_phrase(words, place + 1, lexicon, floors)
                return None if stood is None or stood.noun.kind == "room" else (stood.things(), stood.end)
    return _stood(words, place, lexicon, floors) if text_at(words, place) == "where" else None


def _stood(words: Sequence[Word], at: int, lexicon: Lexicon, floors: Sequence[int]) -> tuple[Things, int] | None:
    """Read ``where it was``, ``where the cart stands now``."""
    subject = noun_phrase(words, at + 1, lexicon, floors)
    if subject is None or not (subject.definite or subject.refers) or subject.noun.kind == "room":
        return None
    said = next((v for v in _STANDING if tuple(w.raw for w in words[subject.end : subject.end + len(v)]) == v), ())
    end = subject.end + len(said)
    end += text_at(words, end) in _AFTER
    if not said:
        return None
    return (_LAST if subject.refers == "last" and not subject.noun.words else subject.things()), end

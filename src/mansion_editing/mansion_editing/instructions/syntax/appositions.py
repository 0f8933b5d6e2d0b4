"""Words after a thing's name that only tell which or what it is: ``the armchair, the one by the window, ...``."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.syntax.noun_groups import end_of_noun_group
from mansion_editing.instructions.syntax.tagged_words import TaggedWord
from mansion_language.colours import COLOUR_WORDS

__all__ = ["without_appositions"]

_OPENING: Final = frozenset([",", "-", "("])
_ONES: Final = frozenset(["one", "ones"])
_ENDS: Final = frozenset(". ! ? ; , ) - ".split())
_ALIKE: Final = (["the", "same", "as"], ["same", "as"], ["just", "like"], ["just", "as"], ["like"], ["as"])
_GOING: Final = (
    ["go", "with"], ["goes", "with"], ["belong", "to"], ["belongs", "to"], ["come", "with"], ["stand", "around"],
    ["are", "around"], ["stand", "at"], ["are", "at"],
)  # fmt: skip
_METRES: Final = frozenset("m metre metres meter meters cm".split())
_MOST_PLACES: Final = 4


def without_appositions(words: Sequence[TaggedWord]) -> list[TaggedWord]:
    """Return words with what tells which or what a thing is joined to its name, and without what it only is like."""
    steps: tuple[Callable[[list[TaggedWord], int], list[TaggedWord] | None], ...] = (
        _likened, _in_same_colour, _in_place_of_colour, _measured, _going_along, _placed, _coloured,
    )  # fmt: skip
    said = list(words)
    for step in steps:
        at = 1
        while at < len(said):
            found = step(said, at)
            at, said = (at, found) if found is not None else (at + 1, said)
    return said


def _placed(words: list[TaggedWord], at: int) -> list[TaggedWord] | None:
    """Join ``the lamp, the one on the desk, ...`` to ``the lamp on the desk ...``."""
    start = at + 3
    one = [word.text for word in words[at + 1 : start]]
    apposed = words[at].text in _OPENING and len(one) == 2 and one[0] in ("the", "that", "those") and one[1] in _ONES
    if not apposed or words[at - 1].tag != "noun" or start >= len(words) or words[start].tag != "preposition":
        return None
    end = _end_of_places(words, start)
    if end == start or (end < len(words) and words[end].text not in _ENDS):
        return None
    closed = end < len(words) and words[end].text in (",", ")", "-")
    return [*words[:at], *words[start:end], *words[end + closed :]]


def _end_of_places(words: Sequence[TaggedWord], at: int) -> int:
    for _ in range(_MOST_PLACES):
        if at >= len(words) or words[at].tag not in ("preposition", "to"):
            return at
        end = end_of_noun_group(words, at + 1)
        if end == at + 1:
            return at
        at = end
    return at


def _coloured(words: list[TaggedWord], at: int) -> list[TaggedWord] | None:
    """Join ``a rug in the hall, a blue one`` and ``a rug in the hall. Blue, please`` to ``a blue rug in the hall``."""
    start = at + 1 + (at + 1 < len(words) and words[at + 1].text in ("a", "an", "the"))
    end = start
    while end < len(words) and words[end].text in COLOUR_WORDS:
        end += 1
    one = end < len(words) and words[end].text in _ONES
    after = end + one
    while after < len(words) and (words[after].text == "please" or _is_please(words, after)):
        after += 1
    closed = words[after].text if after < len(words) else "."
    if words[at].text not in _OPENING | {"."} or end == start or closed not in _ENDS or closed == ",":
        return None
    sentence = next((k + 1 for k in range(at - 1, -1, -1) if words[k].text in ".!?;"), 0)
    heads = [k for k in range(sentence, at) if words[k].text in ("a", "an", "another", "some")]
    head = heads[-1] if heads else None
    if head is None or head + 1 >= at or any(word.text in COLOUR_WORDS for word in words[head:at]):
        return None
    article = replace(words[head], text="a", raw="a") if words[head].text == "an" else words[head]
    colour = [replace(word, raw=word.text) for word in words[start:end]]
    return [*words[:head], article, *colour, *words[head + 1 : at], *words[after + (closed == ")") :]]


def _in_same_colour(words: list[TaggedWord], at: int) -> list[TaggedWord] | None:
    """Read ``in the same grey as the ones in the hall`` as ``in grey``."""
    said = [word.text for word in words[at : at + 3]]
    if said != ["in", "the", "same"] or at + 4 >= len(words) or words[at + 3].text not in COLOUR_WORDS:
        return None
    after = at + 4 + (words[at + 4].text in ("colour", "color", "shade", "tone"))
    if after >= len(words) or words[after].text not in ("as", "like"):
        return None
    end = next((k for k in range(after, len(words)) if words[k].text in ".!?;,"), len(words))
    return [*words[: at + 1], words[at + 3], *words[end:]]


def _in_place_of_colour(words: list[TaggedWord], at: int) -> list[TaggedWord] | None:
    """Read ``should be red instead of blue`` as ``should be red``."""
    said = [word.text for word in words[at : at + 2]]
    length = 2 if said in (["instead", "of"], ["rather", "than"]) else 1 if said[0] == "not" else 0
    after = at + length
    coloured = length and words[at - 1].text in COLOUR_WORDS and after < len(words)
    if not coloured or words[after].text not in COLOUR_WORDS:
        return None
    ends = after + 1 >= len(words) or words[after + 1].text in _ENDS
    return [*words[:at], *words[after + 1 :]] if ends else None


def _measured(words: list[TaggedWord], at: int) -> list[TaggedWord] | None:
    """Read ``away from the sofa, at least 3 m`` as ``at least 3 m away from the sofa``."""
    if [word.text for word in words[at : at + 2]] != ["away", "from"]:
        return None
    comma = end_of_noun_group(words, at + 2)
    if comma == at + 2 or comma + 4 > len(words) or words[comma].text != ",":
        return None
    start = comma + 1
    number = start + 2 * ([word.text for word in words[start : start + 2]] == ["at", "least"])
    if number + 1 >= len(words) or words[number].tag != "number" or words[number + 1].text not in _METRES:
        return None
    measure = words[start : number + 2]
    least = [] if number > start else [replace(measure[0], text=text, raw=text) for text in ("at", "least")]
    return [*words[:at], *least, *measure, *words[at:comma], *words[number + 2 :]]


def _going_along(words: list[TaggedWord], at: int) -> list[TaggedWord] | None:
    """Read ``one table and the four chairs that go with it`` as ``one table and its four chairs``."""
    said = [word.text for word in words[at : at + 4]]
    along = said[:1] in (["that"], ["which"]) and said[1:3] in _GOING and said[3:] in (["it"], ["them"])
    start = at - 1
    while along and start > 0 and words[start].tag in ("noun", "number", "adjective"):
        start -= 1
    if not along or words[start].text not in ("the", "all"):
        return None
    own = "its" if said[3] == "it" else "their"
    possessive = replace(words[start], text=own, raw=own, tag="possessive")
    return [*words[:start], possessive, *words[start + 1 : at], *words[at + 4 :]]


def _is_please(words: Sequence[TaggedWord], at: int) -> bool:
    return words[at].text == "," and at + 1 < len(words) and words[at + 1].text == "please"


def _likened(words: list[TaggedWord], at: int) -> list[TaggedWord] | None:
    """Leave out ``, same as in room 2`` and ``, like dorms 1 and 3 have``."""
    if words[at].text not in (",", "("):
        return None
    texts = [word.text for word in words[at + 1 : at + 4]]
    like = next((said for said in _ALIKE if texts[: len(said)] == said), None)
    if like is None:
        return None
    start = at + 1 + len(like)
    end = next((k for k in range(start, len(words)) if words[k].text in ".!?;,)"), len(words))
    body = words[start:end]
    bare = body and body[0].tag in ("preposition", "number", "determiner", "possessive", "noun")
    if not bare or any(word.tag == "verb" or word.text in ("one", "ones", "well", "it") for word in body):
        return None
    return [*words[:at], *words[end + (end < len(words) and words[end].text == ")") :]]

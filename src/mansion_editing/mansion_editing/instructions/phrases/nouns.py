"""Nouns with their modifiers."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Final, Literal, TypeAlias

from mansion_editing.instructions.phrases.amounts import PARTS
from mansion_editing.instructions.phrases.lexicon import ANYTHING, HYPERNYMS, Lexicon
from mansion_editing.instructions.phrases.runs import SHADES, SIDES, end_of_run
from mansion_editing.instructions.phrases.words import ADVERBS, PERSONS, STATE_WORDS, VAGUE, Word
from mansion_language.colours import COLOUR_WORDS

__all__ = ["COMPARATIVES", "HOLDERS", "MATERIALS", "SIZE_HINTS", "Noun", "is_comparative", "read_noun"]

MATERIALS: Final = {
    "wooden": "wood", "wood": "wood", "oak": "wood", "metal": "metal", "steel": "metal", "leather": "leather",
    "plastic": "plastic", "marble": "marble", "brick": "brick", "concrete": "concrete", "stone": "stone",
    "ceramic": "ceramic", "parquet": "parquet", "carpet": "carpet", "tile": "tile", "tiled": "tile",
    "fabric": "fabric", "glass": "glass", "velvet": "fabric", "linoleum": "vinyl", "vinyl": "vinyl",
    "terrazzo": "terrazzo", "plaster": "plaster", "wallpaper": "wallpaper", "walnut": "wood", "bamboo": "wood",
    "paint": "paint", "granite": "stone", "laminate": "wood", "hardwood": "wood", "pine": "wood", "rattan": "wood",
    "brass": "metal", "bronze": "metal", "copper": "metal", "chrome": "metal", "aluminium": "metal",
    "aluminum": "metal", "porcelain": "ceramic", "terracotta": "ceramic", "mahogany": "wood", "teak": "wood",
    "birch": "wood", "beech": "wood", "maple": "wood", "plywood": "wood", "timber": "wood", "suede": "leather",
    "woollen": "fabric", "woolen": "fabric",
}  # fmt: skip
"""Words for materials, and the family that a palette has for each."""


HOLDERS: Final = frozenset(
    "cup mug glass bottle can bowl plate jar box bag basket carton pot jug tin tray vase packet loaf slice bunch stack "
    "pile pair piece set couple row group roll".split()
)
"""Words by which what something holds, or is a number of, may be named: a cup of yogurt."""

_COLLECTIONS: Final = frozenset("loaf slice bunch stack pile pair piece set couple row group roll".split())


_OPENING: Final = frozenset(["door", "lid", "drawer"])


_Size: TypeAlias = Literal["", "largest", "smallest", "tallest", "shortest"]
_SIZES: Final[dict[str, _Size]] = {
    "largest": "largest", "biggest": "largest", "smallest": "smallest", "tallest": "tallest", "shortest": "shortest",
}  # fmt: skip


SIZE_HINTS: Final = {
    "small": "small", "little": "small", "tiny": "small", "large": "large", "big": "large", "huge": "large",
    "tall": "tall", "high": "tall", "low": "low", "short": "low", "long": "long",
    "smaller": "smaller", "larger": "larger", "bigger": "larger", "taller": "taller",
    "shorter": "lower", "longer": "longer",
}  # fmt: skip
"""Adjectives of size, by which one of several things is told."""

COMPARATIVES: Final = {"larger": "large", "smaller": "small", "taller": "tall", "lower": "low", "longer": "long"}
"""Those that compare, and what they do so by."""


def is_comparative(hint: str) -> bool:
    """Whether an adjective of size compares."""
    return hint in COMPARATIVES


@dataclass(frozen=True)
class Noun:
    """What the words of a phrase name, without its amount."""

    words: tuple[str, ...]
    kind: Literal["object", "room", "both", "anything"]
    plural: bool = False
    number: str = ""
    owned: str = ""
    colour: str = ""
    material: str = ""
    ordinal: int = 0
    size: _Size = ""
    hints: tuple[str, ...] = ()
    states: dict[str, bool] = field(default_factory=dict)
    unknown: tuple[str, ...] = ()
    floors: tuple[int, ...] = ()
    numbers: tuple[str, ...] = ()


def read_noun(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> tuple[Noun | None, int]:
    """Read modifiers and a noun; the end may come earlier where the noun does."""
    run = list(words[start:end])
    number = ""
    if (len(run) > 1 and (run[-1].kind == "code" or (run[-1].kind == "number" and run[-1].raw.isdecimal()))) or (
        len(run) > 1 and len(run[-1].raw) == 1 and run[-1].capital
    ):
        number, run = run[-1].raw, run[:-1]
    if end < len(words) and words[end].text in ("of", "with") and end + 1 < len(words):
        whole = _of_phrase(words, run, end, lexicon)
        if whole is not None:
            return whole
    if len(run) > 1 and run[-1].text in _OPENING and _opens(run[:-1], lexicon):
        run = run[:-1]
    found = _split(run, lexicon, number)
    if found is not None and found.kind == "object" and number.isdecimal():
        found = replace(found, number="", ordinal=int(number))
    if found is None and number:
        found = _split([*run, words[end - 1]], lexicon, "")
    return found, end


def _opens(before: list[Word], lexicon: Lexicon) -> bool:
    """Whether the words before ``door`` name furniture, and no room that has a door: the fridge door."""
    texts = tuple(word.text for word in before)
    rooms = any(lexicon.is_own_room(texts[first:]) for first in range(len(texts)))
    return lexicon.is_object(texts[-1:]) and not (rooms and not lexicon.is_called(texts[-1:]))


def _of_phrase(words: Sequence[Word], run: list[Word], of: int, lexicon: Lexicon) -> tuple[Noun | None, int] | None:
    """Read ``cup of coffee``, ``vase of flowers``, ``bottle of wine``, ``pile of books``."""
    head = run[-1]
    stop = end_of_run(words, of + 1, lexicon)
    tail = [w for w in words[of + 1 : stop] if w.text not in VAGUE]
    if not tail or len(tail) > 2:
        return None
    inner = tuple(w.text for w in tail)
    if head.text not in HOLDERS:
        whole = words[of].text == "of" and lexicon.is_called((head.text, *inner))  # "chest of drawers"
        named = (head.text, *inner)
        return (_split(run[:-1], lexicon, "", noun=named, plural=head.plural), stop) if whole else None
    for order in ((*inner, head.text), (*inner, *(("bottle",) if head.text == "bottle" else ()))):
        single = head.text not in _COLLECTIONS or lexicon.is_called(order)
        if len(order) > 1 and lexicon.is_object(order) and single:
            modified = _split(run[:-1], lexicon, "", noun=order, plural=head.plural)
            return modified, stop
    if words[of].text == "with":
        return None
    if head.text in _COLLECTIONS and lexicon.is_object(inner):
        return _split([*run[:-1], *tail], lexicon, ""), stop
    if lexicon.is_object((head.text,)):
        return _split(run, lexicon, ""), stop
    return None


def _split(
    run: list[Word], lexicon: Lexicon, number: str, noun: tuple[str, ...] | None = None, *, plural: bool = False
) -> Noun | None:
    """Divide words into modifiers and the longest ending that is a noun."""
    if noun is not None:
        return _modified(run, noun, "object", number, lexicon, plural=plural)
    texts = [w.text for w in run]
    of_room = _after_room(texts, lexicon)
    if of_room:
        kind: Literal["object", "room", "both", "anything"] = "object"
        return _modified(run[:of_room], tuple(texts[of_room:]), kind, number, lexicon, plural=run[-1].plural)
    for first in range(len(run)):
        span = tuple(texts[first:])
        if len(span) > 1 and (span[-1] == "one" or (span[0] in COLOUR_WORDS and lexicon.is_object(span[1:]))):
            continue
        if len(span) == 1 and span[0] in COLOUR_WORDS and not lexicon.is_called(span):
            continue  # "a chair, green" asks for no vegetable
        own, room, thing = lexicon.is_own_room(span), lexicon.is_room(span), lexicon.is_object(span)
        if span[-1] in PERSONS and not own:
            continue
        if (number and room) or (own and not lexicon.is_called(span)):
            thing = False
        if thing and len(span) > 1 and lexicon.is_called(span) and lexicon.is_called(span[-1:]):
            room = own = room and lexicon.is_room(span[-1:])  # a reception desk is a desk
        if not (room or thing) and not (len(span) == 1 and (span[0] in ANYTHING or span[0] in HYPERNYMS)):
            continue
        kind = "object"
        if span[0] in ANYTHING and not thing:
            kind = "anything"
        elif room and thing:
            kind = "both"
        elif own or room:
            kind = "room"
        return _modified(run[:first], span, kind, number, lexicon, plural=run[-1].plural)
    if run and run[-1].text == "one":
        return _modified(run[:-1], ("one",), "anything", "", lexicon, plural=run[-1].plural)
    return None


def _after_room(texts: Sequence[str], lexicon: Lexicon) -> int:
    """Return where a thing's name begins after a room's of several words: ``home office desk``; 0 where it does not."""
    for at in range(len(texts) - 1, 1, -1):
        room = next((k for k in range(at - 1) if lexicon.is_own_room(tuple(texts[k:at]))), None)
        whole = room is not None and lexicon.is_object(tuple(texts[room:]))
        if room is not None and not whole and lexicon.is_object(tuple(texts[at:])):
            return at
    return 0


def _modified(
    before: list[Word],
    noun: tuple[str, ...],
    kind: Literal["object", "room", "both", "anything"],
    number: str,
    lexicon: Lexicon,
    *,
    plural: bool,
) -> Noun:
    """Read the modifiers before a noun."""
    colour = material = ""
    ordinal = 0
    size: _Size = ""
    hints: list[str] = []
    states: dict[str, bool] = {}
    rest: list[Word] = []
    for at, word in enumerate(before):
        numeral = word.kind == "number" and at + 1 < len(before) and before[at + 1].text in PARTS
        if numeral or (at > 0 and word.text in PARTS and before[at - 1].kind == "number"):
            continue
        if word.text in COLOUR_WORDS:
            colour = COLOUR_WORDS[word.text]
        elif word.text in MATERIALS and kind != "room":
            material = MATERIALS[word.text]
        elif word.kind == "ordinal":
            ordinal = int(word.value)
        elif word.text == "last":
            ordinal = -1
        elif word.text in _SIZES:
            size = _SIZES[word.text]
        elif word.text in STATE_WORDS and kind != "room":
            name, value = STATE_WORDS[word.text]
            states[name] = value
        elif word.text in SIZE_HINTS:
            hints.append(SIZE_HINTS[word.text])
        elif word.text in SIDES:
            hints.append(word.text)
        elif word.text in VAGUE or word.text in SHADES or word.text in ADVERBS or word.text.endswith("ly"):
            continue
        else:
            rest.append(word)
    sized = next((hint for hint in hints if kind == "object" and lexicon.is_called((hint, *noun))), "")
    if sized:
        noun = (sized, *noun)  # "sixteen big paintings" are large ones
        hints.remove(sized)
    if noun == ("one",):
        words = (*(w.text for w in rest), "one")
        return Noun(words, kind, plural, number, "", colour, material, ordinal, size, tuple(hints), states)
    owned, unknown = _owner(rest, lexicon)
    if kind == "room" and owned and not lexicon.is_own_room((*owned.split(), *noun)) and lexicon.is_own_room(noun):
        owned = ""
    marks = tuple(hints)
    return Noun(noun, kind, plural, number, owned, colour, material, ordinal, size, marks, states, unknown)


def _owner(rest: list[Word], lexicon: Lexicon) -> tuple[str, tuple[str, ...]]:
    """Return the room or the owner that the words before a noun name, and those that name nothing."""
    if not rest:
        return "", ()
    texts = tuple(w.text for w in rest)
    if lexicon.is_room(texts) or rest[-1].genitive:
        return " ".join(texts), ()
    if len(texts) > 1 and texts[-1].isdecimal() and lexicon.is_room(texts[:-1]):
        return " ".join(texts), ()
    if lexicon.is_object(texts) and lexicon.is_here(" ".join(texts)):
        return " ".join(texts), ()
    if texts == ("bedside",):
        return "bed", ()
    if len(texts) == 1 and lexicon.is_own_room((*texts, "room")):
        return f"{texts[0]} room", ()  # "every guest bed"
    if lexicon.begins_room(texts):
        return " ".join(texts), ()  # "the master bed"
    return "", tuple(w.raw for w in rest)

"""Noun phrases: an amount, modifiers and a noun for things or rooms."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Final, Literal, TypeAlias

from mansion_editing.instructions.lexicon import ANYTHING, HYPERNYMS, Lexicon
from mansion_editing.instructions.statements import Amount, AmountKind, Place, Rooms, Things
from mansion_editing.instructions.storeys import read_storeys
from mansion_editing.instructions.verb_words import BY_WORDS
from mansion_editing.instructions.words import (
    ADVERBS,
    BE,
    CONJUNCTIONS,
    DETERMINERS,
    HAVE,
    MODALS,
    NEED,
    PARTICIPLES_OF_REST,
    PERSONS,
    PREPOSITIONS,
    STATE_WORDS,
    VAGUE,
    Word,
)
from mansion_language.colours import COLOUR_WORDS

__all__ = ["MATERIALS", "Noun", "NounPhrase", "noun_phrase", "read_amount"]

MATERIALS: Final = {
    "wooden": "wood", "wood": "wood", "oak": "wood", "metal": "metal", "steel": "metal", "leather": "leather",
    "plastic": "plastic", "marble": "marble", "brick": "brick", "concrete": "concrete", "stone": "stone",
    "ceramic": "ceramic", "parquet": "parquet", "carpet": "carpet", "tile": "tile", "tiled": "tile",
    "fabric": "fabric", "glass": "glass", "velvet": "fabric", "linoleum": "vinyl", "vinyl": "vinyl",
    "terrazzo": "terrazzo", "plaster": "plaster", "wallpaper": "wallpaper", "walnut": "wood", "bamboo": "wood",
    "paint": "paint", "granite": "stone", "laminate": "wood", "hardwood": "wood", "pine": "wood", "rattan": "wood",
}  # fmt: skip
"""Words for materials, and the family that a palette has for each."""

_SHADES: Final = frozenset(["light", "dark", "pale", "bright", "deep", "pastel", "soft"])
_ARTICLES_AFTER_VERBS: Final = frozenset(
    "a an the all every each two three four five six some another my our its".split()
)
_HOLDERS: Final = frozenset(
    "cup mug glass bottle can bowl plate jar box bag basket carton pot jug tin tray vase packet loaf slice bunch stack "
    "pile pair piece set couple row group".split()
)
_COLLECTIONS: Final = frozenset("loaf slice bunch stack pile pair piece set couple row group".split())
_OPENING: Final = frozenset(["door", "lid"])
_SIZES: Final[dict[str, Literal["largest", "smallest"]]] = {
    "largest": "largest", "biggest": "largest", "smallest": "smallest",
}  # fmt: skip
_ENDS_RUN: Final = (
    PREPOSITIONS | CONJUNCTIONS | BE | MODALS | (HAVE - {"hold"}) | (NEED - {"miss"}) | PARTICIPLES_OF_REST
    | frozenset(["not", "there", "please", "to", "thanks", "it", "them", "i", "we", "you", "do", "than", "because",
                 "since", "switched", "turned", "powered", "painted", "removed", "gone", "moved", "replaced", "empty",
                 "emptied", "cleared", "closed", "shut", "opened", "open", "running", "lit", "already", "too",
                 "instead", "again", "somewhere", "anywhere", "here", "now", "also", "as", "if", "so", "that",
                 "facing", "exactly", "which", "upstairs", "downstairs", "each", "both", "all", "every", "ajar",
                 "deleted", "reachable", "accessible", "where", "belong", "sit", "lie", "apart", "rather", "wherever", "whose",
                 "whatever", "died", "broke", "fell", "short", "away", "does", "did", "look", "seem", "each", "anew", "afresh", "want", "visible", "than", "go", "disappear", "vanish", "put", "exceed", "trade", "untouched", "alone", "starting", "next", "either"])
)  # fmt: skip
_MAY_BE_NOUN: Final = frozenset(
    ["light", "open", "left", "right", "front", "stand", "set", "middle", "dark", "present", "sitting", "waiting",
     "standing", "living"]
)


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
    size: Literal["", "largest", "smallest"] = ""
    states: dict[str, bool] = field(default_factory=dict)
    unknown: tuple[str, ...] = ()
    floors: tuple[int, ...] = ()


@dataclass(frozen=True)
class NounPhrase:
    """A noun phrase and its end.

    Attributes
    ----------
    end : int
        Place in the words after it.
    each : bool
        Every one on its own ("each desk").
    """

    noun: Noun
    amount: Amount
    definite: bool
    start: int
    end: int
    each: bool = False
    refers: Literal["", "last", "others"] = ""

    @property
    def plural(self) -> bool:
        """Whether several are meant."""
        return self.noun.plural or self.amount.number > 1 or self.amount.kind in ("all", "all_but")

    def things(self) -> Things:
        """Return the phrase as a description of objects."""
        noun = self.noun
        return Things(
            noun="" if noun.kind == "anything" else " ".join((*noun.words, *filter(None, [noun.number]))),
            amount=self.amount,
            definite=self.definite,
            plural=self.noun.plural and not (self.amount.number == 1 and self.amount.kind in ("some", "more")),
            colour=noun.colour,
            material=noun.material,
            states=dict(noun.states),
            ordinal=noun.ordinal,
            size=noun.size,
            refers=self.refers,
            owned=noun.owned,
            place=Place(rooms=Rooms(floors=noun.floors)) if noun.floors else None,
        )

    def rooms(self) -> Rooms:
        """Return the phrase as a description of rooms."""
        noun = self.noun
        words = " ".join((*filter(None, [noun.owned]), *noun.words, *filter(None, [noun.number])))
        words = "" if words == "room" else words
        several = noun.plural or self.each or self.amount.kind == "all"
        return Rooms(
            words=words,
            floors=noun.floors,
            every=several and self.amount.kind in ("some", "all"),
            number=self.amount.number if noun.plural and self.amount.number > 1 else 0,
            ordinal=noun.ordinal,
            size=noun.size,
        )


Amounted: TypeAlias = tuple[Amount, bool, bool, int]
"""Amount, whether the phrase is definite, whether every one is meant on its own, and the place after the words."""


_PARTS: Final = frozenset(
    "seat seater person drawer door piece tier legged leg floor burner arm door shelf panel".split()
)


def _is_compound(words: Sequence[Word], at: int) -> bool:
    """Whether a number only tells of a part, as in ``three-seat sofa``."""
    return (
        at + 2 < len(words)
        and words[at + 1].text in _PARTS
        and words[at].end + 1 == words[at + 1].start
        and not words[at + 1].plural
        and words[at + 2].kind == "word"
        and words[at + 2].text not in PREPOSITIONS
    )


def _number(words: Sequence[Word], at: int) -> int | None:
    if at >= len(words) or _is_compound(words, at):
        return None
    word = words[at]
    if word.kind == "number" and word.value == int(word.value):
        return int(word.value)
    return {"few": 3, "several": 3}.get(word.text)


def _text(words: Sequence[Word], at: int) -> str:
    return words[at].text if 0 <= at < len(words) else ""


_PHRASES: Final[tuple[tuple[tuple[str, ...], AmountKind], ...]] = (
    (("at", "least"), "at_least"), (("no", "less", "than"), "at_least"), (("no", "fewer", "than"), "at_least"),
    (("minimum",), "at_least"), (("min",), "at_least"), (("not", "less", "than"), "at_least"),
    (("at", "most"), "at_most"), (("no", "more", "than"), "at_most"), (("not", "more", "than"), "at_most"),
    (("up", "to"), "at_most"), (("maximum",), "at_most"), (("max",), "at_most"), (("a", "maximum", "of"), "at_most"),
    (("a", "total", "of"), "exactly"), (("exactly",), "exactly"), (("only",), "exactly"), (("just",), "exactly"),
    (("precisely",), "exactly"),
)  # fmt: skip
_MORE: Final = frozenset(["more", "additional", "extra", "further", "other", "another"])


def read_amount(words: Sequence[Word], at: int) -> Amounted:
    """Read the amount that a noun phrase begins with: articles, numbers and quantifiers."""
    for phrase, kind in _PHRASES:
        if tuple(w.text for w in words[at : at + len(phrase)]) == phrase:
            place = at + len(phrase)
            place += _text(words, place) == "the"
            number = _number(words, place)
            if number is None and _text(words, place) in ("a", "an"):
                number = 1
            if number is not None:
                return Amount(kind=kind, number=number), False, False, place + 1
    first = _text(words, at)
    number = _number(words, at)
    if first == "half" or (first in ("every", "each") and at + 1 < len(words) and words[at + 1].kind == "ordinal"):
        return Amount(number=0), False, False, len(words)  # no share of things can be asked for
    if first in ("all", "both", "every", "each", "everything", "any", "either"):
        return _all(words, at)
    if first in ("no", "none", "neither") or (first == "not" and _text(words, at + 1) in ("a", "any", "one")):
        place = at + 1 + (first == "not")
        place += _text(words, place) == "single"
        while _text(words, place) in ("of", "the", "any"):
            place += 1
        return Amount(kind="none", number=0), False, False, place
    if first == "another":
        number = _number(words, at + 1)
        return Amount(kind="more", number=number or 1), False, False, at + 1 + (number is not None)
    if first in ("a", "an"):
        return _indefinite(words, at)
    if first in ("more", "additional", "extra", "further") and _text(words, at + 1) not in ("than", ""):
        return Amount(kind="more", number=2), False, False, at + 1
    if number is not None and words[at].text not in ("double", "twin", "triple", "single"):
        return _counted(words, at, number, definite=False)
    if first in DETERMINERS:
        return _definite(words, at)
    return Amount(number=0), False, False, at


def _all(words: Sequence[Word], at: int) -> Amounted:
    first = words[at].text
    place = at + 1
    if first in ("all", "everything") and _text(words, place) in ("but", "except"):
        number = _number(words, place + 1) or (1 if _text(words, place + 1) in ("a", "an") else None)
        if number is not None:
            place += 2
            while _text(words, place) in ("of", "the", "these", "those"):
                place += 1
            whole = _number(words, place)
            return Amount(kind="all_but", number=number, of=whole or 0), True, False, place + (whole is not None)
    if first == "everything":
        return Amount(kind="all", number=0), True, False, at
    if _text(words, place) == "single" or _text(words, place) == "one":
        place += 1
    while _text(words, place) in ("of", "the", "these", "those", "my", "our", "your", "their"):
        place += 1
    if first == "either":
        return Amount(kind="some", number=1), False, False, place
    if first == "any":
        return Amount(kind="all", number=0), False, False, place
    number = _number(words, place)
    if number is not None and words[place].kind == "number":
        place += 1
    else:
        number = 2 if first == "both" else 0
    return Amount(kind="all", number=number, of=number), True, first in ("each", "every", "both"), place


def _indefinite(words: Sequence[Word], at: int) -> Amounted:
    place = at + 1
    if _text(words, place) in ("couple", "pair", "few", "dozen", "single") or _number(words, place):
        number = _number(words, place) or 1
        place += 1
        scale = _number(words, place)
        if scale is not None and words[place].kind == "number":
            number, place = number * scale, place + 1
        more = _text(words, place) in ("more", "additional", "extra", "further")
        place += more
        place += _text(words, place) == "of"
        if _text(words, place) in ("the", "these", "those"):
            place += 1
            whole = _number(words, place)
            return Amount(number=number, of=whole or 0), False, False, place + (whole is not None)
        return Amount(kind="more" if more else "some", number=number), False, False, place
    if _text(words, place) in ("additional", "extra", "further", "second", "third"):
        return Amount(kind="more", number=1), False, False, place + 1
    return Amount(number=1), False, False, place


def _counted(words: Sequence[Word], at: int, number: int, *, definite: bool) -> Amounted:
    place = at + 1
    if _text(words, place) == "of" and _text(words, place + 1) in ("the", "these", "those", "them", "my", "our"):
        place += 1 if _text(words, place + 1) == "them" else 2
        whole = _number(words, place)
        return Amount(number=number, of=whole or 0), False, False, place + (whole is not None)
    if _text(words, place) in ("more", "additional", "extra", "further"):
        return Amount(kind="more", number=number), definite, False, place + 1
    if _text(words, place) == "other" and not definite:
        return Amount(kind="more", number=number), definite, False, place + 1
    place += _text(words, place) == "x"
    if _text(words, place) == "(" and _number(words, place + 1) == number and _text(words, place + 2) == ")":
        place += 3
    return Amount(number=number), definite, False, place


def _definite(words: Sequence[Word], at: int) -> Amounted:
    first = words[at].text
    place = at + 1
    if first in ("some", "such", "enough"):
        more = _text(words, place) == "more"
        return Amount(kind="more", number=2) if more else Amount(number=0), False, False, place + more
    definite = True
    number = _number(words, place)
    if number is not None and words[place].text not in ("double", "twin", "triple", "single", "couple", "pair"):
        amount, _, _, place = _counted(words, place, number, definite=True)
        return amount, definite, False, place
    return Amount(number=0), definite, False, place


def noun_phrase(words: Sequence[Word], at: int, lexicon: Lexicon, floors: Sequence[int]) -> NounPhrase | None:
    """Read the noun phrase at a place; None where there is none.

    Parameters
    ----------
    floors : sequence of int
        Those of the building.
    """
    start = at
    while _text(words, at) in ADVERBS and _text(words, at) not in ("only", "just", "exactly", "back", "first", "next"):
        at += 1
    if _text(words, at) in ("only", "just") and _text(words, at + 1) in DETERMINERS:
        at += 1
    if at < len(words) and words[at].kind == "id":
        noun = Noun((words[at].raw,), "object")
        return NounPhrase(noun, Amount(number=1), True, start, at + 1)
    if tuple(w.text for w in words[at : at + 3]) == ("every", "single", "one"):
        return None
    whatever = _whatever(words, at)
    if whatever is not None:
        return whatever
    amount, definite, each, place = read_amount(words, at)
    if _text(words, place) in ("it", "them", "they", "those", "these") and place <= at + 2:
        noun = Noun((), "anything", plural=words[place].text != "it")
        return NounPhrase(noun, amount, True, start, place + 1, refers="last")
    if place == at + 1 and words[at].text in ("this", "that", "these", "those", "both", "another", "all", "each"):
        bare = place >= len(words) or not words[place].text[:1].isalpha() or words[place].text in _ENDS_RUN
        if bare and _text(words, place) != "with":
            noun = Noun((), "anything", plural=words[at].text in ("these", "those", "both", "all"))
            return NounPhrase(noun, amount, True, start, place, refers="last")
    if _text(words, place) in ("other", "rest", "remaining", "remainder"):
        others = _others(words, at, place, amount, lexicon, floors)
        if others is not None:
            return others
    storeys: tuple[int, ...] = ()
    level = read_storeys(words, place, floors)
    if level is not None and not level[1] and _end_of_run(words, level[2], lexicon) > level[2]:
        storeys, place = level[0], level[2]
    end = _end_of_run(words, place, lexicon)
    if end == place:
        return _bare_amount(words, start, place, amount)
    found, end = _noun(words, place, end, lexicon)
    if found is None:
        return None
    if _text(words, end) in ("more", "less", "fewer") and amount.kind == "some" and amount.number and not definite:
        kind: AmountKind = "more" if words[end].text == "more" else "fewer"
        return NounPhrase(replace(found, floors=storeys), Amount(kind=kind, number=amount.number), False, start, end + 1)
    count = _number_after(words, end)
    if count is not None and amount.number in (0, 1) and not definite:
        amount, end = Amount(number=count[0]), count[1]
    if amount.number == 0 and amount.kind == "some" and not definite and not found.plural:
        amount = Amount(number=1)
    noun = replace(found, floors=storeys)
    return NounPhrase(noun, amount, definite, start, end, each=each)


def _whatever(words: Sequence[Word], at: int) -> NounPhrase | None:
    """Read ``whatever stands open``, ``everything that is on``."""
    place = at + 1
    if _text(words, at) not in ("whatever", "everything", "anything", "all"):
        return None
    place += _text(words, place) in ("that", "which")
    if _text(words, place) not in ("is", "are", "stand", "remain", "stay"):
        return None
    place += 1
    place += _text(words, place) in ("still", "switched", "turned", "left", "currently")
    if _text(words, place) not in STATE_WORDS:
        return None
    name, value = STATE_WORDS[_text(words, place)]
    if name == "on" and place + 1 < len(words) and words[place + 1].text in ("the", "a", "my"):
        return None
    noun = Noun((), "anything", plural=True, states={name: value})
    return NounPhrase(noun, Amount(kind="all", number=0), True, at, place + 1)


def _bare_amount(words: Sequence[Word], start: int, place: int, amount: Amount) -> NounPhrase | None:
    """Read an amount without a noun: ``one more``, ``two``, ``none``."""
    counted = place > start and (amount.kind == "more" or words[place - 1].kind == "number")
    if not counted:
        return None
    return NounPhrase(Noun((), "anything"), amount, amount.of > 0, start, place, refers="last")


def _number_after(words: Sequence[Word], at: int) -> tuple[int, int] | None:
    """Read ``x3``, ``(4)``, ``, three of them`` after a noun."""
    if _text(words, at) == "x" and _number(words, at + 1) is not None:
        return int(words[at + 1].value), at + 2
    if _text(words, at) == "(" and _number(words, at + 1) is not None and _text(words, at + 2) == ")":
        return int(words[at + 1].value), at + 3
    place = at + (_text(words, at) == ",")
    number = _number(words, place)
    if number is not None and _text(words, place + 1) == "of" and _text(words, place + 2) in ("them", "those", "these"):
        return number, place + 3
    return None


def _others(
    words: Sequence[Word], start: int, place: int, amount: Amount, lexicon: Lexicon, floors: Sequence[int]
) -> NounPhrase | None:
    """Read ``the other two chairs``, ``the others``, ``the rest of the mugs``, ``the remaining desk``."""
    end = place + 1
    if _text(words, end) == "one":
        end += 1
    number = _number(words, end)
    if number is not None:
        amount, end = Amount(number=number), end + 1
    while _text(words, end) in ("of", "the"):
        end += 1
    stop = _end_of_run(words, end, lexicon)
    plural = words[place].plural or words[place].text in ("rest", "remaining", "remainder") or (number or 0) > 1
    if stop == end:
        kind: AmountKind = "all" if plural and number is None else amount.kind
        noun = Noun((), "anything", plural=plural)
        return NounPhrase(noun, Amount(kind=kind, number=amount.number), True, start, end, refers="others")
    found, stop = _noun(words, end, stop, lexicon)
    if found is None:
        return None
    if number is None and found.plural:
        amount = Amount(kind="all", number=0)
    return NounPhrase(found, amount, True, start, stop, refers="others")


def _end_of_run(words: Sequence[Word], at: int, lexicon: Lexicon) -> int:
    """Return where the words that may make up a noun with its modifiers end."""
    end = at
    while end < len(words):
        word = words[end]
        text = word.text
        if word.kind in ("mark", "unit") or (word.kind == "level"):
            break
        if word.kind == "number" and _is_compound(words, end):
            end += 2
            continue
        if word.text == "one" and end > at and _is_last_of_run(words, end, at, lexicon):
            return end + 1
        if word.kind == "number" and end > at and not _names_number(words, end, lexicon, at):
            if word.text not in ("double", "twin", "triple", "single"):
                break
        if text == "can" and end > at and lexicon.is_object((words[end - 1].text, "can")):
            end += 1
            continue
        if end == at and text in ("empty", "free", "clear", "closed") and _starts_noun(words, end + 1, end + 1, lexicon):
            end += 1
            continue
        if text in _ENDS_RUN and not (end > at and word.genitive):
            if not (text in _MAY_BE_NOUN and _starts_noun(words, end, at, lexicon)):
                break
        if text in DETERMINERS and end >= at and text != "own":
            break
        if text == "other" and _text(words, end + 1) == "than":
            break
        if end > at and text in ("more", "less", "fewer", "itself", "themselves"):
            break
        if end > at and text in ("turn", "switch") and _text(words, end + 1) in ("on", "off"):
            break
        if end > at and (text,) in BY_WORDS and end + 1 < len(words) and words[end + 1].text in _ARTICLES_AFTER_VERBS:
            break
        if end > at and _is_colour_after(words, end, at, lexicon):
            break
        end += 1
        if word.genitive and end < len(words) and words[end].text in PREPOSITIONS:
            break
    return end


def _is_colour_after(words: Sequence[Word], end: int, at: int, lexicon: Lexicon) -> bool:
    """Whether a colour stands after the noun that takes it: ``make the sofa dark red``."""
    shaded = words[end].text in _SHADES and end + 1 < len(words) and words[end + 1].text in COLOUR_WORDS
    if not (shaded or words[end].text in COLOUR_WORDS):
        return False
    before = tuple(w.text for w in words[at:end])
    named = any(lexicon.is_object(before[k:]) or lexicon.is_room(before[k:]) for k in range(len(before)))
    last = end + 1 + shaded
    return named and (last >= len(words) or not lexicon.is_object((words[last].text,)))


def _starts_noun(words: Sequence[Word], end: int, at: int, lexicon: Lexicon) -> bool:
    """Whether a word that often ends a phrase belongs to it: a ceiling light, a front door, an open office."""
    text = words[end].text
    for first in range(max(at, end - 2), end + 1):
        for last in range(end + 1, min(len(words), end + 3) + 1):
            span = tuple(w.text for w in words[first:last])
            if span == (text,) and text != "light":
                continue
            if lexicon.is_object(span) or lexicon.is_own_room(span) or (len(span) > 1 and lexicon.is_room(span)):
                return True
    return text == "open" and end == at and end + 1 < len(words) and lexicon.is_object((words[end + 1].text,))


def _is_last_of_run(words: Sequence[Word], end: int, at: int, lexicon: Lexicon) -> bool:
    """Whether ``one`` stands for a noun ("the red one"), and does not begin the next phrase ("the sofa one more")."""
    before = tuple(w.text for w in words[at:end])
    named = any(lexicon.is_object(before[k:]) or lexicon.is_room(before[k:]) for k in range(len(before)))
    return not named and not _starts_noun(words, end + 1, end + 1, lexicon)


def _names_number(words: Sequence[Word], end: int, lexicon: Lexicon, at: int) -> bool:
    """Whether a number belongs to the noun before it ("bedroom 3")."""
    word = words[end]
    if not (word.raw.isdecimal() or word.kind == "code"):
        return False
    before = tuple(w.text for w in words[at:end])
    rooms = any(lexicon.is_room(before[k:]) or lexicon.is_object(before[k:]) for k in range(len(before)))
    following = words[end + 1] if end + 1 < len(words) else None
    own = any(lexicon.is_room(before[k:]) for k in range(len(before)))
    counts = following is not None and (following.kind == "unit" or lexicon.is_object((following.text,)))
    ends = own or following is None or following.kind == "mark" or following.text in PREPOSITIONS
    return rooms and ends and not counts


def _noun(words: Sequence[Word], start: int, end: int, lexicon: Lexicon) -> tuple[Noun | None, int]:
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
    if len(run) > 1 and run[-1].text in _OPENING and lexicon.is_object(tuple(w.text for w in run[-2:-1])):
        run = run[:-1]
    found = _split(run, lexicon, number)
    if found is not None and found.kind == "object" and number.isdecimal():
        found = replace(found, number="", ordinal=int(number))
    if found is None and number:
        found = _split([*run, words[end - 1]], lexicon, "")
    return found, end


def _of_phrase(words: Sequence[Word], run: list[Word], of: int, lexicon: Lexicon) -> tuple[Noun | None, int] | None:
    """Read ``cup of coffee``, ``vase of flowers``, ``bottle of wine``, ``pile of books``."""
    head = run[-1]
    if head.text not in _HOLDERS:
        return None
    stop = _end_of_run(words, of + 1, lexicon)
    tail = [w for w in words[of + 1 : stop] if w.text not in VAGUE]
    if not tail or len(tail) > 2:
        return None
    inner = tuple(w.text for w in tail)
    for order in ((*inner, head.text), (*inner, *(("bottle",) if head.text == "bottle" else ()))):
        if len(order) > 1 and lexicon.is_object(order) and head.text not in _COLLECTIONS:
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
    for first in range(len(run)):
        span = tuple(texts[first:])
        if len(span) > 1 and span[0] in COLOUR_WORDS and lexicon.is_object(span[1:]):
            continue
        own, room, thing = lexicon.is_own_room(span), lexicon.is_room(span), lexicon.is_object(span)
        if span[-1] in PERSONS and not own:
            continue
        if (number and room) or (own and not lexicon.is_called(span)):
            thing = False
        if not (room or thing) and not (len(span) == 1 and (span[0] in ANYTHING or span[0] in HYPERNYMS)):
            continue
        kind: Literal["object", "room", "both", "anything"] = "object"
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
    size: Literal["", "largest", "smallest"] = ""
    states: dict[str, bool] = {}
    rest: list[Word] = []
    for at, word in enumerate(before):
        numeral = word.kind == "number" and at + 1 < len(before) and before[at + 1].text in _PARTS
        if numeral or (at > 0 and word.text in _PARTS and before[at - 1].kind == "number"):
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
        elif word.text in VAGUE or word.text in _SHADES or word.text in ADVERBS or word.text.endswith("ly"):
            continue
        else:
            rest.append(word)
    if noun == ("one",):
        return Noun((*(w.text for w in rest), "one"), kind, plural, number, "", colour, material, ordinal, size, states)
    owned, unknown = _owner(rest, lexicon)
    if kind == "room" and owned and not lexicon.is_own_room((*owned.split(), *noun)) and lexicon.is_own_room(noun):
        owned = ""
    return Noun(noun, kind, plural, number, owned, colour, material, ordinal, size, states, unknown)


def _owner(rest: list[Word], lexicon: Lexicon) -> tuple[str, tuple[str, ...]]:
    """Return the room or the owner that the words before a noun name, and those that name nothing."""
    if not rest:
        return "", ()
    texts = tuple(w.text for w in rest)
    if lexicon.is_room(texts) or rest[-1].genitive:
        return " ".join(texts), ()
    if len(texts) > 1 and texts[-1].isdecimal() and lexicon.is_room(texts[:-1]):
        return " ".join(texts), ()
    if lexicon.is_object(texts):
        return " ".join(texts), ()
    return "", tuple(w.raw for w in rest)

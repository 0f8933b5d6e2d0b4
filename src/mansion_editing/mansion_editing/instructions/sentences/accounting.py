"""What of an instruction no statement carries out: numbers, negations, nouns, colours, and tableware for each chair."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Final

import msgspec

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.nouns import MATERIALS
from mansion_editing.instructions.phrases.runs import SHADES
from mansion_editing.instructions.phrases.verb_words import VERB_WORDS
from mansion_editing.instructions.phrases.words import FUNCTION_WORDS, VAGUE, Word, text_at
from mansion_editing.instructions.statements import (
    Add,
    Ask,
    Clear,
    Ensure,
    Finish,
    Forbid,
    History,
    Keep,
    Mention,
    Move,
    Reach,
    Remove,
    Rename,
    Replace,
    SetState,
    Statement,
    Swap,
    When,
)
from mansion_language.colours import COLOUR_WORDS
from mansion_language.inflection import singular

__all__ = ["brought_after_moving", "brought_beside_empty", "laid_on_seats", "unaccounted"]

_EMPTY: Final = re.compile(r"\b(?:is|are|looks?)(?: almost| nearly| quite| completely| still)? empty\b")
_BROUGHT_IN: Final = re.compile(r"\b(?:comes?|goes|brought|bring|put) in\b", re.IGNORECASE)
_NEGATIONS: Final = frozenset("not no never neither nor none without".split())
_DENYING: Final = (Remove, Clear, Forbid, Keep, SetState, Ask, Reach, Swap, Replace)
"""Statements that a negation may stand in: what goes or stays, or a state that is the other one."""

_LIMITING: Final = frozenset(["none", "at_most", "at_least", "exactly", "all_but"])
_ALTERNATIVES: Final = frozenset(["or", "either", "whichever"])
_WHOLE: Final = frozenset("each every both".split())
_EVERYBODY: Final = frozenset("everybody everyone".split())
_LEAST_SEVERAL: Final = 2
_SPOTS: Final = frozenset("wall corner window door".split())
_NEAR_SPOTS: Final = frozenset("opposite by at near beside against next in to".split())
_PLACING: Final = (Add, Ensure, Move)
_SUBJECTS: Final = frozenset("the our my room guest bedroom meeting classroom".split())
"""What ``only`` tells apart from others that were given something before."""
_BEFORE_ROOMS: Final = frozenset("the our my in from to into of".split())
_OTHERS: Final = frozenset("other others rest remaining remainder".split())
_OF_ANY_OF_THEM: Final = (Remove, Clear, Forbid, Keep, Ask)
"""Statements in which things joined by "or" are all meant."""


@dataclass(frozen=True)
class _Told:
    """What statements hold: the words of their texts, their numbers, and the kinds of their amounts."""

    words: frozenset[str]
    numbers: frozenset[float]
    kinds: frozenset[str]
    flags: frozenset[str]


def unaccounted(text: str, words: Sequence[Word], statements: Sequence[Statement], lexicon: Lexicon) -> list[str]:
    """Return the quotes of statements that leave out what their words say, each with the word.

    Parameters
    ----------
    text : str
        The instruction.
    words : sequence of Word
        Its words.
    """
    out: list[str] = []
    for quote, group in _by_quote([s.then if isinstance(s, When) else s for s in statements]):
        said = _words_of(text, words, quote)
        left = [] if any(isinstance(s, Rename | History) for s in group) else _left_out(said, group, lexicon)
        out += [f"{word.raw} (in {quote!r})" for word in left[:1]]
    return list(dict.fromkeys(out))


def _by_quote(statements: Sequence[Statement]) -> Iterator[tuple[str, list[Statement]]]:
    told = [s for s in statements if s.quote and not isinstance(s, Mention | Ask)]
    for quote in dict.fromkeys(s.quote for s in told):
        yield quote, [s for s in told if s.quote in quote or quote in s.quote]


def _words_of(text: str, words: Sequence[Word], quote: str) -> list[Word]:
    start = text.find(quote)
    out: list[Word] = []
    within = False
    for word in words:
        if not start <= word.start < start + len(quote):
            continue
        within = (within or word.text in ("if", "unless")) and word.text != ","
        out += [] if within else [word]
    return out


def _left_out(said: Sequence[Word], group: Sequence[Statement], lexicon: Lexicon) -> list[Word]:
    told = _told(group)
    return [word for at, word in enumerate(said) if _is_left_out(said, at, group, told, lexicon)]


def _is_left_out(said: Sequence[Word], at: int, group: Sequence[Statement], told: _Told, lexicon: Lexicon) -> bool:
    word = said[at]
    text = word.text
    if text in told.words or word.raw in told.words:
        return False
    if text == "two" and any(isinstance(s, Swap) for s in group):
        return False
    if word.kind in ("number", "ordinal"):
        return text != "one" and word.value not in told.numbers and not _is_part(said, at)
    if text in _NEGATIONS:
        further = text_at(said, at + 1) in ("further", "farther", "more") and "within" in told.flags
        return not (
            further or told.kinds & _LIMITING or "outside" in told.flags or any(isinstance(s, _DENYING) for s in group)
        )
    if text == "only" and text_at(said, at - 1) in ("", ",", "and", "but"):
        return text_at(said, at + 1) in _SUBJECTS and all(isinstance(s, Add) for s in group)
    if text in _ALTERNATIVES:
        if text == "either" and text_at(said, at + 1) == "side":
            return False
        limit = text_at(said, at + 1) in ("more", "fewer", "less") and told.kinds & {"at_least", "at_most"}
        return not limit and not all(isinstance(s, _OF_ANY_OF_THEM) or _is_none(s) for s in group)
    if text == "half":
        return "half" not in told.kinds and 0.5 not in told.numbers and 180.0 not in told.numbers
    if text in _WHOLE:
        several = told.flags & {"each", "every"} or told.kinds & {"all", "all_but", "none", "half"}
        switched = all(isinstance(s, SetState) for s in group)
        if text == "both" and switched and text_at(said, at + 1) not in ("", "of", ",") and said[at + 1].plural:
            return not (2.0 in told.numbers or len(group) > 1)  # "both loudspeakers" are two, and not all there are
        return not (several or (text == "both" and 2.0 in told.numbers) or len(group) > 1)
    if text in _EVERYBODY and text_at(said, at - 1) == "for" and any(isinstance(s, _PLACING) for s in group):
        return not told.flags & {"each", "every"} and max(told.numbers, default=0) < _LEAST_SEVERAL
    if text in _OTHERS:
        turned = text_at(said, at + 1) in ("way", "direction") and 180.0 in told.numbers
        return not turned and not (
            told.flags & {"others", "spare"} or told.kinds & {"all_but", "more", "exactly", "at_most", "half"}
        )
    if text in COLOUR_WORDS:
        return COLOUR_WORDS[text] not in told.words and text not in SHADES
    if text in ("off", "open", "closed", "shut") and word.kind == "word":
        return not (
            told.flags & {"states"}
            or any(isinstance(s, SetState | Remove | Clear | Move | Keep | Forbid) for s in group)
        )
    if text in _SPOTS and text_at(said, at - 1) in ("the", "a") and any(isinstance(s, _PLACING) for s in group):
        before = {word.text for word in said[max(0, at - 3) : at]}
        following = text_at(said, at + 1)
        part = following in ("of", "to", "between") or lexicon.is_object((text, following))
        return bool(before & _NEAR_SPOTS) and not part and not lexicon.is_object((text_at(said, at - 1), text))
    return _is_lost_room(said, at, told, lexicon) or _is_lost_noun(said, at, group, lexicon)


def _is_lost_room(said: Sequence[Word], at: int, told: _Told, lexicon: Lexicon) -> bool:
    """Whether a room of the building is named of which no statement has a word: ``the desk from the study``."""
    for length in (3, 2, 1):
        span = tuple(word.text for word in said[at : at + length])
        if len(span) == length and lexicon.is_own_room(span) and text_at(said, at - 1) in _BEFORE_ROOMS:
            return not told.words & {word for word in span if word != "room"}
    return False


def _is_part(said: Sequence[Word], at: int) -> bool:
    """Whether a number belongs to a noun or a measure of it: a three-seat sofa, a 60-cm shelf."""
    return at + 1 < len(said) and (said[at + 1].kind == "unit" or said[at].end + 1 == said[at + 1].start)


def _is_none(statement: Statement) -> bool:
    return isinstance(statement, Ensure) and statement.things.amount.kind in ("none", "at_most")


def _is_lost_noun(said: Sequence[Word], at: int, group: Sequence[Statement], lexicon: Lexicon) -> bool:
    text = said[at].text
    if said[at].kind != "word" or text in FUNCTION_WORDS or text in VAGUE or text in MATERIALS or text in VERB_WORDS:
        return False
    held = "of" in (text_at(said, at - 1), text_at(said, at + 1))
    if held or any(isinstance(s, Finish | Reach) for s in group):
        return False
    return lexicon.is_called((text,)) and not lexicon.is_own_room((text,))


def _told(group: Sequence[Statement]) -> _Told:
    words: set[str] = set()
    numbers: set[float] = set()
    kinds: set[str] = set()
    flags: set[str] = set()

    def note(name: str, value: Any) -> None:
        if isinstance(value, bool):
            flags.update([name] if value else [])
        elif isinstance(value, str):
            words.update(re.findall(r"[a-z]+|\d+", value.lower()))
            numbers.update(float(part) for part in re.findall(r"\d+", value))
            kinds.update([value] if name == "kind" else [])
            flags.update([value] if name == "refers" else [])
        elif isinstance(value, int | float):
            numbers.update([float(value), abs(float(value))])
            flags.update([name] if name == "within" and value else [])
        elif isinstance(value, dict):
            flags.update([name] if value else [])
        elif isinstance(value, tuple | list):
            flags.update(["spare"] if value and name in ("spare", "beside") else [])
            for part in value:
                note(name, part)
        elif isinstance(value, msgspec.Struct):
            for field in value.__struct_fields__:
                if field != "quote":
                    note(field, getattr(value, field))

    for statement in group:
        note("", statement)
    return _Told(frozenset(words), frozenset(numbers), frozenset(kinds), frozenset(flags))


_TABLEWARE: Final = frozenset("plate fork knife spoon glass bowl cup mug napkin saucer placemat cutlery".split())
_FOR_EACH: Final = re.compile(r"\b(for (each|every|all)|per) ", re.IGNORECASE)
_SEATS: Final = frozenset("chair stool seat armchair bench".split())


def laid_on_seats(statements: Sequence[Statement]) -> list[str]:
    """Return the words by which tableware would come onto seats: which table is meant is not told."""
    return [
        one.quote
        for one in statements
        if isinstance(one, Add | Ensure)
        and one.place.anchor is not None
        and one.place.anchor.each
        and _FOR_EACH.search(one.quote)
        and one.things.noun.split()[-1:] != []
        and one.things.noun.split()[-1] in _TABLEWARE
        and one.place.anchor.noun.split()[-1:] != []
        and one.place.anchor.noun.split()[-1] in _SEATS
    ]


def brought_beside_empty(statements: Sequence[Statement], lexicon: Lexicon) -> list[str]:
    """Return what comes to a room after words that what holds things is empty: whether it goes in there is not told."""
    told = ""
    for statement in statements:
        if isinstance(statement, Mention):
            told = statement.quote.lower() if _EMPTY.search(statement.quote) else told
        elif told and isinstance(statement, Add | Ensure) and statement.place.anchor is None:
            holds = any(lexicon.encloses((singular(word),)) for word in re.findall(r"[a-z]+", told))
            return [statement.quote] if holds else []
        else:
            return []
    return []


def brought_after_moving(statements: Sequence[Statement]) -> list[str]:
    """Return what ``comes in`` after something went to another room: into which of the two is not told."""
    acting = [s for s in statements if not isinstance(s, Mention | Keep)]
    found: list[str] = []
    for before, one in pairwise(acting):
        away = isinstance(before, Move) and before.place.rooms is not None and bool(before.place.rooms.words)
        rooms = one.place.rooms if isinstance(one, Add | Ensure) and one.place.anchor is None else None
        if away and rooms is not None and rooms.same and not rooms.words and _BROUGHT_IN.search(one.quote):
            found.append(one.quote)
    return found

"""Where the words that may make up a noun with its modifiers end."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.amounts import is_compound
from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.verb_words import BY_WORDS
from mansion_editing.instructions.phrases.words import (
    BE,
    CONJUNCTIONS,
    DETERMINERS,
    HAVE,
    MODALS,
    NEED,
    PARTICIPLES_OF_REST,
    PREPOSITIONS,
    VAGUE,
    Word,
    text_at,
)
from mansion_language.colours import COLOUR_WORDS

__all__ = ["ENDS_RUN", "SHADES", "SIDES", "end_of_run"]

SHADES: Final = frozenset(["light", "dark", "pale", "bright", "deep", "pastel", "soft"])


SIDES: Final = frozenset(["left", "right"])
"""Words before a noun by which one of two things is told."""


_ARTICLES_AFTER_VERBS: Final = frozenset(
    "a an the all both every each two three four five six some another my our its".split()
)


ENDS_RUN: Final = (
    PREPOSITIONS | CONJUNCTIONS | BE | MODALS | (HAVE - {"hold"}) | (NEED - {"miss"}) | PARTICIPLES_OF_REST
    | frozenset(
        "not there please to thanks it them i we you she he they do than because since switched turned powered "
        "painted removed gone moved taken brought carried replaced empty emptied cleared closed shut opened open "
        "running lit already too instead again "
        "somewhere anywhere everywhere here now also as if so that facing exactly which upstairs downstairs each both "
        "all every "
        "ajar deleted reachable accessible where belong sit lie apart rather wherever whose whatever died broke fell "
        "about nearest closest furthest farthest short away does did come look seem feel "
        "sound appear begin anew afresh want visible go disappear vanish put exceed trade untouched "
        "alone starting next either if unless half closer nearer further farther forward forwards backward backwards "
        "wobble squeak smell leak flicker rattle creak stink drip "
        "unhindered unimpeded unobstructed undisturbed "
        "keep become suffice before after when while until today tonight tomorrow yesterday anyway though asap yet"
        .split()
    )
)  # fmt: skip


_BECOMING: Final = ("turn", "into")


_MAY_BE_NOUN: Final = frozenset(
    "light open left right front stand set middle dark present sitting waiting standing hanging living"
    " accessible".split()
)


def end_of_run(words: Sequence[Word], at: int, lexicon: Lexicon) -> int:
    """Return where the words that may make up a noun with its modifiers end."""
    end = at
    while end < len(words):
        word = words[end]
        text = word.text
        if word.kind in ("mark", "unit") or (word.kind == "level"):
            break
        if end > at and word.kind == "number" and _ends_before_verb(words, end, at, lexicon):
            return end + 1
        if word.kind == "number" and is_compound(words, end):
            end += 2
            continue
        if word.text == "one" and end > at and _is_last_of_run(words, end, at, lexicon):
            return end + 1
        counted = word.kind == "number" and word.text not in ("double", "twin", "triple", "single")
        if counted and end > at and not _names_number(words, end, lexicon, at):
            break
        tin = (end > at and lexicon.is_object((words[end - 1].text, "can"))) or text_at(words, end + 1) == "of"
        if text == "can" and tin:
            end += 1
            continue
        bare = end == at and text in ("empty", "free", "clear", "closed", "round")
        bare = bare or (text == "round" and all(before.text in VAGUE for before in words[at:end]))
        thing = bare and text == "round" and lexicon.is_object((text_at(words, end + 1),))
        if thing or (bare and _starts_noun(words, end + 1, end + 1, lexicon)):
            end += 1
            continue
        ending = text in ENDS_RUN and not (end > at and word.genitive)
        if ending and end > at and _is_within_name(words, end, at, lexicon):
            end += 1
            continue
        if text in SIDES and end == at and text_at(words, at - 1) in DETERMINERS and _named_next(words, end, lexicon):
            end += 1
            continue
        if ending and not (text in _MAY_BE_NOUN and _starts_noun(words, end, at, lexicon)):
            break
        if text in DETERMINERS and end >= at and text != "own":
            break
        if text == "other" and text_at(words, end + 1) == "than":
            break
        if end > at and text in ("more", "less", "fewer", "itself", "themselves"):
            break
        if end > at and text == "back" and text_at(words, end + 1) in PREPOSITIONS | {""}:
            break
        if end > at and text.endswith("ly") and _is_named(words, at, end, lexicon):
            break
        following = text_at(words, end + 1)
        particle = text in ("turn", "switch") and following in ("on", "off")
        if end > at and (particle or (text, following) == _BECOMING):
            break
        if end > at and (text,) in BY_WORDS and end + 1 < len(words) and words[end + 1].text in _ARTICLES_AFTER_VERBS:
            break
        if end > at and _is_colour_after(words, end, at, lexicon):
            break
        end += 1
        if word.genitive and end < len(words) and words[end].text in PREPOSITIONS:
            break
    return end


def _named_next(words: Sequence[Word], at: int, lexicon: Lexicon) -> bool:
    """Whether a thing is named right after a word, or meant by ``one``."""
    return (
        text_at(words, at + 1) in ("one", "hand")
        or _starts_noun(words, at + 1, at + 1, lexicon)
        or lexicon.is_object((text_at(words, at + 1),))
    )


def _is_within_name(words: Sequence[Word], end: int, at: int, lexicon: Lexicon) -> bool:
    """Whether a preposition or joint stands within a name: ``the walk-in closet``, ``the lost-and-found office``."""
    starts, ends = range(max(at, end - 2), end), range(end + 2, min(len(words), end + 3) + 1)
    spans = (tuple(word.text for word in words[first:last]) for first in starts for last in ends)
    return any(lexicon.is_own_room(span) or lexicon.is_called(span) for span in spans)


def _is_named(words: Sequence[Word], at: int, end: int, lexicon: Lexicon) -> bool:
    """Whether the last of some words name an object or a room."""
    before = tuple(w.text for w in words[at:end])
    return any(lexicon.is_object(before[k:]) or lexicon.is_room(before[k:]) for k in range(len(before)))


def _is_colour_after(words: Sequence[Word], end: int, at: int, lexicon: Lexicon) -> bool:
    """Whether a colour stands after the noun that takes it: ``make the sofa dark red``."""
    shaded = words[end].text in SHADES and end + 1 < len(words) and words[end + 1].text in COLOUR_WORDS
    if not (shaded or words[end].text in COLOUR_WORDS):
        return False
    last = end + 1 + shaded
    return _is_named(words, at, end, lexicon) and (last >= len(words) or not lexicon.is_object((words[last].text,)))


def _starts_noun(words: Sequence[Word], end: int, at: int, lexicon: Lexicon) -> bool:
    """Whether a word that often ends a phrase belongs to it: a ceiling light, a front door, an open office."""
    if end >= len(words):
        return False
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
    named = words[end - 1].text not in COLOUR_WORDS and _is_named(words, at, end, lexicon)
    return not named and not _starts_noun(words, end + 1, end + 1, lexicon)


def _ends_before_verb(words: Sequence[Word], end: int, at: int, lexicon: Lexicon) -> bool:
    """Whether the number of a room is followed by a verb with its object: ``in bedroom 1 switch on both lamps``."""
    before = tuple(w.text for w in words[at:end])
    room = words[end].raw.isdecimal() and any(lexicon.is_room(before[k:]) for k in range(len(before)))
    following = text_at(words, end + 2)
    return room and (text_at(words, end + 1),) in BY_WORDS and following in (DETERMINERS | PREPOSITIONS)


def _names_number(words: Sequence[Word], end: int, lexicon: Lexicon, at: int) -> bool:
    """Whether a number belongs to the noun before it ("bedroom 3")."""
    word = words[end]
    if not (word.raw.isdecimal() or word.kind == "code"):
        return False
    before = tuple(w.text for w in words[at:end])
    rooms = any(lexicon.is_room(before[k:]) or lexicon.is_object(before[k:]) for k in range(len(before)))
    following = words[end + 1] if end + 1 < len(words) else None
    own = any(lexicon.is_room(before[k:]) for k in range(len(before)))
    called = own and text_at(words, at - 1) == "the" and lexicon.is_own_room((*before, word.raw))
    if called and following is not None and lexicon.is_object((following.text,)):
        return True  # "the bedroom 2 dresser"
    shaded = text_at(words, end + 1) in SHADES and text_at(words, end + 2) in COLOUR_WORDS
    counts = following is not None and (following.kind == "unit" or lexicon.is_object((following.text,)))
    counts = counts and not shaded
    ends = own or following is None or following.kind == "mark" or following.text in PREPOSITIONS
    return rooms and ends and not counts

"""Noun groups and what follows them: where they end, and the finite verb that they are the subject of."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.syntax.tagged_words import TaggedWord

__all__ = ["end_of_complements", "end_of_noun_group", "finite_verb_after"]

_BEFORE_NOUNS: Final = frozenset(["determiner", "possessive", "number", "adjective"])
_ALONE: Final = frozenset(["pronoun", "somebody", "number"])
_WITHIN: Final = frozenset(["noun", "adjective", "number"])
_ADDING: Final = frozenset("which who along together including with".split())
"""Words that begin an addition between commas: ``the desk, along with its chair, ...``."""
_BETWEEN_NUMBERS: Final = frozenset(["to", "and", "or", ",", "-", "–", "&"])
_MOST_STEPS: Final = 40


def end_of_noun_group(words: Sequence[TaggedWord], at: int) -> int:
    """Return the end of the noun group at a place, without what is attached to it; the place where there is none."""
    start = at
    if _tag(words, at) == "adverb" and _text(words, at) in ("only", "just", "even", "almost", "about"):
        at += 1
    first = at
    while _tag(words, at) in _BEFORE_NOUNS or (at > first and _text(words, at) in ("very", "other", "of")):
        if _text(words, at) == "of" and _tag(words, at - 1) not in ("number", "determiner"):
            break
        at += 1
    named = at
    while _tag(words, at) in _WITHIN or _is_before_noun(words, at):
        if at > named and _text(words, at) == "one":
            break  # "the storage room one"
        at += 1
    if at > named:
        at = _end_of_numbers(words, at)
        joined = _text(words, at) == "'" or _text(words, at - 1).endswith(("'s", "s'"))
        return end_of_noun_group(words, at) if joined and _tag(words, at) in _BEFORE_NOUNS | _WITHIN else at
    if at > first and _tag(words, at) in ("pronoun", "somebody"):
        return at + 1  # "all of them"
    if at > first and _tag(words, at - 1) in ("number", "adjective", "determiner"):
        return at
    if _tag(words, at) in _ALONE:
        return at + 1
    return start


def _end_of_numbers(words: Sequence[TaggedWord], at: int) -> int:
    """Return the end of ``rooms 1 to 4``, ``rooms 2, 3 and 5`` whose first number ends at a place."""
    numbered = _tag(words, at - 2) == "noun" and _text(words, at - 1).isdecimal()
    while numbered and _text(words, at) in _BETWEEN_NUMBERS and _text(words, at + 1).isdecimal():
        if _tag(words, at + 2) == "noun":
            break  # "room 4 and 2 chairs"
        at += 2
    return at


def _is_before_noun(words: Sequence[TaggedWord], at: int) -> bool:
    """Whether a participle stands within a noun group: ``the framed picture``, ``the moving boxes``."""
    if at >= len(words) or words[at].form not in ("participle", "gerund", "past"):
        return False
    return _tag(words, at + 1) == "noun" and _tag(words, at - 1) in _BEFORE_NOUNS


def finite_verb_after(words: Sequence[TaggedWord], at: int) -> int | None:
    """Return the place of the finite verb of which the noun group at a place is the subject; None for no such verb."""
    start = at
    at = end_of_noun_group(words, at)
    if at == start:
        return None
    for _ in range(_MOST_STEPS):
        if at >= len(words):
            return None
        word = words[at]
        if word.is_finite and not (word.form == "base" and words[at - 1].tag == "mark"):
            return at
        following = _after_attachment(words, at)
        if following <= at:
            return None
        at = following
    return None


def _after_attachment(words: Sequence[TaggedWord], at: int) -> int:
    """Return the place after what is attached to a noun group at its end; the place where nothing is."""
    word = words[at]
    if word.tag in ("preposition", "to") or (word.tag == "joint" and word.text in ("and", "or")):
        end = end_of_noun_group(words, at + 1)
        here = word.tag == "preposition" and _text(words, at + 1) in ("here", "there")  # "nobody up here"
        return end if end > at + 1 else at + 2 if here else at
    following = words[at + 1] if at + 1 < len(words) else None
    if word.text == "," and following is not None and following.text in _ADDING:
        comma = next((k for k in range(at + 2, len(words)) if words[k].text == ","), None)
        return at if comma is None else comma + 1
    if word.text == ",":
        end = end_of_noun_group(words, at + 1)
        listed = end > at + 1 and end < len(words) and (words[end].text in (",", "and"))
        return end if listed and words[at + 1].tag in _BEFORE_NOUNS | {"noun"} else at
    if word.tag == "relative":
        return _end_of_relative(words, at + 1)
    if word.tag == "somebody" and word.text not in ("me", "us", "him"):
        return _end_of_relative(words, at)
    if word.tag == "verb" and word.form in ("participle", "gerund"):
        return end_of_complements(words, at + 1)
    return at + 1 if word.tag in ("adverb", "not") and word.text != "too" else at


def _end_of_relative(words: Sequence[TaggedWord], at: int) -> int:
    """Return the end of a relative clause from after its pronoun on."""
    subject = at if at < len(words) and words[at].is_finite else end_of_noun_group(words, at)
    verb = subject
    while verb < len(words) and words[verb].tag in ("adverb", "not"):
        verb += 1
    if verb >= len(words) or not words[verb].is_finite:
        return at
    while verb < len(words) and (words[verb].tag in ("verb", "be", "have", "do", "modal", "not", "adverb")):
        if words[verb].is_finite and verb > subject and words[verb - 1].tag in ("verb", "adverb"):
            break
        verb += 1
    return end_of_complements(words, verb)


def end_of_complements(words: Sequence[TaggedWord], at: int) -> int:
    """Return the end of the objects, places and adverbs that follow a verb."""
    while at < len(words):
        word = words[at]
        if word.tag in ("preposition", "to"):
            end = end_of_noun_group(words, at + 1)
            at = end if end > at + 1 else at + 1
        elif word.tag in ("adverb", "not", "adjective"):
            at += 1
        else:
            end = end_of_noun_group(words, at)
            if end == at or word.tag == "somebody":
                return at
            at = end
    return at


def _tag(words: Sequence[TaggedWord], at: int) -> str:
    return words[at].tag if 0 <= at < len(words) else ""


def _text(words: Sequence[TaggedWord], at: int) -> str:
    return words[at].text if 0 <= at < len(words) else ""

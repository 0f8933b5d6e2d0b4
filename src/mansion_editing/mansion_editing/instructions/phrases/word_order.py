"""Sentences in an uncommon order, put in the usual one: ``Between A and B I want a door``, ``The hall I mean``."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.words import (
    DETERMINERS,
    FUNCTION_WORDS,
    SENTENCE_ENDS,
    Word,
    next_mark,
    text_at,
    with_leading_marks,
)

__all__ = ["in_usual_order"]

_DOORS: Final = frozenset("door doorway opening passage".split())
_BEFORE_DOORS: Final = frozenset("i we there please add make build create put install could can".split())
"""Words that begin what is asked for after the two rooms of a door."""
_AFTER_DOORS: Final = frozenset(("", "so", "please", "because", "for", "and", "as", "since"))
_MEANING: Final = frozenset("mean meant".split())
_SUMS: Final = (("the", "lot"), ("all", "of", "it"), ("the", "whole", "lot"), ("everything",), ("all", "of", "them"))
"""What a list ends with that names all there is."""
_EMPTYING: Final = frozenset("clear empty clean".split())
_LONGEST_NAME: Final = 5
_LYING: Final = frozenset("left lying standing on in".split())
_RESTING: Final = frozenset("hangs stands lies sits hang stand lie sit".split())
_ADDING: Final = frozenset("add install".split())


def in_usual_order(words: Sequence[Word]) -> list[Word]:
    """Return words with sentences of an uncommon order in the usual one; what is moved keeps the whole's place."""
    out: list[Word] = []
    for sentence in with_leading_marks(words):
        for reads in _READINGS:
            sentence = reads(sentence)
        if any(word.text not in SENTENCE_ENDS for word in out):
            sentence = _as_correction(sentence)
        out += sentence
    return out


def _door_first(words: list[Word]) -> list[Word]:
    """Return ``I want a door between A and B`` for ``Between A and B I want a door``."""
    start = _after_mark(words)
    if text_at(words, start) != "between":
        return words
    begin = next((k for k in range(start + 4, len(words)) if words[k].text in _BEFORE_DOORS), len(words))
    door = next((k for k in range(begin, len(words)) if words[k].text in _DOORS or words[k].kind == "mark"), len(words))
    rooms = words[start : begin - (text_at(words, begin - 1) == ",")]
    joined = any(word.text == "and" for word in rooms) and not any(word.kind == "mark" for word in rooms)
    following = text_at(words, door + 1)
    ends = following in _AFTER_DOORS or words[door + 1].kind == "mark"
    if text_at(words, door) not in _DOORS or not ends or not joined:
        return words
    return [*words[:start], *_over(words[start : door + 1], [*words[begin : door + 1], *rooms]), *words[door + 1 :]]


def _lacking_first(words: list[Word]) -> list[Word]:
    """Return ``in the hall there is no clock`` for ``in the hall hangs no clock``."""
    start = _after_mark(words)
    rests = next(
        (k for k in range(start + 2, len(words) - 1) if words[k].raw in _RESTING or words[k].kind == "mark"), 0
    )
    if text_at(words, start) not in ("in", "on", "at") or text_at(words, rests + 1) != "no" or not rests:
        return words
    if words[rests].kind == "mark":
        return words
    there = [replace(words[rests], text=text, raw=text) for text in ("there", "is")]
    return [*words[:rests], *there, *words[rests + 1 :]]


def _without_likeness(words: list[Word]) -> list[Word]:
    """Leave out ``like in the other rooms`` after one thing that is added, which only says that others have it."""
    start = _after_mark(words)
    like = next((k for k in range(start + 2, len(words)) if words[k].text in ("like", "as")), 0)
    said = [word.text for word in words[like + 1 : like + 4]]
    end = next_mark(words, like)
    added = text_at(words, start) in _ADDING and text_at(words, start + 1) in ("one", "a", "an")
    plain = end - like <= _LONGEST_NAME + 2 and all(word.text != "and" for word in words[like:end])
    if not (like and added and plain) or said != ["in", "the", "other"] or end + 1 < len(words):
        return words
    kept = words[: like - (text_at(words, like - 1) == ",")]
    return [*kept[:-1], replace(kept[-1], end=words[end - 1].end), *words[end:]]


def _without_headline(words: list[Word]) -> list[Word]:
    """Return ``around the table: ...`` for ``Stools instead of chairs around the table: ...`` that names both again."""
    start = _after_mark(words)
    colon = next_mark(words, start)
    joint = next((k for k in range(start, colon) if words[k].text == "instead" and text_at(words, k + 1) == "of"), 0)
    end = next((k for k in range(joint + 2, colon) if words[k].text in FUNCTION_WORDS - DETERMINERS), colon)
    new, old = words[start:joint], words[joint + 2 : end]
    later = {word.text for word in words[colon + 1 :]}
    plain = all(w.kind == "word" and w.text not in FUNCTION_WORDS - DETERMINERS for w in [*new, *old])
    short = new and old and max(len(new), len(old)) <= _LONGEST_NAME
    if not joint or not plain or not short or text_at(words, colon) != ":" or not {new[-1].text, old[-1].text} <= later:
        return words
    return [*words[:start], *words[end + (end == colon) :]]


def _meaning_first(words: list[Word]) -> list[Word]:
    """Return ``I mean the hall`` for ``The hall I mean``."""
    start = _after_mark(words)
    who = next((k for k in range(start, len(words)) if words[k].text in ("i", "we") or words[k].kind == "mark"), 0)
    meant = text_at(words, who + 1) in _MEANING or (who + 1 < len(words) and words[who + 1].raw in _MEANING)
    ends = who + 2 >= len(words) or words[who + 2].kind == "mark"
    named = text_at(words, start) in DETERMINERS and 1 < who - start <= _LONGEST_NAME
    if not (named and meant and ends) or words[who].kind == "mark":
        return words
    whole = [*words[who : who + 2], *words[start:who]]
    return [*words[:start], *_over(words[start : who + 2], whole), *words[who + 2 :]]


def _as_correction(words: list[Word]) -> list[Word]:
    """Return ``sorry, I meant the hall`` for ``I mean the hall, not the kitchen`` after another sentence."""
    start = _after_mark(words)
    comma = next((k for k in range(start, len(words)) if words[k].kind == "mark"), len(words))
    said = [word.raw for word in words[start : start + 2]]
    contrast = (text_at(words, comma), text_at(words, comma + 1)) == (",", "not")
    bare = next_mark(words, comma + 1) >= len(words) and text_at(words, comma + 2) in DETERMINERS
    short = len(words) - comma <= _LONGEST_NAME + 2
    if said[:1] not in (["i"], ["we"]) or said[1:] not in (["mean"], ["meant"]) or not (contrast and bare and short):
        return words
    sorry = [replace(words[start], text=text, raw=text, kind=kind) for text, kind in (("sorry", "word"), (",", "mark"))]
    meant = replace(words[start + 1], text="meant", raw="meant")
    return [*words[:start], *_over(words[start:], [*sorry, words[start], meant, *words[start + 2 : comma]])]


def _without_ones_named(words: list[Word]) -> list[Word]:
    """Return ``the cup in A and the cup in B`` for ``both cups, the one in A and the one in B,``."""
    both = next((k for k, word in enumerate(words) if word.text == "both"), -1)
    comma = next((k for k in range(both + 1, len(words)) if words[k].kind == "mark"), len(words))
    noun = words[both + 1 + (text_at(words, both + 1) in ("the", "of")) : comma]
    noun = noun[1:] if noun and noun[0].text == "the" else noun
    end = next_mark(words, comma + 1)
    inner = words[comma + 1 : end]
    ones = [k for k in range(len(inner)) if inner[k].text == "one" and text_at(inner, k - 1) == "the"]
    joint = text_at(inner, ones[1] - 2) == "and" if len(ones) == 2 and ones[0] == 1 else False
    plain = noun and all(word.text not in FUNCTION_WORDS and word.kind == "word" for word in noun)
    if both < 0 or not joint or not plain or text_at(words, end) != ",":
        return words
    single = [replace(word, plural=False, raw=word.text) for word in noun]
    named = [part for k, word in enumerate(inner) for part in (single if k in ones else [word])]
    return [*words[:both], *_over(words[both : end + 1], named), *words[end + 1 :]]


def _with_what_comes_too(words: list[Word]) -> list[Word]:
    """Return ``the books and the mug on the table`` for ``the books on the table, the mug too,``."""
    too = next(
        (k for k in range(4, len(words) - 1) if words[k].text in ("too", "also") and words[k + 1].text == ","), 0
    )
    comma = next((k for k in range(too - 2, 0, -1) if words[k].kind == "mark"), 0)
    added = words[comma + 1 : too]
    plain = added and all(word.kind == "word" for word in added) and added[0].text in ("the", "my", "our")
    alone = all(word.text not in FUNCTION_WORDS for word in added[1:])
    before = [k for k in range(comma) if words[k].kind == "mark"]
    start = before[-1] + 1 if before else 0
    quantity = text_at(words, start) in ("all", "the", "both", "every")
    if not (comma and plain and alone and quantity) or text_at(words, comma) != ",":
        return words
    joint = replace(words[comma], text="and", raw="and", kind="word")
    first = next((k for k in range(start + 2, comma) if words[k].raw in _LYING), comma)
    whole = [*words[start:first], joint, *added, *words[first:comma]]
    return [*words[:start], *_over(words[start : too + 2], whole), *words[too + 2 :]]


def _without_summed_list(words: list[Word]) -> list[Word]:
    """Leave out what is on furniture that is cleared of all of it: ``clear the desk: books, pens, the lot``."""
    colon = next((k for k in range(2, len(words)) if words[k].text in (":", "-", "(")), 0)
    verb = any(word.text in _EMPTYING for word in words[:colon])
    end = len(words) - (text_at(words, len(words) - 1) == ")")
    summed = any(tuple(w.text for w in words[end - len(said) : end]) == said for said in _SUMS)
    listed = all(w.text == "," or w.text not in FUNCTION_WORDS - {"and", "the"} for w in words[colon + 1 : end - 3])
    if not colon or not verb or not summed or not listed or any(w.kind == "number" for w in words[colon:end]):
        return words
    return [*words[: colon - 1], replace(words[colon - 1], end=words[-1].end)]


_READINGS: Final[tuple[Callable[[list[Word]], list[Word]], ...]] = (
    _door_first,
    _lacking_first,
    _without_headline,
    _without_likeness,
    _meaning_first,
    _without_ones_named,
    _with_what_comes_too,
    _without_summed_list,
)


def _after_mark(words: Sequence[Word]) -> int:
    """Return where a sentence begins after the mark that ends the one before."""
    return next((k for k, word in enumerate(words) if word.kind != "mark"), len(words))


def _over(phrase: Sequence[Word], words: Sequence[Word]) -> list[Word]:
    """Return words that all stand where a phrase does, so that what is quoted of them is the phrase."""
    start, end = phrase[0].start, phrase[-1].end
    return [replace(word, start=start, end=end) for word in words]

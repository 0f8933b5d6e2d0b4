"""Terse notation, written out: ``chairs 3 -> 4``, ``A <-> B``, ``w/o``, ``remove: A, B``, ``lamp: from A to B``."""

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.verb_words import VERB_WORDS
from mansion_editing.instructions.phrases.words import (
    DETERMINERS,
    FUNCTION_WORDS,
    PREPOSITIONS,
    PRONOUNS,
    SENTENCE_ENDS,
    STATE_WORDS,
    Word,
    text_at,
)
from mansion_language.colours import COLOUR_WORDS

__all__ = ["written_out"]

_ARROW: Final = re.compile(r"\s*(?:-+>|=+>|→)\s*")
_EXCHANGE: Final = re.compile(r"\s*(?:<[-=]+>|↔|⇄)\s*")
_SWAPS: Final = ("swap", "exchange")
_SHAFTS: Final = ("-", "=")
"""Marks that an arrow begins with."""
_BEFORE_LISTS: Final = frozenset("delete remove add swap exchange discard".split())
"""Verbs after which a colon only begins what they ask for."""
_LONGEST_NAME: Final = 4


def written_out(words: Sequence[Word], text: str) -> list[Word]:
    """Return words in which arrows and abbreviations are written as a sentence would have them.

    Parameters
    ----------
    text : str
        That the words were read from, which has the arrows that no word stands for.
    """
    out = _abbreviated(words)
    out = _with_exchanges(out, text)
    out = _with_arrows(_with_differences(out), text)
    out = [word for at, word in enumerate(out) if not _is_colon_of_list(out, at)]
    return _with_ways(out)


def _abbreviated(words: Sequence[Word]) -> list[Word]:
    """Write out ``w/`` and ``w/o``, and ``incl.`` as what else is meant."""
    out: list[Word] = []
    at = 0
    while at < len(words):
        word = words[at]
        slash = words[at + 1] if at + 1 < len(words) else None
        part = words[_start_of_part(words[:at]) : at]
        if word.raw == "incl" and part and not any(other.kind == "number" for other in part):
            out.append(replace(word, text="and", raw="and"))
            at += 1
            continue
        if word.raw != "w" or slash is None or slash.text != "/" or slash.start != word.end:
            out.append(word)
            at += 1
            continue
        other = words[at + 2] if at + 2 < len(words) else None
        without = other is not None and other.raw == "o" and other.start == slash.end
        end = other.end if other is not None and without else slash.end
        name = "without" if without else "with"
        out.append(replace(word, text=name, raw=name, end=end))
        at += 2 + without
    return out


def _with_exchanges(words: list[Word], text: str) -> list[Word]:
    """Write ``A <-> B`` as ``swap A and B``; a place in brackets is where each of them is."""
    joint = next((k for k in range(1, len(words)) if _is_between(_EXCHANGE, words, k, text)), 0)
    if not joint:
        return words
    before, after = _without_dash(words[:joint]), words[joint:]
    first = _start_of_part(before)
    verb = text_at(before, first) in _SWAPS or (
        text_at(before, first - 2) in _SWAPS and text_at(before, first - 1) == ":"
    )
    opening = [] if verb else [_inserted("swap", before[first].start)] if first < len(before) else []
    whole = [*before[:first], *opening, *before[first:], _inserted("and", before[-1].end), *after]
    return [placed for at in range(len(whole)) for placed in _in_brackets(whole, at)]


def _in_brackets(words: Sequence[Word], at: int) -> list[Word]:
    """Return ``on the`` for the bracket before furniture: ``laptop (study desk)``; none for the closing one."""
    word = words[at]
    if word.text == ")":
        return []
    if word.text != "(" or text_at(words, at + 1) in PREPOSITIONS:
        return [word] if word.text != "(" else []
    on = replace(word, text="on", raw="on", kind="word")
    return [on] if text_at(words, at + 1) in DETERMINERS else [on, _inserted("the", word.end)]


def _less_or_more(words: list[Word], at: int) -> tuple[list[Word], int]:
    """Return ``three chairs less`` for ``minus three chairs``, ``one more plant`` for ``plus one plant``."""
    number = words[at + 1] if at + 1 < len(words) else None
    if number is None or number.kind != "number":
        return [words[at]], 1
    if words[at].text in ("plus", "+"):
        return [number, _inserted("more", number.end)], 2
    end = at + 2
    while end < len(words) and words[end].kind == "word" and words[end].text not in PREPOSITIONS | {"and"}:
        end += 1
    return [*words[at + 1 : end], _inserted("less", words[end - 1].end)], end - at


def _with_differences(words: list[Word]) -> list[Word]:
    """Write ``chairs -2, plants +1`` as ``2 chairs less, 1 plants more``."""
    out: list[Word] = []
    at = 0
    while at < len(words):
        sign = words[at]
        if sign.text in ("minus", "plus", "+") and _start_of_part(out) == len(out):
            counted = _less_or_more(words, at)
            out += counted[0]
            at += counted[1]
            continue
        number = words[at + 1] if at + 1 < len(words) else None
        start = _start_of_part(out)
        signed = sign.text in ("-", "+") and number is not None and number.kind == "number" and number.start == sign.end
        ends = at + 2 >= len(words) or words[at + 2].kind == "mark"
        noun = out[start:]
        apart = bool(noun) and noun[-1].kind == "word" and noun[-1].end < sign.start and len(noun) <= _LONGEST_NAME
        if number is None or not (signed and ends and apart):
            out.append(sign)
            at += 1
            continue
        more = _inserted("more" if sign.text == "+" else "less", number.end)
        first = noun[0].start
        out[start:] = [replace(number, start=first, end=first), *noun, more]
        at += 2
    return out


def _with_arrows(words: list[Word], text: str) -> list[Word]:
    """Write ``chairs 3 -> 4`` as ``exactly 4 chairs``, ``lamp -> on`` as ``lamp should be on``, ``A -> B`` with ``to``.

    Any other arrow becomes a word that no clause has, so that the answer names it.
    """
    joint = next((k for k in range(1, len(words)) if _is_between(_ARROW, words, k, text)), 0)
    if not joint:
        return words
    before, after = _without_dash(words[:joint]), words[joint:]
    first = _start_of_part(before)
    things, new = before[first:], after[0]
    if new.kind == "number":
        counted = [word for word in things if word.kind != "number"]
        old = [at for at, word in enumerate(things) if word.kind == "number"]
        if not counted or old not in ([0], [len(things) - 1]):
            return [*before, _inserted("->", before[-1].end), *_with_arrows(after, text)]
        start = things[0].start
        amount = [_inserted("exactly", start), replace(new, start=start, end=start)]
        whole = [*before[:first], *amount, *counted[:-1], replace(counted[-1], end=new.end)]
        return [*whole, *_with_arrows(after[1:], text)]
    source = next((at for at, word in enumerate(things) if word.text == "from" and at), 0)
    if source:
        asked = any(word.text in VERB_WORDS - FUNCTION_WORDS for word in things[:source])
        moved = things if asked else [_inserted("move", things[0].start), *things]
        return [*before[:first], *moved, _inserted("to", before[-1].end), *_with_arrows(after, text)]
    said = new.text in STATE_WORDS or new.text in COLOUR_WORDS
    names = ("should", "be") if said and things else ("->",)
    joined = [_inserted(name, before[-1].end) for name in names]
    return [*before, *joined, new, *_with_arrows(after[1:], text)]


def _without_dash(words: list[Word]) -> list[Word]:
    """Leave out the dash that an arrow begins with."""
    return words[:-1] if words and words[-1].text in _SHAFTS else words


def _is_between(sign: re.Pattern[str], words: Sequence[Word], at: int, text: str) -> bool:
    before = words[at - 2] if words[at - 1].text in _SHAFTS and at > 1 else words[at - 1]
    return sign.fullmatch(text, before.end, words[at].start) is not None


def _start_of_part(words: Sequence[Word]) -> int:
    """Return where the words after the last comma, colon or end of a sentence begin."""
    marks = (at for at in range(len(words) - 1, -1, -1) if words[at].text in (",", ":", ".", ";", "\n", "!", "?"))
    return next((at + 1 for at in marks), 0)


def _inserted(text: str, place: int) -> Word:
    return Word(text, text, "word", place, place)


def _is_colon_of_list(words: Sequence[Word], at: int) -> bool:
    """Whether a colon stands between a verb and what it asks for: ``please delete: the bench``."""
    return (
        words[at].text == ":" and text_at(words, at - 1) in _BEFORE_LISTS and text_at(words, at - 2) not in ("to", "we")
    )


def _with_ways(words: list[Word]) -> list[Word]:
    """Write ``stand: from lobby to hall`` as ``move stand from lobby to hall``."""
    joint = next((at for at in range(1, len(words)) if _is_colon_of_way(words, at)), 0)
    if not joint:
        return words
    start = _start_of_part(words[:joint])
    moved = [_inserted("move", words[start].start), *words[start:joint]]
    return [*words[:start], *moved, *_with_ways(words[joint + 1 :])]


def _is_colon_of_way(words: Sequence[Word], at: int) -> bool:
    """Whether a colon stands between a thing and from where to where it goes: ``stand: from lobby to hall``."""
    if words[at].text != ":" or text_at(words, at + 1) != "from":
        return False
    thing = words[_start_of_part(words[:at]) : at]
    thing = thing[1:] if thing and thing[0].text in DETERMINERS else thing
    end = next((k for k in range(at + 2, len(words)) if words[k].text in SENTENCE_ENDS), len(words))
    goal = next((k for k in range(at + 2, end) if words[k].text == "to" or words[k].kind == "mark"), end)
    verbs = [k for k in range(at + 2, end) if words[k].text in VERB_WORDS - FUNCTION_WORDS]
    asked = any(text_at(words, k + 1) in DETERMINERS | PRONOUNS for k in verbs)
    named = 0 < len(thing) <= _LONGEST_NAME and not any(word.text in FUNCTION_WORDS for word in thing)
    return named and text_at(words, goal) == "to" and goal > at + 2 and not asked

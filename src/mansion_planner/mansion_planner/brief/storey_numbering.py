"""Tell how a brief numbers its storeys: from the ground floor as the first, as the British do, or above G."""

import itertools

from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.storey_forms import ABOVE_GROUND

__all__ = ["counts_above_ground", "counts_from_ground", "levels_above_ground", "numbers_above_ground", "written_after"]


def counts_from_ground(reading: Reading) -> bool:
    """Whether the first floor is the one above the ground floor: the brief uses both names, as the British do.

    A brief that counts as many storeys as its highest ordinal counts from the ground floor as the first all the same.
    """
    words = [token.text for token in reading.tokens]
    pairs = list(itertools.pairwise(words))
    if _lists_ground_and_first(reading) or _tells_first_above_ground(reading):
        return True
    ground = any(
        (word, floor) in pairs for word in ("ground", "street", "entrance") for floor in ("floor", "level", "storey")
    )
    ground = ground or any(token.text == ABOVE_GROUND for token in reading.tokens)
    elliptic = {("at", "the", "bottom"), ("on", "the", "ground")}
    ground = ground or any(words_of in elliptic for words_of in zip(words, words[1:], words[2:], strict=False))
    ground = ground or (not _BELOW_STAIRS.isdisjoint(words) and _BASEMENTS.isdisjoint(words))
    if ground and _counts_ground_apart(reading):
        return True
    named = [*_named_by_ordinals(reading), *_elliptic_ordinals(reading)]
    if not ground or 1 not in named or ("second", "storey") in pairs:
        return False
    stated = _stated_numbers(reading)
    return not (stated and max(stated) == max(named))


_BELOW_STAIRS = frozenset({"downstair", "downstairs"})
_BASEMENTS = frozenset({"basement", "cellar", "underground", "upstair", "upstairs"})
"""Words beside which "downstairs" may lie below the first floor, or the first floor be it."""


def _tells_first_above_ground(reading: Reading) -> bool:
    """Whether the brief says so itself: "the first floor, so directly above ground floor"."""
    for index in range(len(reading.tokens) - 4):
        first = (
            reading.kind(index) == "ordinal" and reading.value(index) == 1 and reading.word(index + 1) in FLOOR_WORDS
        )
        end = reading.appositive(index + 2) if first else 0
        if end and reading.word(end - 1) in ("above", "over"):
            return reading.word(end + (reading.word(end) == "the")) in ("ground", ABOVE_GROUND)
    return False


def _named_by_ordinals(reading: Reading) -> list[int]:
    """Return the storeys that ordinals number: 1 and 2 of "the first and the second floor", "1st to 2nd level"."""
    found = []
    for index, token in enumerate(reading.tokens):
        if token.kind != "ordinal" or token.value != int(token.value):
            continue
        at = index + 1
        while reading.word(at) in _LINKS:
            link, at = at, at + 1
            while reading.word(at) in _LINKS | {"the"} and at - link < 3:
                at += 1
            if reading.kind(at) != "ordinal":
                break
            at += 1
        if reading.word(at) in FLOOR_WORDS and not reading.breaks(at):
            found.append(int(token.value))
    return found


_LINKS = frozenset({"and", ",", "&", "to", "through", "–", "-"})
"""What joins the ordinals of storeys that one noun follows."""


def _elliptic_ordinals(reading: Reading) -> list[int]:
    """Return the storeys that "on the first, ...", "on the second six offices" and "Third:" name by number alone."""
    found = []
    for index, token in enumerate(reading.tokens):
        if token.kind != "ordinal" or token.value != int(token.value):
            continue
        closed = reading.word(index + 1) in _AFTER_ELLIPTIC or reading.kind(index + 1) == "number"
        placed = reading.words(index - 2, index) == ("on", "the") and closed
        if placed or (reading.starts(index) and reading.word(index + 1) == ":"):
            found.append(int(token.value))
    return found


_AFTER_ELLIPTIC = frozenset({",", ".", ";", ":", "a", "an", "the", "there", "we", "are", "is"})
"""What follows a storey that no noun is said of."""


def counts_above_ground(reading: Reading) -> bool:
    """Whether the storeys of "G+7" are numbered above the ground floor: the highest that is named is the seventh."""
    stated = [int(reading.value(i + 2)) for i in range(len(reading.tokens)) if reading.words(i, i + 2) == ("g", "+")]
    named = [
        int(a.value)
        for a, b in itertools.pairwise(reading.tokens)
        if a.kind == "ordinal" and b.text in FLOOR_WORDS | {":", "="}
    ]
    named += [
        int(reading.value(i + 1))
        for i in range(len(reading.tokens) - 1)
        if reading.word(i) in FLOOR_WORDS and reading.kind(i + 1) == "number"
    ]
    return bool(stated and named) and max(named) == stated[0]


def _lists_ground_and_first(reading: Reading) -> bool:
    """Whether "Ground: ... 1st: ..." or "GF: ... 1F: ..." count the storeys of a list from the one above the ground."""
    marks = (":", "=", "-", "–", "\n", "&", "and", ",", "for", "has", "hold", "above")
    ground = first = False
    for index in range(len(reading.tokens)):
        word, opens = reading.word(index), reading.starts(index) or reading.word(index - 1) == ":"
        after = index + 1 + (reading.word(index + 1) in FLOOR_WORDS)
        after += reading.word(after) in ("only", "alone")
        listed = reading.word(after) in (*marks, "to")
        ground = ground or (opens and _is_ground(reading, index) and listed)
        counts = (reading.kind(index) == "ordinal" and opens) or (
            reading.kind(index) == "level" and written_after(reading, index)
        )
        first = first or (counts and listed and reading.value(index) == 1) or (word == "ff" and listed)
    return ground and first


def _counts_ground_apart(reading: Reading) -> bool:
    """Whether the highest of eight storeys is the seventh floor: "1st to 7th floor" beside a ground floor."""
    ordinals = [
        int(token.value)
        for token, after in itertools.pairwise(reading.tokens)
        if token.kind == "ordinal" and after.text in ("to", "–", "-")
    ]
    ordinals += _named_by_ordinals(reading)
    stated = _stated_numbers(reading)
    return bool(stated and ordinals) and min(ordinals) == 1 and max(ordinals) == max(stated) - 1


def levels_above_ground(reading: Reading) -> bool:
    """Whether "L1" is the storey above the ground floor: the brief lists both ("GF: ... L1: ...")."""
    heads = [i for i in range(len(reading.tokens)) if reading.starts(i)]
    marks = (":", "=", "-", "–", "\n", "(", "has", "with", "and", "&")
    ground = any(_is_ground(reading, i) for i in heads)
    levels = [int(t.value) for t in reading.tokens if t.kind == "level" and t.text != ABOVE_GROUND]
    stated = _stated_numbers(reading)
    if ground and levels and stated and max(stated) == max(levels) + 1:
        return True
    return ground and any(
        reading.kind(i) == "level"
        and reading.word(i) != ABOVE_GROUND
        and reading.value(i) == 1
        and reading.word(i + 1) in marks
        for i in heads
    )


def numbers_above_ground(reading: Reading) -> bool:
    """Whether "floor one" is the storey above the ground floor: the brief speaks of both as two, as in lifts.

    "The ground floor (level 1)" names one storey twice; and where the highest number is the count of the storeys, the
    ground floor is the first.
    """
    singular = FLOOR_WORDS - {"storie"}
    grounds = [
        i
        for i in range(len(reading.tokens))
        if reading.word(i) in ("ground", "street", "entrance")
        and (reading.word(i + 1) in singular or (reading.starts(i) and reading.word(i + 1) in (":", "=")))
    ]
    named = {
        i: int(reading.value(i + 1))
        for i in range(len(reading.tokens))
        if reading.word(i) in singular and reading.kind(i + 1) == "number" and reading.kind(i + 2) != "unit"
    }
    firsts = [i for i, value in named.items() if value == 1]
    if not grounds or not firsts:
        return False
    if any(_in_apposition(reading, ground, first) for ground in grounds for first in firsts):
        return False
    stated = _stated_numbers(reading)
    return not (stated and max(stated) == max(named.values()) > 1)


def _in_apposition(reading: Reading, ground: int, first: int) -> bool:
    """Whether nothing but brackets, commas and "is the" stand between two names of storeys."""
    low, high = min(ground, first) + 2, max(ground, first)
    marks = ("(", ",", "the", "is", "=", "or", "-", "/")
    return high - low <= 3 and all(reading.word(i) in marks for i in range(low, high))


def _stated_numbers(reading: Reading) -> list[int]:
    """Return the numbers that stand before a word for storeys: 4 of "four storeys"."""
    return [int(a.value) for a, b in itertools.pairwise(reading.tokens) if a.kind == "number" and b.text in FLOOR_WORDS]


def _is_ground(reading: Reading, index: int) -> bool:
    above = reading.word(index) == ABOVE_GROUND and reading.value(index) == 0
    return above or reading.word(index) in ("ground", "gf", "g", "rdc", "eg")


def written_after(reading: Reading, index: int) -> bool:
    """Whether a level is written as "1F", which a ground floor goes before, rather than as "L1" or "F1"."""
    token = reading.tokens[index]
    return reading.text[token.start : token.end][:1].isdigit()

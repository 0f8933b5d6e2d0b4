"""Tell attics that are storeys of their own, storeys that lie below ground, and a ground floor that is all there is."""

from itertools import pairwise

from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["HOLDING_ROOMS", "all_on_one", "attic_above", "has_upper_storeys", "storeys_below"]

HOLDING_ROOMS = frozenset(
    {":", "is", "hold", "holds", "has", "contain", "contains", "become", "becomes", "get", "gets", "house", "houses"}
)
"""What follows an attic that is a storey with rooms."""
_OTHERS = frozenset({"upstairs", "upstair", "downstairs", "downstair", "basement", "cellar", "attic", "above", "below"})
"""Words of further storeys."""


def attic_above(reading: Reading, last: int) -> int:
    """Return where "2 full floors + attic" ends, where the brief goes on about what is in the attic; or 0."""
    if reading.word(last) not in ("+", "plus", "and"):
        return 0
    end = last + 1 + (reading.word(last + 1) in ("a", "an", "the"))
    if reading.word(end) not in ("attic", "loft"):
        return 0
    texts = [token.text for token in reading.tokens]
    headed = any(
        (word == "top" and after == "floor") or (word in ("attic", "loft") and after in HOLDING_ROOMS)
        for word, after in zip(texts[end + 1 :], texts[end + 2 :], strict=False)
    )
    storey = reading.word(end + 1) in FLOOR_WORDS
    within = any(tuple(texts[at : at + 3]) == ("in", "the", texts[end]) for at in range(end + 1, len(texts)))
    return end + 1 + storey if headed or storey or within else 0


def all_on_one(reading: Reading, index: int) -> int:
    """Return where "all ground level", "All level.", "all on that level" or "Ground floor, 250 m2" ends; else 0."""
    ends = reading.breaks(index + 3) or reading.word(index + 3) in _CLOSERS
    if reading.word(index) == "ground":
        return index + 2 if _is_all_there_is(reading, index) else 0
    if reading.word(index) != "all":
        return 0
    if reading.words(index + 1, index + 3) in _LEVEL and ends:
        return index + 3
    if reading.word(index + 1) == "level":
        return index + 2 if reading.starts(index) and reading.breaks(index + 2) else 0
    last = index + 2 + (reading.word(index + 2) == "the")
    told = reading.word(last) in ("that", "this", "same") and reading.word(last + 1) in FLOOR_WORDS
    led = reading.word(index + 1) in ("on", "at", "in")
    return last + 2 if led and told and not reading.facts.floors else 0


_LEVEL = frozenset((ground, noun) for ground in ("ground", "street") for noun in ("level", "floor"))
"""What follows "all" where everything is on one storey: "all ground level"."""
_CLOSERS = frozenset({",", ":", ")", "-", "="})


def _is_all_there_is(reading: Reading, index: int) -> bool:
    """Whether "Ground floor, 250 m2." stands by itself in a brief that speaks of no other storey."""
    texts = [token.text for token in reading.tokens]
    storeys = [at for at, text in enumerate(texts) if text in FLOOR_WORDS]
    levels = any(token.kind == "level" for token in reading.tokens)
    if storeys != [index + 1] or not _OTHERS.isdisjoint(texts) or levels:
        return False
    at = index + 2
    measured = reading.word(at) == "," and reading.kind(at + 1) == "number" and reading.kind(at + 2) == "unit"
    closed = reading.breaks(at + 3) or reading.word(at + 3) == "," if measured else reading.breaks(at)
    return closed and (reading.starts(index) or reading.word(index - 1) == ",")


_MARKS = frozenset({",", "(", "-", "–"})
_PARTS = frozenset({"them", "which", "these", "those"})
_VERBS = frozenset({"is", "are", "being", "lie", "sit", "go"})
_BELOW = (("underground",), ("below", "ground"), ("below", "grade"), ("in", "the", "basement"), ("a", "basement"))


def storeys_below(reading: Reading, index: int) -> tuple[int, int]:
    """Return how many of the storeys counted right before a token lie below ground, and where that ends; or 0, 0."""
    at = index + (reading.word(index) in _MARKS)
    told = reading.kind(at) == "number" and reading.word(at + 1) == "of" and reading.word(at + 2) in _PARTS
    last = at + 3 + (reading.word(at + 3) in _VERBS)
    place = next((words for words in _BELOW if reading.words(last, last + len(words)) == words), ())
    return (int(reading.value(at)), last + len(place)) if told and place else (0, 0)


def has_upper_storeys(reading: Reading) -> bool:
    """Whether a brief speaks of storeys above the ground floor anywhere: "upstairs", "two storeys", "first floor"."""
    tokens = reading.tokens
    numbered = any(
        after.text in FLOOR_WORDS
        and ((token.kind == "number" and reading.value(at) >= 2) or token.kind == "ordinal" or token.text in _UPPER)
        for at, (token, after) in enumerate(pairwise(tokens))
    )
    return numbered or not _UPSTAIRS.isdisjoint(token.text for token in tokens)


_UPPER = frozenset({"top", "upper"})
_UPSTAIRS = frozenset({"upstairs", "upstair"})

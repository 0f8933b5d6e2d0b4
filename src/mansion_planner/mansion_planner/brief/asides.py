"""Find the words of a brief that only say why or what for something is wanted, and ask for nothing themselves."""

from mansion_planner.brief.phrase import FUNCTION_WORDS
from mansion_planner.brief.reading import Reading

__all__ = ["TRIALS", "aside_tokens"]

TRIALS = frozenset(
    """
    trial test testing experiment research evaluation simulation training development study project benchmark
    evaluating competition demo demonstration
    """.split()
)
"""What a building is wanted for by those who try robots or programs in it."""
_REASONS = frozenset({"because", "since"})
_LEADS = frozenset({"for", "as"})
_WITHIN = frozenset("the our a an some new my this of with on about in and your their".split())
"""Words within a purpose: "for the research about serving robots"."""
_LONGEST = 12
"""Tokens of a reason or a purpose, at most."""


def aside_tokens(reading: Reading) -> set[int]:
    """Return the tokens of reasons and purposes of which no statement is made.

    "On one floor because my knees are bad", "for our navigation benchmark". What a statement was read from stays one,
    and where a reason holds one ("because we want a lift") its other words are told of as well.
    """
    found: set[int] = set()
    for index in range(len(reading.tokens)):
        if reading.word(index) in _REASONS:
            found |= _reason(reading, index)
        elif reading.word(index) in _LEADS:
            found |= _purpose(reading, index)
    return found


def _reason(reading: Reading, index: int) -> set[int]:
    """Return the tokens of the clause that a conjunction opens, if nothing was read in it."""
    end = index + 1
    while not reading.breaks(end) and reading.word(end) not in (",", ")", ":") and end - index <= _LONGEST:
        if end in reading.taken or reading.kind(end) in ("number", "unit"):
            return set()
        end += 1
    return set(range(index, end))


def _purpose(reading: Reading, index: int) -> set[int]:
    """Return the tokens of a purpose whose noun is that of a trial: "for the testing of a disinfecting robot"."""
    end = index + 1
    while end - index <= _LONGEST and reading.kind(end) == "word" and end not in reading.taken:
        if reading.word(end) in FUNCTION_WORDS - _WITHIN:
            break
        end += 1
    return set(range(index, end)) if not TRIALS.isdisjoint(reading.words(index + 1, end)) else set()

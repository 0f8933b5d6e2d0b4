"""Read which stairs and lifts a building is to have: "two lifts", "no elevator", "stairs suffice", "a walk-up"."""

from collections.abc import Mapping

from mansion_planner.brief.facts import Quantity
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["read_stairs_and_lifts"]

_COPULAS = frozenset({"is", "are", "be", "will"})
_ENOUGH = frozenset({"suffice", "sufficient", "enough", "do"})
"""What is said of stairs where no lift is wanted: "stairs suffice", "stairs will do"."""


def read_stairs_and_lifts(reading: Reading, phrases: list[Phrase], negated: Mapping[int, tuple[int, int]]) -> None:
    """State the stairs and lifts that are wanted or not wanted, and how many.

    Parameters
    ----------
    negated : mapping of int to tuple of int
        For phrases that a negation reaches, its tokens.
    """
    for number, phrase in enumerate(phrases):
        if phrase.head not in ("stair", "elevator"):
            continue
        span = reading.span(phrase.first, phrase.last)
        if number in negated:
            first, last = negated[number]
            reading.facts.vertical.append(
                (f"no_{phrase.head}", reading.span(min(first, phrase.first), max(last, phrase.last)))
            )
            continue
        enough = reading.word(phrase.last + (reading.word(phrase.last) in _COPULAS)) in _ENOUGH
        enough = enough and not _has_lift_beside(reading, phrases, number)
        if enough:
            reading.take(phrase.last, phrase.last + 1 + (reading.word(phrase.last) in _COPULAS))
        only = "only" in (reading.word(phrase.last), reading.word(phrase.first - 1))
        only = only and reading.word(phrase.last + 1) != "for"  # "a lift only for prisoners"
        if enough or (only and not phrase.counted):  # "only one lift" is a number
            reading.facts.vertical.append(("no_elevator" if phrase.head == "stair" else "no_stair", span))
            only_at = phrase.last if reading.word(phrase.last) == "only" else phrase.first - 1
            reading.take(only_at, only_at + (reading.word(only_at) == "only"))
        reading.facts.vertical.append((phrase.head, span))
        if phrase.counted and phrase.count is not None and phrase.determiner not in ("the", "both"):
            held = reading.facts.stairs if phrase.head == "stair" else reading.facts.lifts
            held.append(Quantity(float(phrase.count), span))
    for index in range(len(reading.tokens) - 1):
        if (
            reading.word(index) in ("walk", "stair")
            and reading.word(index + 1) == "up"
            and not reading.tokens[index + 1].spaced
        ):
            reading.facts.vertical.append(("no_elevator", reading.span(index, index + 2)))


def _has_lift_beside(reading: Reading, phrases: list[Phrase], number: int) -> bool:
    """Whether a lift is joined to the stairs of a phrase: "one lift and one stairs is enough"."""
    other = phrases[number - 1] if number else None
    joined = other is not None and {"stair", "elevator"} == {other.head, phrases[number].head}
    return joined and other is not None and reading.word(other.last) in ("and", "&", "+", "plus")

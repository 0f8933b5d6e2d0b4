"""Tell which rooms stand on the two sides of a relation."""

from dataclasses import dataclass

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.relation_words import NEGATIONS

__all__ = [
    "Relation",
    "is_negated",
    "joint",
    "rooms_after",
    "rooms_before",
    "rooms_in_sentence",
    "subject_before",
    "with_adverbs",
    "with_alternatives",
]


@dataclass(frozen=True)
class Relation:
    """Rooms that are to be side by side, or apart.

    Attributes
    ----------
    lefts, rights : tuple of int
        Numbers of the phrases; every one on the left with some one on the right.
    apart : bool
    first, last : int
        Tokens of the words of the relation.
    """

    lefts: tuple[int, ...]
    rights: tuple[int, ...]
    apart: bool
    first: int
    last: int


def with_adverbs(reading: Reading, first: int) -> int:
    """Return where a relation begins with the adverbs that strengthen it: "right beside", "immediately next to"."""
    while reading.word(first - 1) in _STRENGTHS and first - 1 not in reading.taken:
        first -= 1
    return first


_STRENGTHS = frozenset(
    "right immediately directly just straight close closely well very conveniently handily situated".split()
)
"""Adverbs before a relation that ask for nothing more than it does."""


def rooms_in_sentence(
    reading: Reading, phrases: list[Phrase], rooms: list[int], index: int, *, before: bool
) -> list[int]:
    sentence = reading.sentence[index]
    return [
        n
        for n in rooms
        if reading.sentence[phrases[n].first] == sentence
        and (phrases[n].last <= index if before else phrases[n].begin >= index)
    ]


def is_negated(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int) -> bool:
    """Whether a negation stands before the relation, after the room on its left or before its sentence's first one."""
    sentence = reading.sentence[index]
    before = rooms_in_sentence(reading, phrases, rooms, index, before=True)
    start = index
    while (
        start > 0
        and reading.sentence[start - 1] == sentence
        and index - start < 9
        and reading.word(start - 1) not in (",", "but", "(", ":")
    ):
        start -= 1
        if reading.word(start) in NEGATIONS - {"nor"}:
            break
    window = range(start, index)
    hits = [i for i in window if reading.word(i) in NEGATIONS and reading.words(i, i + 2) != ("never", "mind")]
    if not hits:
        return False
    # "no lift next to the stairs" negates the lift; "must not be next to" and "neither A nor B" the relation.
    if before and hits[-1] < phrases[before[-1]].first and reading.word(hits[-1]) in ("no", "without"):
        return False
    for hit in hits:
        reading.take(hit, hit + 1)
    return True


def joint(reading: Reading, phrases: list[Phrase], one: int, other: int) -> bool:
    return any(word in ("and", ",", "or") for word in reading.words(phrases[one].last, phrases[other].first))


def subject_before(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int) -> int:
    return next(n for n in reversed(rooms) if phrases[n].last <= index)


def rooms_before(reading: Reading, phrases: list[Phrase], before: list[int], index: int) -> list[int]:
    """Return the rooms on the left: the last one, and those joined to it by "and" where the verb is of several."""
    if not before:
        return []
    lefts = [before[-1]]
    both, every = reading.word(index - 1) == "both", reading.word(index - 1) == "all"
    if len(before) > 1 and _is_plural_subject(reading, phrases[before[-2]], phrases[before[-1]]):
        return before[-2:]
    for number in reversed(before[:-1]):
        between = reading.words(phrases[number].last, phrases[lefts[-1]].first)
        if (
            "nor" in between
            or (both and set(between) <= {"and", "the", "a", "an"})
            or (every and set(between) <= {"and", "the", "a", "an", ","})
            or ("or" in between and "," not in between)
        ):
            lefts.append(number)
            continue
        break
    return lefts[::-1]


def _is_plural_subject(reading: Reading, one: Phrase, other: Phrase) -> bool:
    """Whether two rooms are what a clause in the plural is about: "A and B have no wall in common with C"."""
    if set(reading.words(one.last, other.begin)) - {"the", "a"} != {"and"} or reading.word(other.last) not in _PLURALS:
        return False
    return reading.starts(min(one.first, one.begin - (one.determiner == "the"))) or one.determiner == "both"


_PLURALS = frozenset({"have", "are", "adjoin", "share", "do", "touch", "lie", "stand", "border", "must", "should"})
"""Verbs of a subject in the plural; "must" and "should" where two rooms open the sentence."""


def rooms_after(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int, last: int) -> list[int]:
    """Return the rooms right after a relation: one, and the one joined to it by "and the".

    In "the kitchen is next to a cold room and a pantry" both are what the sentence tells; without "is" the second room
    is one more of those that are listed.
    """
    following = (
        list(rooms_in_sentence(reading, phrases, rooms, last, before=False)) if last < len(reading.tokens) else []
    )
    if not following or phrases[following[0]].begin - last > 5:
        return []
    if reading.breaks(last - 1) or any(
        word in (",", ":", ")", "with", "and") for word in reading.words(last, phrases[following[0]].first)
    ):
        return []
    rights = [following[0]]
    if len(following) > 1:
        first, second = (phrases[number] for number in following[:2])
        joined = reading.words(first.last, second.begin) in _AND_THE
        ends = reading.breaks(second.last) or reading.word(second.last) in (",", ")")
        named = first.determiner in ("the", "both") and second.determiner in ("the", "")
        told = _is_predicate(reading, index) and reading.breaks(second.last)
        if joined and ends and (named or told):
            rights.append(following[1])
    return rights


_AND_THE = [("and", *to, *article) for to in ((), ("to",)) for article in ((), ("the",), ("a",), ("an",))]


def _is_predicate(reading: Reading, index: int) -> bool:
    """Whether a relation is what a sentence tells of its subject: "is right beside", "must be close to"."""
    return reading.word(with_adverbs(reading, index) - 1) in ("is", "are", "be", "lies", "lie", "sits", "stands")


def with_alternatives(reading: Reading, phrases: list[Phrase], rooms: list[int], rights: list[int]) -> list[int]:
    """Return the rooms that another is to be apart from, with those that "or" adds: "not next to A, B or C"."""
    following = [n for n in rooms if rights and n > rights[-1]]
    listed = list(rights)
    for number in following:
        gap = reading.words(phrases[listed[-1]].last, phrases[number].begin)
        if reading.sentence[phrases[number].first] != reading.sentence[phrases[listed[0]].first]:
            break
        if not gap or not set(gap) <= {",", "or", "nor", "the", "any", "to", "on", "with", "from"}:
            break
        listed.append(number)
        if not {"or", "nor"}.isdisjoint(gap):
            return listed
    return rights

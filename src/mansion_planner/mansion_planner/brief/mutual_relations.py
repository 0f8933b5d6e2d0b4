"""Read what is said of two rooms together: "side by side", "between the two", "no common wall between them"."""

import itertools

from mansion_planner.brief.phrase import FUNCTION_WORDS, Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.relation_rooms import Relation, is_negated, rooms_in_sentence

__all__ = [
    "between_relation",
    "closes_clause",
    "mutual_relation",
    "postposed_relation",
    "relation_to_all",
    "wall_relation",
]


def closes_clause(reading: Reading, last: int, phrases: list[Phrase], rooms: list[int]) -> bool:
    """Whether nothing that could be the second room follows before the clause ends."""
    return reading.breaks(last) or reading.word(last) in (
        *(",", ")", "and", "on", "in", "at", ":", "if", "to"),
        *("go", "is", "are", "but", "plus", "which", "take", "occupy", "so", "since", "because", "as"),
    )


def between_relation(
    reading: Reading, phrases: list[Phrase], rooms: list[int], index: int
) -> tuple[Relation, int] | None:
    alone = reading.word(index - 1) == "in" and (reading.breaks(index + 1) or reading.word(index + 1) in (",", ")"))
    two = reading.words(index + 1, index + 3) == ("the", "two")
    if alone or reading.word(index + 1) == "them" or (two and not any(phrases[n].begin == index + 3 for n in rooms)):
        unread = reading.kind(index + 3) == "word" and index + 3 not in reading.taken
        elided = reading.word(index + 2) == "two" and not (unread and reading.word(index + 3) not in FUNCTION_WORDS)
        last = index + 2 - alone + (elided and not alone)
        return _between_them(phrases, [n for n in rooms if phrases[n].last <= index], index, last)
    following = rooms_in_sentence(reading, phrases, rooms, index, before=False)[:2]
    before = rooms_in_sentence(reading, phrases, rooms, index, before=True)
    pair = _told_of_both(reading, phrases, following, index)
    if pair is not None:
        return pair
    if not following or not before or (reading.kind(index + 1) == "number" and not phrases[following[0]].plural):
        return None
    if len(following) > 1 and "and" not in reading.words(phrases[following[0]].last, phrases[following[1]].first):
        following = following[:1]
    if phrases[following[0]].first - index > 4:
        return None
    lefts = (before[-1],)
    if len(following) == 1 and not phrases[following[0]].plural:
        return None
    # One room between two: both are its neighbours, so each is a pair of its own.
    return Relation(lefts * len(following), tuple(following), False, index, index + 1), phrases[following[-1]].last


def _told_of_both(
    reading: Reading, phrases: list[Phrase], following: list[int], index: int
) -> tuple[Relation, int] | None:
    """Read "between the kitchen and the cold store is a direct connection" as of the two."""
    if len(following) < 2 or phrases[following[0]].first - index > 2:
        return None
    first, second = (phrases[number] for number in following)
    if not set(reading.words(first.last, second.begin)) <= {"and", "the"}:
        return None
    verb = second.last + (reading.word(second.last) == "there")
    end = next((at + 1 for at in range(verb + 1, verb + 6) if reading.word(at) in _CONTACTS), 0)
    if reading.word(verb) not in ("is", "should", "must", "be", "exist", "shall") or not end:
        return None
    reading.take(end - 1, end)
    return Relation((following[0],), (following[1],), False, index, index + 1), end


_CONTACTS = frozenset("neighbourhood neighborhood adjacency contact connection door passage opening hatch".split())
"""Nouns for what joins two rooms that are side by side."""


_TO_ALL = tuple(
    (*to, *rooms)
    for to in ((), ("to",), ("with",), ("into",), ("onto",))
    for rooms in (
        ("all", "of", "them"),
        ("them", "all"),
        ("all", "room"),
        ("all", "the", "room"),
        ("all", "other", "room"),
        ("all", "the", "other", "room"),
        ("every", "room"),
        ("every", "other", "room"),
        ("each", "of", "them"),
    )
)


def relation_to_all(
    reading: Reading, phrases: list[Phrase], rooms: list[int], index: int
) -> tuple[Relation, int] | None:
    """Read "a kitchen, a bath and a hallway that touches all of them" as of the hallway and each of the others."""
    if reading.word(index - 1) not in ("that", "which"):
        return None
    end = next((index + 1 + len(p) for p in _TO_ALL if reading.words(index + 1, index + 1 + len(p)) == p), 0)
    before = rooms_in_sentence(reading, phrases, rooms, index, before=True)
    if not end or len(before) < 2 or phrases[before[-1]].last != index - 1:
        return None
    return Relation((before[-1],), tuple(before[:-1]), False, index, end), end


def wall_relation(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int) -> tuple[Relation, int] | None:
    """Read "no common wall between the bedroom and the kitchen"; a wall that is not shared only parts the two."""
    if reading.word(index - 1) not in ("common", "shared", "party"):
        return None
    them = reading.word(index + 2) in ("them", "both") or reading.words(index + 2, index + 4) in _THE_TWO
    if them:
        named = rooms_in_sentence(reading, phrases, rooms, index, before=True)[-2:]
        last = index + 3 + (reading.word(index + 3) == "two")
        if len(named) < 2:
            return None
        return Relation((named[0],), (named[1],), is_negated(reading, phrases, rooms, index - 1), index - 1, last), last
    pair = rooms_in_sentence(reading, phrases, rooms, index, before=False)[:2]
    if len(pair) < 2 or phrases[pair[0]].begin - index > 4:
        return None
    if "and" not in reading.words(phrases[pair[0]].last, phrases[pair[1]].first):
        return None
    negated = is_negated(reading, phrases, rooms, index - 1)
    return Relation((pair[0],), (pair[1],), negated, index - 1, index + 2), phrases[pair[1]].last


_THE_TWO = (("the", "two"), ("these", "two"), ("those", "two"))
"""Words for two rooms that are named before."""


def _between_them(phrases: list[Phrase], before: list[int], index: int, last: int) -> tuple[Relation, int] | None:
    """Read "two bedrooms, the bathroom is between them" and "a bedroom, a bathroom, a cupboard between them"."""
    if len(before) < 2:
        return None
    subject, others = before[-1], before[:-1]
    several = [n for n in others if (phrases[n].count or 2) > 1]
    if phrases[others[-1]].count == 1 and len(others) > 1 and not (several and several[-1] == others[-1]):
        return Relation((subject, subject), tuple(others[-2:]), False, index, last), last
    owner = several[-1] if several else others[-1]
    return Relation((subject,), (owner,), False, index, last), last


def postposed_relation(
    reading: Reading, phrases: list[Phrase], rooms: list[int], index: int, last: int
) -> Relation | None:
    """Read "live room, control room adjacent": the room before is meant."""
    before = rooms_in_sentence(reading, phrases, rooms, index, before=True)
    side = reading.word(index) in ("adjacent", "adjoining", "attached", "beside", "alongside", "next", "at")
    if len(before) < 2 or not side:
        return None
    if phrases[before[-1]].last != index:
        return None
    return Relation((before[-1],), (before[-2],), False, index, last)


def _of_the_two(reading: Reading, first: int, last: int) -> bool:
    """Whether "these two", "the two rooms" or "they" stand between rooms and what is said of them both."""
    words = reading.words(first, last)
    return "they" in words or any(
        pair in (("these", "two"), ("the", "two"), ("those", "two")) for pair in itertools.pairwise(words)
    )


def _owners(reading: Reading, phrases: list[Phrase], before: list[int], index: int) -> list[int]:
    """Return the two that "the director and her assistant, whose offices must adjoin" tells of; none elsewhere."""
    whose = next((at for at in range(index - 1, max(index - 6, 0), -1) if reading.word(at) == "whose"), 0)
    pair = [number for number in before if phrases[number].last <= whose][-2:]
    joined = len(pair) == 2 and "and" in reading.words(phrases[pair[0]].last, phrases[pair[1]].first)
    return pair if whose and joined else []


_COMPANY = frozenset("eat dine cook work sit live play learn meet sleep talk relax study sing read dance".split())
"""What people do together, rather than rooms."""


def mutual_relation(
    reading: Reading, phrases: list[Phrase], rooms: list[int], index: int, last: int
) -> Relation | None:
    if reading.word(index) == "together" and reading.word(index - 1) in _COMPANY:
        return None  # "a kitchen where the shifts eat together"
    before = rooms_in_sentence(reading, phrases, rooms, index, before=True)
    if not before:
        return None
    pair = _owners(reading, phrases, before, index) or before[-2:]
    if len(pair) == 1:
        if not phrases[pair[0]].plural and phrases[pair[0]].count in (1, None):
            return None
        pair = pair * 2
    elif (
        phrases[pair[-1]].counted
        and (phrases[pair[-1]].count or 0) > 1
        and phrases[pair[-1]].determiner in ("the", "both", "these")
    ):
        pair = [pair[-1]] * 2
    elif not (
        set(reading.words(phrases[pair[0]].last, phrases[pair[1]].first)) & {"and", "with", "or", "plus", "&"}
        or _of_the_two(reading, phrases[pair[1]].last, index)
        or (phrases[pair[0]].room_type == phrases[pair[1]].room_type and phrases[pair[1]].last >= index - 1)
    ):
        return None
    negated = is_negated(reading, phrases, rooms, index)
    return Relation((pair[0],), (pair[1],), negated, index, last)

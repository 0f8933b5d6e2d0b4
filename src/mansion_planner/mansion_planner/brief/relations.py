"""Read and state which rooms are to be side by side or apart: "the kitchen next to the bar", "away from the stairs".

A relation joins the room named last before it and the rooms named right after it; pronouns stand for the room before.
"""

import itertools
from bisect import bisect_left
from collections.abc import Mapping, Sequence
from dataclasses import replace

from mansion_planner.brief.facts import AdjacencyFact, Span
from mansion_planner.brief.mutual_relations import (
    between_relation,
    closes_clause,
    mutual_relation,
    postposed_relation,
    relation_to_all,
    wall_relation,
)
from mansion_planner.brief.phrase import FUNCTION_WORDS, PLAIN, Phrase
from mansion_planner.brief.reading import FLOOR_WORDS, Reading
from mansion_planner.brief.relation_rooms import (
    Relation,
    is_negated,
    joint,
    rooms_after,
    rooms_before,
    rooms_in_sentence,
    subject_before,
    with_adverbs,
    with_alternatives,
)
from mansion_planner.brief.relation_words import (
    APART_AT,
    BESIDE_AT,
    LEADS,
    MUTUAL_AT,
    MUTUALLY_APART_AT,
    NEGATIONS,
    PRONOUNS,
)
from mansion_planner.brief.room_facts import identifier

__all__ = ["read_relations", "state_relations"]


def read_relations(reading: Reading, phrases: list[Phrase], excluded_phrases: set[int]) -> list[Relation]:
    """Return the relations from left to right; the tokens of their words are taken.

    Parameters
    ----------
    excluded_phrases : set of int
        Phrases that are no rooms of the building (the building itself).
    """
    rooms = [
        n
        for n, phrase in enumerate(phrases)
        if phrase.head in ("room", "building", "elevator", "stair") and n not in excluded_phrases
    ]
    relations: list[Relation] = []
    index = 0
    while index < len(reading.tokens):
        found = _relation_at(reading, phrases, rooms, index)
        if found is None:
            index += 1
            continue
        relation, last = found
        relation = _of_subject(reading, phrases, relation, relations[-1] if relations else None)
        relations.append(relation)
        reading.take(with_adverbs(reading, relation.first), relation.last)
        index = max(last, index + 1)
        excepted = _excepted(reading, phrases, rooms, relation)
        if excepted is not None:
            relations.append(excepted)
            reading.take(excepted.first, excepted.last)
            index = max(index, excepted.last)
    return relations


def _excepted(reading: Reading, phrases: list[Phrase], rooms: list[int], relation: Relation) -> Relation | None:
    """Return what a relation excepts: "adjacent to the restaurant but not to the lobby"."""
    first = phrases[relation.rights[-1]].last
    if relation.apart or reading.words(first, first + 2) not in (("but", "not"), (",", "not")):
        return None
    last = first + 2
    while reading.word(last) in ("to", "with", "near", "by", "beside", "next"):
        last += 1
    other = next((n for n in rooms if 0 <= phrases[n].begin - last <= 1 and n > relation.rights[-1]), None)
    if other is None or last == first + 2:
        return None
    return Relation(relation.lefts, (other,), True, first, last)


def _of_subject(reading: Reading, phrases: list[Phrase], relation: Relation, before: Relation | None) -> Relation:
    """Return a relation that goes on after a comma as of the same room: "beside the dock, away from the boiler"."""
    if before is None or relation.lefts != before.rights[-1:] or before.lefts == before.rights:
        return relation
    between = reading.words(phrases[relation.lefts[0]].last, relation.first)
    joined = between in ((",",), (",", "and"), (",", "but"), ("but",), ("and",), (",", "not"), ("but", "not"))
    return replace(relation, lefts=before.lefts) if joined else relation


def _relation_at(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int) -> tuple[Relation, int] | None:
    if reading.word(index) not in LEADS or _follows_unknown(reading, index):
        return None
    if reading.word(index) == "between" and index not in reading.taken:
        return between_relation(reading, phrases, rooms, index)
    if reading.word(index) == "from":
        return _reached_from(reading, phrases, rooms, index)
    if reading.words(index, index + 2) == ("wall", "between"):
        return wall_relation(reading, phrases, rooms, index)
    found = relation_to_all(reading, phrases, rooms, index) or _in_a_row(reading, phrases, rooms, index)
    found = found or _said_of_both(reading, phrases, rooms, index)
    if found is not None:
        return found
    if reading.words(index, index + 2) in (("to", "the"), ("of", "the")) and index not in reading.taken:
        return _belonging(reading, phrases, rooms, index)
    if reading.word(index) == "besides" and _adds(reading, index):
        return None
    apart = next((p for p in APART_AT.get(reading.word(index), ()) if reading.words(index, index + len(p)) == p), ())
    words = apart or _longest_at(reading, index, BESIDE_AT)
    if not words or (index in reading.taken and reading.word(index) not in ("direct", "open")):
        return None
    return _directed(reading, phrases, rooms, index, index + len(words), apart=bool(apart))


def _adds(reading: Reading, index: int) -> bool:
    """Whether "besides" means in addition to: "everything besides toilets", "a canteen besides toilets"."""
    after = index + 1
    if reading.word(after) in ("that", "this") and reading.word(after + 1) in (":", ","):
        return True  # "besides that: a hall"
    bare = reading.word(after) not in ("the", "a", "an", "it", "this", "that", "each", "every", "our", "its")
    return bare or reading.word(index - 1) in ("nothing", "anything", "everything", ",")


def _longest_at(reading: Reading, index: int, patterns: Mapping[str, Sequence[tuple[str, ...]]]) -> tuple[str, ...]:
    """Return the longest of some patterns that stands at a token; empty if none does."""
    found = (p for p in patterns.get(reading.word(index), ()) if reading.words(index, index + len(p)) == p)
    return max(found, key=len, default=())


def _in_a_row(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int) -> tuple[Relation, int] | None:
    """Read "a hall, a study and a library, each leading into the next" as pairs of neighbours."""
    if reading.words(index, index + 3) not in (("each", "leading", "into"), ("each", "opening", "into")):
        return None
    pairs = list(itertools.pairwise(rooms_in_sentence(reading, phrases, rooms, index, before=True)))
    last = index + 5
    firsts, seconds = tuple(a for a, _ in pairs), tuple(b for _, b in pairs)
    return (Relation(firsts, seconds, False, index, last), last) if pairs else None


def _said_of_both(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int) -> tuple[Relation, int] | None:
    """Read a relation of the rooms before it alone: "side by side", "live room, control room adjacent"."""
    apart = _longest_at(reading, index, MUTUALLY_APART_AT)
    if apart:
        told = mutual_relation(reading, phrases, rooms, index, index + len(apart))
        return None if told is None else (replace(told, apart=not told.apart), index + len(apart))
    mutual = _longest_at(reading, index, MUTUAL_AT)
    longer = index + len(_longest_at(reading, index, BESIDE_AT))
    last = index + len(mutual)
    if not mutual or not closes_clause(reading, last, phrases, rooms):
        return None
    if longer > last and (reading.word(longer) in PRONOUNS or rooms_after(reading, phrases, rooms, index, longer)):
        return None
    found = mutual_relation(reading, phrases, rooms, index, last)
    found = found or postposed_relation(reading, phrases, rooms, index, last)
    return (found, last) if found is not None else None


def _reached_from(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int) -> tuple[Relation, int] | None:
    """Read "from the kitchen one enters the pantry" and "a corridor; from it open all rooms: a kitchen, a bath"."""
    before = [n for n in rooms if phrases[n].last <= index]
    following = rooms_in_sentence(reading, phrases, rooms, index, before=False)
    if reading.word(index + 1) in ("it", "which", "there", "this") and before:
        origin, at = before[-1], index + 2
    elif following and phrases[following[0]].begin - index <= 2:
        origin, at = following[0], phrases[following[0]].last
    else:
        return None
    verb = next((i for i in range(at, at + 4) if reading.word(i) in _WAYS_IN), None)
    if verb is None or any(reading.kind(i) == "mark" or reading.word(i) == "and" for i in range(at, verb)):
        return None
    if not (NEGATIONS | {"cannot"}).isdisjoint(reading.words(index - 2, verb)):
        return None
    reached, last = [], verb + 1
    for number in (n for n in following if phrases[n].begin > verb):
        if not _LISTING.issuperset(reading.words(last, phrases[number].first)):
            break
        reached.append(number)
        last = phrases[number].last
    if not reached:
        return None
    return Relation((origin,) * len(reached), tuple(reached), False, index, verb + 1), last


_WAYS_IN = frozenset("enter enters go goes open opens lead leads reach reaches get gets branch access".split())
"""Verbs of who goes from a room into another, and of rooms that lie off one."""
_LISTING = frozenset(
    "in into to off away also directly the a an all room our and as well plus , : one each own separate".split()
)
"""Words between the rooms that are reached from another."""


def _follows_unknown(reading: Reading, index: int) -> bool:
    """Whether a relation is said of a noun that nothing is read of: "sterilizers between two of the surgeries"."""
    token = reading.tokens[index - 1] if index else None
    if token is None or token.kind != "word" or index - 1 in reading.taken or index in reading.taken:
        return False
    if reading.word(index - 2) not in (",", "and", ":", ";", "a", "an", "the", "with", "plus", ""):
        return False
    described = token.text.endswith(("ly", "ed", "ing")) or token.text in FUNCTION_WORDS | PLAIN | FLOOR_WORDS
    return not described and token.text not in _ADVERBS


_ADVERBS = frozenset(
    "direct right well far side door distance wall contact access there stay stays kept lie close".split()
)
"""Words right before a relation that are part of it."""


def _belonging(reading: Reading, phrases: list[Phrase], rooms: list[int], index: int) -> tuple[Relation, int] | None:
    """Read "an ensuite to the master bedroom"."""
    at = bisect_left(rooms, index, key=lambda n: phrases[n].last)
    if at + 1 >= len(rooms):
        return None
    owned, owner = rooms[at], rooms[at + 1]
    if phrases[owned].last != index or phrases[owned].room_type not in _OWNED:
        return None
    if phrases[owner].begin != index + 2 or phrases[owner].head != "room":
        return None
    return Relation((owned,), (owner,), False, index, index + 2), phrases[owner].last


_OWNED = frozenset({"ensuite_bathroom", "walk_in_closet", "dressing_room"})
"""Rooms that belong to another."""


def _directed(
    reading: Reading, phrases: list[Phrase], rooms: list[int], index: int, last: int, *, apart: bool
) -> tuple[Relation, int] | None:
    named = any(phrases[n].begin == last + 1 for n in rooms)  # "next to that office"
    pronoun = (reading.word(last) in PRONOUNS and not named) or reading.word(last - 1) == "it"
    rights = [] if pronoun else rooms_after(reading, phrases, rooms, index, last)
    before = rooms_in_sentence(reading, phrases, rooms, index, before=True)
    negated = apart or is_negated(reading, phrases, rooms, index)
    if negated:
        rights = with_alternatives(reading, phrases, rooms, rights)
    if not rights and _is_relative(reading, phrases, before, last):
        return Relation((before[-1],), (before[-2],), negated, index, last), last
    if not rights:
        pair = _with_pronoun(reading, phrases, rooms, index, last)
        return (Relation(*pair, negated, index, last), last) if pair is not None else None
    following = [n for n in rooms_in_sentence(reading, phrases, rooms, last, before=False) if n not in rights]
    gap = phrases[following[0]].first - phrases[rights[-1]].last if following else len(reading.tokens)
    if not before:  # "Next to the kitchen: the pantry", "beside the library a writing room"
        if gap > _FARTHEST:
            return None
        return Relation((following[0],), tuple(rights), negated, index, last), phrases[following[0]].last
    lefts = rooms_before(reading, phrases, before, index)
    inverted = not negated and gap <= _NEAR and _inverted(reading, phrases, before, index)
    if inverted and not joint(reading, phrases, rights[-1], following[0]):
        lefts = [following[0]]
    return Relation(tuple(lefts), tuple(rights), negated, index, last), last


_FARTHEST, _NEAR = 6, 4
"""Tokens between the room of an opening relation and its subject, and the same after a comma, at most."""


def _with_pronoun(
    reading: Reading, phrases: list[Phrase], rooms: list[int], index: int, last: int
) -> tuple[tuple[int, ...], tuple[int, ...]] | None:
    """Return the two sides of a relation to "it", "them", "one of those", or nothing."""
    of_them = reading.words(last, last + 2) in (("one", "of"), ("each", "of"), ("either", "of"), ("any", "of"))
    pronoun = next((i for i in range(last - 1, last + 2 + 2 * of_them) if reading.word(i) in PRONOUNS), None)
    if pronoun is None:
        return None
    before = rooms_in_sentence(reading, phrases, rooms, index, before=True)
    following = rooms_in_sentence(reading, phrases, rooms, last, before=False)
    earlier = [n for n in rooms if phrases[n].last <= index]
    if before and reading.word(index - 1) in (",", "and"):
        after_it = next((n for n in rooms if 0 <= phrases[n].first - pronoun - 1 <= 1), None)
        if after_it is not None:  # "the mayor's office, next to it the archive"
            return (after_it,), (before[-1],)
        if reading.word(pronoun + 1) == "," and following and phrases[following[0]].first - pronoun <= 3:
            return (following[0],), (before[-1],)  # "a preparation room and, adjoining it, the cold room"
    if following and earlier and (not before or reading.starts(index)):
        return (following[0],), (subject_before(reading, phrases, rooms, index),)
    lefts = rooms_before(reading, phrases, before, index)
    others = [n for n in earlier if n < min(lefts, default=0)]
    return (tuple(lefts), (_referent(reading, phrases, others, lefts),)) if lefts and others else None


def _is_relative(reading: Reading, phrases: list[Phrase], before: list[int], last: int) -> bool:
    """Whether a clause says of the room before it where another lies: "a kitchen that the lounge opens onto"."""
    if len(before) < 2 or not (reading.breaks(last) or reading.word(last) in (",", ")", "and")):
        return False
    return reading.words(phrases[before[-2]].last, phrases[before[-1]].begin)[:1] in (("that",), ("which",))


def _referent(reading: Reading, phrases: list[Phrase], others: list[int], lefts: list[int]) -> int:
    """Return which room "it" is: the one that has the room on the left ("a hall with a shoe room in front of it")."""
    sentence = reading.sentence[phrases[lefts[0]].first]
    for number in reversed(others):
        if reading.sentence[phrases[number].first] != sentence:
            break
        following = phrases[number + 1].first if number + 1 < len(phrases) else len(reading.tokens)
        having = reading.words(phrases[number].last, phrases[number].last + 2)
        if having in (("that", "has"), ("which", "has"), ("that", "have")) or having[0] in ("having", "has"):
            return number  # "a dining room that has the kitchen right beside it"
        if "with" in reading.words(phrases[number].last, min(following, phrases[number].last + 6)):
            return number
    return others[-1]


def _inverted(reading: Reading, phrases: list[Phrase], before: list[int], index: int) -> bool:
    """Whether the relation opens its clause: ", and next to the kitchen the pantry"."""
    return reading.word(index - 1) in (",", "and") and phrases[before[-1]].last < index


_THROUGH = frozenset(
    """
    open opening lead leading connected connect connecting linked joined link access accessed accessible reached entered
    communicate communicating attached passage off behind door doorway
    """.split()
)
"""Words of relations between rooms of which one is entered from the other."""
_STRAIGHT = (("direct",), ("directly",), ("straight",))
"""First words of relations between rooms of which one leads to the other: "the garage directly to the kitchen"."""
_BEYOND = frozenset({"opposite", "overlooking", "visible", "front"})
"""Words of relations that ask for more than a wall in common."""
_CLOSE = 8
_WORDS = 12
"""Tokens between a relation and a room that its statement names, and of a statement, at most."""


def state_relations(
    reading: Reading,
    phrases: Sequence[Phrase],
    relations: Sequence[Relation],
    same: Mapping[int, int],
    groups: Mapping[int, list[int]],
) -> None:
    """State each pair of rooms that a relation joins; the words of one that joins none are given back.

    Parameters
    ----------
    same : mapping of int to int
        For a later mention of a room, the phrase that names it first.
    groups : mapping of int to list of int
        For a mention of several rooms, the phrases that name them.
    """
    for relation in relations:
        held = reading.facts.apart if relation.apart else reading.facts.adjacent
        many = len(held)
        words = reading.words(relation.first, relation.last)
        for pair in _pairs(groups, relation, between=words[:1] == ("between",)):
            first, second = (phrases[same.get(n, n)] for n in pair)
            if not first.room_type or not second.room_type or "unknown" in (first.head, second.head):
                continue
            if relation.apart and first is second and first.count == 1:
                continue  # of "those labs" only one is known
            span = _span_of_relation(reading, relation, *(phrases[n] for n in pair))
            between = words[:1] == ("between",) and len(relation.rights) == 1 and second.plural
            held.append(
                AdjacencyFact(
                    first.room_type,
                    second.room_type,
                    span,
                    identifier(first.name),
                    identifier(second.name),
                    each=pair[0] != pair[1] and (first.count or 2) > 1 and not relation.apart,
                    door=not relation.apart and (not _THROUGH.isdisjoint(words) or words[:1] in _STRAIGHT),
                    sides=2 if between else 1,
                    beyond=() if relation.apart else tuple(word for word in words if word in _BEYOND),
                )
            )
        if len(held) == many:
            _tell(reading, relation)


def _span_of_relation(reading: Reading, relation: Relation, first: Phrase, second: Phrase) -> Span:
    """Return the words of a relation, with those of the rooms that stand close by."""
    if len(relation.rights) > 1 and not {"all", "every", "each"}.isdisjoint(
        reading.words(relation.first, relation.last)
    ):
        return reading.span(first.begin, relation.last)  # "a hallway that touches all of them"
    begin = min(first.begin, second.begin, relation.first)
    begin = begin if relation.first - begin <= _CLOSE else relation.first
    last = max(first.noun_end, second.noun_end, relation.last)
    return reading.span(begin, last if last - begin <= _WORDS else relation.last)


def _tell(reading: Reading, relation: Relation) -> None:
    """Give back the words of a relation that no statement was made of."""
    reading.taken.difference_update(range(relation.first, relation.last))


def _pairs(groups: Mapping[int, list[int]], relation: Relation, *, between: bool) -> list[tuple[int, int]]:
    whole = relation.lefts[0]
    if relation.lefts == relation.rights == (whole,) and whole in groups:
        group = groups[whole]
        return [(a, b) for n, a in enumerate(group) for b in group[n + 1 :]]
    lefts, rights = ([m for n in side for m in groups.get(n, [n])] for side in (relation.lefts, relation.rights))
    if relation.apart:
        alone = lefts == rights and len(lefts) == 1  # "the two bedrooms must not share a wall"
        return [(left, right) for left in lefts for right in rights if left != right or alone]
    if len(relation.lefts) == len(relation.rights) and len(relation.lefts) > 1:
        return list(zip(relation.lefts, relation.rights))
    if between:
        return [(left, right) for left in relation.lefts for right in rights]  # "between the two dormitories"
    return [(left, right) for left in relation.lefts for right in relation.rights]

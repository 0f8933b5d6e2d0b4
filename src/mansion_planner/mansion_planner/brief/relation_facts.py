"""State which rooms are to be side by side or apart, from the relations between their phrases."""

from collections.abc import Mapping, Sequence

from mansion_planner.brief.facts import AdjacencyFact, Span
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.relation_rooms import Relation
from mansion_planner.brief.room_facts import identifier

__all__ = ["state_relations"]

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

"""The main bedroom of a home has the bathroom and the closet that a brief lists beside it."""

from dataclasses import replace

from mansion_planner.brief.facts import BriefFacts, RoomFact

__all__ = ["with_master_suite"]

_HOSTS = ("master_suite", "master_bedroom")
_PRIVATE = ("ensuite_bathroom", "walk_in_closet")


def with_master_suite(facts: BriefFacts) -> BriefFacts:
    """Return facts in which an ensuite bathroom and a walk-in closet are reached through the one main bedroom.

    Several of a kind, and those on storeys of their own, stay rooms of the storey.

    Examples
    --------
    >>> from mansion_planner.brief.facts import Span
    >>> span = Span(0, 0, "")
    >>> rooms = [RoomFact("master_suite", "master_suite", span, 1), RoomFact("closet", "walk_in_closet", span, 1)]
    >>> [(room.name, [child.name for child in room.suite]) for room in with_master_suite(BriefFacts(rooms=rooms)).rooms]
    [('master_suite', ['closet'])]
    """
    hosts = [room for room in facts.rooms if room.room_type in _HOSTS]
    if len(hosts) != 1 or not _is_single(hosts[0]):
        return facts
    host = hosts[0]
    own = [
        room
        for room in facts.rooms
        if room.room_type in _PRIVATE and _is_single(room) and room.floors in ((), host.floors)
    ]
    own = [room for room in own if sum(other.room_type == room.room_type for other in facts.rooms) == 1]
    if not own:
        return facts
    whole = replace(host, suite=tuple(replace(room, floors=()) for room in own))
    rooms = [whole if room is host else room for room in facts.rooms if not any(room is other for other in own)]
    return replace(facts, rooms=rooms)


def _is_single(fact: RoomFact) -> bool:
    """Whether a brief asks for one room, by itself."""
    return fact.count == 1 and not fact.each and not fact.unit and not fact.suite

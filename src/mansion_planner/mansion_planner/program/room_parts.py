"""Rooms of a home that belong to one: nooks that are furniture of it, bathroom and closet of the main bedroom."""

from dataclasses import replace

from mansion_knowledge import BuildingType
from mansion_planner.brief.facts import AdjacencyFact, BriefFacts, ObjectFact, RoomFact
from mansion_planner.brief.niches import NICHES, THING_FOR

__all__ = ["with_master_suite", "with_room_parts"]

_LIVING = ("living_room", "lounge", "studio_room")
_EATING = ("living_room", "kitchen_diner", "open_kitchen", "kitchen", "studio_room")

_OTHERWISE = {"sofa": "sofa", "fireplace": "fireplace", "fire": "fireplace", "play": "play_mat", "piano": "piano"}
"""Furniture that makes a corner one beside what a brief's niches are for, or instead of it."""

_HOSTS: dict[str, tuple[str, ...]] = {
    **dict.fromkeys(("tv", "television", "media", "seating", "sitting", "sofa", "fireplace", "fire"), _LIVING),
    **dict.fromkeys(("music", "piano"), _LIVING),
    "reading": (*_LIVING, "bedroom", "master_bedroom"),
    **dict.fromkeys(("play", "homework"), (*_LIVING, "childrens_room")),
    **dict.fromkeys(("work", "desk", "study", "office", "computer"), (*_LIVING, "bedroom")),
    **dict.fromkeys(("dining", "eating"), _EATING),
    "breakfast": ("kitchen", "open_kitchen", "kitchen_diner", "living_room"),
    **dict.fromkeys(("sleeping", "bed", "sleep"), ("studio_room",)),
}
"""What a corner is called after, and the rooms that it may be part of."""


def with_room_parts(building: BuildingType, facts: BriefFacts) -> BriefFacts:
    """Return the facts of a home in which corners of a room are the furniture that they are for.

    A corner with an area or rooms of its own, several of them, and those of public buildings stay rooms, and so do
    those of a room that the home does not have.
    """
    if building.family != "home":
        return facts
    found = [(room, _part_of(room, building, facts)) for room in facts.rooms]
    parts = {room.name: wanted for room, wanted in found if wanted is not None}

    def within(fact: ObjectFact) -> ObjectFact:
        host = parts.get(fact.room)
        return fact if host is None else replace(fact, room=host.room, room_type=host.room_type)

    def joins(fact: AdjacencyFact) -> bool:
        return not {fact.first_name, fact.second_name} & parts.keys()

    return replace(
        facts,
        rooms=[_slept_in(room) for room, wanted in found if wanted is None],
        objects=[*map(within, facts.objects), *parts.values()],
        adjacent=[fact for fact in facts.adjacent if joins(fact)],
        apart=[fact for fact in facts.apart if joins(fact)],
    )


def _slept_in(room: RoomFact) -> RoomFact:
    """Return a room, a nook to sleep in as a bedroom: only studios have their bed where people live."""
    use, _, head = room.name.rpartition("_")
    bed = head in NICHES and use in _HOSTS and _thing_for(use) == "bed"
    return replace(room, room_type="bedroom") if bed else room


def _thing_for(use: str) -> str:
    return _OTHERWISE.get(use) or THING_FOR[use]


def _part_of(room: RoomFact, building: BuildingType, facts: BriefFacts) -> ObjectFact | None:
    """Return the furniture that a corner of another room stands for; ``None`` for a room."""
    use, _, head = room.name.rpartition("_")
    hosts = _HOSTS.get(use)
    if head not in NICHES or hosts is None or room.count != 1 or room.area or room.size or room.suite or room.each:
        return None
    others = [other for other in facts.rooms if other.room_type in hosts and other.count == 1 and other is not room]
    others = [other for other in others if not (room.floors and other.floors) or other.floors == room.floors]
    several = any(wanted.room == room.name and (wanted.count or 1) > 1 for wanted in facts.objects)
    if several and room.floors and not others:
        return None  # "on the landing a homework nook with three desks"
    before = [other for other in others if other.span.start < room.span.start]
    host = max(before, key=lambda other: other.span.start, default=next(iter(others), None))
    usual = {building.hub, *(entry.room_type for entries in building.storeys.values() for entry in entries)}
    own = next((kind for kind in hosts if kind in usual), "")
    name, kind = (host.name, host.room_type) if host is not None else (own, own)
    return ObjectFact(
        words=room.span.words, category=_thing_for(use), span=room.span, room=name, room_type=kind, floors=room.floors,
        noun=room.label or room.name.replace("_", " "),
    ) if kind else None  # fmt: skip


_MAIN_BEDROOMS = ("master_suite", "master_bedroom")
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
    hosts = [room for room in facts.rooms if room.room_type in _MAIN_BEDROOMS]
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

"""Rooms that the rules of building ask for beside others: kitchens of dining rooms, changing rooms, washrooms."""

import math
from collections.abc import Sequence

import msgspec

from mansion_knowledge import KnowledgeBase
from mansion_knowledge.norms import load_norms
from mansion_planner.program.allocation import Allocation
from mansion_planner.program.model import PlannedRoom, Storey
from mansion_planner.program.planned_rooms import planned_room

__all__ = ["for_sleepers", "with_changing_rooms", "with_kitchen"]

_KITCHEN = "commercial_kitchen"

_OF_DINING = 0.35
"""Area of a kitchen to that of the room that it cooks for."""

_TIGHT = 0.8
"""Share of that area to which it may shrink."""


def with_kitchen(
    rooms: Sequence[PlannedRoom], storey: Storey, allocation: Allocation, knowledge: KnowledgeBase, hub: float = 0.0
) -> list[PlannedRoom]:
    """Return the rooms of a storey, with a kitchen where meals are served without one and the brief allows it.

    A single kitchen that the brief asks for is as large as its guests need.

    Parameters
    ----------
    hub : float
        Square metres of the storey's hub, where it is its main room.
    """
    rule, kept = load_norms().rules["kitchen_of_dining"], list(rooms)
    dining = [room for room in kept if room.kind.name in rule.rooms]
    served = sum(room.area for room in dining) + (hub if storey.hub.name in rule.rooms else 0.0)
    least = _OF_DINING * served
    cooks = [room for top in kept for room in top.each() if room.kind.name in rule.others]
    if served and len(cooks) == 1 and not cooks[0].fixed and cooks[0].area < least:
        area = min(least, knowledge.room(_KITCHEN).usual)
        return [room.changed(lambda one: _at_least(one, area) if one is cooks[0] else one) for room in kept]
    refused = not all(allocation.adds(name, storey.index) for name in (_KITCHEN, "kitchen"))
    if not served or cooks or refused:
        return kept
    kind = knowledge.room(_KITCHEN)
    kitchen = planned_room(kind, knowledge, area=min(max(_OF_DINING * served, kind.least), kind.usual))
    place = kept.index(dining[0]) + 1 if dining else 0
    return [*kept[:place], kitchen, *kept[place:]]


def _at_least(kitchen: PlannedRoom, area: float) -> PlannedRoom:
    """Return a kitchen of no less than `area` square metres."""
    area = max(area, kitchen.area)
    return msgspec.structs.replace(
        kitchen, area=area, least=max(kitchen.least, _TIGHT * area), most=max(kitchen.most, area)
    )


_CHANGING = "changing_room"

_EACH = 14.0
"""Square metres of a changing room for one sex beside a hall for sport of another building."""

_HALL = 100.0
"""Square metres from which on a room for sport has two."""


def with_changing_rooms(
    rooms: Sequence[PlannedRoom], storey: Storey, allocation: Allocation, knowledge: KnowledgeBase
) -> list[PlannedRoom]:
    """Return the rooms of a storey, with changing rooms where a hall for sport is asked for without any.

    Homes, and buildings for which the brief asks some on any storey, have no others.
    """
    rule, kept = load_norms().rules["sports_changing"], list(rooms)
    halls = [room for room in kept if room.kind.name in rule.rooms and room.stated and room.area >= _HALL]
    told = any(fact.room_type == _CHANGING for facts in allocation.wanted.values() for fact in facts)
    there = told or any(room.kind.name == _CHANGING for room in kept)
    if not halls or there or storey.use.family == "home" or not allocation.adds(_CHANGING, storey.index):
        return kept
    room = planned_room(knowledge.room(_CHANGING), knowledge, area=_EACH)
    place = kept.index(halls[0]) + 1
    return [*kept[:place], room, room, *kept[place:]]


_SLEEPER, _IN_PAIRS = 3.2, 9.0
"""Square metres for each sleeper of a room with several beds, and where some beds of single rooms are for two."""

_AREAS = {"shared_toilets": (("restroom",), 5.75, 2.0), "shared_showers": (("shower_area",), 3.1, 2.0)}
"""By rule the rooms that hold the fixtures, the square metres for each, and those for walls and the door."""


def for_sleepers(rooms: Sequence[PlannedRoom], storey: Storey) -> list[PlannedRoom]:
    """Return a storey's rooms, the restrooms and showers of its own list large enough for those who sleep on it."""
    norms, kept = load_norms(), list(rooms)
    for name, (kinds, each, around) in _AREAS.items():
        rule = norms.rules[name]
        shared = [room for room in kept if room.kind.name in rule.rooms and not any(r.kind.toilet for r in room.suite)]
        needed = math.ceil(sum(_sleepers(room, storey) for room in shared) / rule.limit(storey.use.name))
        own = [room for room in kept if room.kind.name in kinds]
        if not shared or not own or any(room.stated for room in own):
            continue
        area = each * needed / len(own) + around
        kept = [
            msgspec.structs.replace(room, area=area, least=area, most=max(area, room.most))
            if room in own and room.area < area else room
            for room in kept
        ]  # fmt: skip
    return kept


def _sleepers(room: PlannedRoom, storey: Storey) -> float:
    """Return how many people sleep in a room: as many as the building type says, or as its area has beds for."""
    beds = storey.use.seats
    if beds is not None and beds.room_type == room.kind.name:
        return max(float(beds.area or 1.0), room.area / _IN_PAIRS)
    return max(room.area / _SLEEPER, 1.0)

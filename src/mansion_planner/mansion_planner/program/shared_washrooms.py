"""Toilets and showers of storeys whose sleepers share them: as many as the rules of building ask."""

import math
from collections.abc import Sequence

import msgspec

from mansion_knowledge.norms import load_norms
from mansion_planner.program.model import PlannedRoom, Storey

__all__ = ["for_sleepers"]

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

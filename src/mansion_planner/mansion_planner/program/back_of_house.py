"""Rooms that may not open to the public hall: stores and cells are reached through a room of the staff's."""

from collections.abc import Iterable, Sequence

import msgspec

from mansion_knowledge import RoomType
from mansion_knowledge.norms import load_norms
from mansion_planner.program.model import PlannedRoom, Storey

__all__ = ["behind_staff_rooms"]

_RULES = ("service_door", "secure_door")
"""Rules that say which rooms have no door to which public ones."""

_MOST_BEHIND = 5
"""Rooms that one room leads to at most."""


def behind_staff_rooms(rooms: Sequence[PlannedRoom], storey: Storey, named: Iterable[str] = ()) -> list[PlannedRoom]:
    """Return a storey's rooms, those that may not open to its hub in the suite of a room that may.

    Rooms of a stated area, rooms with a suite of their own, and those `named` in wishes for neighbours stay.
    """
    barred = {
        name for rule in _RULES for name in load_norms().rules[rule].others
        if storey.hub.name in load_norms().rules[rule].rooms
    }  # fmt: skip
    kept = set(named)
    moving = [
        room for room in rooms
        if room.kind.name in barred and not room.fixed and not room.suite and not any(room.called(n) for n in kept)
    ]  # fmt: skip
    found = [room for room in rooms if not any(room is other for other in moving)]
    for room in moving:
        hosts = [number for number, host in enumerate(found) if _leads_to(host, room.kind, barred)]
        if hosts:
            best = max(hosts, key=lambda number: _fit(found[number], room.kind))
            found[best] = msgspec.structs.replace(found[best], suite=(*found[best].suite, room))
        else:
            found.append(room)
    return found


def _leads_to(host: PlannedRoom, kind: RoomType, barred: set[str]) -> bool:
    """Whether a room may lead to another: one of the staff's, that is no toilet and not itself kept from the hub."""
    staff = host.kind.zone == "service" and not host.kind.toilet and not host.fixed
    return (
        staff and host.kind.name not in barred and len(host.suite) < _MOST_BEHIND and (host.kind.food or not kind.food)
    )


def _fit(host: PlannedRoom, kind: RoomType) -> tuple[bool, bool, float]:
    """Prefer a room that belongs beside, one that holds no food for what is not to do with it, then a large one."""
    beside = host.kind.name in kind.near or kind.name in host.kind.near
    return beside, "kitchen" in host.kind.name and "storage" in kind.name, host.area

"""Which rooms lie side by side or lead into others: used together, behind those of staff, entered as a brief tells."""

import itertools
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from typing import Final

import msgspec

from mansion_knowledge import RoomType, is_class
from mansion_knowledge.leads_into import CalledRoom, leading_rules
from mansion_knowledge.norms import load_norms
from mansion_planner.brief.facts import AdjacencyFact
from mansion_planner.program.model import DOOR_WALL, Placement, PlannedRoom, Sketch, Storey, shared_wall

__all__ = ["behind_staff_rooms", "entered_as_told", "pairs_used_together"]

_MOST: Final = 40.0
"""Largest room that has its only door to another room, square metres; a larger one is a thoroughfare."""


def entered_as_told(sketch: Sketch, wishes: Sequence[AdjacencyFact]) -> Sketch:
    """Return a sketch in which rooms are reached from the rooms that a brief has them entered from.

    The room outdoors, else the first named, is reached from the other one instead of from a corridor. It stays as it is
    where they share no wall that takes a door, or where others are reached through it.

    Parameters
    ----------
    sketch : Sketch
    wishes : sequence of AdjacencyFact
        Those without `door` are passed over.
    """
    for fact in wishes:
        moved = next(_moves(sketch, fact), None) if fact.door else None
        if moved is not None:
            inner, outer = moved
            rooms = [msgspec.structs.replace(p, parent=outer.room.id) if p is inner else p for p in sketch.rooms]
            sketch = replace(sketch, rooms=rooms)
    return sketch


def _moves(sketch: Sketch, fact: AdjacencyFact) -> Iterator[tuple[Placement, Placement]]:
    """Yield rooms that a wish means and that can change what they are reached from, each with that room."""
    corridors = {corridor.id for corridor in sketch.corridors}
    entered = {p.parent for p in sketch.rooms} | set(sketch.core_parent.values())
    firsts, seconds = (
        [p for p in sketch.rooms if p.room.called(name)]
        for name in (fact.first_name or fact.first, fact.second_name or fact.second)
    )
    pairs = [(a, b) for a in firsts for b in seconds if a is not b]
    pairs += [(b, a) for a, b in pairs]
    pairs.sort(key=lambda pair: not is_class(pair[0].room.kind.name, "outdoor"))
    for inner, outer in pairs:
        free = inner.parent in corridors and inner.room.id not in entered and inner.area <= _MOST
        if free and outer.parent != inner.room.id and shared_wall(inner.boxes, outer.boxes) >= DOOR_WALL:
            yield inner, outer


_RULES = ("service_door", "secure_door")
"""Rules that say which rooms have no door to which public ones."""

_UNDRESSED_IN = frozenset({"changing_room", "shower_area"})
"""Rooms that nobody else passes through."""

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
    staff = host.kind.zone == "service" and not (host.kind.toilet or host.fixed or host.kind.name in _UNDRESSED_IN)
    return (
        staff and host.kind.name not in barred and len(host.suite) < _MOST_BEHIND and (host.kind.food or not kind.food)
    )


def _fit(host: PlannedRoom, kind: RoomType) -> tuple[bool, bool, float]:
    """Prefer a room that belongs beside, one that holds no food for what is not to do with it, then a large one."""
    beside = host.kind.name in kind.near or kind.name in host.kind.near
    return beside, "kitchen" in host.kind.name and "storage" in kind.name, host.area


def pairs_used_together(storey: Storey) -> list[tuple[str, str]]:
    """Return the rooms of a storey that are used together, by name: the one that leads into the other last.

    Homes have pairs of their own (`home_orders`).
    """
    family = storey.use.family
    if family == "home":
        return []
    pairs = [
        (into.base, room.base)
        for room, into in itertools.permutations(storey.rooms, 2)
        if room.base != into.base and leading_rules(_called(room), _called(into), family)
    ]
    return list(dict.fromkeys(pairs))


def _called(room: PlannedRoom) -> CalledRoom:
    return CalledRoom(room.kind.name, f"{room.label} {room.base}".replace("_", " "))

"""Make the rooms to be placed: of a type or as the brief asks for them, with their suites and the rooms of units."""

from collections.abc import Sequence
from dataclasses import replace

import msgspec

from mansion_knowledge import KnowledgeBase, RoomType
from mansion_language import singular
from mansion_planner.brief.bounds import within_bound
from mansion_planner.brief.facts import RoomFact
from mansion_planner.brief.sizes import size_bound
from mansion_planner.program.household import household_of, is_whole, main_room
from mansion_planner.program.model import PlannedRoom

__all__ = ["planned_room"]


_TIGHT = 0.8
"""Share of the floor that furniture needs to which a room may shrink."""


def planned_room(
    kind: RoomType, knowledge: KnowledgeBase, *, area: float | None = None, fact: RoomFact | None = None
) -> PlannedRoom:
    """Make a room of a type with its suite; the area of a fact is kept."""
    if fact is not None and fact.unit:
        return _planned_unit(kind, knowledge, fact)
    stated = fact is not None and fact.area is not None
    if fact is not None and fact.size and not stated:
        return _sized_room(kind, knowledge, fact)
    wish = within_bound(fact.area, fact.limit) if fact is not None and fact.area is not None else area or kind.usual
    furnished = fact is not None and wish > kind.usual
    return PlannedRoom(
        id=fact.name if fact is not None else kind.name,
        kind=kind,
        area=wish,
        least=wish if stated else max(min(kind.least, wish), _TIGHT * wish if furnished else 0.0),
        most=wish if stated else max(kind.most, 1.15 * wish if furnished else wish),
        fixed=stated,
        stated=fact is not None,
        suite=_suite(kind, knowledge, fact.suite if fact is not None else ()),
        notes=f"from {fact.span.words!r}" if fact is not None else "",
        base=fact.name if fact is not None else kind.name,
        label=_label_of_one(fact) if fact is not None else "",
    )


def _label_of_one(fact: RoomFact) -> str:
    """Return what the brief calls one of several rooms: "guest room" of "three guest rooms"."""
    first, gap, last = fact.label.rpartition(" ")
    one = fact.name.rpartition("_")[2]
    if last.lower() == one or singular(last.lower()) != one:
        return fact.label
    return f"{first}{gap}{one.capitalize() if last[:1].isupper() else one}"


def _sized_room(kind: RoomType, knowledge: KnowledgeBase, fact: RoomFact) -> PlannedRoom:
    """Make a room that is to be large or small for its kind; it may be more so than that."""
    wish = within_bound(*size_bound(fact.size, kind.least, kind.usual))
    large = fact.size == "large"
    return msgspec.structs.replace(
        planned_room(kind, knowledge, fact=replace(fact, size="")),
        area=wish,
        least=wish if large else min(kind.least, wish),
        most=max(kind.most, wish) if large else wish,
    )


def _suite(kind: RoomType, knowledge: KnowledgeBase, stated: Sequence[RoomFact]) -> tuple[PlannedRoom, ...]:
    """Make the rooms reached through one of a type: those stated, and the type's own of other zones."""
    rooms = [
        planned_room(knowledge.room(child.room_type), knowledge, fact=child)
        for child in stated
        for _ in range(child.count or 1)
    ]
    taken = {knowledge.room(child.room_type).zone for child in stated}
    for entry in kind.suite:
        child_kind = knowledge.room(entry.room_type)
        if not stated or child_kind.zone not in taken:
            rooms.append(planned_room(child_kind, knowledge, area=entry.area))
    return tuple(rooms)


def _planned_unit(kind: RoomType, knowledge: KnowledgeBase, fact: RoomFact) -> PlannedRoom:
    """Make the main room of a unit with the rooms that are reached through it; all share a stated area."""
    whole = fact.area if is_whole(fact, knowledge) else None
    main = main_room(fact, knowledge)
    stated, added = household_of(fact, knowledge)
    own = main.area if main is not None else None if whole else fact.area
    room = planned_room(kind, knowledge, fact=replace(fact, unit=False, suite=(), area=own))
    hall = kind.zone == "public" and not (kind.unit or room.fixed)
    rooms = [
        planned_room(knowledge.room(child.room_type), knowledge, fact=child)
        for child in stated
        for _ in range(child.count or 2)
    ]
    rooms += [
        planned_room(knowledge.room(entry.room_type), knowledge, area=entry.area)
        for entry in added
        for _ in range(entry.count)
    ]
    unit = msgspec.structs.replace(
        room,
        area=min(room.area, max(kind.least, _HALL)) if hall else room.area,
        notes=f"from {fact.label!r}",
        suite=tuple(rooms),
        serves_as=tuple(dict.fromkeys((main.room_type, main.name))) if main is not None else (),
    )
    return _of_area(unit, whole) if whole else unit


_HALL = 20.0
"""Square metres of the room that a cluster's or an office unit's other rooms are reached through."""

_LEAST_SHARE = 0.4
"""Share of its usual area that a room of a dwelling keeps whatever the area of the whole."""


def _of_area(unit: PlannedRoom, area: float) -> PlannedRoom:
    """Return a unit of `area` square metres: its rooms without a stated area of their own share what others leave."""
    rooms = unit.each()
    spare = area - sum(room.area for room in rooms if room.fixed)
    factor = max(spare / max(sum(room.area for room in rooms if not room.fixed), 1.0), _LEAST_SHARE)

    def scaled(room: PlannedRoom) -> PlannedRoom:
        if room.fixed:
            return room
        own = room.area * factor
        return msgspec.structs.replace(room, area=own, least=own, most=own, fixed=True)

    return unit.changed(scaled)

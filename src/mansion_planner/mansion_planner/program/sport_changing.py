"""The changing rooms of a hall for sport that a brief asks for, as the rules of building ask."""

from collections.abc import Sequence

from mansion_knowledge import KnowledgeBase
from mansion_knowledge.norms import load_norms
from mansion_planner.program.allocation import Allocation
from mansion_planner.program.model import PlannedRoom, Storey
from mansion_planner.program.planned_rooms import planned_room

__all__ = ["with_changing_rooms"]

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

"""Whether a brief tells what a building holds, so that it is as large as that and has hardly a room besides."""

from mansion_knowledge import BuildingType, KnowledgeBase
from mansion_planner.brief.facts import BriefFacts, RoomFact

__all__ = ["counted_rooms", "tells_program"]

_KINDS = 2
"""Kinds of rooms that such a brief names, unless it counts several of one."""

_ALL_KINDS = 5
"""Kinds of rooms named from which they are all that a building has, where no kind is what it is there for: an office's.
"""


def counted_rooms(facts: BriefFacts, building: BuildingType) -> list[RoomFact]:
    """Return the rooms of a brief of which it counts several, and such buildings many: the guest rooms of a hotel."""
    repeated = {entry.room_type for entries in building.storeys.values() for entry in entries if entry.repeat}
    return [room for room in facts.rooms if room.room_type in repeated and (room.count or 0) > 1]


def tells_program(facts: BriefFacts, building: BuildingType, knowledge: KnowledgeBase) -> bool:
    """Whether a brief tells what a public building is there for, and what else it has.

    It counts the rooms that such buildings repeat, names all that they are there for, or names many kinds where they
    are there for none in particular and their size is not told; and the type says which rooms it cannot do without
    besides (`BuildingType.needed`).
    """
    if building.needed is None or building.family == "home":
        return False
    if counted_rooms(facts, building):
        return True
    told = {knowledge.room(room.room_type).counts_as for room in facts.rooms if room.count is not None}
    told |= {room.room_type for room in facts.rooms if room.count is not None}
    if not building.main:
        sized = facts.floors or facts.area or facts.floor_area or facts.occupants or facts.size or facts.uses
        return not sized and len({room.room_type for room in facts.rooms if room.count is not None}) >= _ALL_KINDS
    several = len(told) >= _KINDS or any((room.count or 0) > 1 for room in facts.rooms)
    several |= building.parti == "hall"  # its name tells the hall that it is
    return building.main <= told and several

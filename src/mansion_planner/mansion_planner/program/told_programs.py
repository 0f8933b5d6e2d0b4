"""Whether a brief tells what a building holds, so that it is as large as that and has hardly a room besides."""

from mansion_knowledge import BuildingType, KnowledgeBase
from mansion_planner.brief.facts import BriefFacts, RoomFact

__all__ = ["counted_rooms", "tells_program"]

_KINDS = 2
"""Kinds of rooms that such a brief names, unless it counts several of one."""


def counted_rooms(facts: BriefFacts, building: BuildingType) -> list[RoomFact]:
    """Return the rooms of a brief of which it counts several, and such buildings many: the guest rooms of a hotel."""
    repeated = {entry.room_type for entries in building.storeys.values() for entry in entries if entry.repeat}
    return [room for room in facts.rooms if room.room_type in repeated and (room.count or 0) > 1]


def tells_program(facts: BriefFacts, building: BuildingType, knowledge: KnowledgeBase) -> bool:
    """Whether a brief tells what a public building is there for, and what else it has.

    It counts the rooms that such buildings repeat, or names all that they are there for; and the type says which rooms
    it cannot do without besides (`BuildingType.needed`).
    """
    if building.needed is None or building.family == "home":
        return False
    if counted_rooms(facts, building):
        return True
    told = {knowledge.room(room.room_type).counts_as for room in facts.rooms if room.count is not None}
    told |= {room.room_type for room in facts.rooms if room.count is not None}
    several = len(told) >= _KINDS or any((room.count or 0) > 1 for room in facts.rooms)
    several |= building.parti == "hall"  # its name tells the hall that it is
    return bool(building.main) and building.main <= told and several

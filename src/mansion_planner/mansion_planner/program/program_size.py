"""Size a building by the rooms that the brief counts, where it states neither storeys nor areas."""

from typing import NamedTuple

from mansion_knowledge import BuildingType, KnowledgeBase
from mansion_planner.brief.facts import BriefFacts, RoomFact
from mansion_planner.program.told_programs import counted_rooms, tells_program

__all__ = ["ProgramSize", "size_of_program"]

_GROSS, _GROSS_TOLD = 1.8, 1.45
"""Gross area for each square metre of counted rooms: walls, corridors, baths and the lesser rooms beside them; and of
rooms of a brief that tells all that the building holds."""
_ENTRANCE = 80.0
"""Square metres of reception, toilets and stairs that a building has whatever its size."""


class ProgramSize(NamedTuple):
    """How large a building is that holds the rooms asked for: storeys, and square metres of each."""

    storeys: int
    area: float
    words: str


def size_of_program(facts: BriefFacts, building: BuildingType, knowledge: KnowledgeBase) -> ProgramSize | None:
    """Return the size that the counted rooms of a brief ask for, ``None`` where the usual size of its type stands.

    A brief that counts the rooms that its type of building repeats (the guest rooms of a hotel, the classrooms of a
    school), or names what it is there for and what else it has, tells how large the building is: "a hotel with 12
    rooms" is no house of five storeys. Homes, and briefs that say anything else of the size, keep theirs; so do those
    that ask for the usual size or more.
    """
    parked = _parked(facts, building)
    if parked is not None:
        return parked
    told_otherwise = facts.area or facts.floor_area or facts.occupants or facts.uses or facts.copies
    says_size = bool(told_otherwise) or any(word != "small" for word, _ in facts.size)
    placed = any(room.floors for room in facts.rooms)
    if building.family == "home" or building.parti != "spine" or says_size or placed:
        return None
    counted, told = counted_rooms(facts, building), tells_program(facts, building, knowledge)
    unsized = any(word == "small" for word, _ in facts.size) and not told
    if unsized or not (counted or told) or any(room.each for room in facts.rooms):
        return None
    least, usual = building.floor_area
    gross = _GROSS_TOLD if told and building.main else _GROSS
    whole = gross * sum(_area(room, knowledge) for room in facts.rooms) + _ENTRANCE
    storeys = max(1, -(-int(whole) // int(1.1 * usual)))
    if storeys >= building.floors[0]:
        return None
    return ProgramSize(storeys, max(least, whole / storeys), (counted or facts.rooms)[0].span.words)


_PARKED = 32.0
"""Gross square metres for each car of a car park, with its lanes and stairs."""


def _parked(facts: BriefFacts, building: BuildingType) -> ProgramSize | None:
    """Return the size of a car park for so many cars, where the brief says nothing else of its size."""
    cars = [wanted for wanted in facts.objects if wanted.category == "garage_car" and wanted.count]
    if building.name != "parking_garage" or not cars or facts.floors or facts.area or facts.floor_area:
        return None
    whole = _PARKED * sum(wanted.count or 0 for wanted in cars) + _ENTRANCE
    storeys = max(1, -(-int(whole) // int(building.floor_area[1])))
    return ProgramSize(storeys, whole / storeys, cars[0].span.words)


def _area(room: RoomFact, knowledge: KnowledgeBase) -> float:
    one = room.area if room.area is not None else knowledge.room(room.room_type).usual
    return one * (room.count or 1)

"""How large a building is: by the people and rooms that its brief tells, and where it is called small or large."""

from typing import Final, NamedTuple

from mansion_knowledge import BuildingType, KnowledgeBase
from mansion_planner.brief.bounds import Limit
from mansion_planner.brief.facts import BriefFacts, RoomFact, Span

__all__ = [
    "ProgramSize",
    "called_bound",
    "called_size",
    "counted_rooms",
    "people_of",
    "size_of_program",
    "tells_program",
    "within_called",
]

_DESKS: Final = frozenset({"desk", "office_desk", "standing_desk"})


def people_of(facts: BriefFacts, building: BuildingType) -> tuple[int, Span | None]:
    """Return how many people a building is for, and the words that say so; 0 where none do.

    An office is for those who sit at the desks that are counted, unless its brief tells people or storeys.
    """
    if facts.occupants:
        return sum(people.count for people in facts.occupants), facts.occupants[0].span
    desks = [
        thing
        for thing in facts.objects
        if thing.category in _DESKS and not (thing.each or thing.excluded or thing.floors)
    ]
    if building.family != "office" or not desks or facts.floors:
        return 0, None
    return sum(thing.count or 0 for thing in desks), desks[0].span


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


_SMALL, _LARGE = 0.88, 1.1
"""Shares of the usual gross area that bound what is called small or large."""

_WITHIN: Final = 0.04
"""Share by which a planned area stays within its bound: whole metres and walls move it."""

_SET_BACK: Final = 0.22
"""Share by which the ground floor of a house exceeds it: the storeys above may be set back."""


def called_size(facts: BriefFacts) -> str:
    """Return what the brief calls the building, ``small`` or ``large``; empty for neither."""
    return next((word for word, _ in facts.size if word in ("small", "large")), "")


def called_bound(facts: BriefFacts, building: BuildingType, storeys: int | None) -> tuple[float | None, Limit]:
    """Return the gross area that bounds a building which is called small or large, and which way.

    An area that the brief states says itself what is meant; then there is no bound.

    Parameters
    ----------
    storeys : int, optional
        How many are stated; the usual number where none is.
    """
    size = called_size(facts)
    if not size or facts.area or facts.floor_area:
        return None, ""
    usual = _usual_storey(building) * (storeys or building.floors[0])
    if size == "large":
        return float(round(_LARGE * usual)), "least"
    return float(round(building.small * (storeys or 1) if building.small else _SMALL * usual)), "most"


def _usual_storey(building: BuildingType) -> float:
    """Return the usual area of a storey; houses are drawn from the least to the greatest that is usual."""
    least, most = building.floor_area
    return (least + most) / 2.0 if building.parti == "house" else most


def within_called(area: float, facts: BriefFacts, building: BuildingType, storeys: int, stated: int | None) -> float:
    """Return the area of a storey, lessened or raised to what the building is called.

    Parameters
    ----------
    area : float
        What a storey has otherwise, square metres.
    storeys : int
        How many it has.
    stated : int, optional
        How many are stated.
    """
    bound, limit = called_bound(facts, building, stated)
    if bound is None:
        return area
    if limit == "least":
        spare = _SET_BACK if building.parti == "house" and storeys > 1 else _WITHIN
        return max(area, (1.0 + spare) * bound / storeys)
    return min(area, (1.0 - _WITHIN) * bound / storeys)

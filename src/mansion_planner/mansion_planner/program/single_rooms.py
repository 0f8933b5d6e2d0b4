"""Beds of rooms that are told to be for one person: "ten single rooms" have one bed each, however large they are."""

from collections.abc import Sequence
from typing import Final

from mansion_msgs_py.program import RequestedObject
from mansion_planner.brief.facts import RoomFact
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.model import PlannedRoom, Storey

__all__ = ["single_beds"]

_BEDS: Final = {
    "dorm_room": "single_bed",
    "hotel_room": "single_bed",
    "patient_room": "hospital_bed",
    "resident_room": "hospital_bed",
    "bedroom": "single_bed",
}
"""Bed of each type of room in which more than one may stand."""


def single_beds(
    decisions: Decisions, rooms: Sequence[tuple[Storey, PlannedRoom]]
) -> dict[tuple[int, str], RequestedObject]:
    """Return the one bed of each single room, by storey and room.

    Parameters
    ----------
    decisions : Decisions
    rooms : sequence of (Storey, PlannedRoom)
        All rooms of the building.
    """
    beds = {object_.room for object_ in decisions.facts.objects if object_.category.endswith("bed")}
    singles = {
        fact.name: fact.room_type for fact in decisions.facts.rooms if _is_single(fact) and fact.name not in beds
    }
    return {
        (storey.index, room.id): RequestedObject(category=_BEDS[room.kind.name], count=1, words="bed", exact=True)
        for storey, room in rooms
        if singles.get(room.base, "-") == room.kind.name
    }


def _is_single(fact: RoomFact) -> bool:
    """Whether a fact is about several rooms for one person each: "a single bedroom" is a number."""
    return fact.room_type in _BEDS and (fact.count or 0) > 1 and "single" in fact.span.words.lower().split()

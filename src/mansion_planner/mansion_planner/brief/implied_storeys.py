"""Tell the storeys that a brief implies: those of a low tower, and the ground floor below what is upstairs."""

from dataclasses import replace

from mansion_planner.brief.facts import BriefFacts, FloorRef, Quantity, RoomFact
from mansion_planner.brief.reading import Place, Reading

__all__ = ["named_of_tower", "put_on_ground"]

_ABOVE = frozenset({"upper", "top"})
_FEWEST = 3
"""Rooms that a brief names without a storey, at least: they are then what the ground floor holds."""


def named_of_tower(reading: Reading, places: list[Place]) -> Quantity | None:
    """Return the number of storeys of a low tower all of whose storeys are named: "a tower with ... on the third"."""
    refs = [ref for place in places for ref in place.refs if ref.kind != "basement"]
    storeys = {ref.first: ref for ref in refs if ref.kind == "number"}
    all_named = len(storeys) > 1 and len(storeys) == max(storeys) and all(ref.kind == "number" for ref in refs)
    if not all_named or "tower" not in {token.text for token in reading.tokens}:
        return None
    return Quantity(float(max(storeys)), storeys[max(storeys)].span)


def put_on_ground(reading: Reading) -> None:
    """Give rooms that are told no storey of the ground floor, where only the upper one of two storeys is named.

    The building is one to work in, or has a flat upstairs: in homes bedrooms may be upstairs without a word. One of
    more storeys has others to put such rooms on.
    """
    facts = reading.facts
    if not _is_of_two_storeys(facts) or not _is_to_work_in(reading):
        return
    left = [room for room in facts.rooms if not room.floors]
    if len(left) < _FEWEST or any(room.unit for room in left):
        return
    ground = (FloorRef("number", 1, 1),)
    facts.rooms[:] = [room if room.floors else replace(room, floors=ground) for room in facts.rooms]


def _is_of_two_storeys(facts: BriefFacts) -> bool:
    """Whether a brief names no storey but the upper one of two, and puts rooms there."""
    others = (facts.floors and facts.floors[0].value != 2) or facts.uses or facts.copies or facts.basements
    if others:
        return False
    refs = [ref for room in facts.rooms for ref in room.floors]
    return bool(refs) and all(ref.kind in _ABOVE and ref.first <= 1 for ref in refs) and not _repeated(facts.rooms)


def _repeated(rooms: list[RoomFact]) -> bool:
    return any(room.each for room in rooms)


def _is_to_work_in(reading: Reading) -> bool:
    facts = reading.facts
    kind = facts.building[0][0] if facts.building else facts.building_like
    record = reading.knowledge.buildings.get(kind)
    flat_above = any(room.unit and room.count == 1 and room.floors for room in facts.rooms)
    return flat_above or (record is not None and record.family != "home")

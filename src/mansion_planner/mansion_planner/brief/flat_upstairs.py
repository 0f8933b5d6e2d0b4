"""Give the flat above a practice or a shop its rooms: "a flat above. ... Upstairs living room, 2 bedrooms"."""

from dataclasses import replace

from mansion_planner.brief.facts import FloorRef, RoomFact
from mansion_planner.brief.reading import Reading

__all__ = ["give_rooms_to_flat"]

_DWELT_IN = frozenset(
    """
    bedroom master_bedroom guest_room childrens_room kitchen open_kitchen living_room dining_room bathroom toilet
    ensuite_bathroom kitchen_diner home_office hallway entrance_hall balcony terrace
    """.split()
)
"""Types of the rooms of a flat."""
_SLEEPING = frozenset({"bedroom", "master_bedroom"})
_FEWEST = 3


def give_rooms_to_flat(reading: Reading) -> None:
    """Make what is told of the storey of a building's only flat its rooms, where it is a building to work in."""
    facts = reading.facts
    flats = [n for n, room in enumerate(facts.rooms) if room.unit and room.count == 1]
    kind = facts.building[0][0] if facts.building else facts.building_like
    record = reading.knowledge.buildings.get(kind)
    if len(flats) != 1 or facts.rooms[flats[0]].suite or record is None or record.family == "home":
        return
    flat = facts.rooms[flats[0]]
    held = _rooms_of_storey(facts.rooms, flat)
    if len(held) < _FEWEST or not any(facts.rooms[n].room_type in _SLEEPING for n in held):
        return
    suite = tuple(replace(facts.rooms[n], floors=(), each=False) for n in held)
    facts.rooms[flats[0]] = replace(flat, floors=facts.rooms[held[0]].floors, suite=suite)
    facts.rooms[:] = [room for n, room in enumerate(facts.rooms) if n not in held]


def _rooms_of_storey(rooms: list[RoomFact], flat: RoomFact) -> list[int]:
    """Return the rooms to live in of the one upper storey that has any, which may be the flat's."""
    found = [
        n
        for n, room in enumerate(rooms)
        if room is not flat and room.room_type in _DWELT_IN and not room.unit and _is_above(room.floors)
    ]
    where = {_key(rooms[n].floors) for n in found}
    same = not flat.floors or where == {_key(flat.floors)}
    return found if len(where) == 1 and same else []


def _key(floors: tuple[FloorRef, ...]) -> tuple[tuple[str, int, int], ...]:
    return tuple((ref.kind, ref.first, ref.last) for ref in floors)


def _is_above(floors: tuple[FloorRef, ...]) -> bool:
    """Whether references mean one storey above the ground floor."""
    if len(floors) != 1:
        return False
    return floors[0].kind in ("upper", "top") or (floors[0].kind == "number" and floors[0].first > 1)

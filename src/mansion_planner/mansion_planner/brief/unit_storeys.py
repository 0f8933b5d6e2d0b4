"""Give units and the rooms in them their storeys: "floors 1 to 6: four flats per floor", "a flat above"."""

from dataclasses import replace

from mansion_planner.brief.facts import FloorRef, RoomFact, UseFact
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Place, Reading
from mansion_planner.brief.storey_attachment import Attachment, attach_storeys
from mansion_planner.brief.units import Households

__all__ = ["attach_units", "give_rooms_to_flat"]


def attach_units(
    reading: Reading, places: list[Place], phrases: list[Phrase], building: int | None, households: Households
) -> dict[int, Attachment]:
    """Return the storeys of phrases, by number, where the rooms of units have those of their unit.

    See `mansion_planner.brief.storey_attachment.attach_storeys`, which reads the other phrases.
    """
    outer = [
        n for n, p in enumerate(phrases)
        if p.first not in households.inner and (p.first not in households.copies or n == building)
    ]  # fmt: skip
    shown = [replace(phrases[n], last=households.ends.get(phrases[n].first, phrases[n].last)) for n in outer]
    named = outer.index(building) if building in outer else None
    found = {outer[n]: entry for n, entry in attach_storeys(reading, places, shown, named).items()}
    numbers = {p.first: n for n, p in enumerate(phrases)}
    for first in households.units:
        number = numbers.get(first)
        if number is None or first in households.copies:
            continue
        if first in households.headed:
            found[number] = Attachment(households.headed[first])
        elif first in households.floors and number not in found:
            found[number] = Attachment(households.floors[first], each=True)
        if number in found:
            found[number] = _narrowed(reading, places, phrases[number], found[number])
    for first, other in households.copies.items():
        if numbers.get(other) in found:
            found[numbers[first]] = found[numbers[other]]
    return found


def _narrowed(reading: Reading, places: list[Place], unit: Phrase, given: Attachment) -> Attachment:
    """Return "four flats per floor" for the storeys that its clause opens with ("Floors 1 to 6: ...")."""
    if [ref.kind for ref in given.refs] != ["every"] or not any(given.refs == place.refs for place in places):
        return given
    every = next(place for place in places if given.refs == place.refs)
    if "all" in reading.words(every.first, every.last):
        return given
    if 0 <= every.first - unit.last <= 1 and reading.word(every.first) == "per":
        given = replace(given, each=True)
    openers = [
        place for place in places
        if place.last <= unit.first and reading.sentence[place.first] == reading.sentence[unit.first]
        and (place.heading or reading.starts(place.first)) and place.refs[0].kind != "every"
    ]  # fmt: skip
    if openers:
        return replace(given, refs=openers[-1].refs, each=True)
    rest = _remaining(reading, places, unit)
    return given if rest is None else replace(given, refs=(rest,), each=True)


def _remaining(reading: Reading, places: list[Place], unit: Phrase) -> FloorRef | None:
    """Return the storeys above all that are named before, for "the remaining floors"."""
    sentence = reading.sentence[unit.first]
    words = [i for i in range(unit.first) if reading.sentence[i] == sentence]
    if not any(reading.word(i) in ("remaining", "other", "rest") for i in words) or not reading.facts.floors:
        return None
    below = [ref.last for p in places if p.last <= words[0] for ref in p.refs if ref.kind in ("number", "range")]
    top = int(reading.facts.floors[0].value)
    if not below or max(below) >= top:
        return None
    span = reading.span(words[0], unit.last)
    return FloorRef("range", max(below) + 1, top, span)


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
    """Make what is told of the storey of a building's only flat its rooms, where it is a building to work in.

    A flat of which the brief tells the rooms of several storeys is what these storeys are for.
    """
    facts = reading.facts
    flats = [n for n, room in enumerate(facts.rooms) if room.unit and room.count == 1]
    if len(flats) == 1 and not facts.rooms[flats[0]].suite and _on_several_storeys(facts.rooms, facts.rooms[flats[0]]):
        flat = facts.rooms.pop(flats[0])
        refs = tuple(dict.fromkeys(ref for room in facts.rooms if _is_dwelt_in(room) for ref in room.floors))
        facts.uses.append(UseFact("flat", _each_once(refs), flat.span))
        return
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


def _is_dwelt_in(room: RoomFact) -> bool:
    return room.room_type in _DWELT_IN and not room.unit and _is_above(room.floors)


def _each_once(refs: tuple[FloorRef, ...]) -> tuple[FloorRef, ...]:
    """Return references to storeys without those that mean one named before."""
    return tuple({(ref.kind, ref.first, ref.last): ref for ref in reversed(refs)}.values())[::-1]


def _on_several_storeys(rooms: list[RoomFact], flat: RoomFact) -> bool:
    """Whether rooms to live in are told of two storeys or more, by their numbers, that the only flat may be on."""
    held = [room for room in rooms if _is_dwelt_in(room) and room.floors[0].kind == "number"]
    where = {room.floors[0].first for room in held}
    inside = not flat.floors or all(
        ref.kind == "upper" or any(ref.first <= storey <= ref.last for storey in where) for ref in flat.floors
    )
    return len(where) > 1 and len(held) >= _FEWEST and inside and any(room.room_type in _SLEEPING for room in held)


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

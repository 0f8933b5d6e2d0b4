"""Give units and the rooms in them the storeys that a brief names: "floors 1 to 6: four flats per floor"."""

from dataclasses import replace

from mansion_planner.brief.facts import FloorRef
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Place, Reading
from mansion_planner.brief.storey_attachment import Attachment, attach_storeys
from mansion_planner.brief.units import Households

__all__ = ["attach_units"]


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

"""Read what each flat, suite or other unit holds: "four flats a floor, each of two bedrooms, a bathroom and a kitchen".

A unit is a dwelling or another group of rooms with a door of its own; the brief may have many alike. What it holds is
said in the noun ("two-bedroom flats"), after it ("with", "consisting of", "(each 2 bedrooms)"), of all units in a
sentence of its own ("Every flat has ..."), or before it ("a bathroom in each flat"). Units of one name that hold
different rooms get names of their own.
"""

import itertools
from collections.abc import Sequence
from dataclasses import replace

from mansion_language.numbers import NUMBER_WORDS
from mansion_planner.brief.facts import FloorRef, RoomFact
from mansion_planner.brief.mixed_units import parted, shares_of
from mansion_planner.brief.phrase import Phrase, is_whole_count
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading
from mansion_planner.brief.unit_rooms import UnitRooms
from mansion_planner.brief.units import ALL, GENERAL, LODGINGS, TELLING, Households, find_units, put_phrase

__all__ = ["read_households", "told_apart"]

_VERBS = frozenset(
    """
    has have with contain consist comprise include hold offer feature get should must will shall need also of comes
    come having containing comprising consisting
    """.split()
)


def read_households(
    reading: Reading, phrases: list[Phrase], places: Sequence[Place], building: int | None
) -> tuple[list[Phrase], Households]:
    """Return the phrases, those of units by their plain names, and what each unit holds.

    Parameters
    ----------
    building : int, optional
        Number of the phrase that names the building itself, which is no unit.
    """
    reader = _Households(reading, phrases, places, None if building is None else phrases[building].first)
    reader.run()
    return reader.phrases, reader.found


class _Households:
    def __init__(self, reading: Reading, phrases: list[Phrase], places: Sequence[Place], building: int | None) -> None:
        self.reading, self.phrases, self.places, self.building = reading, phrases, places, building
        self.found = find_units(reading, phrases, building)
        self.lists = UnitRooms(reading, phrases, places, building, self.found)
        self.listed: set[int] = set()
        self.shared: set[int] = set()

    def run(self) -> None:
        """Read the rooms that each statement gives the units."""
        self._shares()
        for phrase in [p for p in self.phrases if p.first in self.found.units and p.first not in self.shared]:
            every = phrase.determiner in ALL and (phrase.determiner == "each" or not phrase.counted)
            again = phrase.plural or (phrase.determiner == "the" and not phrase.counted and self._leads_list(phrase))
            those = phrase.determiner in ("the", "these", "those") and again and self._named_before(phrase)
            generic = phrase.determiner in ("a", "an", "one") and self.reading.word(phrase.last) in TELLING
            again_one = self._is_spoken_of_again(phrase)
            if again_one:
                self._place_with_mention(phrase, self._owners(phrase))
            if every or those or again_one or (generic and self._named_before(phrase)):
                self._of_all(phrase)
            else:
                self._of_one(phrase)
        self._halves()
        self._pronouns()
        for first, size in self.found.sizes.items():
            rooms = self.found.units.get(first)
            if rooms is not None and not any(room.room_type.endswith("bedroom") for room in rooms):
                rooms.insert(0, size)
        self._counts_behind()
        self._of_rooms_within()

    def _of_one(self, unit: Phrase) -> None:
        """Read what follows a unit that the brief asks for."""
        rooms, end = self.lists.after(unit.last, always=False, guests=unit.room_type in LODGINGS)
        if rooms:
            self._place_with_mention(unit, [unit.first])
            self._give(self._same_noun(unit.first), rooms)
            if not any(unit.last <= place.first < rooms[0].first for place in self.places):
                self.found.ends[unit.first] = end
        reading = self.reading
        index = max(unit.last, unit.noun_end)
        if reading.word(index) in ("a", "per", "/") and reading.word(index + 1) in FLOOR_WORDS:
            span = reading.span(index, index + 2)
            self.found.floors[unit.first] = (FloorRef("every", span=span),)
            reading.take(index, index + 2)

    def _same_noun(self, first: int) -> list[int]:
        """Return the units that share their noun with one, itself among them."""
        noun = self.found.copies.get(first, first)
        return [noun, *(copy for copy, other in self.found.copies.items() if other == noun)]

    def _of_all(self, unit: Phrase) -> None:
        """Read "Every flat has ..." and "a bathroom in each flat"."""
        owners = self._owners(unit)
        self.found.again.add(unit.first)
        before = self.reading.word(unit.first - 1)
        rooms: list[Phrase] = []
        if unit.determiner == "per" or before in ("in", "for", "per", "to"):
            rooms = self.lists.before(unit.first - (before in ("in", "for", "per", "to")))
        if not rooms:
            rooms, _ = self.lists.after(unit.last, always=True, guests=unit.room_type in LODGINGS)
        if not rooms:
            return
        if not owners:
            self.found.again.discard(unit.first)
            self.found.unnumbered.add(unit.first)
            self._give([unit.first], rooms)
        else:
            self._give(owners, rooms)

    def _leads_list(self, unit: Phrase) -> bool:
        """Whether what a unit holds follows right after it: "Upstairs the flat: two bedrooms"."""
        return self.reading.word(unit.last) in (":", "has", "with", "have", "contain", "get")

    def _is_spoken_of_again(self, unit: Phrase) -> bool:
        """Whether "Flat upstairs: two bedrooms" tells what is in the flat that an earlier sentence names."""
        bare = not (unit.counted or unit.plural) and unit.determiner in ("", "the") and unit.name in GENERAL
        return bare and any(
            p.first < unit.first
            and (p.name.endswith(f"_{unit.name}") or self._are_one_home(p, unit))
            and self.found.units.get(p.first) == []
            and self.reading.sentence[p.first] < self.reading.sentence[unit.first]
            for p in self.phrases
        )

    def _are_one_home(self, named: Phrase, unit: Phrase) -> bool:
        """Whether a heading tells of the only home that is named before: "a flat above. Shop: ... Home: ..."."""
        one = named.count == 1 and not named.plural and named.name in GENERAL - {"unit", "room"}
        homes = [p for p in self.phrases if p.first in self.found.units and p.name in GENERAL]
        heads = unit.name in GENERAL - {"unit", "room"} and self.reading.starts(unit.first)
        return one and heads and len(homes) == 2

    def _place_with_mention(self, unit: Phrase, owners: Sequence[int]) -> None:
        """Put flats on the storey that "Flat upstairs: ..." names between the flat and its rooms."""
        place = next((place for place in self.places if place.first == unit.last), None)
        if place is not None and self.reading.word(place.last) == ":":
            for owner in owners:
                self.found.headed.setdefault(owner, place.refs)

    def _named_before(self, unit: Phrase) -> bool:
        return any(p.first < unit.first and p.first in self.found.units and _alike(unit, p) for p in self.phrases)

    def _owners(self, unit: Phrase) -> list[int]:
        """Return the units that "each flat" means: those before it that nothing was said of, or all, else others."""
        reading = self.reading
        others = [
            p for p in self.phrases
            if p.first in self.found.units and p.first != unit.first and _alike(unit, p)
            and p.first not in self.found.again | self.found.unnumbered
            and not (p.determiner in ALL and not p.counted)
        ]  # fmt: skip
        sized = self.found.sizes.get(unit.first)
        if sized is not None:
            sizes = self.found.sizes
            others = [p for p in others if p.first in sizes and sizes[p.first].count == sized.count] or others
        earlier = [p for p in others if p.first < unit.first]
        near = [p for p in earlier if reading.sentence[p.first] == reading.sentence[unit.first]]
        bare = [p for p in earlier if p.first not in self.listed]
        return [p.first for p in near or bare or earlier or others]

    def _pronouns(self) -> None:
        """Read "Each has ...", "all of them with ..." and "they have ... each" of the units named last."""
        reading = self.reading
        for index, token in enumerate(reading.tokens):
            if (
                token.text not in ("each", "all", "both", "they", "every")
                or index in reading.taken
                or any(p.first <= index < p.last for p in self.phrases if p.first in self.found.units)
            ):
                continue
            if not (reading.starts(index) or reading.word(index - 1) in (",", ";", "and", ":", "-", "(")):
                continue
            verb = next((i for i in range(index + 1, index + 5) if reading.word(i) in _VERBS), None)
            verb = index + 1 if reading.word(index + 1) == ":" and token.text in ("each", "all", "both") else verb
            if verb is None or any(p.first < verb and p.last > index + 1 for p in self.phrases if p.head == "room"):
                continue
            owners = self._last_units(index)
            if not owners:
                continue
            guests = any(p.first in owners and p.room_type in LODGINGS for p in self.phrases)
            rooms, _ = self.lists.after(verb, always=True, guests=guests)
            self._give(owners, rooms)
            if rooms:
                reading.take(index, verb)

    def _last_units(self, index: int) -> list[int]:
        """Return the units named last before a token, in its sentence or the two before, if nothing else is meant."""
        reading = self.reading
        for phrase in reversed([p for p in self.phrases if p.last <= index]):
            if phrase.first in self.found.inner or phrase.head not in ("room", "building"):
                continue
            if reading.sentence[index] - reading.sentence[phrase.first] > 2:
                return []
            if phrase.first in self.found.again:
                return self._owners(phrase)
            if phrase.first in self.found.units:
                return self._same_noun(phrase.first)
            if phrase.first == self.building or not phrase.plural:
                continue
            return []
        return []

    def _halves(self) -> None:
        """Read "One has one bedroom and the other has three" of two flats."""
        reading = self.reading
        for index in range(len(reading.tokens)):
            one = reading.kind(index) == "number" and reading.value(index) == 1 and reading.starts(index)
            if not one or reading.word(index + 1) not in ("has", "have", "with", "of"):
                continue
            owners = self._last_units(index)
            unit = next((p for p in self.phrases if owners and p.first == owners[0]), None)
            rooms, end = self.lists.after(index + 1, always=True)
            other = next((i for i in range(end, end + 4) if reading.word(i) == "other"), None)
            if unit is None or not rooms or other is None or (unit.count or 0) < 2:
                continue
            later, _ = self.lists.after(other + 1, always=True)
            common = list(self.found.units[unit.first])
            part = replace(unit, first=index, begin=index, noun_end=index + 1, last=index + 1, count=1)
            put_phrase(reading, self.phrases, part)
            number = next(n for n, p in enumerate(self.phrases) if p.first == unit.first)
            self.phrases[number] = replace(unit, count=(unit.count or 2) - 1)
            self.found.copies[index] = unit.first
            self.found.units[index] = common
            self._give([index], rooms)
            self._give([unit.first], later)

    def _shares(self) -> None:
        """Read how many of some flats have how many bedrooms."""
        reading = self.reading
        for unit in [p for p in self.phrases if p.first in self.found.units and p.first not in self.found.sizes]:
            shares = shares_of(reading, unit)
            for number, share in enumerate(shares):
                beds = Phrase("room", share.bedrooms, share.bedrooms, share.last, share.last, "bedroom", name="bedroom",
                              label="bedroom", count=share.beds, counted=True, plural=share.beds > 1)  # fmt: skip
                put_phrase(reading, self.phrases, beds)
                self.found.inner.add(beds.first)
                self.shared |= {unit.first, share.first}
                if number == 0:
                    at = next(n for n, p in enumerate(self.phrases) if p.first == unit.first)
                    self.phrases[at] = replace(unit, count=share.count)
                    self.found.sizes[unit.first] = beds
                    reading.take(share.first, share.last)
                    continue
                part = parted(unit, share)
                put_phrase(reading, self.phrases, part)
                reading.take(share.first, share.last)
                self.found.copies[part.first] = unit.first
                self.found.units[part.first] = list(self.found.units[unit.first])
                self.found.sizes[part.first] = beds

    def _counts_behind(self) -> None:
        """Read "flats of two bedrooms and a bathroom, three on each floor": the number stands behind."""
        reading = self.reading
        for number, phrase in enumerate(self.phrases):
            if phrase.first not in self.found.units or phrase.counted or not phrase.plural:
                continue
            index = self.found.ends.get(phrase.first, phrase.last)
            if reading.word(index) in (",", ":", "-", "("):
                index += 1
            counts = reading.kind(index) == "number" and is_whole_count(reading.value(index))
            if counts and any(place.first == index + 1 for place in self.places):
                self.phrases[number] = replace(phrase, count=int(reading.value(index)), counted=True)
                self.found.ends[phrase.first] = index + 1
                reading.take(index, index + 1)

    def _of_rooms_within(self) -> None:
        """Read "every bedroom has its own shower room" of the bedrooms that each unit holds."""
        for phrase in [p for p in self.phrases if p.head == "room" and p.determiner in ("each", "every")]:
            units = {
                first: next(room for room in rooms if room.room_type == phrase.room_type)
                for first, rooms in self.found.units.items()
                if any(room.room_type == phrase.room_type and room.first != phrase.first for room in rooms)
            }
            if phrase.first in self.found.inner | self.found.again or phrase.first in self.found.units or not units:
                continue
            rooms, _ = self.lists.after(phrase.last, always=True, guests=True)
            for first, room in units.items():
                self._give([first], [replace(own, count=room.count) for own in rooms])
            self.found.again |= {phrase.first} if rooms else set()

    def _give(self, owners: Sequence[int], rooms: Sequence[Phrase]) -> None:
        for owner in owners:
            held = self.found.units.setdefault(owner, [])
            held += [room for room in rooms if all(room.first != other.first for other in held)]
            self.listed.add(owner)
        self.found.inner |= {room.first for room in rooms}


def _alike(first: Phrase, second: Phrase) -> bool:
    """Whether "each flat" may mean units that are called otherwise."""
    if first.room_type == "team_room" or second.room_type == "team_room":
        return first.room_type == second.room_type
    if first.room_type == second.room_type == "common_room":
        return first.name.rpartition("_")[2] == second.name.rpartition("_")[2]
    return first.name == second.name or first.name.rpartition("_")[2] in GENERAL


def told_apart(facts: Sequence[RoomFact]) -> list[RoomFact]:
    """Return room facts; units of one name and the same storeys that hold different rooms get names of their own."""
    told = list(facts)
    units = [n for n, fact in enumerate(told) if fact.unit]
    for n, m in itertools.combinations(units, 2):
        if facts[n].name != facts[m].name or _where(facts[n]) != _where(facts[m]):
            continue
        if _holding(facts[n]) != _holding(facts[m]):
            told[n], told[m] = _by_size(facts[n]), _by_size(facts[m])
            if told[n].name == told[m].name:
                told[m] = replace(told[m], name=f"other_{told[m].name}", label=f"other {told[m].label}")
    return told


def _where(fact: RoomFact) -> list[tuple[str, int, int]]:
    return [(ref.kind, ref.first, ref.last) for ref in fact.floors]


def _holding(fact: RoomFact) -> list[tuple[str, int | None]]:
    return sorted((room.room_type, room.count) for room in fact.suite)


def _by_size(fact: RoomFact) -> RoomFact:
    """Return a unit named by how many sleep there: no name with "bedroom", which is another room's."""
    beds = sum(room.count or 1 for room in fact.suite if room.room_type.endswith("bedroom"))
    number = NUMBER_WORDS[beds] if beds < len(NUMBER_WORDS) else "many"
    return replace(fact, name=f"{number}_bed_{fact.name}", label=f"{number}-bed {fact.label}")

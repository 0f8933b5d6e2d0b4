"""State the rooms of a brief as facts: how many, where, what each has for itself, and which are not wanted."""

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from mansion_planner.brief.facts import RoomFact, Span, UseFact
from mansion_planner.brief.households import told_apart
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.qualifiers import taken_for_its_head
from mansion_planner.brief.reading import FLOOR_WORDS, Place, Reading
from mansion_planner.brief.storey_attachment import Attachment
from mansion_planner.brief.storey_sequences import other_storeys
from mansion_planner.brief.suites import Suites
from mansion_planner.brief.units import Households, are_dwellings

__all__ = ["RoomStatements", "identifier"]

_AS_USE = {
    "flat": "apartment_building",
    "studio_flat": "apartment_building",
    "shop_building": "shopping_mall",
    "house": "apartment_building",
    "penthouse": "apartment_building",
}
"""Kinds of buildings that a plural of storeys means: "flats on floors 2 to 5" are an apartment building."""


@dataclass(frozen=True)
class RoomStatements:
    """The noun phrases of a brief with all that joins them, for the facts that they state.

    Attributes
    ----------
    phrases : sequence of Phrase
        The other attributes speak of them by number.
    building : int, optional
        The phrase that names the building itself.
    attached : mapping of int to Attachment
        Storeys.
    negated : mapping of int to (int, int)
        Phrases that are not wanted, and the tokens that say so.
    same : mapping of int to int
        Phrases that only speak of another one, and that one.
    """

    reading: Reading
    places: Sequence[Place]
    phrases: Sequence[Phrase]
    building: int | None
    households: Households
    attached: Mapping[int, Attachment]
    negated: Mapping[int, tuple[int, int]]
    same: Mapping[int, int]
    suites: Suites

    def record(self) -> None:
        """Add the rooms to the facts of the reading: wanted, unwanted, and uses of whole storeys."""
        for number, phrase in enumerate(self.phrases):
            if (
                phrase.head not in ("room", "building")
                or number == self.building
                or (number in self.same and phrase.first not in self.households.units)
                or number in self.suites.owners
                or self.reading.words(phrase.begin, phrase.noun_end) == ("walk", "up")  # on which floor a flat is
                or phrase.first in self.households.read
            ):
                continue
            if phrase.first in self.households.unnumbered:
                self.reading.facts.households += self._room_facts(number, replace(phrase, count=None), Attachment())
                continue
            place = self.attached.get(number, Attachment())
            if number in self.negated:
                self._exclude(number, phrase, place)
                continue
            if not phrase.room_type or (phrase.determiner in ("each", "every", "all") and not phrase.known):
                continue
            if self._is_use(phrase, place):
                name = _AS_USE.get(phrase.building, phrase.building)
                self.reading.facts.uses.append(UseFact(name, place.refs, self.reading.span(phrase.first, phrase.last)))
                continue
            self.reading.facts.rooms += self._room_facts(number, phrase, place)
            self._only_there(phrase, place)
        self.reading.facts.rooms[:] = told_apart(self.reading.facts.rooms)

    def _only_there(self, phrase: Phrase, place: Attachment) -> None:
        """Read "toilets on the odd floors only" as no toilets on the others."""
        found = next((p for p in self.places if p.refs == place.refs and self._near(p, phrase)), None)
        if found is None or not self.reading.facts.floors:
            return
        reading = self.reading
        denied = reading.words(found.last, found.last + 3) == ("but", "not", "on")
        if not denied and reading.word(found.last) != "only" and reading.word(found.first - 1) != "only":
            return
        end = found.last + 3
        while denied and (reading.kind(end) in ("number", "ordinal") or reading.word(end) in ("the", *FLOOR_WORDS)):
            end += 1
        if denied:  # "on storeys 1 and 2 but not on 3"
            reading.take(found.last, end)
        others = other_storeys(place.refs, int(self.reading.facts.floors[0].value))
        span = self.reading.span(min(phrase.begin, found.first), max(found.last, phrase.noun_end))
        self.reading.facts.excluded_on += [(phrase.room_type, ref, span) for ref in others]

    def _near(self, place: Place, phrase: Phrase) -> bool:
        """Whether a place stands right after a room, or opens its sentence with "only"."""
        if 0 <= place.first - phrase.last <= 4:
            return True
        opens = self.reading.word(place.first - 1) == "only" and self.reading.starts(place.first - 1)
        return opens and 0 < phrase.first - place.last <= 4

    def _exclude(self, number: int, phrase: Phrase, place: Attachment) -> None:
        first, last = self.negated[number]
        span = self.reading.span(min(first, phrase.first), max(last, phrase.last))
        if not phrase.room_type or self._is_replaced(number, phrase):
            return
        if place.refs and self._is_placed(phrase):
            self.reading.facts.excluded_on += [(phrase.room_type, ref, span) for ref in place.refs]
        else:
            self.reading.facts.excluded.append((phrase.room_type, span))

    def _is_replaced(self, number: int, phrase: Phrase) -> bool:
        """Whether another room of its kind is wanted in the place of one: "a carport instead of a garage"."""
        instead = "instead" in self.reading.words(self.negated[number][0], phrase.first)
        return instead and any(
            p.room_type == phrase.room_type and p.name != phrase.name and n not in self.negated
            for n, p in enumerate(self.phrases)
        )

    def _is_placed(self, phrase: Phrase) -> bool:
        """Whether a negated room is unwanted on some storeys only: named after it, or it is wanted elsewhere."""
        after = any(0 <= place.first - phrase.last <= 2 for place in self.places)
        other = any(
            p.room_type == phrase.room_type and n not in self.negated and p is not phrase
            for n, p in enumerate(self.phrases)
        )
        return after or other or "there" in self.reading.words(phrase.last, phrase.last + 2)

    def _is_use(self, phrase: Phrase, place: Attachment) -> bool:
        """Whether a plural is the use of whole storeys: "offices on floors 2 to 5", not where a crew sleeps."""
        if phrase.room_type == "dorm_room" and self.building is not None:
            return False
        if phrase.room_type == "storage" and all(ref.kind == "basement" for ref in place.refs):
            return False  # "stores in the basement" sell nothing
        return (
            bool(phrase.building) and bool(place.refs) and phrase.plural and phrase.count is None and not phrase.areas
        )

    def _room_facts(self, number: int, phrase: Phrase, place: Attachment) -> list[RoomFact]:
        """Return a phrase's rooms: one fact, or one for each of several areas."""
        span = self._span(phrase)
        place = place if place.refs else self._place_behind_bath(number, phrase)
        children = [
            self.phrases[n]
            for n, owner in self.suites.owners.items()
            if owner == number or number in self.suites.twins.get(n, ())
        ]
        held = self.households.units.get(phrase.first, [])
        suite = tuple(
            RoomFact(
                child.room_type,
                child.name or child.room_type,
                self._span(child),
                child.count or 1,
                child.areas[0] if child.areas else None,
                label=child.label,
                known=child.known and not taken_for_its_head(self.reading, child),
                limit=child.limit,
                size="" if child.areas else child.size,
            )
            for child in (*held, *children)
            if child.room_type
        )
        fact = RoomFact(
            room_type="accessible_toilet" if phrase.name == "accessible_toilet" else phrase.room_type,
            name=identifier(phrase.name) or phrase.room_type,
            span=span,
            count=None if phrase.determiner in ("each", "every") and not phrase.counted else phrase.count,
            area=phrase.areas[0] if phrase.areas else None,
            floors=place.refs,
            each=place.each,
            label=phrase.label,
            suite=suite,
            known=phrase.known and not taken_for_its_head(self.reading, phrase),
            limit=phrase.limit,
            size="" if phrase.areas else phrase.size,
            unit=bool(held) or (self.reading.knowledge.room(phrase.room_type).unit and are_dwellings(phrase)),
        )
        if self._said_before(fact, phrase):
            return []
        if len(phrase.areas) > 1:
            alike = [(area, sum(1 for _ in group)) for area, group in itertools.groupby(phrase.areas)]
            return [replace(fact, count=count, area=area) for area, count in alike]
        return [fact]

    def _place_behind_bath(self, number: int, phrase: Phrase) -> Attachment:
        """Return the storeys that stand behind a bathroom right behind its room: "rooms en suite on each floor"."""
        behind = (n for n, owner in self.suites.owners.items() if owner == number)
        places = (self.attached.get(n) for n in behind if self.phrases[n].first == phrase.last)
        return next((place for place in places if place is not None), Attachment())

    def _span(self, phrase: Phrase) -> Span:
        """Return the words of a phrase, its article left out."""
        return self.reading.span(phrase.first if phrase.counted else min(phrase.begin, phrase.last - 1), phrase.last)

    def _said_before(self, fact: RoomFact, phrase: Phrase) -> bool:
        """Whether an unnumbered room only says again what the brief wants already ("a library ... library")."""
        if phrase.counted or fact.count not in (None, 1) or phrase.determiner in ("a", "an", "another"):
            return False
        own = self.reading.words(phrase.begin - 1, phrase.begin + 1) in (("our", "own"), ("my", "own"))
        if self.reading.kind(phrase.begin - 1) == "ordinal" or own:
            return False  # "our bedroom, a second bedroom"; "a bedroom for her, our own bedroom"
        for number, other in enumerate(self.reading.facts.rooms):
            if (other.name, other.count, other.each) == (fact.name, fact.count, fact.each) and [
                (r.kind, r.first, r.last) for r in other.floors
            ] == [(r.kind, r.first, r.last) for r in fact.floors]:
                if fact.area and not other.area:
                    self.reading.facts.rooms[number] = replace(other, area=fact.area)
                if fact.suite and not other.suite:  # "a shop and flat. Flat upstairs: a living room, a bedroom"
                    self.reading.facts.rooms[number] = replace(other, suite=fact.suite, unit=fact.unit)
                return True
        return False


def identifier(name: str) -> str:
    """Return a snake-case identifier that starts with a letter."""
    return name if name[:1].isalpha() else f"room_{name}" if name else ""

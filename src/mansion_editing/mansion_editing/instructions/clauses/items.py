"""Noun phrases with the places that follow them."""

from collections.abc import Sequence
from dataclasses import dataclass

import msgspec

from mansion_editing.instructions.phrases.noun_phrases import NounPhrase
from mansion_editing.instructions.phrases.places import ReadPlace, merged, with_place
from mansion_editing.instructions.statements import Place, Rooms, Things

__all__ = ["Item", "NotUnderstood", "TwoReadings", "joined_places"]


class NotUnderstood(Exception):
    """Words that belong to no statement.

    Attributes
    ----------
    start, end : int
        Their places in the words of the sentence.
    """

    def __init__(self, start: int, end: int) -> None:
        super().__init__(start, end)
        self.start, self.end = start, end


class TwoReadings(NotUnderstood):
    """A list that belongs to the clause before it or to the one after it, as one likes."""


@dataclass(frozen=True)
class Item:
    """A noun phrase with the places that follow it."""

    phrase: NounPhrase
    places: tuple[ReadPlace, ...]
    end: int

    @property
    def is_room(self) -> bool:
        """Whether the phrase names a room and no object."""
        return self.phrase.noun.kind == "room"

    def goal(self) -> tuple[Place, bool]:
        """Return where the thing goes: all its places but those that it comes from; and whether each is meant."""
        return joined_places([p for p in self.places if not p.source])

    def things(self) -> Things:
        """Return the thing with the places where it is."""
        things = self.phrase.things()
        place, _ = joined_places(list(self.places))
        return things if place == Place() else with_place(things, place)

    def rooms(self) -> Rooms:
        """Return the room that is named, with the storeys that follow."""
        rooms = self.phrase.rooms()
        for read in self.places:
            more = read.place.rooms
            if more is not None:
                whole = merged(Place(rooms=rooms), Place(rooms=more)).rooms
                rooms = rooms if whole is None else whole
            elif read.place.anchor is not None and read.place.relation in ("above", "under"):
                up = 1 if read.place.relation == "above" else -1
                rooms = msgspec.structs.replace(rooms, up=up, base=read.place.anchor.noun, over=True)
            elif read.place.anchor is not None:
                rooms = msgspec.structs.replace(rooms, holding=read.place.anchor)
        return rooms


def joined_places(places: Sequence[ReadPlace]) -> tuple[Place, bool]:
    place, each = Place(), False
    for read in places:
        place = read.place if place == Place() else merged(place, read.place)
        each = each or read.each
    return place, each

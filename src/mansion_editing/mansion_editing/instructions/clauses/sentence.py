"""The pieces that the clauses of a sentence are made of: exceptions, those that are there, places within a frame."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.listed_items import ListedItems
from mansion_editing.instructions.phrases.noun_phrases import NounPhrase
from mansion_editing.instructions.phrases.places import merged, read_place, with_place
from mansion_editing.instructions.statements import JOINED, Amount, Place, Things

__all__ = ["Sentence"]

_THOSE: Final = frozenset("the these those my our your them".split())
_EXCEPTIONS: Final = (
    ("except", "for"), ("apart", "from"), ("other", "than"), ("aside", "from"), ("except",), ("but", "not"),
    ("and", "not"), ("not",), ("besides",), ("but",), ("save", "for"), ("excluding",), ("without",),
)  # fmt: skip
"""Words that begin an exception."""


class Sentence(ListedItems):
    """Reads the clauses of one sentence."""

    def taken_affirmed(self) -> Things | None:
        """Return what the clause just read said to be there, and forget it."""
        affirmed, self.affirmed = self.affirmed, None
        return affirmed

    def exceptions(self, at: int) -> tuple[int, tuple[Things, ...]]:
        """Read ``except the vase and the lamp``."""
        place = at + (self.text(at) == ",")
        for phrase in _EXCEPTIONS:
            span = tuple(w.text for w in self.words[place : place + len(phrase)])
            if span != phrase:
                continue
            if self.starts_clause(place + len(phrase)):
                return at, ()
            rooms = self._excepted_rooms(place + len(phrase))
            if rooms is not None:
                return rooms
            places, stop = self.places(place + len(phrase))
            if places:
                return stop, (Things(amount=Amount(kind="all", number=0), plural=True, place=joined_places(places)[0]),)
            try:
                items = self.items(place + len(phrase))
            except NotUnderstood:
                return at, ()
            spared = tuple(_kind_of_its_own(self._all(item.things())) for item in items)
            return self._also_spared(items, spared)
        return at, ()

    def _also_spared(self, items: Sequence[Item], spared: tuple[Things, ...]) -> tuple[int, tuple[Things, ...]]:
        """Read further rooms of ``those in the office and in the hall``, ``those in the office and the hall``."""
        named = next((k for k in range(1, len(items)) if items[k].is_room), len(items))
        last, own = items[named - 1], spared[named - 1]
        if own.place is None or own.place.rooms is None or own.place.anchor is not None:
            return items[-1].end, spared
        rooms = [msgspec.structs.replace(own, place=Place(rooms=item.rooms())) for item in items[named:]]
        if not all(item.is_room for item in items[named:]):
            return items[-1].end, spared
        end = last.end if named == len(items) else items[-1].end
        while (at := self.conjunction(end)) and self.text(at) == "in":
            read = read_place(self.words, at, self.lexicon, self.floors)
            if read is None or read.place.rooms is None or read.place.anchor is not None:
                break
            rooms.append(msgspec.structs.replace(own, place=read.place))
            end = read.end
        return end, (*spared[:named], *rooms)

    def _excepted_rooms(self, at: int) -> tuple[int, tuple[Things, ...]] | None:
        """Read ``the office``, ``in room 3`` and ``rooms 1 and 2`` of an exception: all that is there."""
        at += self.text(at) == "in"
        found: list[Things] = []
        while (item := self.item(at)) is not None and self._is_own_room(item):
            end = item.end
            found.append(Things(amount=Amount(kind="all", number=0), plural=True, place=Place(rooms=item.rooms())))
            at = self.conjunction(end)
            if not at:
                break
        ends = not at or self.starts_clause(at) or self.item(at) is None
        return (end, tuple(found)) if found and ends else None

    def _is_own_room(self, item: Item) -> bool:
        """Whether an item names a room of the building, which a thing may be called like: the study, the bar."""
        both = item.phrase.noun.kind == "both" and self.lexicon.is_own_room(item.phrase.noun.words)
        return item.is_room or (both and not self.lexicon.is_here(item.phrase.noun.words[-1]))

    def _is_partitive(self, phrase: NounPhrase) -> bool:
        """Whether a phrase takes some of those that are there: ``two of the hammers``."""
        inner = self.words[phrase.start : phrase.end]
        return any(w.text == "of" and self.text(phrase.start + k + 1) in _THOSE for k, w in enumerate(inner))

    def _are_those_there(self, phrase: NounPhrase) -> bool:
        """Whether a phrase means things that are there: named with ``the``, or in the way of notes."""
        return phrase.definite or self._is_bare(phrase)

    def _as_those_there(self, phrase: NounPhrase) -> Things:
        """Return the things that are there, where they are named without an article too."""
        things = phrase.things()
        if not self._is_bare(phrase):
            return things
        return msgspec.structs.replace(things, amount=Amount(number=0), definite=True)

    def _in_each_room(self, phrase: NounPhrase) -> Things:
        """Return things; in notes for several rooms a bare noun means those of each: ``rooms 4+5: minibar open``."""
        rooms = self.frame.rooms
        several = rooms is not None and JOINED in rooms.words
        return self._as_those_there(phrase) if several else phrase.things()

    def _bare_kept(self, item: Item) -> Things:
        """Return all that is named without an article, in the room that the sentence began with."""
        things = self._all(Item(item.phrase, item.places, item.end).things())
        things = msgspec.structs.replace(things, amount=Amount(kind="all", number=0), definite=True)
        rooms = self.frame.rooms
        own = things.place is not None and (things.place.rooms is not None or things.place.anchor is not None)
        return things if rooms is None or own else with_place(things, Place(rooms=rooms))

    def _all(self, things: Things) -> Things:
        """Return all that words describe, where they give no number."""
        if things.amount.number == 0 and things.amount.kind == "some":
            return msgspec.structs.replace(things, amount=Amount(kind="all", number=0))
        return things

    def _all_if_plural(self, things: Things) -> Things:
        return self._all(things) if things.plural else things

    def _within_frame(self, things: Things) -> Things:
        """Return things that are in the room that the sentence began with, where they are in no other.

        A room of their own is on the storey that the sentence began with.
        """
        rooms = self.frame.rooms
        own = things.place is not None and things.place.rooms is not None
        return things if rooms is None or (own and rooms.words) else with_place(things, Place(rooms=rooms))

    def _framed(self, goal: tuple[Place, bool]) -> tuple[Place, bool]:
        """Return a place with what the sentence began with."""
        place, each = goal
        each = each or (self.frame.rooms is not None and self.frame.rooms.every and bool(self.frame.rooms.words))
        if self.frame != Place():
            place = self.frame if place == Place() else merged(place, self.frame)
        return _with_holder_at(place), each


def _with_holder_at(place: Place) -> Place:
    """Return ``on the high table by the wall`` as on the table that is by the wall."""
    holder = place.anchor
    if not place.spot or holder is None or place.relation not in ("on", "in") or holder.refers or not holder.definite:
        return place
    return msgspec.structs.replace(place, spot="", anchor=with_place(holder, Place(spot=place.spot)))


def _kind_of_its_own(things: Things) -> Things:
    """Return an exception that names no kind of its own ("not those in the lab") as one of any kind at its place."""
    if things.refers == "last" and things.place is not None:
        return msgspec.structs.replace(things, refers="", noun="")
    return things

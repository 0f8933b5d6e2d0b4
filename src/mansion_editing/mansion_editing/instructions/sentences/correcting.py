"""What somebody says instead of what was said just before: ``on the table, no wait, on the dresser``."""

from collections.abc import Sequence
from typing import Any, Final

import msgspec

from mansion_editing.instructions.clauses.items import Item, joined_places
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.places import merged
from mansion_editing.instructions.phrases.words import Word
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.statements import (
    Add,
    Ensure,
    Mention,
    Move,
    Paint,
    Place,
    Remove,
    Replace,
    Rooms,
    SetState,
    Statement,
    Things,
    Turn,
)

__all__ = ["Correcting"]

_TAKING_BACK: Final = frozenset("no nope wait sorry oops actually correction mistake".split())
_AROUND: Final = _TAKING_BACK | frozenset("hm hmm oh ah well rather my , - : please hang".split())
_INSTEAD: Final = (
    ("make", "that"), ("make", "it"), ("i", "mean"), ("i", "meant"), ("we", "meant"), ("i", "meant", "to", "say"),
)  # fmt: skip
_ENDS: Final = frozenset("please instead then".split())
_NAMING: Final = frozenset(["correction", "mistake"])
"""Words after which a bare name comes instead."""


class Correcting(Progress):
    """Puts another place, or another thing, for the one that was named just before."""

    def _corrected(self, reader: ClauseReader, words: Sequence[Word], at: int) -> int:
        """Read a correction of what was said last; return its end, 0 where the words are none."""
        end = at
        while end < len(words) and words[end].raw in _AROUND:
            end += 1
        before = {word.raw for word in words[at:end]}
        if not _TAKING_BACK & before:
            return 0
        said = next((s for s in sorted(_INSTEAD, key=len, reverse=True) if _says(words, end, s)), ())
        end += len(said)
        start = end
        last = self.statements[-1] if self.statements else None
        named = bool(said) or bool(before & _NAMING) or self._is_meant(words, end)
        corrected, end = self._said_instead(reader, last, end, named=named)
        end = _past_ending(words, end)
        ends = end >= len(words) or words[end].kind == "mark" or reader.text(end) in _ENDS
        if corrected is None or last is None or not ends:
            return 0
        shared = [s for s in self.statements if not isinstance(s, Mention) and s.quote == last.quote]
        if len(shared) > 1:
            return 0  # which of several is corrected is not told
        quote = self._quote(words, start, end)
        self.statements[-1:] = [Mention(quote=last.quote), msgspec.structs.replace(corrected, quote=quote)]
        return end

    def _is_meant(self, words: Sequence[Word], at: int) -> bool:
        """Whether words end with ``was meant`` or ``I meant``, which says that they come instead."""
        end = next((k for k in range(at, len(words)) if words[k].raw == "meant"), 0)
        return bool(end) and words[end - 1].raw in ("was", "were", "is", "i", "we")

    def _said_instead(
        self, reader: ClauseReader, last: Statement | None, at: int, *, named: bool
    ) -> tuple[Statement | None, int]:
        """Return the last statement with what is said instead, and the end of the words for it."""
        if isinstance(last, Add | Ensure) and last.each:
            return None, at
        number = reader.words[at] if at < len(reader.words) else None
        counted = number is not None and number.kind == "number" and number.value == int(number.value) > 0
        if counted and isinstance(last, Add | Ensure | Remove) and last.things.amount.number > 0 and number is not None:
            amount = msgspec.structs.replace(last.things.amount, number=int(number.value))
            things = msgspec.structs.replace(last.things, amount=amount, plural=amount.number > 1)
            return msgspec.structs.replace(last, things=things), at + 1
        places, end = reader.places(at)
        if places and not any(read.source or read.each for read in places):
            more = self._place_after(reader, end)
            place = joined_places([*places, *more[0]])[0]
            return (_placed(last, place) if last is not None else None), more[1]
        item = reader.item(at)
        if item is None or not (named or item.is_room) or item.phrase.refers or item.phrase.each:
            return None, at
        if item.is_room:
            near, end = self._place_after(reader, item.end)
            rooms = item.phrase.rooms()
            place = joined_places([*item.places, *near])[0]
            whole = merged(place, Place(rooms=rooms)) if place.anchor is not None else Place(rooms=item.rooms())
            return (_placed(last, _of_that_room(whole, rooms)) if last is not None else None), end
        if isinstance(last, Add | Ensure | Move) and item.phrase.definite:
            surface = Place(anchor=item.phrase.things(), rooms=joined_places(list(item.places))[0].rooms)
            holds = self.lexicon.carries(item.phrase.noun.words) and not isinstance(last, Move)
            return (_placed(last, surface) if holds or not item.places else None), item.end
        return _of_thing(last, item), item.end

    def _place_after(self, reader: ClauseReader, at: int) -> tuple[tuple[Any, ...], int]:
        """Read ``, next to the bed there`` after the place that is meant."""
        comma = reader.text(at) == ","
        places, end = reader.places(at + comma)
        if not places or any(read.source or read.each for read in places):
            return (), at
        there = Place(rooms=Rooms(same=True))
        return tuple(read for read in places if read.place != there), end


def _says(words: Sequence[Word], at: int, said: tuple[str, ...]) -> bool:
    return tuple(word.text for word in words[at : at + len(said)]) == said


def _past_ending(words: Sequence[Word], at: int) -> int:
    """Return the place after ``was meant`` and ``, I meant``."""
    place = at + (at < len(words) and words[at].text == ",")
    pair = [word.raw for word in words[place : place + 2]]
    return place + 2 if pair[1:] == ["meant"] and pair[0] in ("was", "were", "is", "i", "we") else at


def _of_that_room(place: Place, rooms: Rooms) -> Place:
    """Return a place in a room without what only says that it is there."""
    return msgspec.structs.replace(place, rooms=rooms if place.rooms is None or place.rooms.same else place.rooms)


def _placed(statement: Statement, place: Place) -> Statement | None:
    """Return a statement at another place; None where it is about none."""
    if isinstance(statement, SetState | Remove | Paint | Turn | Replace):
        return _about_those(statement, place)
    if not isinstance(statement, Add | Ensure | Move):
        return None
    first = statement.place
    place = _on_that_storey(place, first.rooms)
    if place.anchor is None and not place.spot and first.anchor is not None:
        return msgspec.structs.replace(statement, place=msgspec.structs.replace(first, rooms=place.rooms))
    rooms = first.rooms if place.rooms in (None, Rooms(same=True)) else place.rooms
    relation = place.relation or first.relation
    return msgspec.structs.replace(statement, place=msgspec.structs.replace(place, relation=relation, rooms=rooms))


def _on_that_storey(place: Place, first: Rooms | None) -> Place:
    """Return a place on the storey of the first one, where a room of that kind with another number is named."""
    rooms = place.rooms
    if rooms is None or first is None or rooms.floors or not first.floors or not rooms.words:
        return place
    alike = rooms.words.rstrip("0123456789 ") == first.words.rstrip("0123456789 ")
    return msgspec.structs.replace(place, rooms=msgspec.structs.replace(rooms, floors=first.floors)) if alike else place


def _about_those(statement: SetState | Remove | Paint | Turn | Replace, place: Place) -> Statement | None:
    """Return what is done with the same things elsewhere: ``open the wardrobe in room 1, sorry, room 2``."""
    things = statement.things
    if things.refers or place.anchor is not None or place.spot or place.rooms is None:
        return None
    first = things.place
    if first is not None and first.anchor is not None:
        place = msgspec.structs.replace(first, rooms=place.rooms)
    place = _on_that_storey(place, None if first is None else first.rooms)
    return msgspec.structs.replace(statement, things=msgspec.structs.replace(things, place=place))


def _of_thing(statement: Statement | None, item: Item) -> Statement | None:
    """Return a statement about another thing: ``a mug; I meant a glass``, ``the lamp; I meant the one in the hall``."""
    things = getattr(statement, "things", None)
    if not isinstance(statement, Add | Ensure | SetState | Remove | Paint | Turn) or not isinstance(things, Things):
        return None
    said = item.things()
    if isinstance(statement, Add | Ensure) and (said.definite or said.place is not None or not said.noun):
        return None
    if said.noun.split()[-1:] == ["one"]:
        if said.place is None and not said.colour:
            return None
        colour = said.colour or things.colour
        said = msgspec.structs.replace(things, place=said.place or things.place, colour=colour)
    elif said.place is None and not isinstance(statement, Add | Ensure):
        said = msgspec.structs.replace(said, place=things.place)
    return msgspec.structs.replace(statement, things=said)

"""Names, uses, doors, stairs and lifts of rooms."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.giving import Giving
from mansion_editing.instructions.clauses.items import Item, NotUnderstood
from mansion_editing.instructions.phrases.places import ReadPlace, read_place
from mansion_editing.instructions.phrases.word_sets import BEFORE_DOORS, BEFORE_NAMES
from mansion_editing.instructions.phrases.words import DETERMINERS, FUNCTION_WORDS
from mansion_editing.instructions.statements import Ensure, Furnish, Place, Rename, Reshape, Rooms, Statement

__all__ = ["RoomChanges"]


_BETWEEN_ROOMS: Final = ("/", "-")
"""Marks between the two rooms of a door in notes."""
_HEADS_OF_ROOMS: Final = frozenset("room area corner space lounge office studio hall lab zone".split())
"""Last words of names for what a room may become, known or not."""
_LONGEST_KIND: Final = 3


class RoomChanges(Giving):
    """Reads what becomes of rooms."""

    def _rename(self, at: int, place: int) -> tuple[list[Statement], int]:
        place += self.text(place) == '"'
        item = self.item(place)
        if item is not None and item.phrase.refers == "last" and not item.phrase.noun.words:
            return self._rename_it(at, item)
        if item is None or item.phrase.noun.kind not in ("room", "both", "object"):
            raise NotUnderstood(at, self.boundary(at))
        end = item.phrase.end + (self.text(item.phrase.end) == '"')
        rooms = item.phrase.rooms()
        places: list[ReadPlace] = []
        for read in item.places:
            if self.words[read.start].text == "to" or (read.goal and read.place.anchor is not None):
                break
            places.append(read)
            end = read.end
        rooms = Item(item.phrase, tuple(places), end).rooms()
        while self.text(end) in BEFORE_NAMES:
            end += 1
        name, stop = self.name_at(end)
        return [Rename(room=rooms, name=name, quote=self.quote(at, stop))], stop

    def _rename_it(self, at: int, item: Item) -> tuple[list[Statement], int]:
        """Read ``rename it to "Den"``, ``call it "Den"`` of the room before; names are in quotes or capitals."""
        end = item.phrase.end
        while self.text(end) in BEFORE_NAMES and self.text(end) != '"':
            end += 1
        named = self.text(end) == '"' or (end < len(self.words) and self.words[end].capital)
        if not named or item.phrase.plural:
            raise NotUnderstood(at, self.boundary(at))
        name, stop = self.name_at(end + (self.text(end) == '"'))
        return [Rename(room=Rooms(same=True), name=name, quote=self.quote(at, stop))], stop

    def name_at(self, at: int) -> tuple[str, int]:
        """Read a name as it is written, up to a mark or the end."""
        stop = at
        while stop < len(self.words) and self.text(stop) not in (",", '"', ";", "please", "\n") and stop < at + 8:
            if self.text(stop) in ("and", "from") and (self.starts_clause(stop + 1) or self.text(stop) == "from"):
                break
            stop += 1
        if stop == at:
            raise NotUnderstood(at - 1, self.boundary(at - 1))
        name = self.quote(at, stop).strip("\"'“”‘’ ")
        stop += self.text(stop) == '"'
        return name, stop

    def _furnish(self, at: int, place: int) -> tuple[list[Statement], int]:
        framed = self.frame.rooms if self.text(place) in ("to", "into") else None
        if framed is not None:
            return self._furnish_as(at, place, framed)
        item = self.item(place, places=False)
        if item is None:
            raise NotUnderstood(at, self.boundary(at))
        if item.phrase.noun.kind == "object":
            raise NotUnderstood(at, self.boundary(at))
        places: list[ReadPlace] = []
        end = item.end
        while True:
            read = read_place(self.words, end, self.lexicon, self.floors)
            if read is None or self.text(end) in ("into", "to", "with"):
                break
            places.append(read)
            end = read.end
        rooms = Item(item.phrase, tuple(places), end).rooms()
        while self.text(end) in ("anew", "again", "afresh", "completely", "newly", "new"):
            end += 1
        if self.text(end) == "with":
            return self._equip(at, place)
        if self.text(end) in ("into", "as", "to", "for", "like"):
            return self._furnish_as(at, end, rooms)
        return [Furnish(rooms=rooms, quote=self.quote(at, end))], end

    def _furnish_as(self, at: int, joint: int, rooms: Rooms) -> tuple[list[Statement], int]:
        """Read ``into a study`` after the room that becomes one, which a heading may have named."""
        found = self.kind_of_room(joint + 1)
        if found is None:
            raise NotUnderstood(joint, self.boundary(joint))
        kind, end = found
        return [Furnish(rooms=rooms, kind=kind, quote=self.quote(at, end))], end

    def kind_of_room(self, at: int) -> tuple[str, int] | None:
        """Read ``a home gym``, ``our new staff lounge``; ``a movement room`` is a kind by its last word alone."""
        found = self.phrase(at)
        if found is not None and found.noun.kind in ("room", "both") and not found.noun.unknown:
            return " ".join((*filter(None, [found.noun.owned]), *found.noun.words)), found.end
        start = at + (self.text(at) in DETERMINERS)
        start += self.text(start) == "new"
        end = start
        while end < len(self.words) and self.words[end].kind == "word" and self.text(end) not in FUNCTION_WORDS:
            end += 1
        plain = start > at and 1 < end - start <= _LONGEST_KIND and self.text(end - 1) in _HEADS_OF_ROOMS
        return (" ".join(word.text for word in self.words[start:end]), end) if plain else None

    def contained(self, at: int) -> tuple[list[Statement], int]:
        """Read what a room that was furnished just before must contain: ``a piano and two chairs``."""
        items = self.items(at)
        if any(item.is_room or item.phrase.definite or item.phrase.refers or item.places for item in items):
            raise NotUnderstood(at, self.boundary(at))
        end = items[-1].end
        here, quote = Place(rooms=Rooms(same=True)), self.quote(at, end)
        return [Ensure(things=item.phrase.things(), place=here, quote=quote) for item in items], end

    def _use(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``use the storage as an office``."""
        item = self.item(place)
        if item is None or self.text(item.end) != "as":
            raise NotUnderstood(at, self.boundary(at))
        return self._furnish(at, place)

    def _door_between(self, at: int, place: int) -> tuple[list[Statement], int] | None:
        """Read ``add a door between the kitchen and the dining room``, ``add door kitchen / dining room``."""
        start = place
        while self.text(place) in BEFORE_DOORS:
            place += 1
        if self.text(place) not in ("door", "doorway", "opening", "passage"):
            return None
        linking = self.text(place + 1)
        room = self.item(place + 1, places=False)
        if room is not None and room.is_room and self.text(room.end) in _BETWEEN_ROOMS:
            return self._connect(at, place + 1)
        if linking not in ("between", "from", "connecting", "linking", "joining") and start == place:
            return None
        if linking not in ("between", "from", "connecting", "linking", "joining"):
            return None
        return self._connect(at, place + 2)

    def _connect(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read the two rooms that a door shall connect."""
        one = self.item(place, places=False)
        if one is None or one.phrase.noun.kind not in ("room", "both"):
            raise NotUnderstood(place, self.boundary(place))
        end = one.end
        if self.text(end) not in ("and", "to", "with", *_BETWEEN_ROOMS):
            raise NotUnderstood(place, self.boundary(place))
        other = self.item(end + 1)
        if other is None or other.phrase.noun.kind not in ("room", "both"):
            raise NotUnderstood(place, self.boundary(place))
        end = other.end
        if self.text(end) in ("with", "by") and self.text(end + 2) in ("door", "doorway", "opening"):
            end += 3
        floors = other.rooms().floors
        first = msgspec.structs.replace(one.rooms(), floors=floors)
        return [Reshape(what="door", rooms=first, other=other.rooms(), quote=self.quote(at, end))], end

    def _new_core(self, items: Sequence[Item], at: int, end: int) -> Statement | None:
        """Read ``add a second stair``."""
        if (
            len(items) != 1
            or not items[0].phrase.noun.words
            or self.text(at) not in ("add", "build", "create", "install", "put")
        ):
            return None
        head = items[0].phrase.noun.words[-1]
        what = {"stair": "stair", "staircase": "stair", "stairwell": "stair", "elevator": "elevator"}.get(head)
        if what is None:
            return None
        where = items[0].goal()[0].rooms
        return Reshape(what="stair" if what == "stair" else "elevator", rooms=where, quote=self.quote(at, end))

"""Sentences and clauses that only repeat what was asked before: elsewhere, with more, of other things."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import joined_places
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.places import merged, with_place
from mansion_editing.instructions.phrases.words import BE, MODALS, Word, next_mark
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.statements import (
    Add,
    Amount,
    Ensure,
    Finish,
    Forbid,
    History,
    Mention,
    Move,
    Paint,
    Place,
    Reach,
    Remove,
    Replace,
    Rooms,
    SetState,
    Things,
    Turn,
)

__all__ = ["Repeating"]

_BLOCKING: Final = frozenset("block blocks blocking obstruct obstructs obstructing hinder hinders".split())
_BLOCKED: Final = (("it",), ("that",), ("the", "way"), ("the", "path"), ("the", "route"), ("its", "way"),
                   ("the", "robot"), ("this", "way"), ("that", "way"))  # fmt: skip
_FILLING: Final = (("fill", "in"), ("fill", "up"), ("fill",), ("add",), ("bring",), ("supply",), ("complete",))
_MISSING: Final = frozenset(
    [("the", "missing", "one"), ("the", "missing"), ("the", "gap"), ("any", "gap"), ("missing", "one")]
    + [(what, *verb, "missing") for what in ("whatever", "what", "anything", "everything") for verb in (("is",), ())]
)
_IDLE: Final = frozenset("please just only still there that simply and".split())
_IN_THE_WAY: Final = (("in", "the", "way"), ("in", "its", "way"), ("stand", "in", "the", "way"))


class Repeating(Progress):
    """Reads ``and in the bedroom too``, ``one more`` and ``the one in the hall too``."""

    def _repeats(self, reader: ClauseReader, words: Sequence[Word], at: int) -> bool:
        """Read what only repeats an earlier instruction: ``and in the bedroom too``, ``the same upstairs``."""
        if self.statements:
            return self._frees_way(reader, words, at)
        if reader.text(at) in ("same", "likewise", "ditto") or (
            reader.text(at) == "the" and reader.text(at + 1) == "same"
        ):
            at += 1 + (reader.text(at) == "the")
            at += reader.text(at) in ("thing", "again")
            if reader.text(at) == "for":
                return self._repeats_for(reader, words, at + 1)
        elif not (
            words[0].text in ("and", "also", "now", "then") or "too" in (words[-1].text, reader.text(len(words) - 2))
        ):
            return self._one_more(reader, words, at)
        places, end = reader.places(at)
        if not places or reader.skip(end) < len(words):
            return self._one_more(reader, words, at)
        place = places[0].place
        for read in places[1:]:
            place = merged(place, read.place)
        self.statements.append(History(what="repeat", place=place, quote=self._quote(words, 0, len(words))))
        return True

    def _repeats_for(self, reader: ClauseReader, words: Sequence[Word], at: int) -> bool:
        quote = self._quote(words, 0, len(words))
        if tuple(w.text for w in words[at : at + 3]) in (("the", "next", "room"), ("the", "next", "one")):
            place = Place(rooms=Rooms(next_to="room", same=True))
            self.statements.append(History(what="repeat", place=place, quote=quote))
            return True
        item = reader.item(at)
        if item is None or reader.skip(item.end) < len(words):
            return False
        if item.phrase.noun.kind in ("room", "both"):
            self.statements.append(History(what="repeat", place=Place(rooms=item.rooms()), quote=quote))
        else:
            self.statements.append(History(what="repeat", things=item.things(), quote=quote))
        return True

    def _one_more(self, reader: ClauseReader, words: Sequence[Word], at: int) -> bool:
        phrase = reader.phrase(at)
        bare = phrase is not None and phrase.refers == "last" and phrase.amount.kind == "more"
        if phrase is None or not bare or reader.skip(phrase.end) < len(words):
            return False
        quote = self._quote(words, 0, len(words))
        self.statements.append(History(what="repeat", things=phrase.things(), quote=quote))
        return True

    def _same_of_others(self, reader: ClauseReader, words: Sequence[Word], at: int) -> int | None:
        """Read things without a verb after a state, a removal or the like: ``turn the TV on and the beer tap too``."""
        last = self.statements[-1] if self.statements else None
        if isinstance(last, Finish) and at and words[at - 1].text in ("and", ","):
            covered = self._surface_too(reader, words, at, last)
            if covered is not None:
                return covered
        filled = self._end_of_filling(words, at) if isinstance(last, Ensure) else 0
        if filled and last is not None:
            whole = self.text[self.text.find(last.quote) : words[filled - 1].end]
            self.statements[-1] = msgspec.structs.replace(last, quote=whole)
            return filled
        there_too = self._same_there(reader, words, at) or self._none_there(reader, words, at)
        if there_too is not None:
            return there_too
        if not isinstance(last, SetState | Remove | Paint | Turn | Replace) or at == 0 or reader.starts_clause(at):
            return None
        if words[at - 1].text not in ("and", "also", ",", "plus"):
            return None
        item = reader.item(at)
        if item is None or item.is_room or reader.subjects(at) or item.phrase.amount.kind == "none":
            return None
        if words[at].raw in ("its", "their") and isinstance(last, Remove):
            return None  # the chairs of the desks that go, which are some of those there
        if reader.tells_states(at):
            return None
        end = item.end + (reader.text(item.end) in ("too", "also"))
        end += 2 * ((reader.text(end), reader.text(end + 1)) == ("as", "well"))
        if end < len(words) and words[end].text not in ("and", ",", ".", "please"):
            return None
        new = item.phrase.amount.kind == "some" and words[at].text in ("a", "an")
        counted = new or (item.phrase.amount.kind == "some" and words[at].kind == "number" and not item.phrase.definite)
        brought = isinstance(last, SetState) and counted and bool(item.places)
        brought = brought and not self._begins_with_order(last.quote)
        aimed = any(p.goal and reader.text(p.start) in ("into", "onto", "to") for p in item.places)
        if isinstance(last, Remove) and aimed and not any(p.source for p in item.places):
            return None  # after "the can out" the bottle goes into the fridge, and not away
        if brought or (new and isinstance(last, Remove)):
            return None  # a desk after "the rugs go" does not go, two mugs after "TV on" take no state
        things = item.things()
        if things.noun == "one" and (things.place is not None or things.colour):
            things = msgspec.structs.replace(things, noun=last.things.noun)
        elif isinstance(last, Replace) and (end == item.end or not things.definite):
            return None
        rooms = last.things.place.rooms if last.things.place is not None else None
        if things.place is None and rooms is not None:
            things = with_place(things, Place(rooms=rooms))
        if things.plural and things.amount.number == 0:
            things = msgspec.structs.replace(things, amount=Amount(kind="all", number=0))
        self.statements.append(msgspec.structs.replace(last, things=things, quote=self._quote(words, at, end)))
        return end

    def _end_of_filling(self, words: Sequence[Word], at: int) -> int:
        """Return the end of ``fill in whatever is missing``, as wishes for what shall be there do; 0 for others."""
        said = [word.text for word in words[at : next_mark(words, at)] if word.text not in _IDLE]
        verb = next((len(verb) for verb in _FILLING if tuple(said[: len(verb)]) == verb), 0)
        missing = tuple(said[verb:])
        return next_mark(words, at) if verb and missing in _MISSING else 0

    def _same_there(self, reader: ClauseReader, words: Sequence[Word], at: int) -> int | None:
        """Read ``and in the kitchen`` after a state or a removal in another room: the same there."""
        last = self.statements[-1] if self.statements else None
        if not isinstance(last, SetState | Remove | Paint) or at == 0 or words[at - 1].text != "and":
            return None
        places, end = reader.places(at)
        before = last.things.place
        if not places or before is None or before.anchor is not None or before.rooms is None or before.outside:
            return None
        if isinstance(last, Remove) and any(read.goal for read in places):
            return None  # "out of the hall and into the study"
        place, _ = joined_places(places)
        counted = last.things.amount.number > 0 and not last.things.definite
        plain = place.anchor is None and place.rooms is not None and bool(place.rooms.words) and not place.outside
        if not plain or counted or last.things.beside or (end < len(words) and words[end].kind != "mark"):
            return None
        there = msgspec.structs.replace(last.things, place=place)
        self.statements.append(msgspec.structs.replace(last, things=there, quote=self._quote(words, at, end)))
        return end

    def _none_there(self, reader: ClauseReader, words: Sequence[Word], at: int) -> int | None:
        """Read ``and none in the dining room either`` after ``No knives in the kitchen``."""
        last = self.statements[-1] if self.statements else None
        if isinstance(last, Add | Ensure):
            return self._none_elsewhere(reader, words, at, last)
        denied = isinstance(last, Remove) and "no" in last.quote.lower().split() and last.things.amount.kind == "all"
        if not isinstance(last, Remove) or not denied or at == 0 or reader.text(at) != "none":
            return None
        if last.things.definite or last.things.beside or not last.things.noun or self._begins_with_order(last.quote):
            return None
        places, end = reader.places(at + 1)
        place, each = joined_places(places)
        end += reader.text(end) in ("either", "too")
        told = bool(places) and not place.outside and not any(read.source or read.goal for read in places)
        if (
            not told
            or each
            or words[at - 1].text not in ("and", ",")
            or (end < len(words) and words[end].kind != "mark")
        ):
            return None
        there = msgspec.structs.replace(last.things, place=place)
        self.statements.append(msgspec.structs.replace(last, things=there, quote=self._quote(words, at, end)))
        return end

    def _none_elsewhere(self, reader: ClauseReader, words: Sequence[Word], at: int, last: Add | Ensure) -> int | None:
        """Read ``but none on the bed`` after what is brought elsewhere: no such thing comes there."""
        if (
            reader.text(at) != "none"
            or at == 0
            or words[at - 1].text not in ("and", "but", ",")
            or not last.things.noun
        ):
            return None
        places, end = reader.places(at + 1)
        place, each = joined_places(places)
        told = bool(places) and place.anchor is not None and not (place.outside or each or place.anchor.refers)
        if (
            not told
            or any(read.source or read.goal for read in places)
            or (end < len(words) and words[end].kind != "mark")
        ):
            return None
        if place.rooms is None and last.place.rooms is not None:
            place = msgspec.structs.replace(place, rooms=last.place.rooms)
        things = Things(noun=last.things.noun, amount=Amount(kind="all", number=0), plural=True)
        self.statements.append(Forbid(things=things, place=place, quote=self._quote(words, at, end)))
        return end

    def _surface_too(self, reader: ClauseReader, words: Sequence[Word], at: int, last: Finish) -> int | None:
        """Read ``and the walls green`` after the ceiling of a room was painted, ``and the hall white`` after walls."""
        frame, reader.frame = reader.frame, Place(rooms=last.rooms)
        surface = reader.surface(at)
        reader.frame = frame
        room = reader.item(at) if surface is None and last.part == "walls" else None
        if room is not None and room.is_room and not room.rooms().same:
            surface = ("walls", room.rooms()), room.end
        colour = None if surface is None else reader.colour_at(surface[1])
        if surface is None or colour is None:
            return None
        (part, rooms), _ = surface
        quote = self._quote(words, at, colour[2])
        self.statements.append(Finish(rooms=rooms, part=part, colour=colour[0], material=colour[1], quote=quote))
        return colour[2]

    def _more_of_the_same(self, reader: ClauseReader, words: Sequence[Word], at: int) -> int | None:
        """Read things without a verb, which go where the things before them went: ``and a pen too``."""
        last = self.statements[-1] if self.statements else None
        if (
            not isinstance(last, Add | Ensure | Move)
            or at == 0
            or words[at - 1].text not in ("and", "also", ",", "plus")
        ):
            return None
        item = reader.item(at)
        if item is None or item.is_room or item.phrase.definite or item.places or reader.subjects(at):
            return None
        after = reader.skip(item.end)
        if after < len(words) and not reader.starts_clause(after) and words[item.end].text not in ("and", ","):
            return None
        if isinstance(last, Move) and (last.place.anchor is None or last.place.anchor.refers):
            return None
        quote = self._quote(words, at, item.end)
        new = Add(things=item.phrase.things(), place=last.place) if isinstance(last, Move) else last
        self.statements.append(msgspec.structs.replace(new, things=item.phrase.things(), quote=quote))
        return item.end

    def _frees_way(self, reader: ClauseReader, words: Sequence[Word], at: int) -> bool:
        """Read ``make sure nothing blocks it`` after a way was asked for, which is then checked again."""
        last = next((s for s in reversed(self.statements) if not isinstance(s, Mention)), None)
        texts = [word.text for word in words[at:]]
        if texts[:1] in (["make"], ["be"]) and texts[1:2] == ["sure"]:
            texts = texts[2:]
        elif texts[:1] == ["ensure"]:
            texts = texts[1:]
        texts = texts[1:] if texts[:1] == ["that"] else texts
        if not isinstance(last, Reach) or texts[:1] != ["nothing"]:
            return False
        rest = [word for word in texts[1:] if word not in MODALS and word not in BE]
        verb = len(rest) > 1 and rest[0] in _BLOCKING and tuple(rest[1:]) in _BLOCKED
        if not verb and tuple(rest) not in _IN_THE_WAY:
            return False
        self.statements.append(msgspec.structs.replace(last, quote=self._quote(words, at, len(words))))
        return True

"""Clauses that tell what rooms or furniture have not: ``the kitchen and the hall have no clock``."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import Item, NotUnderstood
from mansion_editing.instructions.clauses.predicates import Predicates
from mansion_editing.instructions.phrases.words import BE
from mansion_editing.instructions.statements import JOINED, Amount, Mention, Place, Rooms, Statement

__all__ = ["Lacks"]

_JUST_NOW: Final = frozenset("currently still now yet also both all each".split())
_HAVE: Final = frozenset("have has".split())


class Lacks(Predicates):
    """Reads what is told to be missing, which removes nothing."""

    def _told_to_lack(self, subjects: Sequence[Item], at: int, *, denied: bool) -> tuple[list[Statement], int] | None:
        """Read ``the kitchen and the hall have no clock``, which asks for nothing, for what comes next.

        Raises
        ------
        NotUnderstood
            Where what is missing is not one kind of thing in certain rooms or at one piece of furniture.
        """
        verb = self._verb_of_lack(subjects[-1].end, denied=denied)
        if verb is None:
            return None
        place, negated = verb
        lacking = self.items(place)
        if not negated and any(item.phrase.amount.kind != "none" for item in lacking[:1]):
            return None
        end = lacking[-1].end
        if self.text(end) in ("anymore", "any") or self._is_way(lacking[0].phrase):
            return None
        where = self._where_all_are(subjects)
        several = len(lacking) > 1 or lacking[0].phrase.noun.kind != "object" or lacking[0].places
        if where is None or several:
            raise NotUnderstood(at, end)
        if where.rooms is not None and (denied or subjects[0].phrase.amount.kind == "none"):
            where = msgspec.structs.replace(where, rooms=msgspec.structs.replace(where.rooms, every=True))
        end = self._past_adverbs(end)
        things = lacking[0].phrase.things()
        self.topic = msgspec.structs.replace(things, amount=Amount(kind="more"), place=where)
        return [Mention(quote=self.quote(at, end))], end

    def _verb_of_lack(self, at: int, *, denied: bool) -> tuple[int, bool] | None:
        """Return the place after ``has`` or ``does not have``, and whether it is denied; None for other verbs."""
        place = self._past_adverbs(at)
        raw = self.words[place].raw if place < len(self.words) else ""
        negated = denied or (self.text(place) == "not" and raw.startswith(("do", "has", "have")))
        if self.text(place) in ("do", "does") and self.text(place + 1) == "not":
            place, negated = place + 2, True
        elif negated and not denied:
            place += raw.startswith("do")
        place = self._past_adverbs(place)
        having = self.text(place) in _HAVE or (self.text(place) == "not" and raw.startswith("ha"))
        if not having or self.text(place + 1) in ("to", *BE):
            return None
        place += 1 + (self.text(place + 1) in ("got", "get"))
        place = self._past_adverbs(place)
        if self.text(place + 1) in ("business", "place") or self.text(place) in ("nothing", "nowhere"):
            return None
        return place, negated

    def _past_adverbs(self, at: int) -> int:
        while self.text(at) in _JUST_NOW:
            at += 1
        return at

    def _where_all_are(self, subjects: Sequence[Item]) -> Place | None:
        """Return the place of what several rooms on the same storeys, or one subject, have; None for others."""
        if len(subjects) == 1:
            return self._receiver(subjects[0])
        rooms = [subject.rooms() for subject in subjects if subject.is_room]
        last = rooms[-1] if rooms else Rooms()
        alike = [
            msgspec.structs.replace(room, words="", floors=room.floors or last.floors) == Rooms(floors=last.floors)
            for room in rooms
        ]
        if len(rooms) < len(subjects) or not all(alike) or not all(room.words for room in rooms):
            return None
        words = JOINED.join(room.words for room in rooms)
        return Place(rooms=Rooms(words=words, floors=last.floors, every=True, number=len(rooms)))

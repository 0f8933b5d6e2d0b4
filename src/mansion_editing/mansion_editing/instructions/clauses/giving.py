"""Rooms and furniture that are given things."""

from abc import abstractmethod
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import Item, NotUnderstood
from mansion_editing.instructions.clauses.outcomes import Outcomes
from mansion_editing.instructions.phrases.places import ReadPlace, read_place
from mansion_editing.instructions.phrases.word_sets import PEOPLE
from mansion_editing.instructions.phrases.words import PERSONS
from mansion_editing.instructions.statements import Add, Amount, Ensure, Statement

__all__ = ["Giving"]

_LOADING: Final = frozenset("load fill pack stock restock refill".split())
"""Verbs that name what is filled, or what it is filled with."""
_HOLDING: Final = frozenset(["on", "in"])


class Giving(Outcomes):
    """Reads ``equip the office with two desks``."""

    def _equip(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``equip the office with two desks``, ``fill the basket with apples``, ``load the books on the cart``."""
        loaded = self._loaded(at, place)
        if loaded is not None:
            return loaded
        where = self.holder_at(place)
        served = where is not None and self.text(where.end) == "for" and not self._further(where.end)
        persons = self._persons_served(where)
        where = self._holder_before_list(at, place, where)
        items = self.items(where.end + 1)
        end = items[-1].end
        goal = self._receiver(where)
        if goal.anchor is not None and self.text(at) in _LOADING and self._opens(where):
            goal = msgspec.structs.replace(goal, relation="in")
        each = where.phrase.each or where.phrase.amount.kind == "all" or (where.phrase.plural and where.phrase.definite)
        goal = goal if goal.rooms is not None else self._framed((goal, each))[0]
        quote = self.quote(at, end)
        out = [self._given(item, goal, quote, each=each) for item in items]
        out = [_there(s) for s in out] if served else out
        stop = self._end_of_each_person(end) if served else end
        if served and stop == end and persons > 1 and all(self._is_bare(item.phrase) for item in items):
            return [_for_persons(s, persons) for s in out], end  # "for six: plate, knife and fork"
        if stop > end and not persons:
            raise NotUnderstood(at, stop)
        return [_for_persons(s, persons) for s in out] if stop > end else out, stop

    def _persons_served(self, where: Item | None) -> int:
        """Return for how many it is: 12 of ``the room for 12 people``; 0 where that is not told."""
        number = where.end + 1 if where is not None and self.text(where.end) == "for" else len(self.words)
        counted = number < len(self.words) and self.words[number].kind == "number"
        return int(self.words[number].value) if counted else 0

    def _end_of_each_person(self, at: int) -> int:
        """Return the end of ``each``, ``per person`` after what is given; the place itself where there is none."""
        if self.text(at) in ("each", "apiece"):
            return at + 1
        if (self.text(at), self.text(at + 1)) == ("for", "each") and self._ends_clause_at(at + 2):
            return at + 2
        per = self.text(at) == "per" or (self.text(at), self.text(at + 1)) == ("for", "each")
        after = at + 1 + (self.text(at) == "for")
        return after + 1 if per and self.text(after) in PEOPLE | PERSONS | {"head", "seat"} else at

    def _ends_clause_at(self, at: int) -> bool:
        return at >= len(self.words) or self.words[at].kind == "mark"

    def _further(self, at: int) -> bool:
        """Whether words after a holder ask for more than there is: ``set the table for two more people``."""
        return bool({word.text for word in self.words[at : at + 4]} & {"more", "extra", "additional", "another"})

    def _opens(self, where: Item) -> bool:
        return self.lexicon.takes_state(where.phrase.noun.words, "open")

    def _loaded(self, at: int, place: int) -> tuple[list[Statement], int] | None:
        """Read ``load the books on the cart``, where what the verb is followed by is no holder but what goes there."""
        if self.text(at) not in _LOADING:
            return None
        item = self.item(place)
        if item is None or item.is_room or self.text(item.end) in ("with", "for", ":"):
            return None
        last = self.items(place)[-1]
        held = [p for p in last.places if not p.source and p.place.anchor is not None and p.place.relation in _HOLDING]
        return self._add(at, place) if held and self.text(last.end) != "with" else None

    @abstractmethod
    def _add(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read what is put somewhere."""

    def _holder_before_list(self, at: int, place: int, where: Item | None) -> Item:
        """Return what is given things, which ends before the ``with`` or the colon of their list.

        Raises
        ------
        NotUnderstood
            Where there is no such word.
        """
        after = "" if where is None else self.text(where.end)
        if where is not None and after == "for":
            joints = (k for k in range(where.end, min(where.end + 6, len(self.words))) if self.text(k) in (":", "with"))
            colon = next(joints, None)
            if colon is None:
                raise NotUnderstood(at, self.boundary(at))
            return Item(where.phrase, where.places, colon)
        if where is not None and after == ":":
            more, start = self._skip_storey(where.end + 1)
            return Item(where.phrase, (*where.places, *more), start - 1)
        if where is not None and after == "with":
            return where
        joint = next((k for k in range(place, len(self.words)) if self.text(k) == "with"), None)
        where = None if joint is None else self.until(joint).item(place)
        if joint is None or where is None:
            raise NotUnderstood(at, self.boundary(at))
        return Item(where.phrase, where.places, joint)

    def holder_at(self, at: int) -> Item | None:
        """Read what is laid or filled, without the ``for six`` that says for how many."""
        item = self.item(at)
        last = None if item is None or not item.places else item.places[-1]
        if item is None or last is None or self.text(last.start) != "for":
            return item
        return Item(item.phrase, item.places[:-1], last.start)

    def _skip_storey(self, at: int) -> tuple[tuple[ReadPlace, ...], int]:
        """Read a storey that only tells where the thing before a colon is (``: 2nd floor, ...``)."""
        read = read_place(self.words, at, self.lexicon, self.floors)
        if read is None or read.place.rooms is None or read.place.rooms.words or self.text(read.end) != ",":
            return (), at
        return (read,), read.end + 1


def _for_persons(statement: Statement, persons: int) -> Statement:
    """Return what each of so many persons gets as what all of them get."""
    if not isinstance(statement, Ensure) or statement.things.amount.kind != "some":
        return statement
    amount = Amount(number=max(1, statement.things.amount.number) * persons)
    things = msgspec.structs.replace(statement.things, amount=amount, plural=amount.number > 1)
    return msgspec.structs.replace(statement, things=things)


def _there(statement: Statement) -> Statement:
    """Return that so many are there, those that lie there counted: ``set the table for six: six plates``."""
    if not isinstance(statement, Add):
        return statement
    return Ensure(things=statement.things, place=statement.place, each=statement.each, quote=statement.quote)

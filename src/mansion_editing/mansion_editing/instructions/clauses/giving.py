"""Rooms and furniture that are given things."""

import msgspec

from mansion_editing.instructions.clauses.items import Item, NotUnderstood
from mansion_editing.instructions.clauses.outcomes import Outcomes
from mansion_editing.instructions.phrases.places import ReadPlace, read_place
from mansion_editing.instructions.phrases.word_sets import PEOPLE
from mansion_editing.instructions.phrases.words import PERSONS
from mansion_editing.instructions.statements import Add, Amount, Ensure, Statement

__all__ = ["Giving"]


class Giving(Outcomes):
    """Reads ``equip the office with two desks``."""

    def _equip(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``equip the office with two desks``, ``fill the basket with apples``."""
        where = self.holder_at(place)
        served = False
        persons = self._persons_served(where)
        if where is not None and self.text(where.end) == "for":
            further = {w.text for w in self.words[where.end : where.end + 4]} & {
                "more",
                "extra",
                "additional",
                "another",
            }
            served = not further
        if where is not None and self.text(where.end) == "for":
            colon = next(
                (k for k in range(where.end, min(where.end + 6, len(self.words))) if self.text(k) in (":", "with")),
                None,
            )
            if colon is None:
                raise NotUnderstood(at, self.boundary(at))
            where = Item(where.phrase, where.places, colon)
        elif where is not None and self.text(where.end) == ":":
            more, start = self._skip_storey(where.end + 1)
            where = Item(where.phrase, (*where.places, *more), start - 1)
        elif where is None or self.text(where.end) not in ("with",):
            joint = next((k for k in range(place, len(self.words)) if self.text(k) == "with"), None)
            if joint is None:
                raise NotUnderstood(at, self.boundary(at))
            where = self.until(joint).item(place)
            if where is None:
                raise NotUnderstood(at, self.boundary(at))
            where = Item(where.phrase, where.places, joint)
        items = self.items(where.end + 1)
        end = items[-1].end
        goal = self._receiver(where)
        each = where.phrase.each or where.phrase.amount.kind == "all" or (where.phrase.plural and where.phrase.definite)
        quote = self.quote(at, end)
        out = [self._given(item, goal, quote, each=each) for item in items]
        out = [_there(s) for s in out] if served else out
        stop = self._end_of_each_person(end) if served else end
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
        per = self.text(at) == "per" or (self.text(at), self.text(at + 1)) == ("for", "each")
        after = at + 1 + (self.text(at) == "for")
        return after + 1 if per and self.text(after) in PEOPLE | PERSONS | {"head", "seat"} else at

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

"""Clauses that tell of more things than shall be, and clauses that say how many of them are left."""

from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import Item, joined_places
from mansion_editing.instructions.clauses.outcomes import Outcomes
from mansion_editing.instructions.phrases.places import with_place
from mansion_editing.instructions.phrases.word_sets import KEPT_AS_IT_IS
from mansion_editing.instructions.phrases.words import STATE_WORDS
from mansion_editing.instructions.statements import Amount, Ensure, Mention, Place, Remove, Rooms, Statement, Things

__all__ = ["TooMany"]

_HAVING: Final = frozenset("has have got".split())
_BY_FAR: Final = frozenset("far way much really simply just a bit somewhat clearly definitely".split())
_ENOUGH: Final = frozenset("enough suffice sufficient plenty do".split())
_LEAVING: Final = frozenset("leave keep".split())


class TooMany(Outcomes):
    """Reads ``six easels are too many for the art room`` and ``leave four of them``."""

    def _too_many(self, at: int) -> tuple[list[Statement], int] | None:
        """Read a clause by which there are too many of a kind somewhere, of which the next clause leaves a number."""
        return (
            self._too_few(at)
            or self._so_many_too_many(at)
            or self._has_too_many(at)
            or self._not_so_many(at)
            or self._are_too_many(at)
        )

    def _too_few(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``there is one chair too few in the hall``, ``we are two chairs short``: so many are missing."""
        contracted = at < len(self.words) and self.words[at].raw in ("there's", "theres", "we're")
        start = at + 1 + (self.text(at + 1) in ("is", "are"))
        if self.text(at) not in ("there", "we") or not (contracted or start == at + 2):
            return None
        item = self.item(start, places=False)
        counted = item is not None and item.phrase.amount.kind == "some" and item.phrase.amount.number
        if item is None or not counted or item.is_room or not item.phrase.noun.words:
            return None
        few = (self.text(item.end), self.text(item.end + 1)) == ("too", "few") and self.text(at) == "there"
        short = self.text(item.end) == "short" and self.text(at) == "we"
        if not (few or short):
            return None
        place, end = self._where(item, item.end + 1 + few)
        if place == Place():
            return None
        missing = Amount(kind="more", number=item.phrase.amount.number)
        self.topic = msgspec.structs.replace(item.phrase.things(), amount=missing, definite=False, place=place)
        return [Mention(quote=self.quote(at, end))], end

    def _are_too_many(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``six easels are too much for the art room``."""
        item = self.item(at)
        if item is None or self.text(item.end) not in ("is", "are") or not self._is_counted(item):
            return None
        end = self._past_too_many(item.end + 1)
        if not end:
            return None
        place, after = self._where(item, end)
        return self._told(at, item, place, after)

    def _has_too_many(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the art room has too many stools``, ``we've got too many stools in the art room``."""
        ours = self._past_our_having(at)
        many = self._past_too_many(ours) if ours else 0
        item = self.item(many) if many else None
        if item is not None and not item.is_room:
            place, end = self._where(item, item.end)
            return self._told(at, item, place, end)
        owner = self.item(at)
        if owner is None or not owner.is_room or self.text(owner.end) not in _HAVING:
            return None
        many = self._past_too_many(owner.end + 1)
        item = self.item(many) if many else None
        if item is None or item.is_room or item.places:
            return None
        return self._told(at, item, Place(rooms=owner.rooms()), item.end)

    def _past_our_having(self, at: int) -> int:
        """Return the place after ``we have``, ``we've got``; 0 where no such words stand there."""
        if self.text(at) not in ("we", "i"):
            return 0
        end = at + 1
        while self.text(end) in _HAVING:
            end += 1
        return end if end > at + 1 or self.words[at].raw.endswith("'ve") else 0

    def _not_so_many(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``we do not need six easels in the art room`` before ``four are enough``."""
        nobody = self.text(at) == "nobody" and self.text(at + 1) == "need"
        ours = self.text(at) in ("we", "i") and (self.text(at + 1), self.text(at + 2)) == ("not", "need")
        if not (ours or nobody):
            return None
        item = self.item(at + 3 - nobody)
        if item is None or item.phrase.amount.number < 2 or not self._is_counted(item):
            return None
        rest = {word.text for word in self.words[item.end :]}
        ends = item.end >= len(self.words)
        if not ends and (self.text(item.end) not in (",", "and", "-", ";") or not (rest & _ENOUGH or nobody)):
            return None
        return self._told(at, item, joined_places(list(item.places))[0], item.end)

    def _so_many_too_many(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``there are two chairs too many in the hall``: they go; ``leave three`` says how many there are."""
        if self.text(at) != "there" or self.text(at + 1) not in ("is", "are"):
            return None
        item = self.item(at + 2, places=False)
        if item is None or item.is_room or not item.phrase.amount.number or item.phrase.amount.kind != "some":
            return None
        end = self._past_too_many(item.end)
        if not end:
            return None
        place, end = self._where(item, end)
        left, stop = self._number_left(end)
        amount = Amount(number=item.phrase.amount.number, of=item.phrase.amount.number + left if left else 0)
        things = item.phrase.things()
        if place == Place():
            return None
        quote = self.quote(at, stop)
        gone = Remove(things=with_place(msgspec.structs.replace(things, amount=amount), place), quote=quote)
        rest = msgspec.structs.replace(things, amount=Amount(kind="exactly", number=left))
        return [gone, *([Ensure(things=rest, place=place, quote=quote)] if left else [])], stop

    def _number_left(self, at: int) -> tuple[int, int]:
        """Read ``, leave three of them``; 0 and the place itself for others."""
        start = self.skip(at)
        number = self.words[start + 1] if start + 1 < len(self.words) else None
        if self.text(start) not in _LEAVING or number is None or number.kind != "number":
            return 0, at
        end = start + 2 + 2 * ((self.text(start + 2), self.text(start + 3)) == ("of", "them"))
        ends = end >= len(self.words) or self.words[end].kind == "mark"
        return (int(number.value), end) if ends else (0, at)

    def _is_counted(self, item: Item) -> bool:
        """Whether things of a kind are told of by their number, or as all that are there."""
        phrase = item.phrase
        return not item.is_room and phrase.noun.kind == "object" and phrase.plural and not phrase.refers

    def _past_too_many(self, at: int) -> int:
        """Return the end of ``far too many``; 0 for other words."""
        while self.text(at) in _BY_FAR:
            at += 1
        return at + 2 if self.text(at) == "too" and self.text(at + 1) in ("many", "much") else 0

    def _where(self, item: Item, at: int) -> tuple[Place, int]:
        """Return the place of things, which may come after what is said of them: ``too many for the hall``."""
        room = self.item(at + 1) if self.text(at) == "for" else None
        places, end = self.places(at)
        if room is not None and room.is_room:
            return Place(rooms=room.rooms()), room.end
        return self._framed(joined_places([*item.places, *places]))[0], end

    def _told(self, at: int, item: Item, place: Place, end: int) -> tuple[list[Statement], int] | None:
        """Make things what the next clause is about."""
        if place == Place():
            return None
        things = msgspec.structs.replace(item.phrase.things(), definite=True, plural=True, place=None)
        self.topic = with_place(things, place)
        return [Mention(rooms=place.rooms, quote=self.quote(at, end))], end

    def _left_over(self, at: int, place: int) -> tuple[list[Statement], int] | None:
        """Read ``leave four of them, and four stools``, ``keep only two of the stools``: all others go."""
        place += self.text(place) in ("only", "just")
        begun = self.item(place)
        if begun is None:
            return None
        first = begun.phrase
        partitive = self._is_partitive(first) or (first.refers == "last" and self.text(first.end - 1) == "them")
        partitive = partitive or (self._is_bare_number(first) and first.end >= len(self.words))
        if not partitive or first.amount.kind != "some" or not first.amount.number or first.amount.of:
            return None
        items = self.items(place)
        end = items[-1].end
        plain = all(i.phrase.amount.kind == "some" and i.phrase.amount.number and not i.is_room for i in items)
        if not plain or self.text(end) in KEPT_AS_IT_IS or self.text(end) in STATE_WORDS:
            return None
        if first.refers != "last" and self._framed(self._shared_goal(items, items[0]))[0] == Place():
            return None
        quote = self.quote(at, end)
        return [self._exactly(items, item, quote) for item in items], end

    def _exactly(self, items: list[Item], item: Item, quote: str) -> Statement:
        goal, each = self._framed(self._shared_goal(items, item))
        goal = Place(rooms=Rooms(same=True)) if goal == Place() else goal
        things: Things = msgspec.structs.replace(
            item.phrase.things(), amount=Amount(kind="exactly", number=item.phrase.amount.number), definite=False
        )
        return Ensure(things=things, place=goal, each=each, quote=quote)

"""Rooms and furniture that are given things."""

from mansion_editing.instructions.clauses.items import Item, NotUnderstood
from mansion_editing.instructions.clauses.outcomes import Outcomes
from mansion_editing.instructions.phrases.places import ReadPlace, read_place
from mansion_editing.instructions.statements import Statement

__all__ = ["Giving"]


class Giving(Outcomes):
    """Reads ``equip the office with two desks``."""

    def _equip(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``equip the office with two desks``, ``fill the basket with apples``."""
        where = self.item(place)
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
        return [self._given(item, goal, quote, each=each) for item in items], end

    def _skip_storey(self, at: int) -> tuple[tuple[ReadPlace, ...], int]:
        """Read a storey that only tells where the thing before a colon is (``: 2nd floor, ...``)."""
        read = read_place(self.words, at, self.lexicon, self.floors)
        if read is None or read.place.rooms is None or read.place.rooms.words or self.text(read.end) != ",":
            return (), at
        return (read,), read.end + 1

"""Areas of rooms and numbers of things that rise or fall."""

import msgspec

from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.outcomes import Outcomes
from mansion_editing.instructions.phrases.places import with_place
from mansion_editing.instructions.phrases.word_sets import BEFORE_AREAS
from mansion_editing.instructions.statements import Add, Amount, Ensure, Place, Remove, Reshape, Statement

__all__ = ["Sizes"]


class Sizes(Outcomes):
    """Reads ``enlarge the lobby by 10 m2`` and ``reduce the chairs to two``."""

    def _amount_of_area(self, at: int) -> tuple[float, bool, int] | None:
        """Read ``by 10 m2`` or ``to 40 m2``."""
        place = at
        while self.text(place) in BEFORE_AREAS:
            place += 1
        absolute = any(w.text == "to" for w in self.words[at:place])
        if place + 1 < len(self.words) and self.words[place].kind == "number" and self.words[place + 1].text == "m2":
            return self.words[place].value, absolute, place + 2
        number = place < len(self.words) and self.words[place].kind == "number"
        if number and self.text(place + 1) in ("square", "sqm", "sq"):
            return self.words[place].value, absolute, place + 2 + (self.text(place + 2) in ("metre", "meter", "m"))
        return None

    def _enlarge(self, at: int, place: int) -> tuple[list[Statement], int]:
        return self._resized(at, place, 1.0)

    def _shrink(self, at: int, place: int) -> tuple[list[Statement], int]:
        return self._resized(at, place, -1.0)

    def _resized(self, at: int, place: int, sign: float) -> tuple[list[Statement], int]:
        """Read ``enlarge the cafeteria by 10 m2``, and ``reduce the chairs in the lobby to two``."""
        start = place
        if self.text(place) == "the" and self.text(place + 1) in ("number", "amount", "count", "area", "size"):
            place += 3
        item = self.item(place)
        if item is None:
            raise NotUnderstood(at, self.boundary(at))
        cut = next((p for p in item.places if self.words[p.start].text in ("to", "by", "down", "up")), None)
        end = cut.start if cut is not None else item.end
        end += self.text(end) in ("down", "up")
        kept = Item(item.phrase, tuple(p for p in item.places if p.end <= end), end)
        area = self._amount_of_area(end)
        it = item.phrase.refers == "last" and not item.phrase.noun.words and not item.phrase.plural
        room = (it or item.phrase.noun.kind in ("room", "both")) and self.text(start + 1) not in (
            "number",
            "amount",
            "count",
        )
        if area is not None and room:
            value = area[0] if area[1] else sign * area[0]
            quote = self.quote(at, area[2])
            return [Reshape(what="area", rooms=kept.rooms(), area=value, absolute=area[1], quote=quote)], area[2]
        if self.text(end) in ("to", "by") and end + 1 < len(self.words):
            last = end + 1 + (self.text(end + 1) in ("only", "just", "exactly"))
            if self.words[last].kind == "number":
                return self._numbered(at, kept, int(self.words[last].value), last + 1, self.text(end), sign)
        raise NotUnderstood(at, self.boundary(at))

    def _numbered(
        self, at: int, item: Item, number: int, end: int, preposition: str, sign: float
    ) -> tuple[list[Statement], int]:
        """Return the statement of a number of things that rises or falls, by or to a number."""
        end += self.text(end) in ("piece", "unit")
        quote = self.quote(at, end)
        place, each = self._framed(joined_places(list(item.places)))
        things = item.phrase.things()
        if preposition == "to":
            counted = msgspec.structs.replace(things, amount=Amount(kind="exactly", number=number), definite=False)
            return [Ensure(things=counted, place=place, each=each, quote=quote)], end
        if sign > 0:
            more = msgspec.structs.replace(things, amount=Amount(kind="more", number=number), definite=False)
            return [Add(things=more, place=place, each=each, quote=quote)], end
        fewer = msgspec.structs.replace(things, amount=Amount(number=number))
        return [Remove(things=with_place(fewer, place) if place != Place() else fewer, quote=quote)], end

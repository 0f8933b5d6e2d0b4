"""Things and rooms that become other ones."""

from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import Item, NotUnderstood
from mansion_editing.instructions.clauses.moving import Moving
from mansion_editing.instructions.clauses.sizes import Sizes
from mansion_editing.instructions.clauses.wishes import Wishes
from mansion_editing.instructions.phrases.word_sets import PROPERTIES
from mansion_editing.instructions.statements import Add, Amount, Ensure, Furnish, Mention, Reshape, Statement

__all__ = ["Changing"]

_SLIGHTLY: Final = frozenset("a little bit tad slightly somewhat touch".split())
_LARGER: Final = frozenset("larger bigger wider roomier".split())
_SMALLER: Final = frozenset("smaller narrower".split())
_A_LITTLE: Final = 0.1
"""Share of its area by which a room becomes a little larger or smaller."""


class Changing(Wishes, Moving, Sizes):
    """Reads ``change`` and ``make``."""

    def _change(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``change the colour of the sofa to red``, ``change the sofa for an armchair``."""
        start = place
        if self.text(place) == "the" and self.text(place + 1) in PROPERTIES:
            what = self.text(place + 1)
            place += 2 + (self.text(place + 2) == "of")
            if what == "name":
                return self._rename(at, place)
        by = next((k for k in range(place + 1, len(self.words)) if self._begins_new_by(k)), None)
        if by is not None:
            return self._replaced_by(at, place, by)
        found = self.items_or_surfaces(place)
        if found is not None:
            subject, end = found
            if isinstance(subject, list):
                goals = [p for p in subject[-1].places if self.words[p.start].text in ("to", "into", "for")]
                end = goals[0].start if goals else end
                subject = [Item(i.phrase, tuple(p for p in i.places if p.end <= end), end) for i in subject]
            if self.text(end) in ("to", "into", "for"):
                colour = self.colour_at(end + 1)
                if (colour is not None and self.phrase(end + 1) is None) or (
                    colour is not None and colour[2] >= len(self.words)
                ):
                    return self._painted(subject, colour[0], colour[1], self.quote(at, colour[2])), colour[2]
                if colour is not None and self.text(colour[2]) in (",", "and", "please", "."):
                    return self._painted(subject, colour[0], colour[1], self.quote(at, colour[2])), colour[2]
                if isinstance(subject, list):
                    new = self.phrase(end + 1)
                    if new is not None and subject[0].phrase.noun.kind == "room":
                        return self._furnish(at, place)
                    return self._replaced_by(at, start, end)
        joint = next((k for k in range(place, len(self.words)) if self.text(k) in ("with", "for", "to", "into")), None)
        if joint is None:
            raise NotUnderstood(at, self.boundary(at))
        return self._replaced_by(at, place, joint)

    def _begins_new_by(self, at: int) -> bool:
        """Whether ``by a sofa`` stands at a place: what something is changed by is new."""
        new = self.phrase(at + 1) if self.text(at) == "by" else None
        article = self.text(at + 1) in ("a", "an", "another", "one")
        return new is not None and article and new.noun.kind == "object" and not new.noun.unknown

    def _a_little(self, item: Item, at: int, start: int) -> tuple[list[Statement], int] | None:
        """Read ``a little larger``, ``slightly smaller`` of a room: by a tenth of what it is."""
        end = at
        while self.text(end) in _SLIGHTLY:
            end += 1
        said = self.text(end)
        room = item.is_room and not item.rooms().every
        if end == at or not room or said not in _LARGER | _SMALLER or self.text(end + 1) in ("by", "than"):
            return None
        share = _A_LITTLE if said in _LARGER else -_A_LITTLE
        return [Reshape(what="area", rooms=item.rooms(), share=share, quote=self.quote(start, end + 1))], end + 1

    def _make(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``make the cafeteria 10 m2 larger``, ``make the sofa red``, ``make sure``, ``make it two``."""
        if self.text(place) in ("it", "this") and self.text(place + 1) in ("look", "so", "happen", "seem"):
            end = self.boundary(place)
            return [Mention(quote=self.quote(at, end))], end
        surface = self.surface(place)
        if surface is not None:
            colour = self.colour_at(surface[1])
            if colour is not None:
                return self._painted(surface[0], colour[0], colour[1], self.quote(at, colour[2])), colour[2]
        counted = place + 1 < len(self.words) and self.words[place + 1].kind == "number"
        if self.text(place) == "it" and counted and self._amount_of_area(place + 1) is None:
            said, stop = self._wanted(at, place + 1)
            if (self.text(stop), self.text(stop + 1)) == ("instead", "of") and self.words[stop + 2 :]:
                stop += 3 if self.words[stop + 2].kind == "number" else 0
            return [_in_number(statement) for statement in said], stop  # "make it six chairs"
        room = self.item(place, places=False)
        if room is not None and room.is_room and "into" in [word.text for word in self.words[room.end : room.end + 6]]:
            return self._furnish(at, place)
        item = self.item(place)
        if item is None:
            raise NotUnderstood(at, self.boundary(at))
        end = item.end
        resized = self._made_larger(item, at) or self._a_little(item, end, at)
        if resized is not None:
            return resized
        colour = self.colour_at(end)
        if colour is not None:
            return self._painted([item], colour[0], colour[1], self.quote(at, colour[2])), colour[2]
        found = self._predicate(item, end, at)
        if found is not None and all(isinstance(statement, Mention) for statement in found[0]):
            raise NotUnderstood(at, self.boundary(at))  # "make the hall feel cosier" is a wish, not an opinion
        if found is not None:
            return found
        it = item.phrase.refers == "last" and not item.phrase.noun.words and not item.phrase.plural
        kind = self.kind_of_room(end) if it or item.phrase.noun.kind in ("room", "both") else None
        if kind is not None and not (it and self.lexicon.is_object(tuple(kind[0].split()))):
            return [Furnish(rooms=item.rooms(), kind=kind[0], quote=self.quote(at, kind[1]))], kind[1]
        raise NotUnderstood(at, self.boundary(at))

    def _made_larger(self, item: Item, at: int) -> tuple[list[Statement], int] | None:
        """Read ``10 m2 larger``, ``smaller by 10 m2`` of a room.

        Raises
        ------
        NotUnderstood
            Where it is not told by how much.
        """
        end = item.end
        area = self._amount_of_area(end)
        if area is not None:
            value, absolute, stop = area
            sign = 0.0
            if self.text(stop) in ("larger", "bigger", "wider", "more", "greater"):
                sign, stop = 1.0, stop + 1
            elif self.text(stop) in ("smaller", "less", "narrower"):
                sign, stop = -1.0, stop + 1
            elif self.text(stop) in ("large", "big"):
                stop += 1
            rooms = item.rooms()
            quote = self.quote(at, stop)
            return [
                Reshape(
                    what="area", rooms=rooms, area=value * (sign or 1.0), absolute=absolute or not sign, quote=quote
                )
            ], stop
        if self.text(end) in ("larger", "bigger", "smaller", "wider"):
            sign = -1.0 if self.text(end) == "smaller" else 1.0
            area = self._amount_of_area(end + 1)
            if area is not None:
                quote = self.quote(at, area[2])
                change = Reshape(what="area", rooms=item.rooms(), area=sign * area[0], absolute=area[1], quote=quote)
                return [change], area[2]
            raise NotUnderstood(at, self.boundary(at))
        return None


def _in_number(statement: Statement) -> Statement:
    """Return things of a kind that are named with their number as so many in all."""
    if not isinstance(statement, Add) or not statement.things.noun or statement.things.amount.kind != "some":
        return statement
    amount = Amount(kind="exactly", number=statement.things.amount.number)
    things = msgspec.structs.replace(statement.things, amount=amount)
    return Ensure(things=things, place=statement.place, each=statement.each, quote=statement.quote)

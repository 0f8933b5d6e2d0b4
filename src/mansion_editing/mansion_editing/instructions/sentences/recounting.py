"""Numbers that are told and then set: ``The table has one fork and one glass. Make it four forks and four glasses``."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.places import with_place
from mansion_editing.instructions.phrases.words import COURTESIES, Word, text_at
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.statements import Add, Amount, Ensure, Mention, Place, Things

__all__ = ["Recounting"]

_HAVING: Final = frozenset("has have holds contains".split())
_ONLY: Final = frozenset("only just already currently now still merely".split())
_JOINTS: Final = frozenset(["and", "but", ","])
_IT: Final = frozenset("it that them those these".split())
_BEFORE: Final = COURTESIES | _JOINTS | frozenset("so then - : ; .".split())
_LONGEST: Final = 12
"""Words of what has something, with its places."""


class Recounting(Progress):
    """Reads how many there are, and how many there shall be."""

    def _tells_numbers(self, reader: ClauseReader, at: int) -> int:
        """Read ``the table has four plates but only one fork`` where ``make it four forks`` follows; return its end."""
        words = reader.words
        stop = next((k for k in range(at + 1, len(words)) if self._makes_it(words, k)), len(words))
        end = stop
        while end > at and words[end - 1].text in _BEFORE:
            end -= 1
        if stop == len(words) and not self._makes_it(self.later, self._past_joints(self.later)):
            return 0
        told = _held_by(reader.until(end), at) or _listed_there(reader.until(end), at)
        if told is None:
            return 0
        self.counted = tuple(told)
        self.statements.append(Mention(quote=self._quote(words, at, end)))
        return stop

    def _past_joints(self, words: Sequence[Word]) -> int:
        return next((k for k, word in enumerate(words) if word.text not in _BEFORE), len(words))

    def _makes_it(self, words: Sequence[Word], at: int) -> bool:
        """Whether ``make it four forks`` begins at a place, and not ``make it four``."""
        number = words[at + 2] if at + 3 < len(words) else None
        named = number is not None and number.kind == "number" and self.lexicon.is_object((text_at(words, at + 3),))
        return named and text_at(words, at) == "make" and text_at(words, at + 1) in _IT

    def _recounted(self, reader: ClauseReader, words: Sequence[Word], at: int) -> int:
        """Read ``make it four forks and four glasses`` of what was told or asked for before; return its end, else 0."""
        if not self._makes_it(words, at):
            return 0
        try:
            items = reader.items(at + 2)
        except NotUnderstood:
            return 0
        end = items[-1].end
        quote = self._quote(words, at, end)
        told = {things.noun: things for things in self.counted}
        meant = [told.get(item.phrase.things().noun) for item in items]
        last = self.statements[-1] if self.statements else None
        plain = all(_is_number(item) for item in items)
        if plain and len(items) == 1 and not told and isinstance(last, Add | Ensure):
            new = items[0].phrase.things()
            if last.things.noun == new.noun and last.things.amount.kind in ("some", "exactly") and not last.each:
                things = msgspec.structs.replace(last.things, amount=new.amount, plural=new.plural)
                self.statements[-1] = msgspec.structs.replace(last, things=things)
                self.statements.append(Mention(quote=quote))
                return end
        if not plain or any(things is None for things in meant):
            self.unknown.append(quote)  # it is not told where so many shall be
            return end
        for item, there in zip(items, meant, strict=True):
            amount = Amount(kind="exactly", number=item.phrase.amount.number)
            whole = msgspec.structs.replace(item.phrase.things(), amount=amount)
            place = Place() if there is None or there.place is None else there.place
            self.statements.append(Ensure(things=whole, place=place, quote=quote))
        self.counted = ()
        return end


def _is_number(item: Item) -> bool:
    """Whether an item is only a number of things: ``four forks``."""
    phrase = item.phrase
    plain = not (item.places or item.is_room or phrase.definite or phrase.refers or phrase.noun.unknown)
    return plain and phrase.amount.kind == "some" and phrase.amount.number > 0 and phrase.noun.kind == "object"


def _held_by(reader: ClauseReader, at: int) -> list[Things] | None:
    """Read ``the table in the hall has four plates but only one fork`` to its end."""
    words = reader.words
    verb = next((k for k in range(at + 1, min(at + _LONGEST, len(words))) if words[k].raw in _HAVING), 0)
    holder = reader.until(verb).item(at) if verb else None
    if holder is None or holder.end != verb or holder.phrase.refers or holder.phrase.plural:
        return None
    if not (holder.is_room or holder.phrase.definite):
        return None
    place = Place(rooms=holder.rooms()) if holder.is_room else _on(holder.things())
    items = _counted(reader, verb + 1)
    return None if items is None else [with_place(item.phrase.things(), place) for item in items]


def _on(holder: Things) -> Place:
    """Return the place on furniture, which is in the room that its words tell."""
    where = holder.place
    if where is None or where.anchor is not None or where.rooms is None:
        return Place(relation="on", anchor=holder)
    return Place(relation="on", anchor=msgspec.structs.replace(holder, place=None), rooms=where.rooms)


def _listed_there(reader: ClauseReader, at: int) -> list[Things] | None:
    """Read ``there is one fork and one glass on the table`` to its end."""
    if reader.text(at) != "there" or reader.text(at + 1) not in ("is", "are"):
        return None
    items = _counted(reader, at + 2, placed=True)
    if items is None or not items[-1].places:
        return None
    place, each = joined_places(list(items[-1].places))
    several = each or place.outside or any(read.source or read.goal for read in items[-1].places)
    return None if several else [with_place(item.phrase.things(), place) for item in items]


def _counted(reader: ClauseReader, at: int, *, placed: bool = False) -> list[Item] | None:
    """Read numbers of things up to the end of the words, the last of which may have a place; None for others."""
    found: list[Item] = []
    while True:
        while reader.text(at) in _ONLY | _JOINTS:
            at += 1
        item = reader.item(at, places=placed)
        if item is None or item.is_room or item.phrase.definite or item.phrase.refers or item.phrase.noun.unknown:
            return None
        if item.phrase.amount.kind not in ("some", "exactly") or item.phrase.noun.kind != "object":
            return None
        found.append(item)
        at = item.end
        if at >= len(reader.words):
            return found
        if reader.text(at) not in _JOINTS or item.places:
            return None

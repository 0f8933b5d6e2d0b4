"""Lists of things: ``two mugs and a bowl on the table``, and what one of a list tells of another."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.coordination import first_subject
from mansion_editing.instructions.clauses.items import Item, NotUnderstood, TwoReadings
from mansion_editing.instructions.clauses.placed_items import PlacedItems
from mansion_editing.instructions.phrases.lexicon import HYPERNYMS
from mansion_editing.instructions.phrases.noun_phrases import NounPhrase
from mansion_editing.instructions.phrases.places import SUPERLATIVES, ReadPlace, merged
from mansion_editing.instructions.phrases.words import DETERMINERS
from mansion_editing.instructions.statements import Amount, Place, Relation

__all__ = ["ListedItems"]

_HOLDING: Final = frozenset(["on", "in", "under"])
"""Relations to furniture that carries or covers things."""


_TAKING: Final = frozenset("remove take throw get move bring carry delete".split())


class ListedItems(PlacedItems):
    """Reads things joined by commas and conjunctions."""

    def items(self, at: int) -> list[Item]:
        """Read noun phrases joined by commas and conjunctions.

        Raises
        ------
        NotUnderstood
            Where there is no noun phrase, or where it is not told which of several go where.
        """
        return self._distributed(self._joined(at))

    def _distributed(self, items: list[Item]) -> list[Item]:
        """Return the shares of ``two lamps for the study, one on the desk and one on the shelf`` alone."""
        shares = items[1:]
        bare = [self.words[i.phrase.start].kind == "number" and i.phrase.end == i.phrase.start + 1 for i in shares]
        whole = items[0].phrase.amount.number
        if len(shares) < 2 or not all(bare) or sum(i.phrase.amount.number for i in shares) != whole:
            return items
        if items[0].phrase.definite:
            raise NotUnderstood(items[0].phrase.start, items[-1].end)
        rooms = tuple(p for p in items[0].places if p.place.anchor is None and p.place.rooms is not None)
        return [Item(i.phrase, (*i.places, *rooms), i.end) for i in shares]

    def _joined(self, at: int) -> list[Item]:
        found: list[Item] = []
        while True:
            item = self.item(at)
            if item is None:
                if found:
                    return found
                raise NotUnderstood(at, self.boundary(at))
            if found and not item.phrase.definite and any(p.place.former is not None for p in item.places):
                return found  # "remove the fridge, two plants in its place"
            placed = self._participle(item.phrase.end)
            new = placed is not None and placed[0] == "add" and not item.phrase.definite
            if found and (self._is_way(item.phrase) or new):
                return found
            if found and self.is_subject(item):
                return self._objects(found, item)
            if found and self._tells_number_of(found[-1], item):
                found[-1] = Item(replace(found[-1].phrase, amount=item.phrase.amount), found[-1].places, item.end)
                return found
            shares = self._shared_out(found[-1], item) if found else None
            if shares is not None:
                found[-1] = shares
                return found
            if found and self._tells_which(found[-1], item):
                found[-1] = Item(found[-1].phrase, (*found[-1].places, *item.places), item.end)
                after = self.conjunction(item.end)
                if not after or self.starts_clause(after):
                    return found
                at = after
                continue
            if found and self._tells_where_holder_is(found[-1], item):
                last = found[-1].places[-1]
                whole = replace(last, place=merged(last.place, item.goal()[0]), end=item.end)
                found[-1] = Item(found[-1].phrase, (*found[-1].places[:-1], whole), item.end)
                at = self.conjunction(item.end)
                if not at or self.starts_clause(at):
                    return found
                continue
            found.append(self._beside_it(self._as_before(self._named(item, found), found), found))
            after = self.conjunction(item.end)
            if not after or self.starts_clause(after) or self.text(after) in ("only", "just", "now"):
                return found
            at = after

    def _tells_number_of(self, before: Item, item: Item) -> bool:
        """Whether an item is the number of the one before: ``chairs in the hall, at least three of them``."""
        phrase, open_number = item.phrase, before.phrase.plural and not before.phrase.definite
        bare = phrase.refers == "last" and not phrase.noun.words and not item.places and phrase.amount.number > 1
        open_number = open_number and before.phrase.amount.kind == "some" and not before.phrase.amount.number
        counted = phrase.amount.kind in ("some", "at_least") and not phrase.amount.of
        ends = item.end >= len(self.words) or self.words[item.end].kind == "mark"
        return bare and open_number and counted and ends and self.text(phrase.start - 1) == ","

    def _tells_which(self, before: Item, item: Item) -> bool:
        """Whether an item only tells which one before it is meant: ``four tables, the ones nearest the bar``."""
        one = item.phrase.noun.words == ("one",) and item.phrase.definite and bool(item.places)
        apposed = self.text(item.phrase.start - 1) == "," and not any(p.source or p.goal for p in item.places)
        named = bool(before.phrase.noun.words) and before.phrase.noun.words != ("one",) and not before.is_room
        return one and apposed and named and before.phrase.plural == item.phrase.noun.plural

    def _shared_out(self, before: Item, item: Item) -> Item | None:
        """Read ``two plants in the offices, one each``: one in each of the two; None for others.

        Raises
        ------
        NotUnderstood
            Where the numbers do not fit each other.
        """
        phrase, whole = item.phrase, before.phrase.amount
        bare = phrase.refers == "last" and not phrase.noun.words and not item.places and phrase.amount.kind == "some"
        if not bare or self.text(item.end) != "each" or self.text(phrase.start - 1) != "," or not before.places:
            return None
        share = phrase.amount.number
        at = next((k for k, read in enumerate(before.places) if _names_several(read.place)), -1)
        if at < 0 or not share or whole.kind != "some" or whole.number % share:
            raise NotUnderstood(before.phrase.start, item.end + 1)
        there = before.places[at]
        counted = replace(there, place=_so_many(there.place, whole.number // share), each=True)
        places = (*before.places[:at], counted, *before.places[at + 1 :])
        return Item(replace(before.phrase, amount=phrase.amount), places, item.end + 1)

    def _tells_where_holder_is(self, before: Item, item: Item) -> bool:
        """Whether an item is what the one before goes into, with its place: ``keys in a bowl, bowl on the shelf``."""
        holder = before.places[-1].place.anchor if before.places else None
        again = self._is_bare(item.phrase) or (item.phrase.definite and not item.phrase.refers)
        if holder is None or holder.definite or holder.place is not None or not item.places or not again:
            return False
        return holder.noun == " ".join(item.phrase.noun.words) and not any(p.source for p in item.places)

    def is_subject(self, item: Item) -> bool:
        """Whether a clause follows of which an item is the subject: ``the others as they are`` is one too."""
        as_it_is = self.text(item.end) == "as" and self.text(item.end + 1) in ("it", "they")
        return as_it_is or self.predicate_follows(item.end) or self._stays_after(item.end)

    def _stays_after(self, at: int) -> bool:
        """Whether the words at a place say that what is before them stays as it is."""
        return False

    def _objects(self, found: list[Item], subject: Item) -> list[Item]:
        """Return those of a list that are no subjects of the clause after it."""
        first = first_subject(self.words, [*found, subject])
        if first is None:
            raise TwoReadings(found[0].phrase.start, self.boundary(subject.end))
        return found[:first]

    def subjects(self, at: int) -> list[Item]:
        """Read the list of things that a clause begins with; empty where no clause follows it."""
        found: list[Item] = []
        while (item := self.item(at)) is not None:
            found.append(item)
            if self.is_subject(item):
                return found
            at = self.conjunction(item.end)
            if not at or self.starts_clause(at):
                break
        return []

    def _beside_it(self, item: Item, before: Sequence[Item]) -> Item:
        """Put the thing before for ``it``: the table or anything on it."""
        last = before[-1] if before else None
        if last is not None and self._belongs_to(item, last):
            relation: Relation = "around" if self.lexicon.stands(item.phrase.noun.words) else "on"
            owner = Item(last.phrase, tuple(p for p in last.places if not p.goal), last.end).things()
            there = ReadPlace(Place(relation=relation, anchor=owner), item.phrase.end, item.phrase.end)
            return Item(item.phrase, (replace(there, relative=True), *item.places), item.end)
        if last is None or not item.places:
            return item
        if not last.phrase.definite:
            return self._at_their_holder(item, last)
        anchor = item.places[0].place.anchor
        if anchor is None or anchor.refers != "last" or anchor.noun:
            return item
        if self.text(item.places[0].start) == "from" or (last.phrase.noun.plural and not anchor.plural):
            return item  # "all desks and all chairs from it"
        words = last.phrase.noun.words
        general = " ".join(words) in HYPERNYMS and not self.lexicon.stands(words)
        holds = not (general or self.lexicon.lies_beside_others(words))
        if (item.places[0].source or item.places[0].place.relation in _HOLDING) and not holds:
            return item  # "the laptop and the pen on it" are on what was named before
        place = msgspec.structs.replace(item.places[0].place, anchor=last.things())
        return Item(item.phrase, (replace(item.places[0], place=place), *item.places[1:]), item.end)

    def _belongs_to(self, item: Item, before: Item) -> bool:
        """Whether a thing is that of the furniture named before it: ``the table and its four chairs``."""
        several = before.phrase.noun.plural and before.phrase.amount.number != 1
        own = self.words[item.phrase.start].raw == ("their" if several else "its")
        certain = before.phrase.definite or any(p.place.relation in SUPERLATIVES for p in before.places)
        certain = certain or any(word.text in _TAKING for word in self.words[: before.phrase.start])
        named = item.phrase.noun.kind == "object" and before.phrase.noun.kind == "object" and certain
        return own and named and not before.is_room and self.lexicon.stands(before.phrase.noun.words)

    def _at_their_holder(self, item: Item, before: Item) -> Item:
        """Put what several new things are at for ``it``: ``two chairs at the table and a candle on it``."""
        it, (there, _) = item.places[0].place.anchor, before.goal()
        told = it is not None and it.refers == "last" and not it.noun and not it.plural
        holder = there.anchor
        if not told or not before.phrase.plural or holder is None or holder.plural or not holder.definite:
            return item
        centre = self.text(item.places[0].start + 2) in ("middle", "centre", "center")
        relation: Relation = "on" if centre else item.places[0].place.relation
        place = msgspec.structs.replace(item.places[0].place, relation=relation, anchor=holder, rooms=there.rooms)
        return Item(item.phrase, (replace(item.places[0], place=place), *item.places[1:]), item.end)

    def _as_before(self, item: Item, before: Sequence[Item]) -> Item:
        """Give a bare noun the quantifier before it: any bottle of wine or beer."""
        amount = item.phrase.amount
        plain = amount.kind == "some" and amount.number > 0 and not item.phrase.definite and not item.phrase.refers
        if before and before[-1].phrase.amount.kind == "exactly" and plain:
            exactly = Amount(kind="exactly", number=amount.number)  # "exactly four plates, four forks and a jug"
            return Item(replace(item.phrase, amount=exactly), item.places, item.end)
        bare = item.phrase.end - item.phrase.start == len(item.phrase.noun.words) and not item.phrase.definite
        if not before or not bare or before[-1].phrase.amount.kind not in ("all", "none") or amount.kind != "some":
            return item
        first = before[-1].phrase
        phrase = replace(item.phrase, amount=first.amount, definite=first.definite)
        return Item(phrase, item.places, item.end)

    def _named(self, item: Item, before: Sequence[Item]) -> Item:
        """Put the noun that came before for ``one``: two red mugs and a blue one."""
        if before and self._is_bare_number(item.phrase):
            return self._of_the_same_kind(item, before[-1])
        last = next((i.phrase.noun for i in reversed(before) if i.phrase.noun.kind != "anything"), self.last_noun)
        if item.phrase.noun.words[-1:] != ("one",) or last is None:
            if item.phrase.noun.kind == "object":
                self.last_noun = item.phrase.noun
            return item
        if not last.words:  # "replace it by a bigger one"
            raise NotUnderstood(item.phrase.start, item.end)
        told = item.phrase.noun.words[:-1]
        words = (*told, last.words[-1]) if told else last.words
        if told and not self.lexicon.is_object(words):
            raise NotUnderstood(item.phrase.start, item.end)
        noun = replace(item.phrase.noun, words=words, kind=last.kind)
        return Item(replace(item.phrase, noun=noun), item.places, item.end)

    def _is_bare_number(self, phrase: NounPhrase) -> bool:
        """Whether a phrase is only a number of what was named before: ``one``, ``two more``; not ``two of them``."""
        counted = phrase.amount.number > 0 and phrase.amount.kind in ("some", "more")
        pronoun = self.text(phrase.end - 1) in ("it", "them", "they", "those", "these", "both")
        return phrase.refers == "last" and not phrase.noun.words and counted and not pronoun

    def _of_the_same_kind(self, item: Item, before: Item) -> Item:
        """Return so many others of a kind, from where those before come: ``two chairs from the hall ... and one``."""
        noun = replace(before.phrase.noun, plural=item.phrase.amount.number > 1, ordinal=0, size="", number="")
        phrase = replace(item.phrase, noun=noun, refers="", definite=False)
        whence = () if any(p.source for p in item.places) else tuple(p for p in before.places if p.source)
        return Item(phrase, (*whence, *item.places), item.end)

    def boundary(self, at: int) -> int:
        """Return the end of the words that cannot be read, at the next comma or conjunction with a clause."""
        place = at + 1
        while place < len(self.words):
            word = self.words[place]
            if word.kind == "mark" and word.text in (",", ".", ";", "\n", "(", ")", ":", "!"):
                break
            joint = word.text in ("and", "but", "then", "so") and self.text(place + 1) != "that"
            if joint and self.begins_request(place + 1):
                break
            place += 1
        return place

    def begins_request(self, at: int) -> bool:
        """Whether a clause begins with a verb that asks for something, or with things of which something is said."""
        return self.starts_clause(at) or any(self._is_known_thing(item) for item in self.subjects(at))

    def _is_known_thing(self, item: Item) -> bool:
        return item.phrase.definite and bool(item.phrase.noun.words) and item.phrase.noun.kind == "object"

    def _is_bare(self, phrase: NounPhrase) -> bool:
        """Whether a thing is named without an article, an owner or a number, as in notes: ``monitor stays``."""
        first = self.words[phrase.start]
        counted = first.kind == "number" or first.text in DETERMINERS
        plain = phrase.amount.kind == "some" and phrase.amount.number <= 1 and not phrase.definite
        return plain and not counted and not phrase.refers and phrase.noun.kind == "object"

    def _is_way(self, phrase: NounPhrase) -> bool:
        return bool(phrase.noun.words) and self.lexicon.is_way(phrase.noun.words[-1])


def _names_several(place: Place) -> bool:
    """Whether a place names several things or rooms without their number: ``on the desks``, ``in the offices``."""
    if place.anchor is not None:
        return place.anchor.plural and not place.anchor.amount.number
    return place.rooms is not None and place.rooms.every and not place.rooms.number


def _so_many(place: Place, number: int) -> Place:
    """Return several things or rooms with their number, where it is told."""
    if not number:
        return place
    if place.anchor is not None:
        return msgspec.structs.replace(
            place, anchor=msgspec.structs.replace(place.anchor, amount=Amount(number=number))
        )
    return (
        place
        if place.rooms is None
        else msgspec.structs.replace(place, rooms=msgspec.structs.replace(place.rooms, number=number))
    )

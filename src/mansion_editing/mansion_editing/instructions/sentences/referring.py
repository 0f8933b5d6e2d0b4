"""What ``it``, ``there`` and ``in there`` stand for, from the clauses before, and what ``clear it`` then asks for."""

from typing import Any, Final

import msgspec

from mansion_editing.instructions.phrases.places import with_place
from mansion_editing.instructions.phrases.word_sets import MASSES
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.sentences.refinement import counts_those_brought, held_there, so_many
from mansion_editing.instructions.statements import (
    Add,
    Amount,
    Clear,
    Ensure,
    Finish,
    Furnish,
    Mention,
    Move,
    Paint,
    Place,
    Remove,
    Rename,
    Rooms,
    SetState,
    Statement,
    Things,
    Turn,
)

__all__ = ["Referring"]

_PORTIONS: Final = {"roll": frozenset("paper towel foil tape".split()), "bar": frozenset(["soap", "chocolate"])}
"""Pieces by which things are counted, and the last words of the names of those things."""


class Referring(Progress):
    """Puts what was mentioned for the words that refer to it."""

    def _referred(self, statement: Statement) -> Statement:
        """Return a statement about what its pronouns stand for."""
        missing = self.topic is not None and self.topic.amount.kind == "more"
        present = isinstance(statement, Remove | SetState | Paint | Turn)
        if missing and present and _is_bare_it(getattr(statement, "things", None), many=True):
            self.unknown.append(statement.quote)  # what was told to be missing is not there
            return statement
        statement = self._switched_off(self._in_each_named(statement))
        told = self._about_topic(self._about_room(self._about_holder(self._put_there(self._cleared(statement)))))
        bare = isinstance(told, Ensure) and _is_bare_it(told.things, many=True)
        counting = bool(self.statements) and counts_those_brought(told, self.statements[-1])
        if isinstance(told, Ensure) and bare and told.things.amount.kind == "at_most" and not counting:
            if self.statements and isinstance(self.statements[-1], Add | Ensure):
                self.unknown.append(told.quote)  # "a pillow on each, at most two": brought besides, or in all
            return Mention(quote=told.quote)  # "eight is enough" of what nothing tells
        return told

    def _switched_off(self, statement: Statement) -> Statement:
        """Return ``off with it`` as switching off, where that is what switches."""
        if not isinstance(statement, Remove) or not statement.quote.lower().startswith("off with"):
            return statement
        meant = self.topic if statement.things.refers and self.topic is not None else statement.things
        if not meant.noun or not self.lexicon.takes_state(tuple(meant.noun.split()), "on"):
            return statement
        return SetState(things=statement.things, state="on", value=False, quote=statement.quote)

    def _in_each_named(self, statement: Statement) -> Statement:
        """Return ``in each of them`` as in each of the rooms that were named before."""
        place = getattr(statement, "place", None)
        if not isinstance(place, Place) or place.rooms != Rooms(same=True, every=True) or place.anchor is not None:
            return statement
        places = (p for s in reversed(self.statements) for p in (getattr(s, "place", None), _place_of_things(s)))
        told = (p.rooms for p in places if isinstance(p, Place) and p.rooms is not None)
        rooms = next((rooms for rooms in told if rooms.every and rooms.words), None)
        if rooms is None and self.topic is not None and self.topic.place is not None:
            rooms = self.topic.place.rooms
        if rooms is None or not rooms.every:
            return statement
        return msgspec.structs.replace(statement, place=msgspec.structs.replace(place, rooms=rooms))

    def _cleared(self, statement: Statement) -> Statement:
        """Return ``clear it`` of furniture as emptying it, and of what is loose as taking it away."""
        if not isinstance(statement, Clear) or not _is_bare_it(statement.place.anchor, many=True):
            return statement
        if statement.quote.lower().startswith("empty"):
            return statement  # a bin, a box: what it holds goes
        last = next((s for s in reversed(self.statements) if not isinstance(s, Mention)), None)
        meant = self.topic if self.topic is not None else getattr(last, "things", None)
        noun = tuple(meant.noun.split()) if isinstance(meant, Things) else ()
        if isinstance(meant, Things) and not noun and meant.place is not None and not meant.refers:
            place = msgspec.structs.replace(meant.place, relation=statement.place.relation)
            return msgspec.structs.replace(statement, place=place)  # a mess, or whatever was left there
        holds = (
            bool(noun) and self.lexicon.carries(noun) and (self.lexicon.stands(noun) or not statement.place.relation)
        )
        if holds or statement.spare or statement.place.anchor is None:
            return statement
        return Remove(things=statement.place.anchor, quote=statement.quote)

    def _put_there(self, statement: Statement) -> Statement:
        """Return what is loose as put on or in what things just came off or went to: ``and put a mug there``."""
        last = self.statements[-1] if self.statements else None
        there = isinstance(statement, Add | Ensure | Move) and statement.place == Place(rooms=Rooms(same=True))
        if not there or self.topic is not None or not isinstance(statement, Add | Ensure | Move):
            return statement
        at = last.things.place if isinstance(last, Remove) else last.place if isinstance(last, Add | Move) else None
        holder = None if at is None else at.anchor
        noun = () if holder is None else tuple(holder.noun.split())
        loose = bool(statement.things.noun) and not self.lexicon.stands(tuple(statement.things.noun.split()))
        if at is None or at.relation not in ("on", "in", "") or not (loose and noun and self.lexicon.carries(noun)):
            return statement
        place = Place(relation=at.relation or "on", anchor=holder, rooms=at.rooms)
        return msgspec.structs.replace(statement, place=place)

    def _about_holder(self, statement: Statement) -> Statement:
        """Put the furniture that was mentioned last for ``in there``, where it holds things."""
        last = next((s for s in reversed(self.statements) if not isinstance(s, Mention)), None)
        left = self._where_that_was(statement, last)
        if left is not None:
            return left
        holder = self.topic if self.topic is not None else _mentioned_by(last)
        thing = getattr(statement, "things", None)
        if holder is None or not holder.noun or holder.refers or not isinstance(thing, Things):
            return statement
        if isinstance(statement, Add | Ensure | Move) and self.lexicon.stands(tuple(thing.noun.split())):
            return statement
        if not self.lexicon.carries(tuple(holder.noun.split())):
            return statement
        told = self.statements[-1] if self.statements else None
        there = getattr(statement, "place", None) == Place(rooms=Rooms(same=True)) and bool(thing.noun)
        if there and isinstance(told, Mention) and holder is self.topic and told.quote.lower().startswith("there"):
            self.unknown.append(statement.quote)  # on it, in it or only in its room
            return statement
        held: Statement = held_there(statement, msgspec.structs.replace(holder, definite=True))
        return held

    def _where_that_was(self, statement: Statement, last: Statement | None) -> Statement | None:
        """Return ``put a bowl there`` after a small thing was removed as put on what that lay on."""
        there = isinstance(statement, Add | Ensure) and statement.place == Place(rooms=Rooms(same=True))
        gone = last.things.noun if isinstance(last, Remove) and "there" in statement.quote.lower().split() else ""
        if not isinstance(statement, Add | Ensure) or not there or not gone or self.topic is not None:
            return None
        if any(self.lexicon.stands(tuple(noun.split())) for noun in (gone, statement.things.noun)):
            return None
        on_it = Place(relation="on", anchor=Things(refers="last", definite=True, amount=Amount(number=0)))
        return msgspec.structs.replace(statement, place=on_it)

    def _about_room(self, statement: Statement) -> Statement:
        """Put the room that was renamed, painted or furnished just before for ``it``."""
        last = next((s for s in reversed(self.statements) if not isinstance(s, Mention)), None)
        place = getattr(statement, "place", None)
        told = self.statements[-1] if self.statements else None
        needed = isinstance(statement, Add | Ensure) and isinstance(place, Place) and not place.spot
        needed = needed and place is not None and _is_bare_it(place.anchor) and self.topic is None
        if needed and isinstance(told, Mention) and told.rooms is not None:
            return msgspec.structs.replace(statement, place=Place(rooms=told.rooms))
        if not isinstance(last, Rename | Finish | Furnish) or self.topic is not None:
            return statement
        things = getattr(statement, "things", None)
        if isinstance(things, Things) and things.place is not None and _is_at_it(things.place):
            inside = Place(rooms=Rooms(same=True))
            return msgspec.structs.replace(statement, things=msgspec.structs.replace(things, place=inside))
        if not isinstance(place, Place) or place.relation not in ("in", "on") or not _is_bare_it(place.anchor):
            return statement
        return msgspec.structs.replace(statement, place=Place(rooms=Rooms(same=True), spot=place.spot))

    def _about_topic(self, statement: Statement) -> Statement:
        """Put what the clause before was about for ``it``."""
        if self.topic is None:
            return statement
        topic = self.topic
        rooms = topic.place.rooms if topic.place is not None else None
        if topic.amount.kind == "more" and rooms is not None and isinstance(statement, Add | Ensure | Move):
            statement = _of_what_lacks(statement, topic, rooms)
        numbered = (
            isinstance(statement, Add | Ensure) and statement.things.refers == "last" and not statement.things.noun
        )
        if isinstance(statement, Add | Ensure) and numbered and statement.things.amount.number:
            return so_many(statement, topic)
        moved = isinstance(statement, Move) and statement.place == Place() and statement.things.refers == "last"
        if isinstance(statement, Move) and moved and statement.things.amount.number > 1:
            return so_many(Ensure(things=statement.things, place=Place(), quote=statement.quote), topic)

        def named(value: Any) -> Any:
            there = isinstance(value, Add | Ensure | Move) and value.place == Place(rooms=Rooms(same=True))
            if there and topic.place is not None:
                value = msgspec.structs.replace(value, place=topic.place)
            if isinstance(value, Move) and value.things.refers == "last" and not topic.definite:
                where = named(value.place)
                counted = value.things.amount.kind == "some" and value.things.amount.number > 0
                if topic.amount.kind in ("all", "none") and counted and not value.things.definite:  # "no towels here"
                    several = value.things.amount.number > 1
                    new = msgspec.structs.replace(topic, amount=value.things.amount, plural=several, place=None)
                    return Add(things=new, place=where, quote=value.quote)
                if topic.amount.kind == "more":  # told to be missing
                    where = where if where.rooms or rooms is None else msgspec.structs.replace(where, rooms=rooms)
                    return Add(things=msgspec.structs.replace(topic, place=None), place=where, quote=value.quote)
                return msgspec.structs.replace(value, things=topic, place=where, or_new=not topic.amount.of)
            if isinstance(value, Rooms) and value.same and not value.words and rooms:
                return rooms
            held = topic.place is not None and topic.place.anchor is not None and topic.amount.number > 1
            if isinstance(value, Place) and held and value.relation in ("on", "in") and _is_bare_it(value.anchor):
                where = topic.place or Place()  # "four cups on the table, and the mug on it must go"
                return msgspec.structs.replace(value, anchor=where.anchor, rooms=value.rooms or where.rooms)
            if isinstance(value, Things) and value.refers == "last" and not value.noun:
                told_whole = topic.amount.kind == "all" and (topic.each or value.amount.number == topic.amount.number)
                if value.amount.number and value.amount.kind == "some" and not told_whole:
                    several = value.amount.number > 1
                    return msgspec.structs.replace(topic, amount=value.amount, plural=several, definite=False)
                if value.amount.kind in ("all_but", "half"):
                    return _share_of(topic, value.amount)
                whole = value.amount == Amount(number=0) and not topic.definite and topic.noun in MASSES
                if whole and not isinstance(statement, Add | Ensure):
                    return msgspec.structs.replace(topic, amount=Amount(kind="all", number=0), definite=True)
                where = value.place
                told = topic.place is None and where is not None and where.anchor is None and not where.outside
                return with_place(topic, where) if told and where is not None else topic
            if not isinstance(value, msgspec.Struct):
                return tuple(named(part) for part in value) if isinstance(value, tuple) else value
            return msgspec.structs.replace(value, **{f: named(getattr(value, f)) for f in value.__struct_fields__})

        changed: Statement = named(statement)
        return changed


def _of_what_lacks(statement: Add | Ensure | Move, topic: Things, rooms: Rooms) -> Add | Ensure | Move:
    """Return ``a roll on the toilet`` as the toilet paper that was told to be missing, in the room that lacks it."""
    things, place = statement.things, statement.place
    if things.noun in _PORTIONS and topic.noun.split()[-1] in _PORTIONS[things.noun]:
        things = msgspec.structs.replace(things, noun=topic.noun, plural=things.plural)
    bare = things.refers == "last" and not things.noun and not things.definite
    if not (bare or things.noun == topic.noun) or place.anchor is None or place.anchor.refers:
        return statement
    where = place if place.rooms is not None else msgspec.structs.replace(place, rooms=rooms)
    return msgspec.structs.replace(statement, things=things, place=where)


def _place_of_things(statement: Statement) -> Place | None:
    things = getattr(statement, "things", None)
    return things.place if isinstance(things, Things) else None


def _is_bare_it(things: Things | None, *, many: bool = False) -> bool:
    return things is not None and things.refers == "last" and not things.noun and (many or not things.plural)


def _is_at_it(place: Place) -> bool:
    """Whether a place is only in or at what was mentioned last: ``the chairs from it``."""
    return place.relation in ("", "in", "on") and _is_bare_it(place.anchor) and not place.outside and not place.rooms


def _mentioned_by(statement: Statement | None) -> Things | None:
    """Return the furniture that a statement named last: where something went or lay, else what it is about."""
    if isinstance(statement, Add | Ensure | Move) and statement.place.anchor is not None:
        return statement.place.anchor
    things = getattr(statement, "things", None)
    if isinstance(things, Things) and things.place is not None and things.place.anchor is not None:
        return things.place.anchor
    return things if isinstance(things, Things) else None


def _share_of(topic: Things, amount: Amount) -> Things:
    """Return all of what was told before but so many, or half: ``there are three; remove all but one``."""
    whole = topic.amount.number if topic.amount.kind == "some" and topic.amount.number > 1 else 0
    share = msgspec.structs.replace(amount, of=amount.of or whole)
    return msgspec.structs.replace(topic, amount=share, definite=True, plural=True)

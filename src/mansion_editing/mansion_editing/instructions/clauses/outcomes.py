"""What items with their places amount to: things that are there, new, given, gone or elsewhere."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.sentence import Sentence
from mansion_editing.instructions.phrases.places import ReadPlace, merged, read_place, with_place
from mansion_editing.instructions.phrases.storage import AWAY
from mansion_editing.instructions.phrases.word_sets import BEFORE_SPOTS, NO_FRONTED_PLACES
from mansion_editing.instructions.statements import (
    Add,
    Amount,
    Clear,
    Ensure,
    Move,
    Place,
    Remove,
    Rooms,
    Spot,
    Statement,
    Things,
)

__all__ = [
    "Outcomes",
    "at_receiver",
    "begins_in_a_room",
    "everything_at",
    "goes_on_from_a_room",
    "named_as",
    "places_besides",
]

_CARRYING: Final = frozenset(
    "bring carry fetch get deliver move take shift transfer transport haul push pull roll wheel slide drag".split()
)
"""Verbs of what goes somewhere else than where it is."""
_RUBBISH: Final = frozenset("rubbish trash garbage dump skip tip landfill".split())
"""Where things go that leave the building."""
_FACED: Final[dict[str, Spot]] = {"window": "window", "door": "door", "doorway": "door", "wall": "wall"}


class Outcomes(Sentence):
    """Makes statements of items and the places that are said of them."""

    def faced_spot(self, at: int) -> tuple[Spot, int] | None:
        """Read ``the window`` that something turns to, with the end of the words; None for things."""
        while self.text(at) in BEFORE_SPOTS | {"nearest", "closest"}:
            at += 1
        spot = _FACED.get(self.text(at))
        return None if spot is None else (spot, at + 1)

    def _put_away(self, items: list[Item], quote: str) -> list[Statement]:
        """Read ``put the keyboard on the desk away``: what is there is kept in furniture of its room."""
        if any(item.is_room or not (item.phrase.definite or item.phrase.refers) for item in items):
            raise NotUnderstood(items[0].phrase.start, items[-1].end)
        shared = () if any(item.places for item in items[:-1]) else items[-1].places
        whole = [Item(item.phrase, item.places or shared, item.end).things() for item in items]
        return [Move(things=self._all_if_plural(self._within_frame(one)), place=AWAY, quote=quote) for one in whole]

    def _shared_goal(self, items: Sequence[Item], item: Item) -> tuple[Place, bool]:
        """Return where a thing of several goes: its own place, else the next one's, else the last before it."""
        at = items.index(item)
        if items[at].places:
            return items[at].goal()
        for other in (*items[at:], *reversed(items[:at])):
            moved = len(other.places) > 1 and other.places[0].source and any(p.goal for p in other.places)
            goal = self._source_and_goal(other.places)[1:] if moved else other.goal()
            if goal[0].anchor is not None or goal[0].rooms is not None:
                return goal
        return Place(), False

    def _coming_together(self, verb: str, items: list[Item]) -> list[Item]:
        """Return the things of a list that all go where the last one does, each with where it comes from.

        ``Carry the desk near the window and the chair over to the store`` brings both there.
        """
        aimed = tuple(p for p in items[-1].places if p.goal and self.text(p.start) in ("to", "over", "up", "down"))
        if verb not in _CARRYING or not aimed:
            return items
        out: list[Item] = []
        for item in items[:-1]:
            stays = bool(item.places) and not any(p.goal or p.source for p in item.places)
            whence = tuple(replace(p, source=True) for p in item.places)
            out.append(Item(item.phrase, (*whence, *aimed), item.end) if stays else item)
        return [*out, items[-1]]

    def _source_and_goal(self, places: Sequence[ReadPlace]) -> tuple[Place, Place, bool]:
        """Return where things come from and where they go: the goal begins with ``to``, or is the last place."""
        explicit = next((k for k, p in enumerate(places) if p.goal), None)
        told = max((k for k, p in enumerate(places) if p.relative), default=-1)
        if explicit is None and 0 <= told < len(places) - 1:
            explicit = told + 1
        leaving = next((k for k, p in enumerate(places) if p.source), None)
        if explicit is None:
            related = [
                k for k, p in enumerate(places) if not p.source and (p.place.relation or p.place.spot or p.place.facing)
            ]
            anew = [
                k for k, p in enumerate(places) if not p.source and p.place.rooms is not None and p.place.rooms.words
            ]
            explicit = (
                related[-1]
                if related
                else anew[-1]
                if anew
                else max((k for k, p in enumerate(places) if not p.source), default=0)
            )
            if leaving is not None and leaving > explicit:
                explicit = min(k for k, p in enumerate(places) if not p.source)
        if leaving is not None and leaving > explicit:
            goal, each = joined_places(places[explicit:leaving])
            source, _ = joined_places([*places[:explicit], *places[leaving:]])
        else:
            goal, each = joined_places(places[explicit:])
            source, _ = joined_places(places[:explicit])
        return source, goal, each

    def _there(self, item: Item, shared: tuple[Place, bool], quote: str, *, negated: bool = False) -> list[Statement]:
        """Return that things are at a place, or are not."""
        amount = item.phrase.amount
        goal, each = self._framed(shared)
        things = item.phrase.things()
        if amount.kind == "fewer":
            fewer = msgspec.structs.replace(things, amount=Amount(number=amount.number), plural=False)
            return [Remove(things=with_place(fewer, goal) if goal != Place() else fewer, quote=quote)]
        if negated and amount.kind in ("at_most", "at_least"):
            negated, things = False, _counted_otherwise(things)
        if amount.kind == "none" or negated:
            gone = with_place(things, goal) if goal != Place() else things
            return [Remove(things=msgspec.structs.replace(gone, amount=Amount(kind="all", number=0)), quote=quote)]
        if item.phrase.definite and item.phrase.noun.kind != "anything":
            return [Move(things=things, place=goal, or_new=True, quote=quote)]
        return [Ensure(things=things, place=goal, each=each, quote=quote)]

    def _added(self, items: Sequence[Item], item: Item, quote: str) -> Statement:
        """Return the statement of ``put X at Y``: a move of what is there, else something new."""
        item, items = self._from_where_all_are(items, item)
        goal, each = self._framed(self._shared_goal(items, item))
        phrase = item.phrase
        if self._joins(item, goal):
            goal = msgspec.structs.replace(goal, relation="beside")  # "one more chair to each table"
        shared = item.places or not any(other.places for other in items)
        source = joined_places([p for p in item.places if p.source])[0] if shared else Place()
        whence = phrase.definite or phrase.refers or source != Place()
        if whence and (any(p.relative or p.goal for p in item.places) or begins_in_a_room(item.places)):
            source, goal, each = self._source_and_goal(item.places)
            goal, each = self._framed((goal, each))
        to_them = goal.anchor is not None and goal.anchor.refers == "last" and not goal.anchor.noun
        if phrase.refers == "last" and not phrase.noun.words and phrase.amount.number and to_them:
            more = Things(refers="last", amount=Amount(kind="more", number=phrase.amount.number), plural=phrase.plural)
            return Add(things=more, place=Place(rooms=Rooms(same=True)), quote=quote)
        goal = self._laid_over(item, goal)
        partitive = self._is_partitive(phrase)
        begun = partitive and _begins_in_bare_room(item.places)
        if (
            (partitive and any(p.relative for p in item.places))
            or begun
            or (not whence and goes_on_from_a_room(item.places))
        ):
            source, goal, each = self._source_and_goal(item.places)
            goal, each = self._framed((goal, each))
            goal = self._laid_over(item, goal)
        other = self._other_furniture(item) if phrase.definite else 0
        if other:
            source, goal = (joined_places(part)[0] for part in (item.places[:other], item.places[other:]))
        moved = (
            phrase.definite
            or partitive
            or (phrase.refers and phrase.amount.kind != "more")
            or source != Place()
            or phrase.amount.kind in ("all", "all_but")
        )
        if not moved:
            if phrase.amount.kind in ("exactly", "at_least", "at_most"):
                return Ensure(things=phrase.things(), place=goal, each=each, quote=quote)
            return Add(things=phrase.things(), place=goal, each=each, quote=quote)
        things = phrase.things()
        if source != Place():
            things = with_place(things, self._framed((source, False))[0] if source.rooms is None else source)
        return Move(things=things, place=goal, or_new=source == Place() and not phrase.refers, quote=quote)

    def _other_furniture(self, item: Item) -> int:
        """Return which place is on other furniture than where a thing is: ``the mug in the cupboard on the desk``."""
        told = [k for k, p in enumerate(item.places) if p.place.anchor is not None and p.place.relation in ("on", "in")]
        plain = len(told) == 2 and not any(p.source or p.goal or p.relative for p in item.places)
        names = [tuple(p.place.anchor.noun.split()) for p in item.places if p.place.anchor is not None]
        return told[1] if plain and len(names) == 2 and all(map(self.lexicon.stands, names)) else 0

    def _laid_over(self, item: Item, goal: Place) -> Place:
        """Return ``a blanket over the armchair`` as on it."""
        loose = goal.relation == "above" and self.lexicon.is_loose(item.phrase.noun.words)
        return msgspec.structs.replace(goal, relation="on") if loose else goal

    def _joins(self, item: Item, goal: Place) -> bool:
        """Whether furniture comes ``to`` other furniture that it cannot stand on, and so beside it."""
        noun = item.phrase.noun.words
        holder = () if goal.anchor is None else tuple(goal.anchor.noun.split())
        mark = next((p for p in item.places if p.place.anchor is not None and not p.source), None)
        bare = mark is not None and self.text(mark.start) == "to" and goal.relation in ("on", "")
        stands = bool(holder) and self.lexicon.stands(holder) and not self.lexicon.is_loose(noun)
        return bare and stands and self.lexicon.stands(noun)

    def _from_where_all_are(self, items: Sequence[Item], item: Item) -> tuple[Item, Sequence[Item]]:
        """Return a thing of a list with the places of its last one, where all come from: ``A and B from C into D``."""
        last = items[-1]
        told = any(p.source for p in last.places) and any(not p.source for p in last.places)
        bare = not any(other.places for other in items[:-1]) and all(other.phrase.definite for other in items)
        if item is last or not told or not bare:
            return item, items
        whole = Item(item.phrase, last.places, item.end)
        return whole, [whole if other is item else other for other in items]

    def _elsewhere(self, statement: Statement, where: Item) -> Statement:
        """Return the same at another place."""
        old = getattr(statement, "place", Place())
        if where.is_room or (where.phrase.noun.kind == "both" and old.anchor is None):
            place = msgspec.structs.replace(old, rooms=where.rooms())
        else:
            place = Place(relation=old.relation or "on", anchor=where.phrase.things())
        return msgspec.structs.replace(statement, place=place)

    def _brought(self, item: Item, places: Sequence[ReadPlace], quote: str) -> Statement:
        """Return that a subject, with the place where it is, goes to other places."""
        whole = Item(item.phrase, tuple(places), item.end)
        if not item.places:
            return self._added([whole], whole, quote)
        source, _ = self._framed(joined_places(list(item.places)))
        goals = [p for p in places if not p.source]
        goal, _ = self._framed(joined_places(goals))
        if self._joins(Item(item.phrase, tuple(goals), item.end), goal):
            goal = msgspec.structs.replace(goal, relation="beside")  # "the chair goes to the desk"
        things = with_place(item.phrase.things(), source)
        return Move(things=self._all_if_plural(things), place=goal, quote=quote)

    def _receiver(self, where: Item) -> Place:
        """Return the place of what is given to a room or to furniture."""
        if where.is_room or (where.phrase.noun.kind == "both" and self.lexicon.is_own_room(where.phrase.noun.words)):
            return Place(rooms=where.rooms())
        place, _ = joined_places(list(where.places))
        return merged(Place(relation="on", anchor=where.phrase.things()), place)

    def _given(self, item: Item, goal: Place, quote: str, *, each: bool) -> Statement:
        own = item.goal()[0]
        place = at_receiver(own, goal)
        on_it = place.anchor is not None and self._may_be_on(item, tuple(place.anchor.noun.split()))
        stands = not on_it and self.lexicon.stands(item.phrase.noun.words)
        if place.relation == "on" and place.anchor is not None and stands:
            place = msgspec.structs.replace(place, relation="around" if item.phrase.plural else "beside")
        if item.phrase.amount.kind in ("exactly", "at_least", "at_most"):
            return Ensure(things=item.phrase.things(), place=place, each=each, quote=quote)
        source = joined_places([p for p in item.places if p.source])[0]
        if source != Place() and not each:  # "give the den the desk from the study"
            known = item.phrase.definite or self._is_partitive(item.phrase)
            things = with_place(item.phrase.things(), source)
            return Move(things=self._all_if_plural(things) if known else things, place=goal, quote=quote)
        return Add(things=item.phrase.things(), place=place, each=each, quote=quote)

    def _around_it(self, item: Item, place: Place) -> Place:
        """Return where furniture is ``from`` other furniture that it does not stand on: the chairs of a table."""
        holder = () if place.anchor is None else tuple(place.anchor.noun.split())
        stands = bool(holder) and self.lexicon.stands(holder) and self.lexicon.stands(item.phrase.noun.words)
        seats = item.phrase.noun.words[-1:] in (("chair",), ("stool",), ("seat",), ("armchair",))
        one = place.anchor is not None and not place.anchor.plural and place.anchor.amount.number <= 1
        around = stands and seats and one and place.anchor is not None and not place.anchor.each and not place.relation
        return msgspec.structs.replace(place, relation="around") if around else place

    def _may_be_on(self, item: Item, holder: tuple[str, ...]) -> bool:
        """Whether a general word for one thing has kinds that lie on furniture such as this: a plant for each desk."""
        noun = item.phrase.noun.words
        return not item.phrase.plural and self.lexicon.has_small_kinds(noun) and self.lexicon.carries(holder)

    def _removed(
        self, items: Sequence[Item], item: Item, more: Sequence[ReadPlace], besides: tuple[Things, ...], quote: str
    ) -> Statement:
        at = items.index(item)
        others = (places_besides(item, other) for other in (*items[at:], *reversed(items[:at])))
        own = item.places or next((places for places in others if places), ())
        place, _ = self._framed(joined_places([*own, *more]))
        place = self._around_it(item, place)
        things = self._in_each_room(item.phrase)
        number = next((b.amount.number for b in besides if b.refers == "last" and b.amount.number), 0)
        bare_all = things.refers == "last" and not things.noun and self.text(item.phrase.start) == "all"
        if number and (things.amount.kind == "all" or bare_all):
            things = msgspec.structs.replace(things, amount=Amount(kind="all_but", number=number))
            besides = ()
        told = next((b.place for b in besides if b.place is not None and b.noun not in ("", "one", things.noun)), None)
        if place == Place() and told is not None:
            place = told
        if things.noun == "" and not things.refers:
            return Clear(place=place, spare=besides, quote=quote)
        if item.phrase.amount.kind == "some" and item.phrase.amount.number == 0 and item.phrase.plural:
            things = msgspec.structs.replace(things, amount=Amount(kind="all", number=0))
        things = msgspec.structs.replace(things, beside=tuple(named_as(one, things.noun) for one in besides))
        return Remove(things=with_place(things, place) if place != Place() else things, quote=quote)

    def _emptied(self, item: Item, *, wholly: bool = False) -> Place:
        """Return a place that is to be empty: a room, on furniture, or `wholly` on it and in it."""
        if item.is_room or (item.phrase.noun.kind == "both" and not item.places):
            return Place(rooms=item.rooms())
        where, _ = joined_places(list(item.places))
        return Place(relation="" if wholly else "on", anchor=item.phrase.things(), rooms=where.rooms)

    def _kept(self, item: Item) -> Things:
        """Return what stays: the things of an item, all that is in a room."""
        return everything_at(Place(rooms=item.rooms())) if item.is_room else self._all(item.things())

    def _gone_from(self, where: Item, gone: Sequence[Item], quote: str) -> list[Statement]:
        out: list[Statement] = []
        place = self._emptied(where)
        for item in gone:
            things = item.phrase.things()
            if not things.noun and not things.refers:
                out.append(Clear(place=place, quote=quote))
            else:
                whole = msgspec.structs.replace(things, amount=Amount(kind="all", number=0))
                out.append(Remove(things=with_place(whole, place), quote=quote))
        return out

    def _rubbish(self, at: int) -> int:
        """Return the end of ``in the rubbish`` at a place, 0 where there is none."""
        place = at + (self.text(at) in ("in", "into", "to", "on", "onto"))
        place += place > at and self.text(place) in ("the", "a")
        whole = self.text(place) in _RUBBISH and self.text(place + 1) not in ("bin", "can", "bag")
        return place + 1 if place > at and whole else 0

    def _fronted(self, place: int) -> int:
        """Read a place before the object ("put on the desk two mugs") into the frame."""
        read = read_place(self.words, place, self.lexicon, self.floors)
        if read is None or self.text(place) in NO_FRONTED_PLACES:
            return place
        following, end = self.places(place)
        end += self.text(end) == ","
        if self.phrase(end) is None:
            return place
        self.frame, _ = joined_places(following)
        return end


def places_besides(item: Item, other: Item) -> tuple[ReadPlace, ...]:
    """Return the places of another thing of a list that the first is at too: not ``around it``, which is at itself."""
    noun = " ".join(item.phrase.noun.words)
    return tuple(p for p in other.places if p.place.anchor is None or p.place.anchor.noun != noun)


def goes_on_from_a_room(places: Sequence[ReadPlace]) -> bool:
    """Whether places begin with where something is, and a goal follows: ``in the storage to the lobby``."""
    named = [read.place.anchor is not None or bool(read.place.rooms and read.place.rooms.words) for read in places]
    aside = [read.place.relation in ("left", "right") for read in places]
    told = next((k for k, read in enumerate(places) if read.goal and named[k] and not aside[k]), 0)
    rooms = [place.place.rooms for place in places[:told]]
    return told > 0 and any(room is not None and room.words for room in rooms)


def begins_in_a_room(places: Sequence[ReadPlace]) -> bool:
    """Whether places begin with furniture and its room: ``from the bar in the hall on the table in the study``."""
    if _is_of_another_room(places):
        return True
    if len(places) < 3 or not places[0].source or places[0].place.anchor is None:
        return False
    goal = next((at for at in range(1, len(places)) if places[at].place.anchor is not None), 0)
    return goal > 1 and all(p.place.rooms is not None and not p.place.spot for p in places[1:goal])


def _begins_in_bare_room(places: Sequence[ReadPlace]) -> bool:
    """Whether a room comes first and furniture follows: one of the stools ``in the bar at the high table``."""
    first = places[0].place if places else Place()
    bare = first.rooms is not None and bool(first.rooms.words) and first == Place(rooms=first.rooms)
    return bare and len(places) > 1 and places[1].place.anchor is not None


def _is_of_another_room(places: Sequence[ReadPlace]) -> bool:
    """Whether furniture of one room follows another room: ``in the kitchen on the dining room table``."""
    if not _begins_in_bare_room(places):
        return False
    rooms, anchor = places[0].place.rooms, places[1].place.anchor
    return rooms is not None and anchor is not None and bool(anchor.owned) and anchor.owned != rooms.words


def _counted_otherwise(things: Things) -> Things:
    """Return things with their limit denied: ``not more than two`` are at most two, ``not fewer`` at least."""
    number = things.amount.number
    more = things.amount.kind == "at_least"
    denied = Amount(kind="at_most", number=number - 1) if more else Amount(kind="at_least", number=number + 1)
    return msgspec.structs.replace(things, amount=denied)


def at_receiver(own: Place, receiver: Place) -> Place:
    """Return the place of what a subject has or is given: ``on it``, ``next to it`` mean the subject."""
    it = own.anchor is not None and own.anchor.refers == "last" and not own.anchor.noun
    if it and receiver.anchor is not None:
        return msgspec.structs.replace(receiver, relation=own.relation)
    if own == Place() or (it and own.relation == "in"):
        return receiver
    return merged(own, receiver)


def everything_at(place: Place) -> Things:
    """Return all that is at a place."""
    return Things(amount=Amount(kind="all", number=0), definite=True, plural=True, place=place)


def named_as(spared: Things, noun: str) -> Things:
    """Return an exception without a noun as one of the kind that it is excepted from."""
    return msgspec.structs.replace(spared, noun=noun) if not spared.noun and not spared.refers else spared

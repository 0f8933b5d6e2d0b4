"""Things that move, change places with others, or make way for others."""

from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.outcomes import places_besides
from mansion_editing.instructions.clauses.shifting import Shifting
from mansion_editing.instructions.phrases.places import ReadPlace, read_place, with_place
from mansion_editing.instructions.phrases.words import MODALS
from mansion_editing.instructions.statements import (
    JOINED,
    Add,
    Amount,
    Move,
    Place,
    Replace,
    Rooms,
    Statement,
    Swap,
    Things,
)

__all__ = ["Moving"]


_FOR: Final = frozenset("for with by to against".split())
"""Words before what something is swapped for."""
_SEATS: Final = ("chair", "sofa", "loveseat", "couch", "bench", "recliner")
"""Ends of names of what no other furniture stands on."""


class Moving(Shifting):
    """Reads ``move``, ``swap`` and ``replace``."""

    def _move(self, at: int, place: int) -> tuple[list[Statement], int]:
        shifted = self._shifted(at, place)
        if shifted is not None:
            return shifted
        items = self._coming_together(self.text(at), self.items(place))
        end, besides = self.exceptions(items[-1].end)
        if any(item.is_room for item in items):
            raise NotUnderstood(place, end)
        if besides:
            further, stop = self.places(end + (self.text(end) == ","))
            end = stop if further else end
            if not further and not any(p.goal for p in items[-1].places):
                raise NotUnderstood(place, end)
            items = [*items[:-1], Item(items[-1].phrase, (*items[-1].places, *further), end)]
        if (
            self.text(end) in ("and", ",", "then")
            and read_place(self.words, end + 1, self.lexicon, self.floors) is not None
        ):
            more, end = self.places(end + 1)
            items = [*items[:-1], Item(items[-1].phrase, (*items[-1].places, *more), end)]
        goal_of = [p for p in items[-1].places if not p.source]
        if not goal_of:
            raise NotUnderstood(at, self.boundary(at))
        out: list[Statement] = []
        quote = self.quote(at, end)
        for item in items:
            own = item.places or places_besides(item, items[-1])
            source, goal, _ = self._source_and_goal(own)
            if goal == Place():
                raise NotUnderstood(at, end)
            things = item.phrase.things()
            if source != Place():
                things = with_place(things, source)
            if goal.spot and goal.anchor is None and goal.rooms is None and self.frame.rooms is not None:
                goal = self._framed((goal, False))[0]  # "in the study, move the desk to the window"
            spared = tuple(msgspec.structs.replace(one, noun=one.noun or things.noun) for one in besides)
            things = msgspec.structs.replace(things, beside=spared)
            new = item.phrase.amount.kind == "more" and self.text(item.phrase.start) != "another"
            if new and source == Place() and not item.phrase.definite:
                out.append(Add(things=things, place=goal, quote=quote))  # "roll out one more mat next to it"
                continue
            if self._comes_beside(item, own, goal):
                goal = msgspec.structs.replace(goal, relation="beside")
            out.append(Move(things=self._all_if_plural(things), place=goal, quote=quote))
        return out, end

    def _comes_beside(self, item: Item, places: Sequence[ReadPlace], goal: Place) -> bool:
        """Whether furniture goes to other furniture, and so beside it: ``move the trolley over to the washbasin``."""
        noun = item.phrase.noun.words
        mark = next((p for p in places if p.goal and p.place.anchor is not None), None)
        bare = mark is not None and self.text(mark.start) in ("over", "to", "up") and goal.relation in ("on", "in")
        holder = () if goal.anchor is None else tuple(goal.anchor.noun.split())
        sat_on = bool(holder) and holder[-1].endswith(_SEATS)
        heavy = sat_on or not self.lexicon.is_loose(noun)
        furniture = self.lexicon.stands(noun) and heavy and self.lexicon.stands(holder)
        return bare and furniture and self.text(mark.end - 1 if mark else 0) != "it"

    def _swap(self, at: int, place: int) -> tuple[list[Statement], int]:
        items = self.items(place)
        end = items[-1].end
        quote = self.quote(at, end)
        if len(items) == 1 and _means_two(items[0]):
            return [Swap(one=items[0].things(), other=items[0].things(), quote=quote)], end
        of_each = _of_two_rooms(items[0]) if len(items) == 1 else None
        if of_each is not None:
            return [Swap(one=of_each[0], other=of_each[1], quote=quote)], end
        exchanged = any(self.text(read.start) in _FOR for item in items for read in item.places)
        if len(items) == 1 and _names_two(items[0]) and not exchanged and self._ends_swap(end):
            both = self._within_frame(items[0].things())
            return [Swap(one=both, other=both, quote=quote)], end
        names = items[0].rooms().words.split(JOINED) if len(items) == 1 and items[0].is_room else []
        if len(names) == 2:
            floors = items[0].rooms().floors
            pair = [Rooms(words=name, floors=floors) for name in names]
            return [Swap(one=pair[0], other=pair[1], quote=quote)], end
        if len(items) == 2 and items[0].is_room and items[1].is_room:
            one, other = items[0].rooms(), items[1].rooms()
            one = one if one.floors else msgspec.structs.replace(one, floors=other.floors)
            return [Swap(one=one, other=other, quote=quote)], end
        if len(items) == 1 and items[0].is_room and self.text(end) == ":":
            named = self.items(end + 1)
            if len(named) == 2:
                quote = self.quote(at, named[1].end)
                return [Swap(one=named[0].rooms(), other=named[1].rooms(), quote=quote)], named[1].end
        if len(items) == 1 and items[0].is_room and items[0].phrase.amount.number == 2:
            return [Swap(one=items[0].rooms(), other=Rooms(same=True), quote=quote)], end
        joint = next((k for k in range(place, len(self.words)) if self.text(k) in _FOR
                      and self.phrase(k + 1) is not None), None)  # fmt: skip
        if len(items) == 1 and joint is not None:
            return self._replaced_by(at, place, joint)
        if len(items) == 2:
            nearer, further = items
            shared = further.places and not nearer.places
            place_of_both = joined_places(list(further.places))[0]
            first = with_place(nearer.phrase.things(), place_of_both) if shared else nearer.things()
            return [Swap(one=self._within_frame(first), other=self._within_frame(further.things()), quote=quote)], end
        raise NotUnderstood(at, self.boundary(at))

    def _ends_swap(self, at: int) -> bool:
        """Whether nothing follows that two things are swapped for."""
        while self.text(at) in ("around", "round", "over"):
            at += 1
        return at >= len(self.words) or self.words[at].kind == "mark" or self.text(at) == "and"

    def _change_places(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``the sofa and the desk change places``, ``let the sofa and the desk trade places``."""
        place = at + (self.text(at) == "let")
        stop = next((k for k in range(place, len(self.words)) if self.text(k + 1) == "place"), 0)
        if self.text(stop) not in ("change", "swap", "exchange", "trade", "switch"):
            return None
        subjects = self.until(stop)  # "change" is no noun here
        subjects.frame = self.frame
        one = subjects.item(place)
        if one is not None and _means_two(one) and one.end == stop:
            quote = self.quote(at, stop + 2)
            return [Swap(one=one.things(), other=one.things(), quote=quote)], stop + 2
        if one is not None and self.text(stop + 2) == "with":
            return self._changes_places_with(at, one, stop)
        if one is None or self.text(one.end) != "and":
            return None
        other = subjects.item(one.end + 1)
        if other is None or one.is_room != other.is_room or not (one.phrase.definite and other.phrase.definite):
            return None
        end = other.end
        while self.text(end) in MODALS or self.text(end) in ("to", "please"):
            end += 1
        if end != stop:
            return None
        quote = self.quote(at, end + 2)
        if one.is_room:
            return [Swap(one=one.rooms(), other=other.rooms(), quote=quote)], end + 2
        return [
            Swap(one=self._within_frame(one.things()), other=self._within_frame(other.things()), quote=quote)
        ], end + 2

    def _changes_places_with(self, at: int, one: Item, stop: int) -> tuple[list[Statement], int] | None:
        """Read ``the dresser in room 1 should swap places with the one in room 3``; the verb is at `stop`."""
        end = one.end
        while self.text(end) in MODALS or self.text(end) in ("to", "please", "has", "have", "need"):
            end += 1
        self.last_noun = one.phrase.noun if one.phrase.noun.words else self.last_noun
        other = self.item(stop + 3)
        if end != stop or other is None or other.is_room != one.is_room or not one.phrase.definite:
            return None
        quote = self.quote(at, other.end)
        if one.is_room:
            return [Swap(one=one.rooms(), other=other.rooms(), quote=quote)], other.end
        other = self._named(other, [one])
        first, second = (self._within_frame(item.things()) for item in (one, other))
        return [Swap(one=first, other=second, quote=quote)], other.end

    def _replaced_by(self, at: int, place: int, joint: int) -> tuple[list[Statement], int]:
        """Read ``X with Y``: an exchange of places where both are there, else something new for something old."""
        before = self.until(joint)
        old = before.items(place)
        self.last_noun = old[-1].phrase.noun if old[-1].phrase.noun.words else self.last_noun
        new = self._new_ones(joint + 1)
        end = new[-1].end
        quote = self.quote(at, end)
        if len(old) == 1 and len(new) == 1 and old[0].is_room and new[0].is_room:
            return [Swap(one=old[0].rooms(), other=new[0].rooms(), quote=quote)], end
        swapped = self.text(at) in ("swap", "exchange", "trade", "interchange")
        if swapped and len(new) == 1 and new[0].phrase.definite and not new[0].phrase.refers:
            first, second = (self._within_frame(item.things()) for item in (old[0], new[0]))
            return [Swap(one=first, other=_beside_it(second, first), quote=quote)], end
        out: list[Statement] = []
        for item in old:
            things = item.things()
            for other in new:
                if other.places:
                    things = with_place(things, joined_places(list(other.places))[0]) if not item.places else things
            place_, _ = self._framed((things.place or Place(), False))
            things = msgspec.structs.replace(things, place=place_ if place_ != Place() else None)
            out += [
                Replace(things=self._all_if_plural(things), by=other.phrase.things(), quote=quote) for other in new[:1]
            ]
            out += [Add(things=other.phrase.things(), place=things.place or Place(), quote=quote) for other in new[1:]]
        return out, end

    def _replace(self, at: int, place: int) -> tuple[list[Statement], int]:
        joint = next((k for k in range(place, len(self.words)) if self.text(k) in ("with", "by", "for")), None)
        if joint is None:
            raise NotUnderstood(at, self.boundary(at))
        if self.text(at) == "substitute" and self.text(joint) == "for":
            new = self.until(joint).items(place)
            old = self.items(joint + 1)
            quote = self.quote(at, old[-1].end)
            return [Replace(things=old[0].things(), by=new[0].phrase.things(), quote=quote)], old[-1].end
        return self._replaced_by(at, place, joint)

    def _new_ones(self, at: int) -> list[Item]:
        """Read what comes instead, without ``and the one in the hall too``, which is replaced likewise."""
        first = self.item(at)
        after = 0 if first is None else self.conjunction(first.end)
        other = self.item(after) if after else None
        if first is not None and other is not None and other.phrase.definite and not first.phrase.definite:
            return self.until(first.end).items(at)
        return self.items(at)


def _beside_it(other: Things, one: Things) -> Things:
    """Return ``the clock next to it`` as the one next to what it is swapped with."""
    place = other.place
    anchor = None if place is None else place.anchor
    if place is None or anchor is None or anchor.refers != "last" or anchor.noun:
        return other
    return msgspec.structs.replace(other, place=msgspec.structs.replace(place, anchor=one))


def _names_two(item: Item) -> bool:
    """Whether an item is ``the two armchairs``, ``both lamps``, which change places with each other."""
    phrase = item.phrase
    two = phrase.amount.number == 2 and phrase.amount.kind in ("some", "all")
    return two and phrase.definite and not item.is_room and bool(phrase.noun.words) and not phrase.refers


def _of_two_rooms(item: Item) -> tuple[Things, Things] | None:
    """Return ``the whiteboards of classrooms 1 and 2`` as the one of each room; None for others."""
    place, _ = joined_places(list(item.places))
    names = [] if place.rooms is None else place.rooms.words.split(JOINED)
    counted = item.phrase.amount.kind in ("some", "all") and item.phrase.amount.number in (0, 2)
    if len(names) < 2 or len(names) > 2 or place.anchor is not None or item.is_room or not counted:
        return None
    one = msgspec.structs.replace(
        item.phrase.things(), amount=Amount(number=0), plural=False, definite=True, each=False
    )
    first, second = (Rooms(words=name, floors=place.rooms.floors if place.rooms else ()) for name in names)
    return with_place(one, Place(rooms=first)), with_place(one, Place(rooms=second))


def _means_two(item: Item) -> bool:
    """Whether an item is only ``these two``, ``both``, ``them``."""
    phrase = item.phrase
    several = phrase.noun.plural or phrase.amount.number == 2
    return phrase.refers == "last" and not phrase.noun.words and several and phrase.amount.number in (0, 2)

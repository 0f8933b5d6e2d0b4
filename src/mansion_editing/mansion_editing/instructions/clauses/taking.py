"""Things that are taken or looked for, for what comes next."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.clauses.adding import Adding
from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.removing import Removing
from mansion_editing.instructions.phrases.places import ReadPlace, read_place, with_place
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import AWAY
from mansion_editing.instructions.phrases.words import CONJUNCTIONS, PREPOSITIONS
from mansion_editing.instructions.statements import History, Mention, Move, Place, Statement, Things

__all__ = ["Taking"]

_TAKING_AWAY: Final = frozenset("take collect gather".split())

_BEFORE_HOLDERS: Final = frozenset("on onto in into inside off from under beneath of with".split())
"""Before ``it`` they tell where something goes, so that ``it`` is not what goes."""


class Taking(Adding, Removing):
    """Reads ``take`` and ``find``."""

    def _take(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``take the mug to the kitchen``, ``take the mug off the desk``, and ``take the mug and put it ...``."""
        if self.text(place) in ("that", "it", "this") and self.text(place + 1) == "back":
            return [History(what="undo", quote=self.quote(at, place + 2))], place + 2
        items = self.items(place)
        end = items[-1].end
        places = items[-1].places
        if any(p.goal and not p.source for p in places):
            return self._move(at, place)
        if (
            self.text(end) in ("and", ",", "then")
            and read_place(self.words, end + 1, self.lexicon, self.floors) is not None
        ):
            return self._move(at, place)
        away = self.text(end) in ("away", "out", "off", "down")
        put = self._put_without_object(end + away)
        if put and any(p.source for p in places):
            return self._moved_to(at, items, *put)
        if self._goes_on_with_it(end + away):
            if len(items) > 1:
                return self._taken_and_put(at, items, end + away)
            self.topic = items[0].things()
            return [Mention(quote=self.quote(at, end + away))], end + away
        if away or (any(p.source for p in places) and self.text(at) in _TAKING_AWAY):
            return self._remove(at, place)
        if self.text(at) in ("grab", "pick") and not items[0].phrase.definite:
            return self._add(at, place)
        raise NotUnderstood(at, self.boundary(at))

    def _bring(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``bring the mug to the kitchen``; ``get the mug off the desk`` takes it away."""
        if self.text(place) in ("me", "us"):
            return self._add(at, place)
        if self.text(at) == "get":
            items = self.items(place)
            places = items[-1].places
            stated = self._states_after(items, items[-1].end, at) if self._are_known(items) else None
            if stated is not None:
                return stated
            leaving = self._leaves(places) and self.text(places[0].start) in ("off", "out")
            kinds = {item.phrase.amount.kind for item in items}
            known = self._are_known(items) or "all" in kinds
            end = items[-1].end
            onward = self.text(end) in ("and", ",", "then") and bool(self.places(end + 1)[0])
            if leaving and known and not self._goes_on_with_it(end):
                return self._move(at, place) if onward else self._remove(at, place)
        source = self._fetched_from(at, place)
        return source or self._add(at, place)

    def _are_known(self, items: Sequence[Item]) -> bool:
        """Whether things are told as those that are there already."""
        return all(item.phrase.definite or item.phrase.refers for item in items)

    def _fetched_from(self, at: int, place: int) -> tuple[list[Statement], int] | None:
        """Read ``fetch one of the mugs off the shelf in the kitchen and ... it``: the room is where the shelf is."""
        items = self.items(place)
        item = items[0]
        known = item.phrase.definite or self._is_partitive(item.phrase)
        if len(items) > 1 or not known or not self.comes_from_furniture(item.places):
            return None
        put = self._put_without_object(item.end)
        if put:
            return self._moved_to(at, items, *put)
        if not self._goes_on_with_it(item.end):
            return None
        if not item.phrase.definite:
            return self._taken_and_put(at, items, item.end)
        self.topic = item.things()
        return [Mention(quote=self.quote(at, item.end))], item.end

    def _leaves(self, places: Sequence[ReadPlace]) -> bool:
        """Whether places are furniture or a room that something comes from, and nothing that it goes to."""
        rooms = places[0].place.rooms if len(places) == 1 and places[0].source else None
        only_room = rooms is not None and bool(rooms.words) and places[0].place.anchor is None
        return self.comes_from_furniture(places) or only_room

    def comes_from_furniture(self, places: Sequence[ReadPlace]) -> bool:
        """Whether places are furniture that something comes from, and at most the room which that is in."""
        if not places or not places[0].source:
            return False
        rooms = [p.place.anchor is None and p.place.rooms is not None and not p.goal for p in places[1:]]
        inner = [self.text(p.start) in ("in", "of", "on", "upstairs", "downstairs") for p in places[1:]]
        return places[0].place.anchor is not None and all(rooms) and all(inner)

    def _throw(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``throw the newspaper away``, ``throw it in the rubbish``, ``throw a blanket over the armchair``.

        What is thrown out of something, without a goal, goes away.
        """
        last = self.items(place)[-1]
        out = any(p.source for p in last.places) and not any(p.goal and not p.source for p in last.places)
        gone = out or self._rubbish(last.end) or self.text(last.end) in AWAY
        return self._remove(at, place) if gone else self._add(at, place)

    def _taken_and_put(self, at: int, items: list[Item], after: int) -> tuple[list[Statement], int]:
        """Read ``take the cup and the glass out of the cabinet and set them on the table``: each of them moves."""
        verb = verb_at(self.words, self.conjunction(after) or self.skip(after), self.lexicon)
        if (
            verb is None
            or verb[0] not in ("add", "bring", "move", "set")
            or self.text(verb[1]) not in ("it", "them", "those")
        ):
            raise NotUnderstood(at, self.boundary(after + 1))
        return self._moved_to(at, items, *self.places(verb[1] + 1))

    def _put_without_object(self, at: int) -> tuple[tuple[ReadPlace, ...], int] | None:
        """Read ``and put to the fridge`` after what was taken, where the words say only where it goes."""
        after = self.conjunction(at) or self.skip(at)
        verb = verb_at(self.words, after, self.lexicon)
        if after == at or verb is None or verb[0] not in ("add", "bring", "move", "set"):
            return None
        places, end = self.places(after + 1)
        if not places or self.phrase(end) is not None or any(p.source for p in places):
            return None
        anchor = places[0].place.anchor
        holds = anchor is None or bool(anchor.refers) or self.lexicon.carries(tuple(anchor.noun.split()))
        return (places, end) if holds else None

    def _moved_to(
        self, at: int, items: list[Item], places: tuple[ReadPlace, ...], end: int
    ) -> tuple[list[Statement], int]:
        """Return that things that were taken from where they are go to a place."""
        goal, _ = self._framed(joined_places(list(places)))
        if goal == Place() or any(item.is_room for item in items):
            raise NotUnderstood(at, self.boundary(end - 1))
        shared = () if any(item.places for item in items[:-1]) else items[-1].places
        quote = self.quote(at, end)
        out: list[Statement] = []
        for item in items:
            source = joined_places(list(item.places or shared))[0]
            things = item.phrase.things() if source == Place() else with_place(item.phrase.things(), source)
            out.append(Move(things=self._all_if_plural(things), place=goal, quote=quote))
        return out, end

    def _goes_on_with_it(self, at: int) -> bool:
        """Whether the next clause does something with what the one before took."""
        after = self.conjunction(at) or self.skip(at)
        objects = [
            k
            for k in range(after, min(after + 8, len(self.words)))
            if (self.text(k) in ("it", "them") or self._is_pronoun(k))
            and self.text(k - 1) not in _BEFORE_HOLDERS
            and self.words[k].raw != "door"
            and (self.text(k - 2), self.text(k - 1)) != ("see", "to")
        ]
        return self.starts_clause(after) and bool(objects)

    def _is_pronoun(self, at: int) -> bool:
        """Whether ``that`` stands for a thing, and begins no clause: ``check that she gets there``."""
        following = self.text(at + 1)
        ends = at + 1 >= len(self.words) or self.words[at + 1].kind == "mark"
        return self.text(at) == "that" and (ends or following in PREPOSITIONS | CONJUNCTIONS | {"away", "there"})

    def _gone_up(self, at: int) -> tuple[list[Statement], int] | None:
        """Read ``go up one floor from the cafe``, which tells where the rest of the sentence is."""
        if self.text(at) not in ("go", "walk", "head", "climb", "come"):
            return None
        read = read_place(self.words, at + 1, self.lexicon, self.floors)
        if read is None or read.place.rooms is None or not (read.place.rooms.up or read.place.rooms.floors):
            return None
        self.frame = read.place
        return [Mention(quote=self.quote(at, read.end))], read.end

    def _goes_on_there(self, at: int) -> bool:
        """Whether another clause follows what was only gone to."""
        return self.starts_clause(self.conjunction(at) or self.skip(at))

    def _go(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``find the wardrobe and open it``: the thing is only what the next clause is about."""
        items = self.items(place)
        end = items[-1].end
        if not (
            self._goes_on_with_it(end)
            or self._goes_on_there(end)
            or end >= len(self.words)
            or self.text(end) in (":", ".")
        ):
            raise NotUnderstood(at, self.boundary(at))
        room = items[0].is_room
        self.topic = Things(place=Place(rooms=items[0].rooms())) if room else items[0].things()
        return [Mention(quote=self.quote(at, end))], end

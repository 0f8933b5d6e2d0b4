"""Things that are taken or looked for, for what comes next."""

from typing import Final

from mansion_editing.instructions.clauses.adding import Adding
from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.removing import Removing
from mansion_editing.instructions.phrases.places import read_place, with_place
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import AWAY
from mansion_editing.instructions.statements import History, Mention, Move, Place, Statement, Things

__all__ = ["Taking"]

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
        if self._goes_on_with_it(end + away):
            if len(items) > 1:
                return self._taken_and_put(at, items, end + away)
            self.topic = items[0].things()
            return [Mention(quote=self.quote(at, end + away))], end + away
        if away or (any(p.source for p in places) and self.text(at) == "take"):
            return self._remove(at, place)
        if self.text(at) in ("grab", "pick") and not items[0].phrase.definite:
            return self._add(at, place)
        raise NotUnderstood(at, self.boundary(at))

    def _throw(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``throw the newspaper away``, ``throw it in the rubbish``, ``throw a blanket over the armchair``."""
        end = self.items(place)[-1].end
        return self._remove(at, place) if self._rubbish(end) or self.text(end) in AWAY else self._add(at, place)

    def _taken_and_put(self, at: int, items: list[Item], after: int) -> tuple[list[Statement], int]:
        """Read ``take the cup and the glass out of the cabinet and set them on the table``: each of them moves."""
        verb = verb_at(self.words, self.conjunction(after) or self.skip(after), self.lexicon)
        if (
            verb is None
            or verb[0] not in ("add", "bring", "move", "set")
            or self.text(verb[1]) not in ("it", "them", "those")
        ):
            raise NotUnderstood(at, self.boundary(after + 1))
        places, end = self.places(verb[1] + 1)
        goal, _ = self._framed(joined_places(list(places)))
        if goal == Place() or any(item.is_room for item in items):
            raise NotUnderstood(at, self.boundary(after + 1))
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
            if self.text(k) in ("it", "them", "that") and self.text(k - 1) not in _BEFORE_HOLDERS
        ]
        return self.starts_clause(after) and bool(objects)

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

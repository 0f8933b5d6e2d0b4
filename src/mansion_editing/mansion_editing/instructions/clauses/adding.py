"""Things that are put somewhere, new or there before."""

import msgspec

from mansion_editing.instructions.clauses.colours import Colours
from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.states import States, state_set
from mansion_editing.instructions.phrases.places import read_place
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import BACK_IN_PLACE
from mansion_editing.instructions.phrases.words import STATE_WORDS
from mansion_editing.instructions.statements import (
    Add,
    Amount,
    Ensure,
    History,
    Mention,
    Place,
    Relation,
    Replace,
    Rooms,
    Statement,
    Things,
)

__all__ = ["Adding"]


class Adding(States, Colours):
    """Reads ``put``, ``add``, ``bring``, ``give`` and ``set``."""

    def _add(self, at: int, place: int) -> tuple[list[Statement], int]:
        if self.text(place) in ("on", "off") and self.text(at) == "put":
            return self._switch(at, place)
        laid = self._laid(at, place)
        if laid is not None:
            return laid
        if self._is_table_laid(at, place):
            return self._equip(at, place)
        door = self._door_between(at, place)
        if door is not None:
            return door
        place = self._fronted_holder(at, place) or self._fronted(place)
        for_whom = self.text(place) in ("me", "us") and self.text(place + 1) != "to"
        items = self.items(place + for_whom)
        if items[0].is_room and self.text(items[-1].end) == "with":
            return self._equip(at, place)
        return self._brought_otherwise(at, place, items) or self._added_at(at, place, items)

    def _is_table_laid(self, at: int, place: int) -> bool:
        """Whether ``lay the table for`` begins at a place, which names what is laid and not what is put somewhere."""
        if self.text(at) not in ("lay", "prepare", "arrange") or place != at + 1:
            return False
        table = self.holder_at(place)
        return table is not None and table.phrase.definite and self.text(table.end) in (":", "for")

    def _brought_otherwise(self, at: int, place: int, items: list[Item]) -> tuple[list[Statement], int] | None:
        """Read ``put the mug away``, ``put the mug back``, ``put the lamp on``, ``fetch the mug from the desk``."""
        end = items[-1].end
        if self.text(at) == "put" and self.text(end) == "away":
            return self._put_away(items, self.quote(at, end + 1)), end + 1
        back = self.text(end) == "back" or "back" in (w.text for w in self.words[at:place])
        if back and len(items) == 1 and not items[0].places and (items[0].phrase.refers or items[0].phrase.definite):
            end += self.text(end) == "back"
            while self.text(end) in BACK_IN_PLACE:
                end += 1
            return [History(what="restore", things=items[0].things(), quote=self.quote(at, end))], end
        verb = self.text(at)
        if len(items) == 1 and verb in ("put", "leave") and self.text(end) in ("on", "off"):
            state, value = STATE_WORDS[self.text(end)]
            return [state_set(items[0].things(), state, self.quote(at, end + 1), value=value)], end + 1
        source_only = bool(items[0].places) and all(p.source for p in items[0].places)
        fetched = verb in ("fetch", "bring", "get", "carry", "take") and items[0].phrase.definite and source_only
        if fetched and len(items) == 1:
            self.topic = items[0].things()
            return [Mention(quote=self.quote(at, end))], end
        return None

    def _added_at(self, at: int, place: int, items: list[Item]) -> tuple[list[Statement], int]:
        """Return that things come to their places, with what comes along."""
        items = self._coming_together(self.text(at), items)
        end = items[-1].end
        structure = self._new_core(items, at, end)
        if structure is not None:
            return [structure], end
        chosen = (k for k in range(place, end) if self.text(k) in ("or", "either"))
        if any(self.text(k + 1) != "side" for k in chosen):
            raise NotUnderstood(place, end)
        items, further = self._places_after_places(items)
        joined, end = self._joined_places(end)
        if any(item.is_room for item in items):
            raise NotUnderstood(place, end)
        alone = self.text(at) == "add" and len(items) == 1
        more = self._more_of_them(items[0], self.quote(at, end)) if alone else None
        out = [more or self._added(items, item, self.quote(at, end)) for item in items]
        for extra in further:
            out += [self._elsewhere(statement, extra) for statement in out[: len(items)]]
        for place_too in joined:
            moved = [s for s in out[: len(items)] if not isinstance(s, Add | Ensure)]
            if moved:
                raise NotUnderstood(place, end)
            out += [msgspec.structs.replace(statement, place=place_too) for statement in out[: len(items)]]
        out = [msgspec.structs.replace(statement, quote=self.quote(at, end)) for statement in out]
        return self.with_companions(out, at, end)

    def _fronted_holder(self, at: int, place: int) -> int:
        """Read ``inside`` and ``on it`` before what is new ("put inside two apples") into the frame; 0 for others."""
        start = place - (place - 1 > at and self.text(place - 1) in ("in", "on"))
        word, it = self.text(start), self.text(start + 1) in ("it", "them")
        new = start + 1 + it
        thing = self.phrase(new)
        if not (word == "inside" or (it and word in ("in", "into", "on", "onto"))) or thing is None:
            return 0
        counted = self.words[new].kind == "number" or self.text(new) in ("a", "an", "another", "some")
        if not counted or thing.definite or thing.refers or thing.noun.kind != "object":
            return 0
        holder = Things(refers="last", definite=True, amount=Amount(number=0), plural=self.text(start + 1) == "them")
        self.frame = Place(relation="on" if word in ("on", "onto") else "in", anchor=holder)
        return new

    def _more_of_them(self, item: Item, quote: str) -> Add | None:
        """Read ``add one``, ``add two``: so many more of what was mentioned last, where that is."""
        phrase = item.phrase
        amount = phrase.amount
        bare = phrase.refers == "last" and not phrase.noun.words and not item.places and not amount.of
        if not bare or amount.kind != "some" or not amount.number:
            return None
        more = Things(refers="last", amount=Amount(kind="more", number=amount.number), plural=phrase.plural)
        return Add(things=more, place=Place(rooms=Rooms(same=True)), quote=quote)

    def _joined_places(self, at: int) -> tuple[list[Place], int]:
        """Read ``and in the bathroom`` after a place: the same there."""
        out: list[Place] = []
        start, listed = at, False
        while True:
            after = self.conjunction(at)
            read = read_place(self.words, after, self.lexicon, self.floors) if after else None
            if (
                read is None
                or read.source
                or self.text(after - 1) not in ("and", ",", "&")
                or self.starts_clause(after)
            ):
                break
            places, end = self.places(after)
            place = joined_places(list(places))[0]
            begins = verb_at(self.words, end, self.lexicon) is not None  # "and in the kitchen remove the mugs"
            if begins or self.phrase(end) is not None or (place.anchor is None and place.rooms is None):
                break
            listed = listed or self.text(after - 1) != ","
            out.append(place)
            at = end
        return (out, at) if listed else ([], start)

    def _places_after_places(self, items: list[Item]) -> tuple[list[Item], list[Item]]:
        """Tell further places from things: in ``a mug on the table and the desk`` the desk is a place."""
        if items[0].phrase.definite:
            return items, []
        for at in range(1, len(items)):
            bare = items[at - 1].places and not items[at].places
            if bare and (items[at].is_room or items[at].phrase.definite):
                return items[:at], items[at:]
        return items, []

    def with_companions(self, said: list[Statement], at: int, end: int) -> tuple[list[Statement], int]:
        """Read what comes with new things: ``12 desks, each with a chair``, ``a tray with two mugs``.

        Parameters
        ----------
        said : list of Statement
            What was read so far, the last of which brings the things.
        """
        place = end + (self.text(end) == ",")
        each = self.text(place) == "each"
        place += each
        main = said[-1]
        if self.text(place) != "with" or self.tells_of_door(place) or not isinstance(main, Add | Ensure | Replace):
            return said, end
        new = main.by if isinstance(main, Replace) else main.things
        near = Place(relation="beside", anchor=Things(refers="last", definite=True, amount=Amount(number=0)))
        goal = near if isinstance(main, Replace) else main.place
        end_of_goal = 0
        if isinstance(main, Add | Ensure) and main.place == Place():
            goal, end_of_goal = self._goal_after_each(place + 1)
            if goal == Place():
                return self._with_contents(said[:-1], main, at, place + 1)
            main = msgspec.structs.replace(main, place=goal)
            said = [*said[:-1], main]
        try:
            others = self.items(place + 1)
        except NotUnderstood:
            return said, end
        stop = others[-1].end + (self.text(others[-1].end) == "each")
        each = each or stop > others[-1].end
        stop = max(stop, end_of_goal)
        quote = self.quote(at, stop)
        said = [msgspec.structs.replace(s, quote=quote) if s is main else s for s in said]
        times = max(1, new.amount.number) if each else 1
        out = [*said]
        for other in others:
            things = other.phrase.things()
            number = max(1, things.amount.number) * times
            things = msgspec.structs.replace(things, amount=Amount(kind=things.amount.kind, number=number))
            where = other.goal()[0]
            if where == Place():
                on_it = not self.lexicon.stands(other.phrase.noun.words)
                last = Things(refers="last", definite=True, amount=Amount(number=0))
                where = Place(relation="on", anchor=last) if on_it else goal
            out.append(Add(things=things, place=where, quote=quote))
        return out, stop

    def _goal_after_each(self, at: int) -> tuple[Place, int]:
        """Read where things go after ``with a chair each``: ``to the open office``; no place where none is told."""
        try:
            others = self.items(at)
        except NotUnderstood:
            return Place(), 0
        if any(other.places for other in others) or self.text(others[-1].end) != "each":
            return Place(), 0
        places, end = self.places(others[-1].end + 1)
        return (self._framed(joined_places(places))[0], end) if places else (Place(), 0)

    def _with_contents(
        self, said: list[Statement], main: Add | Ensure, at: int, place: int
    ) -> tuple[list[Statement], int]:
        """Read ``a box with bandages on the trolley``: the box goes there, and they into or onto it."""
        others = self.items(place)
        end = others[-1].end
        there = [p for p in others[-1].places if p.place.anchor is None or p.place.anchor.refers != "last"]
        shared = Item(others[-1].phrase, tuple(there), others[-1].end)
        goal = self._framed(self._shared_goal([*others[:-1], shared], shared))[0]
        quote = self.quote(at, end)
        holder = Things(refers="last", definite=True, amount=Amount(number=0))
        out: list[Statement] = [*said, msgspec.structs.replace(main, place=goal, quote=quote)]
        for other in others:
            stands = self.lexicon.stands(other.phrase.noun.words)
            if stands and other.phrase.amount.kind not in ("some", "more"):
                raise NotUnderstood(place, end)
            relation: Relation = "on" if not stands else "around" if other.phrase.plural else "beside"
            out.append(Add(things=other.phrase.things(), place=Place(relation=relation, anchor=holder), quote=quote))
        return out, end

    def _give(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``give the lobby two plants``; ``give me a chair`` asks for it."""
        whom = self.text(place) in ("him", "her") and self.text(place + 1) in ("a", "an", "another", "two", "some")
        if whom or self.text(place) in ("me", "us"):
            return self._add(at, place + 1)
        surface = self.surface(place)
        coat = 0 if surface is None else surface[1]
        while coat and self.text(coat) in ("a", "an", "new", "fresh", "coat", "lick", "of", "paint", "touch"):
            coat += 1
        colour = self.colour_at(coat) if surface is not None else None
        if surface is not None and colour is not None:
            return self._painted(surface[0], colour[0], colour[1], self.quote(at, colour[2])), colour[2]
        where = self.item(place)
        if where is None:
            raise NotUnderstood(at, self.boundary(at))
        article = where.end + (self.text(where.end) in ("a", "the"))
        tint = self.colour_at(article)
        if tint is not None and self.text(tint[2] - 1) in ("colour", "color"):
            return self._painted([where], tint[0], tint[1], self.quote(at, tint[2])), tint[2]
        items = self.items(where.end)
        end = items[-1].end
        each = where.phrase.each or where.phrase.amount.kind == "all"
        goal = self._receiver(where)
        return [self._given(item, goal, self.quote(at, end), each=each) for item in items], end

    def _set(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``set the table with eight plates``; otherwise as ``put``."""
        where = self.holder_at(place)
        if where is not None and self.text(where.end) in ("with", ":", "for"):
            return self._equip(at, place)
        return self._add(at, place)

"""The clause at a place: by its verb, its predicate, or its things alone."""

from collections.abc import Callable, Sequence

import msgspec

from mansion_editing.instructions.clauses.changing import Changing
from mansion_editing.instructions.clauses.fronting import Fronting
from mansion_editing.instructions.clauses.history import PastSteps
from mansion_editing.instructions.clauses.items import Item, NotUnderstood
from mansion_editing.instructions.clauses.keeping import Keeping
from mansion_editing.instructions.clauses.outcomes import begins_in_a_room, goes_on_from_a_room
from mansion_editing.instructions.clauses.taking import Taking
from mansion_editing.instructions.phrases.places import with_place
from mansion_editing.instructions.phrases.verb_words import Deed
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import MASSES
from mansion_editing.instructions.statements import (
    JOINED,
    Add,
    Amount,
    Move,
    Paint,
    Place,
    Remove,
    Replace,
    Rooms,
    SetState,
    Statement,
    Things,
    Turn,
)

__all__ = ["ClauseReader", "of_each_room", "sparing"]


class ClauseReader(Keeping, Changing, Taking, PastSteps, Fronting):
    """Reads the clauses of one sentence."""

    def read(self, at: int) -> tuple[list[Statement], int]:
        """Read the clause at a place; what it changes is in the room that the sentence began with.

        Raises
        ------
        NotUnderstood
            Where the words make no clause.
        """
        statements, end = self._clause(at)
        return [self._done_within_frame(statement) for statement in statements], end

    def _done_within_frame(self, statement: Statement) -> Statement:
        """Return ``magazines gone`` after ``Lounge:`` as those of the lounge."""
        if isinstance(statement, Remove | Move):
            statement = msgspec.structs.replace(statement, things=_whole_mass(statement.things))
        if isinstance(statement, Move):
            return self._out_of_frame(statement)
        if not isinstance(statement, Remove | SetState | Paint | Replace | Turn):
            return statement
        things = statement.things
        if things.place is not None or things.refers:
            return statement
        return msgspec.structs.replace(statement, things=self._within_frame(things))

    def _out_of_frame(self, move: Move) -> Move:
        """Return ``In the hall, the chairs go to the office`` as those of the hall to the office, whichever is next."""
        frame, goal = self.frame.rooms, move.place.rooms
        if frame is None or goal is None or not (frame.words and goal.words):
            return move
        if goal.next_to != frame.words:
            elsewhere = goal.words != frame.words and not goal.same and move.things.place is None
            bare = elsewhere and bool(move.things.noun) and not (move.things.refers or move.or_new)
            return msgspec.structs.replace(move, things=self._within_frame(move.things)) if bare else move
        floors = () if goal.floors == frame.floors else goal.floors
        number = 0 if goal.number == frame.number else goal.number
        rooms = msgspec.structs.replace(goal, next_to="", floors=floors, number=number, every=False)
        place = msgspec.structs.replace(move.place, rooms=rooms)
        return msgspec.structs.replace(move, things=self._within_frame(move.things), place=place)

    def _clause(self, at: int) -> tuple[list[Statement], int]:
        """Read the clause at a place by the first of the readers that understands it."""
        if at >= len(self.words):
            raise NotUnderstood(len(self.words) - 1, len(self.words))
        staying = (
            self._way_stays_free(at, at)
            or self._meant(at)
            or self._staying(at)
            or self._stays_so(at)
            or self._gone_up(at)
            or self._too_many(at)
            or self._arranged(at)
            or self._change_places(at)
        )
        if staying is not None:
            return staying
        fronted = self._fronted_object(at)
        if fronted is not None:
            return fronted
        if self.words[at].kind == "ordinal" and verb_at(self.words, at + 1, self.lexicon) is not None:
            at += 1
        if self.words[at].kind == "ordinal" and self.text(at + 1) == "," and self.starts_clause(at + 2):
            at += 2
        if self.text(at) in ("only", "just", "to") and verb_at(self.words, at + 1, self.lexicon) is not None:
            at += 1
        if at >= len(self.words):
            raise NotUnderstood(len(self.words) - 1, len(self.words))
        if self.text(at) == "that" and {w.text for w in self.words[:at]} & {"sure", "ensure", "check", "certain"}:
            return self._check(at, at + 1)
        for opening in (self._negated, self._existential, self._inverted, self._going, self._desired,
                        self._of_persons, self._with_verb, self._with_predicate):  # fmt: skip
            found = opening(at)
            if found is not None:
                return found
        return self._verbless(at)

    def _with_verb(self, at: int) -> tuple[list[Statement], int] | None:
        verb = verb_at(self.words, at, self.lexicon)
        if verb is None:
            return None
        deed, place = verb
        readers: dict[Deed, Callable[[int, int], tuple[list[Statement], int]]] = {
            "add": self._add, "bring": self._bring, "remove": self._remove, "clear": self._clear, "move": self._move,
            "swap": self._swap, "replace": self._replace, "switch": self._switch, "open": self._open,
            "close": self._close, "start": self._start, "stop": self._stop, "paint": self._paint,
            "rename": self._rename, "furnish": self._furnish, "equip": self._equip, "enlarge": self._enlarge,
            "shrink": self._shrink, "make": self._make, "turn": self._rotate, "check": self._check, "undo": self._undo,
            "redo": self._undo, "restore": self._restore, "leave": self._leave, "tidy": self._tidy, "keep": self._keep,
            "let": self._let, "change": self._change, "give": self._give, "take": self._take, "go": self._go,
            "set": self._set, "want": self._want, "repeat": self._repeat, "connect": self._connect, "use": self._use,
            "throw": self._throw,
        }  # fmt: skip
        reader = readers.get(deed)
        if reader is None:
            return None
        return reader(at, place)

    def _carried_over(self, items: Sequence[Item], at: int) -> tuple[list[Statement], int] | None:
        """Read ``the laptop from the study to the hall``, ``two chairs out of the hall and into the study``."""
        first = items[-1].places
        if not first or not (first[0].source or goes_on_from_a_room(first)) or any(item.is_room for item in items):
            return None
        places, end = items[-1].places, items[-1].end
        if not any(p.goal for p in places) and self.text(end) in ("and", ","):
            more, stop = self.places(end + 1)
            places, end = (*places, *more), stop
        if not any(p.goal for p in places) and not begins_in_a_room(places):
            return None
        source, goal, _ = self._source_and_goal(places)
        source = source if source.rooms is not None else self._framed((source, False))[0]
        goal = goal if goal.rooms is not None else self._framed((goal, False))[0]
        quote = self.quote(at, end)
        moved = [self._all_if_plural(with_place(item.phrase.things(), source)) for item in items]
        return [Move(things=things, place=goal, quote=quote) for things in moved], end

    def _goes_there(self, items: Sequence[Item], at: int) -> tuple[list[Statement], int] | None:
        """Read ``all of the dishes into the sink``: without a verb, what is there goes somewhere."""
        places = items[-1].places
        aimed = any(p.goal and self.text(p.start) in ("into", "onto", "to") for p in places)
        known = all((item.phrase.definite or item.phrase.refers) and not item.is_room for item in items)
        if not aimed or not known:
            return None
        source, goal, _ = self._source_and_goal(places)
        quote = self.quote(at, items[-1].end)
        named = [item.phrase.things() for item in items]
        moved = [self._all_if_plural(things if source == Place() else with_place(things, source)) for things in named]
        return [Move(things=things, place=goal, quote=quote) for things in moved], items[-1].end

    def _is_counted_out(self, item: Item) -> bool:
        """Whether an article or a number asks for so many more: ``two plants for the lobby``."""
        phrase = item.phrase
        first = self.words[phrase.start]
        counted = first.text in ("a", "an") or (first.kind == "number" and phrase.amount.number > 0)
        given = any(self.text(p.start) == "for" for p in item.places)
        return given and counted and phrase.amount.kind == "some" and not phrase.definite and not phrase.refers

    def _all_leave(self, items: Sequence[Item]) -> bool:
        """Whether things without a verb only come out of a room or off furniture: ``all plants out of the hall``."""
        places = items[-1].places
        leaving = bool(places) and places[0].source and not any(p.goal for p in places)
        counted = items[0].phrase.amount.kind in ("all", "all_but", "half", "some")
        return leaving and counted and self.text(places[0].start) in ("out", "off") and not items[0].phrase.refers

    def _each_for_itself(self, items: Sequence[Item], item: Item, quote: str, *, own: bool) -> list[Statement]:
        """Return that one of several things leaves, or is where its own place says."""
        if not own or self._all_leave([item]):
            return [self._removed([item] if own else items, item, (), (), quote)]
        return self._there(item, self._shared_goal([item], item), quote)

    def _is_at_its_place(self, item: Item) -> bool:
        """Whether new things have a place of their own: ``two mugs on the table, the magazine out``."""
        new = not (item.phrase.definite or item.phrase.refers) and item.phrase.amount.kind == "some"
        return new and item.phrase.amount.number > 0 and bool(item.places) and not item.places[0].source

    def _placed_or_out(self, item: Item, items: Sequence[Item], quote: str, *, own: bool) -> list[Statement]:
        """Return that one of several things comes to its own place, or is out as all of them are."""
        if own and self._is_at_its_place(item):
            return self._there(item, self._shared_goal([item], item), quote)
        return [self._removed([item] if own else items, item, (), (), quote)]

    def _comes_in_notes(self, items: Sequence[Item], after: int) -> bool:
        """Whether notes say that new things come in: ``the shelf out, an exam table in``."""
        ends = after >= len(self.words) or self.words[after].kind == "mark" or self.text(after) == "and"
        gone = {"out", "go", "away"} & {word.text for word in self.words[: items[0].phrase.start]}
        return ends and bool(gone) and all(self._is_new(item) for item in items)

    def _is_new(self, item: Item) -> bool:
        phrase = item.phrase
        return not (item.is_room or item.places or phrase.definite or phrase.refers or phrase.noun.unknown)

    def _verbless(self, at: int) -> tuple[list[Statement], int]:
        """Read things with their places and no verb: ``three apples in a bowl on the table``."""
        items = self.items(at)
        if self._is_way(items[0].phrase):
            return self._way(at, items[0].phrase.end)
        end = items[-1].end
        carried = self._carried_over(items, at) or self._goes_there(items, at)
        if carried is not None:
            return carried
        leaving = [self._all_leave([item]) for item in items]
        if self._all_leave(items) or (any(leaving) and all(item.places for item in items)):
            quote = self.quote(at, end)
            own = any(leaving) and not all(leaving)  # "the towels on the rack, the bottle off the sink"
            return [s for item in items for s in self._each_for_itself(items, item, quote, own=own)], end
        out: list[Statement] = []
        found = self._states_after(items, end, at)
        if found is not None:
            return found
        if self.text(end) == "as" and self.text(end + 1) in ("it", "they"):
            return self._leave(at, at)
        if any(item.is_room for item in items):
            raise NotUnderstood(at, self.boundary(at))
        if items[0].phrase.definite and not self.follows and self.text(end) not in ("out", "away", "gone"):
            raise NotUnderstood(at, end)
        if self.text(end) == "in" and self._comes_in_notes(items, end + 1):
            here, quote = Place(rooms=Rooms(same=True)), self.quote(at, end + 1)
            return [Add(things=item.phrase.things(), place=here, quote=quote) for item in items], end + 1
        if self.text(end) in ("out", "away", "gone"):
            quote = self.quote(at, end + 1)
            own = not items[-1].places and any(self._is_at_its_place(item) for item in items[:-1])
            return [s for item in items for s in self._placed_or_out(item, items, quote, own=own)], end + 1
        if not any(item.places for item in items) and self.frame == Place():
            kinds = {item.phrase.amount.kind for item in items}
            if not kinds & {"more", "fewer", "none", "exactly"}:
                raise NotUnderstood(at, end)
        besides: tuple[Things, ...] = ()
        if items[0].phrase.amount.kind == "none":
            end, besides = self.exceptions(end)
        quote = self.quote(at, end)
        out = []
        for item in items:
            if item.phrase.amount.kind == "more" or self._is_counted_out(item):
                out.append(self._added(items, item, quote))
            else:
                out += [_sparing(s, besides) for s in self._there(item, self._shared_goal(items, item), quote)]
        return out, end


def _whole_mass(things: Things) -> Things:
    """Return ``the beer in the fridge`` as all that is there."""
    held = things.place is not None and things.place.anchor is not None and not things.refers
    mass = things.noun.rpartition(" ")[2] in MASSES and things.definite and not things.plural
    if not (held and mass) or things.amount.kind != "some" or things.amount.number:
        return things
    return msgspec.structs.replace(things, amount=Amount(kind="all", number=0), plural=True)


def sparing(statement: SetState | Remove | Paint | Move, besides: tuple[Things, ...]) -> Statement:
    """Return what is done with all of a kind but for exceptions: ``all plants except the one in the study``."""
    noun = statement.things.noun
    besides = tuple(_in_the_kind(one, statement.things.place) for one in besides)
    spared = tuple(msgspec.structs.replace(one, noun=noun) if one.noun in ("", "one") else one for one in besides)
    beside = (*statement.things.beside, *spared)
    return msgspec.structs.replace(statement, things=msgspec.structs.replace(statement.things, beside=beside))


def _in_the_kind(spared: Things, place: Place | None) -> Things:
    """Return an exception in ``room 3`` as one in the third of the rooms that all are of: ``every guest room``."""
    rooms = None if place is None else place.rooms
    own = None if spared.place is None else spared.place.rooms
    if rooms is None or own is None or spared.place is None or not rooms.words or own.floors:
        return spared
    numbers = own.words.removeprefix("room ").split(JOINED + "room ")
    if not own.words.startswith("room ") or not all(number.isdecimal() for number in numbers):
        named = msgspec.structs.replace(own, floors=rooms.floors) if own.words.startswith(rooms.words) else own
    else:
        words = JOINED.join(f"{rooms.words} {number}" for number in numbers)
        named = msgspec.structs.replace(own, words=words, floors=rooms.floors)
    return msgspec.structs.replace(spared, place=msgspec.structs.replace(spared.place, rooms=named))


def of_each_room(statement: Statement) -> Statement:
    """Return what is done with ``the screen in every room but room 3`` as done with all of those."""
    if not isinstance(statement, SetState | Paint | Remove):
        return statement
    things = statement.things
    beside = tuple(_in_the_kind(one, things.place) for one in things.beside)
    things = msgspec.structs.replace(things, beside=beside)
    rooms = None if things.place is None else things.place.rooms
    one = things.definite and not things.plural and things.amount.kind == "some" and things.amount.number <= 1
    every = rooms is not None and rooms.every and one and not things.refers and not things.ordinal
    if every and not isinstance(statement, Remove):
        things = msgspec.structs.replace(things, amount=Amount(kind="all", number=0), plural=True)
    return msgspec.structs.replace(statement, things=things)


def _sparing(statement: Statement, besides: tuple[Things, ...]) -> Statement:
    """Return a removal but for the exceptions: ``no plants upstairs except the one in the study``."""
    return sparing(statement, besides) if isinstance(statement, Remove) and besides else statement

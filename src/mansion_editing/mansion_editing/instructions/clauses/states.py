"""Things that are switched on or off, opened or closed."""

from collections.abc import Sequence

import msgspec

from mansion_editing.instructions.clauses.items import Item, NotUnderstood, joined_places
from mansion_editing.instructions.clauses.outcomes import named_as
from mansion_editing.instructions.clauses.rooms import RoomChanges
from mansion_editing.instructions.clauses.turning import Turning
from mansion_editing.instructions.phrases.places import with_place
from mansion_editing.instructions.phrases.word_sets import BEFORE_STATES
from mansion_editing.instructions.phrases.words import STATE_WORDS
from mansion_editing.instructions.statements import Amount, Ensure, Place, SetState, Statement, Things

__all__ = ["States", "state_set"]


class States(RoomChanges, Turning):
    """Reads states, and the other things that turning means."""

    def _switch(self, at: int, place: int) -> tuple[list[Statement], int]:
        """Read ``turn on the lamp``, ``switch the lamp off``, ``turn the sofa by 90 degrees``."""
        place -= self.text(place - 1) in ("on", "off") and place - 1 > at
        misspelt = self.text(place) == "of" and self.text(place + 1) in ("the", "all", "every", "both")
        if self.text(place) in ("on", "off") or misspelt:
            value = self.text(place) == "on"
            items = self.items(place + 1)
            end, besides = self.exceptions(items[-1].end)
            quote = self.quote(at, end)
            return [self._state_of(items, i, "on", besides, quote, value=value) for i in items], end
        items = self.items(place)
        last = items[-1]
        if (self.text(last.phrase.end), self.text(last.phrase.end + 1)) == ("on", "there"):  # "turn it on there"
            items[-1] = Item(last.phrase, (), last.phrase.end)
        end = items[-1].end
        if self.text(end) in ("on", "off") or (self.text(end) in ("back",) and self.text(end + 1) in ("on", "off")):
            end += self.text(end) == "back"
            value = self.text(end) == "on"
            places, stop = self.places(end + 1)
            stop, besides = self.exceptions(stop)
            quote = self.quote(at, stop)
            out: list[Statement] = []
            for item in items:
                whole = Item(item.phrase, (*item.places, *places), stop)
                out.append(self._state_of([whole], whole, "on", besides, quote, value=value))
            return out, stop
        if (len(items) == 1 and items[0].is_room) or (
            items[0].places and items[0].places[-1].goal and items[0].phrase.noun.kind != "object"
        ):
            return self._furnish(at, place)
        return self._rotate(at, place)

    def _state_of(
        self, items: Sequence[Item], item: Item, state: str, besides: tuple[Things, ...], quote: str, *, value: bool
    ) -> Statement:
        own = item.places or next((other.places for other in items[items.index(item) :] if other.places), ())
        place, _ = self._framed(joined_places(list(own)))
        things = self._in_each_room(item.phrase)
        if item.is_room:
            if self.lexicon.is_short_for_room(item.phrase.noun.words):
                raise NotUnderstood(item.phrase.start, item.end)
            rooms = item.rooms()
            things, place = (
                Things(noun="light", definite=True, plural=True, amount=Amount(kind="all", number=0)),
                Place(rooms=rooms),
            )
        spared = tuple(named_as(one, things.noun) for one in besides)
        things = msgspec.structs.replace(self._all_if_plural(things), beside=spared)
        return state_set(with_place(things, place) if place != Place() else things, state, quote, value=value)

    def _open(self, at: int, place: int) -> tuple[list[Statement], int]:
        return self._set_state(at, place, "open", value=True)

    def _close(self, at: int, place: int) -> tuple[list[Statement], int]:
        return self._set_state(at, place, "open", value=False)

    def _start(self, at: int, place: int) -> tuple[list[Statement], int]:
        return self._set_state(at, place, "on", value=True)

    def _stop(self, at: int, place: int) -> tuple[list[Statement], int]:
        return self._set_state(at, place, "on", value=False)

    def _set_state(self, at: int, place: int, state: str, *, value: bool) -> tuple[list[Statement], int]:
        items = self.items(place)
        end, besides = self.exceptions(items[-1].end)
        quote = self.quote(at, end)
        return [self._state_of(items, item, state, besides, quote, value=value) for item in items], end

    def tells_states(self, at: int) -> bool:
        """Whether things without a verb begin here, of which a state is said: ``TV and lamp both off``."""
        try:
            items = self.items(at)
        except NotUnderstood:
            return False
        return self._states_after(items, items[-1].end, at) is not None

    def _states_after(self, items: Sequence[Item], end: int, at: int) -> tuple[list[Statement], int] | None:
        """Read ``TV on``, ``washing machine and dryer both running`` of things that are there."""
        if len(items) > 1 and (
            any(i.is_room for i in items) or not all(self._are_those_there(i.phrase) for i in items)
        ):
            return None
        found = self._state_after(items[-1], end, at)
        last = found[0][-1] if found is not None and len(found[0]) == 1 else None
        if len(items) == 1 or found is None or not isinstance(last, SetState):
            return found if len(items) == 1 else None
        before = [self._state_of(items, i, last.state, (), last.quote, value=last.value) for i in items[:-1]]
        return [*before, last], found[1]

    def _state_after(self, item: Item, end: int, at: int) -> tuple[list[Statement], int] | None:
        place = end
        while self.text(place) in BEFORE_STATES:
            if self.text(place) == "," and self.text(place + 1) not in (
                "switched",
                "turned",
                "on",
                "off",
                "open",
                "closed",
            ):
                return None
            place += 1
        dark = self.text(place) in ("out", "dark") and self.lexicon.gives_light(item.phrase.noun.words)
        if dark:
            quote = self.quote(at, place + 1)
            where, stop = self.places(place + 1)
            whole = Item(item.phrase, (*item.places, *where), stop)
            return [self._state_of([whole], whole, "on", (), quote, value=False)], stop
        if self.text(place) not in STATE_WORDS:
            return None
        if self.is_preposition(place):
            return None
        state, value = STATE_WORDS[self.text(place)]
        where, stop = self.places(place + 1)
        quote = self.quote(at, stop)
        whole = Item(item.phrase, (*item.places, *where), stop)
        switched = self._state_of([whole], whole, state, (), quote, value=value)
        brought = not self._are_those_there(item.phrase) and item.phrase.amount.kind == "some" and bool(item.places)
        if brought and not item.is_room:
            goal, each = self._framed(item.goal())
            return [Ensure(things=item.phrase.things(), place=goal, each=each, quote=quote), switched], stop
        return [switched], stop


def state_set(things: Things, state: str, quote: str, *, value: bool) -> SetState:
    """Return that things take a state; without a noun whatever can take it is meant."""
    if not things.noun and not things.refers:
        things = msgspec.structs.replace(things, noun="openable" if state == "open" else "switchable")
    return SetState(things=things, state="open" if state == "open" else "on", value=value, quote=quote)

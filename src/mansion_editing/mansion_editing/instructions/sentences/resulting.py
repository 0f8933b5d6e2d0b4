"""States said after a clause of what it moves or adds: ``on the desk, switched on``, ``which stays open``."""

from typing import Final, Literal, TypeAlias

import msgspec

from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.places import with_place
from mansion_editing.instructions.phrases.words import BE, MODALS, STATE_WORDS
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.statements import Add, Amount, Ensure, Move, Place, Replace, SetState, Things

__all__ = ["Resulting"]

_State: TypeAlias = tuple[Literal["open", "on"], bool]

_LIDS: Final = frozenset("lid door cover screen flap".split())
"""Parts by which a thing opens."""

_BEFORE_STATES: Final = frozenset(
    "switched turned powered left kept standing put set both all still also fully wide already then again be".split()
)
_OBLIGED: Final = MODALS | BE | frozenset("to has have need ought".split())
_JOINTS: Final = frozenset(["and", "but", ","])
_OWN: Final = frozenset("the its their both".split())
_AFTER: Final = frozenset("so before until till when while for because since as please again overnight".split())
_IT: Final = Things(amount=Amount(number=0), definite=True, refers="last")


class Resulting(Progress):
    """Reads states after a clause, of what it put somewhere or of what it opened or switched."""

    def _in_state(self, reader: ClauseReader, at: int) -> int:
        """Read a state after a clause; return its end, 0 where none is told."""
        return self._with_lid(reader, at) or self._which_is(reader, at) or self._so_left(reader, at)

    def _so_left(self, reader: ClauseReader, at: int) -> int:
        """Read ``, switched on`` after what is put somewhere, ``and turned on`` after what opens."""
        start = at + (reader.text(at) in _JOINTS)
        start += start > at and reader.text(start) in _JOINTS
        if start == at and reader.words[at].raw not in ("switched", "turned", "powered"):
            return 0
        states, end = _states_at(reader, start)
        last = self.clause[-1] if self.clause else None
        noun = last.things.noun.split() if isinstance(last, Add | Ensure | Move) else []
        if noun and not all(self.lexicon.takes_state(tuple(noun), state) for state, _ in states):
            return 0  # the furniture that it is in, or something else
        return end if states and self._tell(reader, states, start, end) else 0

    def _which_is(self, reader: ClauseReader, at: int) -> int:
        """Read ``, which should be left open``, of the thing or of the furniture that takes such a state."""
        start = at + (reader.text(at) == ",")
        if reader.text(start) not in ("which", "that") or not self.clause:
            return 0
        place = start + 1
        while reader.text(place) in _OBLIGED:
            place += 1
        states, end = _states_at(reader, place)
        last = self.clause[-1]
        if not states or place == start + 1 or not isinstance(last, Add | Ensure | Move):
            return 0
        nouns = [last.things.noun, "" if last.place.anchor is None else last.place.anchor.noun]
        able = [[bool(n) and self.lexicon.takes_state(tuple(n.split()), s) for n in nouns] for s, _ in states]
        if any(all(both) for both in able):
            return 0  # the thing, or what it is in
        return end if self._tell(reader, states, at, end) else 0

    def _with_lid(self, reader: ClauseReader, at: int) -> int:
        """Read ``with the lid open`` and ``, its door shut`` after what is put somewhere."""
        start = at + (reader.text(at) == ",")
        own = start + (reader.text(start) == "with")
        part = own + (reader.text(own) in _OWN)
        named = own > at and reader.text(part) in _LIDS
        states, end = _states_at(reader, part + 1) if named else ([], at)
        if len(states) != 1 or states[0][0] != "open":
            return 0
        last = self.clause[-1] if self.clause else None
        holder = last.place.anchor if isinstance(last, Add | Ensure | Move) and last.place.relation == "in" else None
        if reader.text(part) == "door" and holder is not None and not holder.plural and not holder.each:
            noun = last.things.noun if isinstance(last, Add | Ensure | Move) else ""
            if holder.refers and self.lexicon.takes_state(tuple(noun.split()), "open"):
                return 0  # "it" would mean the thing that was put there
            quote = self._quote(reader.words, start, end)
            whole = last.place.rooms if isinstance(last, Add | Ensure | Move) else None
            things = holder if whole is None else with_place(holder, Place(rooms=whole))
            self.clause = [*self.clause, SetState(things=things, state="open", value=states[0][1], quote=quote)]
            return end
        return end if self._tell(reader, states, at, end) else 0

    def _tell(self, reader: ClauseReader, states: list[_State], at: int, end: int) -> bool:
        """Add states of what the clause is about; return whether it is about something that can be told."""
        quote = self._quote(reader.words, at, end)
        switched = [s for s in self.clause if isinstance(s, SetState)]
        if switched and len(switched) == len(self.clause):
            if any(s.state == state for s in switched for state, _ in states):
                return False
            more = [
                msgspec.structs.replace(s, state=state, value=value, quote=quote)
                for state, value in states
                for s in switched
            ]
            self.clause = [*self.clause, *more]
            return True
        last = self.clause[-1] if self.clause else None
        if not isinstance(last, Add | Ensure | Move | Replace) or len(self.clause) > 1:
            return False
        new = last.by if isinstance(last, Replace) else last.things
        it = msgspec.structs.replace(_IT, plural=new.plural)
        self.clause = [last, *(SetState(things=it, state=s, value=value, quote=quote) for s, value in states)]
        return True


def _states_at(reader: ClauseReader, at: int) -> tuple[list[_State], int]:
    """Read ``open and switched on``, up to the end of a clause; none where something else is said."""
    found: list[_State] = []
    end = at
    while True:
        place = end
        if found and reader.text(place) in _JOINTS:
            place += 1
            place += reader.text(place) in _JOINTS
        while reader.text(place) in _BEFORE_STATES:
            place += 1
        said = STATE_WORDS.get(reader.text(place))
        following = reader.text(place + 1)
        if said is None or following == "there" or (following not in _AFTER and reader.phrase(place + 1) is not None):
            break
        state: _State = ("open" if said[0] == "open" else "on", said[1])
        if any(state[0] == one[0] for one in found):
            return [], at
        found.append(state)
        end = place + 1
    after = reader.text(end)
    ends = end >= len(reader.words) or reader.words[end].kind == "mark" or after in _AFTER
    ends = ends or (after in _JOINTS and reader.starts_clause(end + 1))
    return (found, end) if found and ends else ([], at)

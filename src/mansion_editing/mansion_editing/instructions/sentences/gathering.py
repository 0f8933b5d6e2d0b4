"""What a clause asks for beside what was asked for before: more of it, what stays of it, where it goes on."""

import re
from collections.abc import Iterable

import msgspec

from mansion_editing.instructions.clauses.outcomes import everything_at
from mansion_editing.instructions.clauses.reader import ClauseReader, sparing
from mansion_editing.instructions.sentences.clearing import taken_off
from mansion_editing.instructions.sentences.refinement import (
    adds_it,
    counted_by,
    counts_those_brought,
    exactly,
    goes_as_well,
    goes_while_others_stay,
    is_everything,
    is_only_fetched,
    is_surplus,
    left_where_brought,
    moved_on,
    moves_it,
    only_brings_it,
    placed_at_last,
    removes_all_of_it,
    removes_what_went,
    spared_of,
    surplus_of,
    tells_of_surplus,
    tells_who_may_stay,
)
from mansion_editing.instructions.sentences.tails import Tails
from mansion_editing.instructions.statements import (
    Add,
    Clear,
    Ensure,
    Finish,
    Furnish,
    Keep,
    Mention,
    Move,
    Paint,
    Place,
    Remove,
    Rename,
    Reshape,
    Rooms,
    SetState,
    Statement,
    Things,
)

__all__ = ["Gathering"]


class Gathering(Tails):
    """Takes the statements of clauses in; some only tell more of the last one."""

    def _take(self, found: Iterable[Statement]) -> None:
        """Add statements; what stays is an exception of what is cleared or removed just before."""
        for statement in found:
            last = self.statements[-1] if self.statements else None
            statement = self._but_for_those_spared(statement)
            if isinstance(statement, Keep):
                statement = left_where_brought(statement, last) or self._of_the_kind(statement)
            if isinstance(statement, SetState | Remove | Paint | Move):
                statement = self._those_elsewhere(statement)
            if isinstance(statement, Remove):
                statement, self.statements[:] = taken_off(statement, self.statements, self._reader_of)
                last = self.statements[-1] if self.statements else None
            if _says_again(statement, last):
                continue
            if isinstance(statement, Rename) and statement.room == Rooms(same=True):
                self._rename_it(statement, last)
                continue
            if isinstance(statement, Remove) and isinstance(last, Add | Ensure | Move) and last.things.noun:
                statement = _one_of_its_kind(statement, last.things)
            readers = (self._extends, self._spares, self._moves_on, self._tells_of_rest)
            if not any(reads(statement, last) for reads in readers):
                self.statements += self._room_and_thing(statement)

    def _but_for_those_spared(self, statement: Statement) -> Statement:
        """Return what is done with all but the exception that the sentence began with."""
        if not self.spared or isinstance(statement, Mention):
            return statement
        spared, self.spared = self.spared, ()
        if isinstance(statement, Clear):
            return msgspec.structs.replace(statement, spare=(*statement.spare, *spared))
        whole = isinstance(statement, SetState | Remove | Paint | Move) and (
            statement.things.amount.kind == "all" or statement.things.plural
        )
        if isinstance(statement, SetState | Remove | Paint | Move) and whole:
            return sparing(statement, spared)
        if not self.exception.lower().startswith("not"):  # "not the floor lamp, the table lamp should be on"
            self.unknown.append(f"{self.exception} ({statement.quote})")
        return statement

    def _rename_it(self, statement: Rename, last: Statement | None) -> None:
        """Rename the room of the statement before; after a colon, the name is all that becomes of it."""
        if not isinstance(last, Furnish | Finish | Reshape | Mention) or last.rooms is None:
            self.unknown.append(statement.quote)
            return
        between = self._from_to(last, statement)[len(last.quote) : -len(statement.quote)]
        if isinstance(last, Furnish) and last.kind == statement.name.lower() and between.strip() == ":":
            statement = msgspec.structs.replace(statement, quote=self._from_to(last, statement))
            self.statements.pop()
        self.statements.append(msgspec.structs.replace(statement, room=last.rooms))

    def _room_and_thing(self, statement: Statement) -> list[Statement]:
        """Return what shall be left alone as the thing and the room that are called so: the bar, the kennel."""
        if not isinstance(statement, Keep) or statement.things.place is not None or statement.things.refers:
            return [statement]
        noun = tuple(statement.things.noun.split())
        if not noun or statement.things.plural or not self.lexicon.is_own_room(noun):
            return [statement]
        room = Place(rooms=Rooms(words=statement.things.noun))
        whole = Keep(things=everything_at(room), quote=statement.quote)
        return [statement, whole] if self.lexicon.is_here(statement.things.noun) else [whole]

    def _reader_of(self, quote: str) -> ClauseReader:
        words = self._words_of(quote)
        return ClauseReader(words, self.lexicon, self.floors, lambda a, b: self._quote(words, a, b))

    def _extends(self, statement: Statement, last: Statement | None) -> bool:
        """Read more of what the last statement clears or brings; return whether that is all."""
        if isinstance(last, Clear) and isinstance(statement, Clear) and _is_of_it(statement, last):
            self.statements[-1] = msgspec.structs.replace(last, spare=(*last.spare, *statement.spare))
            return True
        if isinstance(last, Add | Ensure) and isinstance(statement, Ensure) and counts_those_brought(statement, last):
            self.statements[-1] = counted_by(last, statement, self._from_to(last, statement))
            return True
        return False

    def _spares(self, statement: Statement, last: Statement | None) -> bool:
        """Read what stays of what the last statement clears or removes; return whether it does."""
        if isinstance(statement, Keep) and is_everything(statement.things):
            return False
        spared = spared_of(statement) if isinstance(last, Clear) else ()
        if isinstance(last, Clear) and spared:
            self.statements[-1] = msgspec.structs.replace(last, spare=(*last.spare, *spared))
            return True
        if tells_who_may_stay(statement):
            self.unknown.append(statement.quote)  # it is not told where
            return True
        if not isinstance(statement, Keep):
            return False
        alone = not isinstance(last, Clear | Remove) and not statement.things.place
        if alone and re.match(r"(keep|leave) (only|just)\b", statement.quote.lower()):
            self.unknown.append(statement.quote)  # it is not told what all else is
            return True
        only = re.search(r"\b(only|just|nothing but)\b", statement.quote)
        if isinstance(last, Remove) and last.things.noun and only and not self._removed_together()[2:]:
            self.unknown.append(statement.quote)  # more than what was named would have to go
            return True
        if isinstance(last, Remove) and last.things.amount.kind == "all":
            but = msgspec.structs.replace(last.things, beside=(*last.things.beside, statement.things))
            self.statements[-1] = msgspec.structs.replace(last, things=but)
            return True
        return False

    def _moves_on(self, statement: Statement, last: Statement | None) -> bool:
        """Read where what the last statement removes or moves goes; return whether it does."""
        if not isinstance(statement, Move):
            return False
        together = [s for s in self.statements if isinstance(s, Move) and last is not None and s.quote == last.quote]
        onward = moved_on(together, statement) if isinstance(last, Move) else None
        listed = self._removed_together()
        brought = placed_at_last(self.statements, statement)
        if brought:
            quote = self._from_to(brought[0], statement)
            self.statements[-len(brought) :] = [msgspec.structs.replace(new, quote=quote) for new in brought]
        elif onward is not None:
            quote = self._from_to(together[0], statement)
            self.statements[-len(together) :] = [msgspec.structs.replace(move, quote=quote) for move in onward]
        elif len(listed) > 1 and moves_it(statement) and statement.things.plural:
            quote = self._from_to(listed[0], statement)
            moved_all = [Move(things=gone.things, place=statement.place, quote=quote) for gone in listed]
            self.statements[-len(listed) :] = moved_all
        elif isinstance(last, Mention) and self._moves_on_past_remarks(statement):
            return True
        elif (isinstance(last, Remove) or is_only_fetched(last)) and last.things.noun and moves_it(statement):
            moved = Move(things=last.things, place=statement.place, quote=self._from_to(last, statement))
            new = _new_where_none_are(last.things, statement)
            if new is not None:
                self.statements[-1:] = [Mention(quote=last.quote), new]
            elif re.search(r"\b(not|no|No)\b|n't\b", last.quote):  # "we do not need it here: take it to the hall"
                moved = msgspec.structs.replace(moved, quote=statement.quote)
                self.statements[-1:] = [Mention(quote=last.quote), moved]
            else:
                self.statements[-1] = moved
        else:
            return False
        return True

    def _moves_on_past_remarks(self, statement: Move) -> bool:
        """Read where what was taken out goes, also past remarks: ``Get it out. It is loud. It can ...``."""
        at = next((k for k in reversed(range(len(self.statements))) if not isinstance(self.statements[k], Mention)), 0)
        last = self.statements[at]
        if not isinstance(last, Remove) or not last.things.noun or not moves_it(statement) or self.topic is not None:
            return False
        self.statements[at] = Mention(quote=last.quote)
        self.statements.append(msgspec.structs.replace(statement, things=last.things))
        return True

    def _tells_of_rest(self, statement: Statement, last: Statement | None) -> bool:
        """Read what becomes of those beyond the number that shall be; return whether that is said."""
        if isinstance(last, Ensure) and isinstance(statement, Move | Remove) and is_surplus(statement, last):
            rest = surplus_of(last, statement.things)
            self.statements[-1] = msgspec.structs.replace(statement, things=rest)
            return True
        shared = goes_while_others_stay(statement, last)
        if shared is not None:
            self.statements[-1] = shared
            return True
        if goes_as_well(statement, last):
            self.unknown.append(statement.quote)  # another one, or the same one further on
            return True
        if tells_of_surplus(statement):
            self.undecided = True
            self.unknown.append(statement.quote)  # it is not told how many shall be there
            return True
        if isinstance(last, Ensure) and isinstance(statement, Remove) and statement.things.refers == "others":
            self.statements[-1] = msgspec.structs.replace(exactly(last), quote=self._from_to(last, statement))
            return True
        return False

    def _removed_together(self) -> list[Remove]:
        """Return the removals of several things that the last clause asked for."""
        last = self.statements[-1] if self.statements else None
        if not isinstance(last, Remove):
            return []
        return [s for s in self.statements if isinstance(s, Remove) and s.quote == last.quote and s.things.noun]

    def _of_the_kind(self, keep: Keep) -> Keep:
        """Return ``those in the corridor`` as things of the kind that was mentioned before."""
        things = keep.things
        before = next((getattr(s, "things", None) for s in reversed(self.statements) if hasattr(s, "things")), None)
        bare = things.noun == "one" or (things.refers == "last" and not things.noun)
        last = self.statements[-1] if self.statements else None
        if bare and things.place is None and isinstance(last, Move) and last.place.rooms is not None:
            things = msgspec.structs.replace(things, place=Place(rooms=last.place.rooms))  # "the one already up there"
        if not bare or things.place is None or not isinstance(before, Things) or not before.noun:
            return keep
        named = msgspec.structs.replace(things, noun=before.noun, refers="", definite=True, plural=True)
        return msgspec.structs.replace(keep, things=named)

    def _those_elsewhere(self, statement: SetState | Remove | Paint | Move) -> SetState | Remove | Paint | Move:
        """Return ``those in the study`` as things of the kind that was named before: ``the lights here off, ...``."""
        things = statement.things
        rooms = None if things.place is None else things.place.rooms
        bare = things.refers == "last" and not things.noun and things.plural and not things.amount.number
        if not bare or rooms is None or not rooms.words or not re.search(r"\bthose\b", statement.quote.lower()):
            return statement
        told = (getattr(before, "things", None) for before in reversed(self.statements))
        noun = next((before.noun for before in told if isinstance(before, Things) and before.noun), "")
        named = things if not noun else msgspec.structs.replace(things, noun=noun, refers="")
        return msgspec.structs.replace(statement, things=named)


def _one_of_its_kind(statement: Remove, named: Things) -> Remove:
    """Return ``one in the hall`` as one of the kind that was just named: ``two benches here, one in the hall goes``."""
    things = statement.things
    bare = things.refers == "last" and not things.noun and not things.definite and not things.amount.of
    elsewhere = things.place is not None and things.place.rooms is not None and bool(things.place.rooms.words)
    if not bare or not elsewhere or things.amount.kind != "some" or not things.amount.number:
        return statement
    return msgspec.structs.replace(statement, things=msgspec.structs.replace(things, noun=named.noun, refers=""))


def _says_again(statement: Statement, last: Statement | None) -> bool:
    """Whether a statement only says once more what the last one asks for: ``add a door and put it in``."""
    if isinstance(last, Clear):
        return removes_all_of_it(statement)
    if isinstance(last, Reshape):
        return last.what == "door" and adds_it(statement)
    if isinstance(last, Remove):
        return removes_what_went(statement)
    return isinstance(last, Add | Ensure | Move) and isinstance(statement, Move) and only_brings_it(statement)


def _is_of_it(statement: Clear, last: Clear) -> bool:
    """Whether a clearing only tells what stays of the one before: ``clear the desk, keep only the lamp on it``."""
    return _is_at_it(statement.place) and bool(statement.spare) and last.place.anchor is not None


def _is_at_it(place: Place) -> bool:
    return place.anchor is not None and place.anchor.refers == "last" and not place.anchor.noun


def _new_where_none_are(none: Things, statement: Move) -> Add | None:
    """Return ``put three on the bed`` after ``no towels`` as three new ones; None where those that are there move."""
    amount = statement.things.amount
    counted = amount.kind == "some" and amount.number > 0 and not statement.things.definite
    if none.amount.kind != "all" or none.definite or not counted:
        return None
    new = msgspec.structs.replace(none, amount=amount, plural=amount.number > 1, place=None)
    return Add(things=new, place=statement.place, quote=statement.quote)

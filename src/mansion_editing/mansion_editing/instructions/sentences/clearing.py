"""What leaves furniture that is cleared or wiped: ``Clear the bench, the toolbox that lies on it goes to a shelf``."""

import re
from collections.abc import Callable, Sequence
from typing import Any, Final

import msgspec

from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.places import with_place
from mansion_editing.instructions.sentences.refinement import removes_what_went
from mansion_editing.instructions.statements import Add, Clear, Ensure, Mention, Move, Place, Remove, Statement, Things

__all__ = ["taken_off", "with_takings_first"]


def with_takings_first(statements: Sequence[Statement], lexicon: Lexicon) -> list[Statement]:
    """Return statements in which what goes elsewhere leaves furniture before the rest of what is there is removed.

    An instruction names the clearing first, but what it then moves is what stands there, and not a new thing of its
    kind. ``It`` in the words for what is moved is the furniture that is cleared; other words are looked up in its room
    first, as they would be after the clearing.
    """
    out: list[Statement] = []
    at = 0
    while at < len(statements):
        emptied = _emptied(statements[at])
        end = at + 1
        while emptied is not None and end < len(statements) and _leaves(statements[end], emptied, lexicon):
            end += 1
        taken = [] if emptied is None else _from_there(statements[at + 1 : end], emptied)
        out += [*taken, statements[at], *(s for s in statements[at + 1 : end] if isinstance(s, Mention))]
        at = end
    return out


def _emptied(statement: Statement) -> Place | None:
    """Return the furniture that a statement leaves nothing on or in; None for others."""
    place = statement.place if isinstance(statement, Clear) else None
    if isinstance(statement, Remove) and not statement.things.noun and statement.things.amount.kind == "all":
        place = statement.things.place
    if place is None or place.anchor is None or place.anchor.refers or place.outside or not place.anchor.noun:
        return None
    return place


def _leaves(statement: Statement, emptied: Place, lexicon: Lexicon) -> bool:
    """Whether a statement moves single things to another place, or asks for nothing."""
    if isinstance(statement, Mention):
        return not statement.rooms
    if not isinstance(statement, Move) or not (statement.things.noun or _is_all_of_it(statement.things)):
        return False
    if lexicon.stands(tuple(statement.things.noun.split())):
        return False
    anchor = statement.place.anchor
    return anchor is None or not (anchor.refers or anchor == emptied.anchor)


def _from_there(statements: Sequence[Statement], emptied: Place) -> list[Statement]:
    moves = [statement for statement in statements if isinstance(statement, Move)]
    referring = {move.quote for move in moves if _is_on_it(move.things)}
    where = emptied.rooms
    out: list[Statement] = [Mention(rooms=where)] if moves and where is not None and not where.same else []
    for move in moves:
        things = move.things
        if _is_all_of_it(things) or _is_on_it(things) or (things.place is None and move.quote in referring):
            things = msgspec.structs.replace(things, place=emptied)
            move = msgspec.structs.replace(move, things=things, or_new=False)
        out.append(move)
    return out


def _is_all_of_it(things: Things) -> bool:
    """Whether words mean all that was there: ``everything in it``, ``all of it``."""
    bare = not things.noun and not things.refers and not things.beside and things.amount.kind == "all"
    return bare and (things.place is None or _is_on_it(things))


def _is_on_it(things: Things) -> bool:
    """Whether things are on, in or at what was mentioned last, and no more is said of where."""
    place: Any = things.place
    anchor = None if place is None else place.anchor
    return anchor is not None and anchor.refers == "last" and not anchor.noun and place.rooms is None


_OFF: Final = re.compile(r"\b(?:take|taken|get|lift|clear)\b.*\boff\W*$", re.IGNORECASE)


def taken_off(
    statement: Remove, before: Sequence[Statement], reader_of: Callable[[str], ClauseReader]
) -> tuple[Remove, list[Statement]]:
    """Return a removal, and the statements before it, as of things on the furniture that was mentioned last.

    Parameters
    ----------
    reader_of : callable
        Returns a reader of the words of a quote.
    """
    gone = [at for at in range(len(before)) if all(isinstance(other, Remove) for other in before[at:])]
    holder = _holder_told(before[: gone[0]] if gone else before, reader_of)
    if holder is None or not _OFF.search(statement.quote):
        return statement, list(before)
    if not removes_what_went(statement):
        return _off(statement, holder), list(before)
    named = [
        _off(other, holder) if isinstance(other, Remove) and at in gone else other for at, other in enumerate(before)
    ]
    return statement, named


def _off(statement: Remove, holder: Place) -> Remove:
    things = statement.things
    if things.place is not None or things.refers or not things.noun:
        return statement
    return msgspec.structs.replace(statement, things=with_place(things, holder))


def _holder_told(before: Sequence[Statement], reader_of: Callable[[str], ClauseReader]) -> Place | None:
    """Return the place on the furniture that the last statement is about; None where it is about none."""
    last = before[-1] if before else None
    if isinstance(last, Add | Ensure | Move | Clear):
        on_it = last.place.relation == "on" and last.place.anchor is not None and not last.place.anchor.refers
        return last.place if on_it else None
    if not isinstance(last, Mention):
        return None
    reader = reader_of(last.quote)
    found = [item for at in range(len(reader.words)) if (item := reader.item(at)) is not None]
    held = [item for item in found if item.phrase.definite and reader.lexicon.carries(item.phrase.noun.words)]
    holder: Things | None = held[0].things() if held else None
    if holder is None or holder.refers or not reader.lexicon.stands(held[0].phrase.noun.words):
        return None
    rooms = None if holder.place is None else holder.place.rooms
    return Place(relation="on", anchor=msgspec.structs.replace(holder, place=None), rooms=rooms)

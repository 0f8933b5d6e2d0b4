"""What is taken off, where only the sentence before tells what it lies on: ``wipe the table, take the bowl off``."""

import re
from collections.abc import Callable, Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.places import with_place
from mansion_editing.instructions.sentences.refinement import removes_what_went
from mansion_editing.instructions.statements import Add, Clear, Ensure, Mention, Move, Place, Remove, Statement, Things

__all__ = ["taken_off"]

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

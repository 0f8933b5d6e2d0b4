"""Nouns without an article, as notes have them: ``crash cart next to the bed`` means the one in the room."""

import re
from typing import Final

import msgspec

from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import anchors_of, is_at, things_of
from mansion_editing.instructions.statements import Add, Ensure, Instruction, Move, Place, Rooms, Statement, Things
from mansion_editing.state import SceneState
from mansion_msgs_py.errors import MansionError

__all__ = ["with_existing_things"]

_NEW: Final = re.compile(r"\b(a|an|one|1|another|some|new|more|extra|add|bring|get|buy|give|provide|need|want)\b", re.I)
"""What says that a thing is brought, and not the one that is there."""
_INTO: Final = re.compile(r"\b(into|over to|across to) (the|our|my|[a-z]+)\b", re.I)
"""What says that a thing goes from somewhere to a room."""


def with_existing_things(instruction: Instruction, state: SceneState, context: Context) -> Instruction:
    """Return an instruction in which the only thing of its kind in a room is moved, and no second one is brought.

    Notes
    -----
    That holds for one thing without an article beside, on or in a thing of the room: "put medical screen between the
    stretcher and the bed". Where the room has none or several, a new one is brought.
    """
    statements = [_meant(statement, state, context) for statement in instruction.statements]
    return msgspec.structs.replace(instruction, statements=statements)


def _meant(statement: Statement, state: SceneState, context: Context) -> Statement:
    if not isinstance(statement, Add | Ensure) or statement.each or not _is_bare(statement.things, statement.quote):
        return statement
    place = statement.place
    if place.anchor is None and place.rooms is not None and _INTO.search(statement.quote):
        return _moved_into(statement, state, context)
    if place.anchor is None or place.anchor.plural or not _is_known(place.anchor, statement.quote):
        return statement
    try:
        rooms = {anchor.room for anchor in anchors_of(state, place, context)}
        if len(rooms) != 1:
            return statement
        things = msgspec.structs.replace(statement.things, definite=True, place=Place(rooms=Rooms(words=rooms.pop())))
        found = things_of(state, things, context)
    except MansionError:
        return statement
    if len(found) != 1 or is_at(state, found[0], place, context):
        return statement
    return Move(quote=statement.quote, things=things, place=place)


def _moved_into(statement: Add | Ensure, state: SceneState, context: Context) -> Statement:
    """Return ``cart into the corridor`` as a move, where the building has one cart, and that is elsewhere."""
    things = msgspec.structs.replace(statement.things, definite=True)
    try:
        found = things_of(state, things, context)
        elsewhere = len(found) == 1 and not is_at(state, found[0], statement.place, context)
    except MansionError:
        return statement
    return Move(quote=statement.quote, things=things, place=statement.place) if elsewhere else statement


def _is_known(anchor: Things, quote: str) -> bool:
    """Whether a mark is one that is there: named with ``the``, or without an article as in notes."""
    new = rf"\b(a|an|any|another|some|one) ([\w'-]+ ){{0,3}}{re.escape(anchor.noun)}\b"
    return anchor.definite or (bool(anchor.noun) and re.search(new, quote, re.IGNORECASE) is None)


def _is_bare(things: Things, quote: str) -> bool:
    """Whether one thing is named without an article, and nothing says that it is new."""
    plain = not (things.definite or things.plural or things.refers or things.owned or things.place)
    one = things.amount.kind == "some" and things.amount.number == 1
    if not things.noun:
        return False
    before = quote.lower().partition(things.noun.lower())[0]
    return plain and one and len(before) < len(quote) and _NEW.search(before) is None

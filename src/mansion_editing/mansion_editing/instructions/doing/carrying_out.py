"""Carry out statements with the editor's tools, one at a time, and say what was there and what changed."""

from collections.abc import Callable, Generator
from dataclasses import replace
from typing import Any, Final

from mansion_editing.instructions.doing.answering import answer
from mansion_editing.instructions.doing.changing import paint, reach, set_state
from mansion_editing.instructions.doing.exact_moves import shift
from mansion_editing.instructions.doing.moving import move, swap, turn
from mansion_editing.instructions.doing.providing import add, ensure, replace_things
from mansion_editing.instructions.doing.removing import clear, remove
from mansion_editing.instructions.doing.rooms import finish, furnish_rooms, rename, reshape
from mansion_editing.instructions.doing.work import Done, Work, listed
from mansion_editing.instructions.meaning.choices import things_meant
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import rooms_of, things_of
from mansion_editing.instructions.meaning.doors import means_doors
from mansion_editing.instructions.meaning.wording import place_words, thing_words
from mansion_editing.instructions.statements import (
    Add,
    Ask,
    Clear,
    Ensure,
    Finish,
    Forbid,
    Furnish,
    Keep,
    Mention,
    Move,
    Paint,
    Reach,
    Remove,
    Rename,
    Replace,
    Reshape,
    SetState,
    Shift,
    Statement,
    Swap,
    Things,
    Turn,
)
from mansion_editing.runs.policies import Action, Outcome, Unmet
from mansion_editing.state import SceneState

__all__ = ["carry"]

_WORK: Final[dict[type[Any], Callable[[Any, SceneState, Context], Work]]] = {
    Add: add,
    Ensure: ensure,
    Remove: remove,
    Clear: clear,
    Move: move,
    Shift: shift,
    Swap: swap,
    Replace: replace_things,
    SetState: set_state,
    Paint: paint,
    Turn: turn,
    Reach: reach,
    Rename: rename,
    Finish: finish,
    Furnish: furnish_rooms,
    Reshape: reshape,
}


def carry(statement: Statement, state: SceneState, context: Context) -> Generator[Action, Outcome, Done]:
    """Carry out one statement.

    Raises
    ------
    Unmet, MansionError
        Where it cannot be, with the reason.
    """
    work = _WORK.get(type(statement))
    if work is not None:
        return (yield from work(statement, state, context))
    if isinstance(statement, Ask):
        return answer(statement, state, context)
    if isinstance(statement, Keep):
        if means_doors(statement.things):
            return Done("", context)  # no other statement may change a door that it does not mean
        if _is_bare(statement.things, state, context):
            return Done("nothing to leave as it was", context)
        if statement.things.refers == "others" and not things_of(state, statement.things, context):
            return Done("nothing else to leave as it was", context)
        kept = things_meant(state, statement.things, replace(context, kept=frozenset()))
        rooms = tuple(dict.fromkeys(item.room for item in kept))
        reply = f"{listed(kept)} left as {'it was' if len(kept) == 1 else 'they were'}"
        return Done(reply, context.followed([item.id for item in kept], rooms, statement.things.noun))
    if isinstance(statement, Forbid):
        rooms = () if statement.place.rooms is None else tuple(rooms_of(state, statement.place.rooms, context))
        reply = f"no {thing_words(statement.things)} added {place_words(statement.place)}".rstrip()
        return Done(reply, context.followed((), rooms, "") if len(rooms) == 1 else context)
    if isinstance(statement, Mention):
        rooms = () if statement.rooms is None else tuple(rooms_of(state, statement.rooms, context))
        return Done("", context.followed((), rooms if len(rooms) == 1 else (), ""))
    raise Unmet("an earlier instruction is taken back, or done again, in an instruction of its own")


def _is_bare(things: Things, state: SceneState, context: Context) -> bool:
    """Whether all that is in a room of the building is meant, and nothing is."""
    rooms = None if things.place is None or things.place.anchor is not None else things.place.rooms
    if things.noun or things.refers or rooms is None or not rooms_of(state, rooms, context):
        return False
    return not things_of(state, things, replace(context, kept=frozenset()))

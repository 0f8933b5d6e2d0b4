"""Move of several things next to each other: the first stays, each further one goes beside those before it."""

from collections.abc import Sequence

import msgspec

from mansion_editing.instructions.doing.work import Done, Work, listed, live
from mansion_editing.instructions.meaning.choices import things_meant
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.wording import thing_words
from mansion_editing.instructions.statements import Move, Place
from mansion_editing.runs.policies import Action, Unmet
from mansion_editing.state import SceneState
from mansion_editing.tools.relations import relation_holds
from mansion_msgs_py.scene import SceneObject

__all__ = ["are_together", "gather", "gathered"]


def gather(statement: Move, state: SceneState, context: Context) -> Work:
    """Bring things that are in one room next to each other."""
    items = gathered(statement, state, context)
    rooms = tuple(dict.fromkeys(item.room for item in items))
    if len(items) < 2 or len(rooms) > 1:
        raise Unmet(f"{listed(items)}: say which {thing_words(statement.things)} of one room shall be together")
    moved: list[str] = []
    for number, item in enumerate(items[1:], start=1):
        before = live(state, [one.id for one in items[:number]])
        if _is_by_one(state, item, before):
            continue
        reason = ""
        for mark in before:
            arguments = {"object_id": item.id, "near": mark.id, "side": "beside"}
            answer = yield Action(f"{item.id} should be beside {mark.id}.", "MoveObject", arguments)
            if answer.error is None:
                moved.append(item.id)
                break
            reason = reason or answer.error.info.message
        else:
            raise Unmet(reason)
    reply = f"{listed(moved)} moved next to the others" if moved else f"{listed(items)} are together already"
    return Done(reply, context.followed([item.id for item in items], rooms, statement.things.noun))


def gathered(statement: Move, state: SceneState, context: Context) -> list[SceneObject]:
    """Return the things that shall be together; a room that the sentence names is where they are.

    Raises
    ------
    MansionError, Ambiguous
        As `things_meant`.
    """
    things, rooms = statement.things, statement.place.rooms
    if rooms is not None and things.place is None:
        things = msgspec.structs.replace(things, place=Place(rooms=rooms))
    return things_meant(state, things, context)


def are_together(state: SceneState, items: Sequence[SceneObject]) -> bool:
    """Whether each of some things is beside another of them."""
    return len(items) > 1 and all(_is_by_one(state, item, items) for item in items)


def _is_by_one(state: SceneState, item: SceneObject, others: Sequence[SceneObject]) -> bool:
    return any(
        other.id != item.id and other.room == item.room and relation_holds(state, item, "beside", other.id)
        for other in others
    )

"""Shift, and Move to where another thing stood: things go to exact positions on their floor."""

import math
from typing import Final

from mansion_editing.instructions.doing.work import Done, Work, live, whereabouts
from mansion_editing.instructions.meaning.choices import things_meant
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.directions import direction_of
from mansion_editing.instructions.meaning.vacated import vacated_by
from mansion_editing.instructions.statements import Move, Shift
from mansion_editing.runs.policies import Action, Unmet
from mansion_editing.state import SceneState

__all__ = ["move_to_former_spot", "shift"]


def shift(statement: Shift, state: SceneState, context: Context) -> Work:
    """Move things by a length; what stands in the way is not moved."""
    items = things_meant(state, statement.things, context)
    replies = []
    for item in items:
        dx, dy = direction_of(statement, item, state, context)
        x, y = (round(at + statement.metres * d, 4) for at, d in zip(item.position[:2], (dx, dy), strict=True))
        arguments = {"object_id": item.id, "x": x, "y": y, "rotation": item.rotation}
        answer = yield Action(f"{item.id} should move by {statement.metres:g} m.", "MoveObject", arguments)
        if answer.error is not None:
            raise Unmet(answer.error.info.message)
        (now,) = live(state, [item.id])
        went = math.dist(item.position[:2], now.position[:2])
        replies.append(f"{item.id} moved by {went:.2f} m to the {_compass(dx, dy)}")
    rooms = tuple(dict.fromkeys(item.room for item in items))
    return Done("; ".join(replies), context.followed([i.id for i in items], rooms, statement.things.noun))


def _compass(dx: float, dy: float) -> str:
    names = ("east", "north-east", "north", "north-west", "west", "south-west", "south", "south-east")
    return names[round(math.degrees(math.atan2(dy, dx)) / 45.0) % 8]


_TURNS: Final = (0.0, 90.0, 180.0, 270.0)


def move_to_former_spot(statement: Move, state: SceneState, context: Context) -> Work:
    """Bring one thing to where another one stood, turned as that was where there is room.

    Raises
    ------
    Unmet
        Where several things are meant, or it does not fit there.
    """
    assert statement.place.former is not None
    old = vacated_by(state, statement.place.former, context)
    items = things_meant(state, statement.things, context)
    if len(items) != 1:
        raise Unmet(f"only one thing can go where {old.id} stood")
    item, where = items[0], whereabouts(items[0]).removeprefix("in ")
    name, known = item.id, {other.id for _, other in state.objects()}
    holder = old.parent if old.parent is not None and live(state, [old.parent]) else old.room
    if item.parent != old.parent or item.room != old.room:
        arguments = {"object_id": item.id, "receptacle_id": holder}
        answer = yield Action(f"{item.id} goes where {old.id} was.", "MoveObject", arguments)
        if answer.error is not None:
            raise Unmet(answer.error.info.message)
        name = next((new for new in answer.value.object_ids if new not in known), item.id)
    reasons = []
    for turn in _TURNS:
        x, y, _ = old.position
        where_it_was = {"object_id": name, "x": x, "y": y, "rotation": round((old.rotation + turn) % 360.0, 4)}
        answer = yield Action(f"{name} should stand where {old.id} was.", "MoveObject", where_it_was)
        if answer.error is None:
            (now,) = live(state, [name])
            reply = f"{item.id} moved from {where} to where {old.id} was, {whereabouts(now)}"
            return Done(reply, context.followed([name], (now.room,), statement.things.noun))
        reasons.append(answer.error.info.message)
    raise Unmet(reasons[0])

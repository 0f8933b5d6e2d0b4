"""Shift: things move so many metres where they stand."""

import math

from mansion_editing.instructions.doing.work import Done, Work, live
from mansion_editing.instructions.meaning.choices import things_meant
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.directions import direction_of
from mansion_editing.instructions.statements import Shift
from mansion_editing.runs.policies import Action, Unmet
from mansion_editing.state import SceneState

__all__ = ["shift"]


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

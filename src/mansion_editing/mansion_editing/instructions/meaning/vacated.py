"""Where something stood that went away in the course of an instruction."""

import math
from typing import Final

from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.nouns import called
from mansion_editing.instructions.statements import Things
from mansion_editing.state import SceneState
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneObject

__all__ = ["stands_where", "vacated_by", "went_away"]

_NEAR: Final = 0.5
"""Metres from the middle of what stood there within which something stands in its place."""


def went_away(before: SceneState, after: SceneState) -> tuple[SceneObject, ...]:
    """Return what is no longer where it was, as it stood; what stood by itself first."""
    gone = []
    for _, item in before.objects():
        now = after.find(item.id)
        if now is None or now[1].position != item.position or now[1].room != item.room:
            gone.append(item)
    return tuple(sorted(gone, key=lambda item: (item.parent is not None, item.id)))


def vacated_by(state: SceneState, things: Things, context: Context) -> SceneObject:
    """Return what stood at a place that is told by it, as it stood.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` where no such thing went away before, or several did.
    """
    gone = list(context.vacated)
    meant = [item for item in gone if item.id in context.things] or gone
    if things.noun:
        meant = called(state, gone, things.noun)
    elif len(meant) > 1:
        meant = [item for item in meant if item.parent is None] or meant
    if len(meant) != 1:
        what = things.noun or "thing"
        reason = f"no {what} went away before" if not meant else f"more than one {what} went away before"
        raise MansionError(ErrorCode.NOT_FOUND, f"{reason}; say where it shall go")
    return meant[0]


def stands_where(item: SceneObject, old: SceneObject) -> bool:
    """Whether a thing stands, lies or hangs where another one did."""
    return item.room == old.room and math.dist(item.position[:2], old.position[:2]) <= _NEAR

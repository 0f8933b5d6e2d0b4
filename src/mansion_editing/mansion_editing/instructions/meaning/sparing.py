"""What stays of what is cleared: all that words fit, or as many as they say."""

from collections.abc import Sequence

from mansion_editing.instructions.meaning.context import Context, ambiguous
from mansion_editing.instructions.meaning.descriptions import things_of
from mansion_editing.instructions.meaning.nouns import is_loose
from mansion_editing.instructions.meaning.wording import bare_words, counted, thing_words, title_of
from mansion_editing.instructions.statements import Clear, Things
from mansion_editing.state import SceneState
from mansion_knowledge.object_kinds import is_fixed
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneObject

__all__ = ["is_movable", "spared_among", "spares_furniture"]


def spared_among(
    state: SceneState, spare: Sequence[Things], there: Sequence[SceneObject], context: Context
) -> set[str]:
    """Return the ids of what stays of some things: ``only one magazine`` is the first of them.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` where there are fewer than the words have.
    Ambiguous
        Where words for certain things fit more.
    """
    ids = {item.id for item in there}
    out: set[str] = set()
    for things in spare:
        found = things_of(state, things, context)
        near = [item for item in found if item.id in ids]
        number = 0 if things.amount.kind == "all" else things.amount.number
        if number > len(near):
            message = (
                f"there {'is' if len(near) == 1 else 'are'} {counted(len(near), bare_words(things))}, not {number}"
            )
            raise MansionError(ErrorCode.INFEASIBLE, message)
        if things.definite and 0 < number < len(near):
            raise ambiguous(thing_words(things), [title_of(state, item) for item in near], [i.id for i in near])
        out |= {item.id for item in (near[:number] if number else found)}
    return out


def spares_furniture(state: SceneState, statement: Clear, context: Context) -> bool:
    """Whether a room shall be cleared but for furniture, so that other furniture goes too."""
    place = statement.place
    if place.anchor is not None or place.rooms is None:
        return False
    spared = (item for things in statement.spare for item in things_of(state, things, context))
    return any(item.mount == "floor" and not is_loose(item) for item in spared)


def is_movable(item: SceneObject) -> bool:
    """Whether an object stands on the floor and is not built in."""
    return item.mount == "floor" and not is_fixed(item.category)

"""What carrying out one statement yields and ends with, and the words of its reply."""

from collections.abc import Generator, Iterable, Sequence
from dataclasses import dataclass
from typing import TypeAlias

from mansion_editing.instructions.meaning.context import Context
from mansion_editing.runs.policies import Action, Outcome
from mansion_editing.state import SceneState
from mansion_msgs_py.scene import SceneObject

__all__ = ["Done", "Work", "listed", "live", "whereabouts"]


@dataclass(frozen=True)
class Done:
    """How a statement ended.

    Attributes
    ----------
    reply : str
        What was there and what became of it; empty where there is nothing to say.
    context : Context
        What the next statement may refer to.
    """

    reply: str
    context: Context


Work: TypeAlias = Generator[Action, Outcome, Done]
"""Yields calls of tools; raises `Unmet` or `MansionError` where the statement cannot be carried out."""


def listed(items: Sequence[SceneObject] | Sequence[str]) -> str:
    """Return ids in a row, a dozen at most."""
    names = [item if isinstance(item, str) else item.id for item in items]
    return ", ".join(names[:12]) + (f" and {len(names) - 12} more" if len(names) > 12 else "")


def live(state: SceneState, ids: Iterable[str]) -> list[SceneObject]:
    """Return the objects of these ids that are still there."""
    found = [state.find(name) for name in ids]
    return [pair[1] for pair in found if pair is not None]


def whereabouts(item: SceneObject) -> str:
    """Return where an object is: on, in or under what, and in which room."""
    if item.parent is not None:
        relation = {"inside": "in", "floor": "under"}.get(item.mount, "on")
        return f"{relation} {item.parent}"
    hangs = {"wall": "on a wall in ", "ceiling": "on the ceiling in "}.get(item.mount, "in ")
    return f"{hangs}{item.room}"

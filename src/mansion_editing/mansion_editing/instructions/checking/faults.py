"""Whether an instruction holds on the finished scene, read anew from its statements, apart from how it was done.

Each statement is looked up in the scene before and the scene after it. What differs between the two must be what the
statement asks for, or follow from it (what furniture carries, a small thing that made room); anything else is a fault.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any, Final

import msgspec

from mansion_editing.instructions.checking.changes import check_paint, check_reach, check_rooms, check_state
from mansion_editing.instructions.checking.differences import Differences, differences
from mansion_editing.instructions.checking.finding import Finding
from mansion_editing.instructions.checking.numbers import (
    check_add,
    check_clear,
    check_ensure,
    check_remove,
    check_replace,
)
from mansion_editing.instructions.checking.places import check_move, check_shift, check_swap, check_turn
from mansion_editing.instructions.doing.work import listed
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import all_at, rooms_of, things_of
from mansion_editing.instructions.meaning.wording import thing_words
from mansion_editing.instructions.statements import (
    Add,
    Clear,
    Ensure,
    Finish,
    Forbid,
    Furnish,
    Keep,
    Mention,
    Move,
    Paint,
    Place,
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
from mansion_editing.state import SceneState
from mansion_msgs_py.scene import SceneObject

__all__ = ["Step", "fault", "faults", "faults_together", "moved_aside"]


@dataclass(frozen=True)
class Step:
    """A statement with what it could refer to, and the building before and after it was carried out."""

    statement: Statement
    context: Context
    before: SceneState
    after: SceneState


def faults(steps: Sequence[Step]) -> list[str]:
    """Return what does not hold of an instruction whose statements were carried out in turn, empty for nothing."""
    out = []
    for step in steps:
        found = fault(step.statement, step.before, step.after, step.context)
        if found:
            out.append(f"{step.statement.quote or type(step.statement).__name__}: {found}")
    if steps:
        first, last = steps[0].before, steps[-1].after
        for step in steps:
            found = _lasting(step.statement, first, last, step.context)
            if found:
                out.append(f"{step.statement.quote or type(step.statement).__name__}: {found}")
    return list(dict.fromkeys(out))


def fault(statement: Statement, before: SceneState, after: SceneState, context: Context) -> str:
    """Return why a statement does not hold, or what else was changed; empty when it holds and nothing else was.

    Parameters
    ----------
    before, after : SceneState
        The building before and after the statement was carried out.
    """
    diff = differences(before, after)
    finding = _finding(statement, before, after, context, diff)
    if finding.fault:
        return finding.fault
    rest = sorted(diff.ids - finding.accounted)
    if finding.makes_room:
        aside, most = _aside(diff, finding), max(1, len(diff.added))
        left = [name for name in aside if diff.moved[name][0].parent != diff.moved[name][1].parent]
        few = len(left) <= most and len(aside) <= _MOST_ASIDE * most
        rest = [name for name in rest if name not in aside] if few else rest
    if rest:
        return f"{listed(rest)} changed besides what was asked for"
    others = sorted(diff.rooms - finding.rooms)
    return f"{', '.join(others)} changed besides what was asked for" if others else ""


def faults_together(
    statements: Sequence[Statement], before: SceneState, after: SceneState, context: Context
) -> list[str]:
    """Return what does not hold of statements made true in no certain order, and what none of them accounts for.

    Parameters
    ----------
    before, after : SceneState
        The building before and after all that was done.
    """
    diff = differences(before, after)
    findings = [_finding(statement, before, after, context, diff) for statement in statements]
    out = [finding.fault for finding in findings if finding.fault]
    accounted = {name for finding in findings for name in finding.accounted}
    rest = [*sorted(diff.ids - accounted), *sorted(diff.rooms - {name for f in findings for name in f.rooms})]
    return [*out, f"{listed(rest)} changed besides what was asked for"] if rest else out


def _finding(
    statement: Statement, before: SceneState, after: SceneState, context: Context, diff: Differences
) -> Finding:
    check = _CHECKS.get(type(statement))
    return Finding() if check is None else check(statement, before, after, context, diff)


_CHECKS: Final[dict[type[Any], Callable[[Any, SceneState, SceneState, Context, Differences], Finding]]] = {
    Add: check_add,
    Ensure: check_ensure,
    Remove: check_remove,
    Clear: check_clear,
    Replace: check_replace,
    Move: check_move,
    Shift: check_shift,
    Swap: check_swap,
    Turn: check_turn,
    SetState: check_state,
    Paint: check_paint,
    Reach: check_reach,
    Rename: check_rooms,
    Finish: check_rooms,
    Furnish: check_rooms,
    Reshape: check_rooms,
}


_MOST_ASIDE: Final = 3
"""How many things may move aside for a new one; only one of them may leave what it lies on."""


def _aside(diff: Differences, finding: Finding) -> list[str]:
    """Return the small things that were moved within their room and are not what the statement is about."""
    return [
        name
        for name, (old, new) in diff.moved.items()
        if name not in finding.accounted and name not in diff.changed and _is_aside(old, new)
    ]


def _is_aside(old: SceneObject, new: SceneObject) -> bool:
    """Whether a thing lies elsewhere on what it lay on, or, where a hand can carry it, elsewhere in its room."""
    on_it = old.parent is not None and old.parent == new.parent and old.mount != "floor"
    return old.room == new.room and (on_it or old.pickupable)


def moved_aside(step: Step) -> list[str]:
    """Return a sentence for each small thing that was moved to make room."""
    diff = differences(step.before, step.after)
    if not diff.moved:
        return []
    finding = _finding(step.statement, step.before, step.after, step.context, diff)
    if not finding.makes_room:
        return []
    out = []
    for name in _aside(diff, finding):
        old, new = diff.moved[name]
        where = "moved aside on" if old.parent == new.parent else "made room and is now on"
        out.append(f"{name} {where} {new.parent}")
    return out


def _lasting(statement: Statement, first: SceneState, last: SceneState, context: Context) -> str:
    """Return why what shall hold of the whole instruction does not: nothing added, or all left as it was."""
    if isinstance(statement, Forbid):
        known = {item.id for _, item in first.objects()}
        there = all_at(last, things_of(last, statement.things, context), statement.place, context)
        new = [item for item in there if item.id not in known]
        return f"{listed(new)} was added" if new else ""
    if isinstance(statement, Mention):
        found = (_touched(things, first, last, context) for things in statement.untouched)
        return next((fault for fault in found if fault), "")
    if isinstance(statement, Keep):
        kept = things_of(first, statement.things, context)
        touched = [item.id for item in kept if not _stays(item, statement.things, first, last)]
        if not touched and not statement.things.noun and statement.things.place is not None:
            touched_rooms = _changed_rooms(statement.things.place, first, last, context)
            return f"{', '.join(touched_rooms)} is not as it was, though it shall stay" if touched_rooms else ""
        return (
            f"{listed(touched)} is not as it was, though {thing_words(statement.things)} shall stay" if touched else ""
        )
    return ""


def _stays(item: SceneObject, things: Things, first: SceneState, last: SceneState) -> bool:
    """Whether an object is as it was, or stays on what it was said to stay on, which turned or moved with it."""
    if last.find(item.id) is None:
        return False
    now = last.get(item.id)[1]
    on_it = things.place is not None and things.place.anchor is not None and item.parent is not None
    if now == item or not on_it or item.parent is None or last.find(item.parent) is None:
        return now == item
    carried = now.parent == item.parent and last.get(item.parent)[1] != first.get(item.parent)[1]
    return carried and msgspec.structs.replace(now, position=item.position, rotation=item.rotation) == item


def _touched(things: Things, first: SceneState, last: SceneState, context: Context) -> str:
    """Return why what was named beside a request is not as it was, with what it carries and holds."""
    named = {item.id for item in things_of(first, things, context)}
    old, new = (_with_carried(state, named) for state in (first, last))
    differ = [name for name in sorted({*old, *new}) if old.get(name) != new.get(name)]
    if differ:
        return f"{listed(differ)} changed, which was only mentioned; say what shall become of it"
    rooms = [] if things.noun or things.place is None else _changed_rooms(things.place, first, last, context)
    return f"{', '.join(rooms)} changed, which was only mentioned; say what shall become of it" if rooms else ""


def _with_carried(state: SceneState, names: set[str]) -> dict[str, SceneObject]:
    return {item.id: item for _, item in state.objects() if item.id in names or item.parent in names}


def _changed_rooms(place: Place, first: SceneState, last: SceneState, context: Context) -> list[str]:
    """Return the rooms of a place without an anchor that are not as they were, or hold something else."""
    if place.anchor is not None or place.rooms is None:
        return []
    return [name for name in rooms_of(first, place.rooms, context) if _of_room(first, name) != _of_room(last, name)]


def _of_room(state: SceneState, name: str) -> tuple[object, list[object]]:
    return state.room(name), [item for _, item in state.objects() if item.room == name]

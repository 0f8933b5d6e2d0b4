"""Changes of objects: applied, inverted, reduced to their net effect, and rebased onto a newer revision."""

from collections.abc import Mapping, Sequence

import msgspec

from mansion_msgs_py.editing import ObjectChange
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene

__all__ = ["changed", "inverse", "net_changes", "rebase"]


def inverse(change: ObjectChange) -> ObjectChange:
    """Return the change that takes `change` back."""
    return msgspec.structs.replace(change, before=change.after, after=change.before)


def changed(scene: FloorScene, change: ObjectChange) -> FloorScene:
    """Return `scene` with one change done.

    Raises
    ------
    MansionError
        ``CONFLICT`` when the object is not as the change has it before.
    """
    objects = list(scene.objects)
    before, after = change.before, change.after
    if before is not None:
        at = next((i for i, item in enumerate(objects) if item.id == before.id), None)
        if at is None or objects[at] != before:
            state = "was removed" if at is None else "was changed"
            raise MansionError(
                ErrorCode.CONFLICT,
                f"{before.id} {state} since this edit began; look again and repeat the edit",
                details={"object": before.id},
            )
        objects.pop(at)
        if after is not None:
            objects.insert(at, after)
    elif after is not None:
        if any(item.id == after.id for item in objects):
            raise MansionError(
                ErrorCode.CONFLICT,
                f"the id {after.id} was taken meanwhile; repeat the edit",
                details={"object": after.id},
            )
        objects.insert(min(change.index, len(objects)), after)
    return msgspec.structs.replace(scene, objects=objects)


def net_changes(changes: Sequence[ObjectChange]) -> list[ObjectChange]:
    """Return changes that together do the same, at most one for each object; an object added and removed has none."""
    out: dict[tuple[int, str], ObjectChange] = {}
    for change in changes:
        key = (change.floor, change.id)
        first = out.get(key)
        if first is not None:
            change = msgspec.structs.replace(change, before=first.before, index=first.index)
        if change.before == change.after:
            out.pop(key, None)
        else:
            out[key] = change
    return list(out.values())


def rebase(changes: Sequence[ObjectChange], scenes: Mapping[int, FloorScene]) -> list[ObjectChange]:
    """Return the changes as they apply to `scenes`, with new ids for additions whose id is taken by now.

    Raises
    ------
    MansionError
        ``CONFLICT`` when something that carries an added object is gone.
    """
    taken = {floor: {item.id for item in scene.objects} for floor, scene in scenes.items()}
    kept = net_changes(changes)
    for change in kept:
        if change.after is None:
            taken[change.floor].discard(change.id)
    names: dict[str, str] = {}
    for change in kept:
        if change.before is None:
            ids = taken[change.floor]
            fresh = change.id if change.id not in ids else _next_id(change.id, ids)
            names[change.id] = fresh
            ids.add(fresh)
    out = [_renamed(change, names) for change in kept]
    for change in out:
        parent = change.after.parent if change.after is not None else None
        if parent is not None and parent not in taken[change.floor]:
            raise MansionError(
                ErrorCode.CONFLICT,
                f"{parent}, which should carry {change.id}, was removed meanwhile; look again and repeat the edit",
                details={"object": parent},
            )
    return out


def _renamed(change: ObjectChange, names: Mapping[str, str]) -> ObjectChange:
    after = change.after
    if after is None:
        return change
    parent = names.get(after.parent, after.parent) if after.parent is not None else None
    own = names.get(after.id, after.id) if change.before is None else after.id
    if (own, parent) == (after.id, after.parent):
        return change
    return msgspec.structs.replace(change, after=msgspec.structs.replace(after, id=own, parent=parent))


def _next_id(wanted: str, taken: set[str]) -> str:
    stem = wanted.rstrip("0123456789")
    number = 1
    while f"{stem}{number}" in taken:
        number += 1
    return f"{stem}{number}"

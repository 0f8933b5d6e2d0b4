"""Diff: changes that wait to be saved, in words."""

from mansion_editing.state import Change
from mansion_msgs_py.editing.changes import DocumentChange, ObjectChange, RoomParts

__all__ = ["in_words"]


def in_words(change: Change) -> str:
    """Return a change in words: ``+`` what comes, ``-`` what goes, ``~`` what differs and how a room does.

    Examples
    --------
    >>> in_words(DocumentChange(path="floors/floor_1/layout.json", before="6f1c", after="90aa"))
    '~ floors/floor_1/layout.json'
    """
    if isinstance(change, DocumentChange):
        return f"{_sign(change.before, change.after)} {change.path}"
    if isinstance(change, ObjectChange):
        return f"{_sign(change.before, change.after)} {change.id}"
    told = _facts(change.before)
    facts = [
        f"{name} {told[name] or 'none'} -> {value or 'none'}"
        for name, value in _facts(change.after).items()
        if value != told[name]
    ]
    return f"~ {change.id} ({'; '.join(facts) or 'as its records have it'})"


def _sign(before: object, after: object) -> str:
    if not before:
        return "+"
    return "~" if after else "-"


def _facts(parts: RoomParts) -> dict[str, str]:
    room = parts.room
    start = "" if parts.spawn is None else f"{parts.spawn.x} {parts.spawn.y}"
    return {
        "name": room.name,
        "type": room.room_type,
        "walls": room.wall_material,
        "floor": room.floor_material,
        "ceiling": room.ceiling_material,
        "lights": str(len(parts.lights)),
        "robot's start": start,
    }

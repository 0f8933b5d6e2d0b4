"""What an edit changed: the building before and after, object by object."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from mansion.parts import Object, Room
from mansion.selections import Floors, Objects, Rooms
from mansion_msgs_py.scene import FloorScene

__all__ = ["Edit", "edit_between"]


@dataclass(frozen=True)
class Edit:
    """What became of an instruction, an undo or a redo; false where nothing changed.

    Attributes
    ----------
    message : str
        What was there and what changed, or the answer to a question.
    added, removed : Objects
        Objects that came and went.
    changed : tuple of (Object, Object)
        Objects that were moved, painted or set, before and after.
    rooms : Rooms
        Rooms whose shape, name, kind or finish is new, as they are now.
    """

    message: str
    added: Objects
    removed: Objects
    changed: tuple[tuple[Object, Object], ...]
    rooms: Rooms

    def __bool__(self) -> bool:
        return bool(self.added or self.removed or self.changed or self.rooms)

    def __str__(self) -> str:
        return self.message


def edit_between(message: str, before: Sequence[FloorScene], after: Sequence[FloorScene]) -> Edit:
    """Return the edit that led from some scenes to others."""
    known = {scene.floor: scene for scene in before}
    now = [scene for scene in after if known.get(scene.floor) != scene]
    then = [scene for scene in before if scene.floor in {scene.floor for scene in now}]
    old, new = Floors.of(then), Floors.of(now)
    past = {item.id: item for item in old.objects}
    present = {item.id: item for item in new.objects}
    return Edit(
        message=message,
        added=Objects(item for item in new.objects if item.id not in past),
        removed=Objects(item for item in old.objects if item.id not in present),
        changed=tuple((past[name], item) for name, item in present.items() if _differ(past.get(name), item)),
        rooms=Rooms(_new_rooms(old.rooms, new.rooms)),
    )


def _differ(one: Object | None, other: Object) -> bool:
    return one is not None and one.record != other.record


def _new_rooms(old: Iterable[Room], new: Iterable[Room]) -> list[Room]:
    past = {room.id: room for room in old}
    return [room for room in new if past.get(room.id) != room]

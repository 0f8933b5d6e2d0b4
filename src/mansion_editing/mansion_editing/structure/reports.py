"""What a change of structure moved, in plain sentences."""

from collections.abc import Iterable, Sequence

from mansion_editing.structure.rebuilding import Rebuilt
from mansion_editing.structure.rebuilt_scene import Finished
from mansion_editing.structure.storey_documents import Storey
from mansion_editing.structure.wall_moves import MovedWall
from mansion_language.inflection import plural
from mansion_msgs_py.scene import Door, FloorScene
from mansion_msgs_py.wording import counted, listed

__all__ = ["door_sentences", "object_sentences", "room_sentences", "wall_sentences"]

_NAMED = 6
"""Objects that are named one by one before the rest is counted."""


def room_sentences(before: Storey, after: FloorScene) -> list[str]:
    """Say which rooms have another area."""
    old = {room.id: room.area for room in before.scene.rooms}
    return [
        f"{room.id} has {room.area:.1f} m2 instead of {old[room.id]:.1f} m2."
        for room in after.rooms
        if abs(room.area - old[room.id]) >= 0.05
    ]


def wall_sentences(moves: Iterable[MovedWall]) -> list[str]:
    """Say which walls moved, how far and where to."""
    return [
        f"The wall between {move.gainer} and {move.giver} moved {_length(move):.2f} m {_heading(move)}."
        for move in moves
    ]


def _length(move: MovedWall) -> float:
    return float((move.shift[0] ** 2 + move.shift[1] ** 2) ** 0.5)


def _heading(move: MovedWall) -> str:
    x, y = move.shift
    if abs(x) >= abs(y):
        return "to the east" if x > 0 else "to the west"
    return "to the north" if y > 0 else "to the south"


def door_sentences(rebuilt: Rebuilt) -> list[str]:
    """Say which doors are new, gone or elsewhere."""
    gone = {frozenset(door.rooms): door for door in rebuilt.lost_doors if door.kind != "open"}
    said = []
    for door in rebuilt.new_doors:
        if door.kind == "open":
            continue
        was = gone.pop(frozenset(door.rooms), None)
        between = _between(door)
        said.append(f"The door {between} is elsewhere in its wall." if was else f"A door {between} is new: {door.id}.")
    said += [f"The door {_between(door)} is gone." for door in gone.values()]
    return said


def _between(door: Door) -> str:
    a, b = door.rooms
    return f"between {a} and {b}" if b is not None else f"from {a} to the outside"


def object_sentences(finished: Finished) -> list[str]:
    """Say which objects went along with a wall, stand elsewhere, or were left out."""
    said = []
    for room, settled in finished.settled.items():
        if settled.went_along:
            said.append(f"{_names(settled.went_along)} moved with the wall.")
        if settled.placed:
            said.append(f"{_names(settled.placed)} stand{'s' if len(settled.placed) == 1 else ''} elsewhere in {room}.")
        if settled.lost:
            said.append(f"{room} has no place left for {_names([item.id for item in settled.lost])}.")
    for room, lost in finished.refurnished.items():
        missing = [_pieces(category, count) for category, count in sorted(lost.items())]
        said.append(f"{room} is refurnished" + (f", without {listed(missing)}." if missing else "."))
    return said


def _pieces(category: str, count: int) -> str:
    noun = category.replace("_", " ")
    return counted(count, noun, plural(noun))


def _names(ids: Sequence[str]) -> str:
    rest = len(ids) - _NAMED
    if rest <= 1:
        return listed(list(ids))
    return listed([*ids[:_NAMED], counted(rest, "other object")])

"""SetFinish: the materials of a room's walls, floor and ceiling."""

import re
from collections.abc import Collection
from typing import Final

import msgspec

from mansion_editing.state import SceneState
from mansion_editing.tools.rooms import RoomRecords, change_room, room_named
from mansion_knowledge import is_class
from mansion_language.colours import COLOUR_WORDS
from mansion_msgs_py.editing.changes import RoomParts
from mansion_msgs_py.editing.rooms import SetFinishArgs
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneRoom
from mansion_scene.structure.materials import SUBSTANCES, Material, Use, library

__all__ = ["finish_named", "set_finish"]

_USES: Final[dict[str, Use]] = {"walls": "wall", "floor": "floor", "ceiling": "ceiling"}
_FIELDS: Final = {"walls": "wall_material", "floor": "floor_material", "ceiling": "ceiling_material"}
_PAINT: Final = "paint"
_FILLERS: Final = frozenset(["a", "an", "and", "finish", "floor", "in", "of", "the", "wall", "walls", "with"])


def set_finish(state: SceneState, args: SetFinishArgs, records: RoomRecords) -> tuple[SceneRoom, Material]:
    """Give a part of a room another finish; return the room and the material.

    Walls change on this room's side alone. Program and room graph name the material from then on.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` without a material and a colour, ``INFEASIBLE`` for what the library does not have or a
        room without that part.
    """
    floor, room = room_named(state, args.room_id)
    if not args.material.strip() and not args.color.strip():
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "give material, color or both", path="$.material")
    if args.part == "ceiling" and is_class(room.room_type, "outdoor"):
        raise MansionError(ErrorCode.INFEASIBLE, f"{room.id} is outdoors and has no ceiling", path="$.part")
    field = _FIELDS[args.part]
    finish = finish_named(_USES[args.part], args.material, args.color, getattr(room, field))

    def finished(parts: RoomParts) -> RoomParts:
        changed = msgspec.structs.replace(parts, room=msgspec.structs.replace(parts.room, **{field: finish.name}))
        if args.part == "walls":
            changed = msgspec.structs.replace(changed, faces=dict.fromkeys(parts.faces, finish.name))
        if args.part == "ceiling":
            return changed
        told = {name: entry for name in ("program", "node") if (entry := getattr(parts, name)) is not None}
        return msgspec.structs.replace(
            changed, **{name: msgspec.structs.replace(entry, **{field: finish.name}) for name, entry in told.items()}
        )

    change_room(state, floor, room.id, records, finished)
    return msgspec.structs.replace(room, **{field: finish.name}), finish


def finish_named(use: Use, material: str, color: str, present: str = "") -> Material:
    """Return the material of the library that words name.

    Parameters
    ----------
    use : {"floor", "wall", "ceiling"}
    material : str
        A name of the library or words; with a colour alone, walls are painted and floors stay of their substance.
    color : str
        A word for a colour.
    present : str
        The material of now.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with the materials that there are.
    """
    choice = {entry.name: entry for entry in library().values() if use in entry.uses}
    name = re.sub(r"[\s\-]+", "_", material.strip().lower())
    if name in choice and not color.strip():
        return choice[name]
    words = [word for word in re.findall(r"[a-z]+", material.lower().replace("_", " ")) if word not in _FILLERS]
    colours = re.findall(r"[a-z]+", color.lower())
    if not words:
        kept = SUBSTANCES & set(choice[present].keywords) if present in choice else set()
        for substance in ([_PAINT] if use == "wall" else sorted(kept)) + [""]:
            fitting = _fitting(choice.values(), [substance] if substance else [], colours)
            if fitting:
                return _plainest(fitting, kept)
    fitting = _fitting(choice.values(), words, colours)
    if words and fitting:
        return _plainest(fitting, words)
    raise MansionError(
        ErrorCode.INFEASIBLE,
        f"there is no {' '.join([*colours, *words])[:120] or 'such material'} for a {use}; "
        f"there are {', '.join(choice)}",
        path="$.material" if words else "$.color",
        details={"materials": list(choice)},
    )


def _fitting(choice: Collection[Material], words: Collection[str], colours: Collection[str]) -> list[Material]:
    """Return the materials that all words describe; a word that is a colour may be told by its usual name."""

    def described(entry: Material, word: str) -> bool:
        told = {*entry.keywords, *entry.name.split("_")}
        return bool({word, word.rstrip("s"), f"{word}s", COLOUR_WORDS.get(word, word)} & told)

    return [entry for entry in choice if all(described(entry, word) for word in (*words, *colours))]


def _plainest(fitting: Collection[Material], words: Collection[str]) -> Material:
    """Return the material with most of some words among those that say what it is, then the one that says least."""
    return max(fitting, key=lambda entry: (len(set(words) & set(entry.keywords)), -len(entry.keywords)))

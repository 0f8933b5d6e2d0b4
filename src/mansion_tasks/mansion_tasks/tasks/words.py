"""Which objects and rooms of a building the words of a task may mean."""

from typing import Final

from mansion_msgs_py.scene import SceneObject, SceneRoom
from mansion_tasks.words.colours import COLOURS
from mansion_tasks.words.nouns import plain
from mansion_tasks.words.things import ROOMS, THINGS

__all__ = ["colour_of", "room_fits", "thing_fits"]

_THINGS: Final = tuple(group.same + group.goal for group in THINGS)
_ROOMS: Final = tuple(group.same + group.goal for group in ROOMS)


def _names(word: str, name: str, groups: tuple[tuple[str, ...], ...]) -> bool:
    """Whether `name` is `word` or a synonym, or a kind of it (an ``office desk`` is a ``desk``)."""
    wanted = plain(word)
    same = next((group for group in groups if wanted in group), (wanted,))
    return any(name == w or name.endswith(f" {w}") for w in same)


def thing_fits(noun: str, thing: SceneObject) -> bool:
    """Whether a noun names an object: its category or name, a synonym, or what it is a kind of."""
    return any(_names(noun, plain(name), _THINGS) for name in (thing.category, thing.name) if name)


def room_fits(word: str, room: SceneRoom) -> bool:
    """Whether a word names a room: its type, a synonym, or its own name (``meeting room 2``)."""
    return plain(word) == plain(room.name) or _names(word, plain(room.room_type), _ROOMS)


def colour_of(thing: SceneObject) -> str:
    """Return the colour that an object's material names (``paint_red``), empty when it names none."""
    return next((part for part in thing.material.split("_") if part in COLOURS), "")

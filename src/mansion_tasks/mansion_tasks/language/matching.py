"""Which categories, objects and rooms a noun names: as an agent may guess, and as the goals of a task are judged."""

from typing import Final

from mansion_language import singular
from mansion_msgs_py.scene import SceneObject, SceneRoom
from mansion_tasks.language.vocabulary import OBJECTS, ROOMS, plain

__all__ = ["match_score", "matches", "names_object", "names_room"]

_SYNONYMS: Final = {word: group.same + group.loose for group in (*OBJECTS, *ROOMS) for word in group.same + group.loose}


def match_score(noun: str, name: str) -> int:
    """Rate how well a noun names a category or a room.

    Returns
    -------
    int
        3: with the same or an equal word, and number. 2: the name is of a kind of the noun, or lacks the number ("1" is
        understood). 1: the noun is of a kind of the name. 0: not at all.

    Examples
    --------
    >>> match_score("couch", "sofa"), match_score("table", "dining_table"), match_score("pen", "open_shelf")
    (3, 2, 0)
    >>> match_score("round table", "table"), match_score("office 2", "office_3"), match_score("hall 1", "hall")
    (1, 0, 2)
    """
    wanted, known = _normalised(noun), _normalised(name)
    asked, given = _trailing_number(noun), _trailing_number(name)
    if not wanted or not known or (asked and asked != (given or "1")):
        return 0
    if any(a == b for a in _variants(wanted) for b in _variants(known)):
        return 3 if asked in ("", given) else 2
    if any(f" {known}".endswith(f" {a}") for a in _variants(wanted)):
        return 2
    return int(any(f" {wanted}".endswith(f" {b}") for b in _variants(known)))


def matches(noun: str, name: str) -> bool:
    """Whether a noun may name a category or a room."""
    return match_score(noun, name) > 0


def _normalised(text: str) -> str:
    words = text.casefold().replace("_", " ").replace("-", " ").split()
    while words and words[-1].isdigit():
        words.pop()
    return " ".join([*words[:-1], singular(words[-1])]) if words else ""


def _trailing_number(text: str) -> str:
    """Return the number that a name ends with, empty for none."""
    last = text.replace("_", " ").split()[-1:]
    return last[0] if last and last[0].isdigit() else ""


def _variants(text: str) -> tuple[str, ...]:
    """Return a noun, its spelling as one word, and its synonyms."""
    joined = text.replace(" ", "")
    return tuple(dict.fromkeys((text, joined, *_SYNONYMS.get(text, ()))))


_OBJECT_GROUPS: Final = tuple(group.same + group.goal for group in OBJECTS)
_ROOM_GROUPS: Final = tuple(group.same + group.goal for group in ROOMS)


def _is_kind_of(word: str, name: str, groups: tuple[tuple[str, ...], ...]) -> bool:
    """Whether `name` is `word`, a synonym of it, or a kind of it (an ``office desk`` is a ``desk``)."""
    wanted = plain(word)
    same = next((group for group in groups if wanted in group), (wanted,))
    return any(name == w or name.endswith(f" {w}") for w in same)


def names_object(noun: str, item: SceneObject) -> bool:
    """Whether a noun names an object: its category or name, a synonym, or what it is a kind of."""
    return any(_is_kind_of(noun, plain(name), _OBJECT_GROUPS) for name in (item.category, item.name) if name)


def names_room(word: str, room: SceneRoom) -> bool:
    """Whether a word names a room: its type, a synonym, or a name of its own (``meeting room 2``)."""
    called = [plain(name) for name in (room.name, *room.aliases)]
    return plain(word) in called or _is_kind_of(word, plain(room.room_type), _ROOM_GROUPS)

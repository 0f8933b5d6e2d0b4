"""What the name of a room tells about it, whether or not it is a known type: classes, colour family, uses, other names.

A type of the user's own that names a kin is taken for that kin. Everything else is said by the words of the name
(``room_words.csv``), so that a planner may write ``staff_toilet`` and be understood.
"""

from functools import lru_cache
from typing import Literal, TypeAlias

from mansion_knowledge.base import KnowledgeBase, default_knowledge

__all__ = ["interchangeable_names", "is_class", "kin_of", "name_groups", "uses_of", "words_by"]

Fact: TypeAlias = Literal["classes", "colour", "thor", "uses", "keeps"]


def kin_of(room_type: str) -> str:
    """Return the room type as which a type is treated: its kin's kin's ..., or itself where it names none."""
    rooms = default_knowledge().rooms
    while room_type in rooms and rooms[room_type].kin:
        room_type = rooms[room_type].kin
    return room_type


def words_by(fact: Fact) -> dict[str, tuple[str, ...]]:
    """Return the words that say something of a room, by what they say.

    Parameters
    ----------
    fact : {"classes", "colour", "thor", "uses", "keeps"}
        Field of `RoomWord`.

    Examples
    --------
    >>> words_by("classes")["outdoor"]
    ('balcony', 'deck', 'loggia', 'patio', 'terrace', 'veranda')
    """
    return _words_by(default_knowledge(), fact)


@lru_cache(maxsize=32)
def _words_by(knowledge: KnowledgeBase, fact: Fact) -> dict[str, tuple[str, ...]]:
    found: dict[str, list[str]] = {}
    for entry in knowledge.words.values():
        said = getattr(entry, fact)
        for value in (said,) if isinstance(said, str) else said:
            if value:
                found.setdefault(value, []).append(entry.word)
    return {value: tuple(words) for value, words in found.items()}


def is_class(room_type: str, name: str) -> bool:
    """Tell whether a room type belongs to a class: is it wet, circulation, a store, outdoors ...?

    A type belongs to a class when one of its words (``staff_toilet`` has ``staff`` and ``toilet``) is one of the
    class's.

    Examples
    --------
    >>> is_class("staff_toilet", "wet"), is_class("open_office", "wet")
    (True, False)
    >>> is_class("store_room", "store"), is_class("grocery_store", "store")
    (True, False)
    """
    return _is_class(default_knowledge(), room_type, name)


@lru_cache(maxsize=8192)
def _is_class(knowledge: KnowledgeBase, room_type: str, name: str) -> bool:
    classes = _words_by(knowledge, "classes")
    words = kin_of(room_type).lower().replace("-", "_").replace(" ", "_").split("_")
    words = [word for word in words if word and not word.isdigit()]
    if name in ("dark", "worship"):
        # Whatever kind of hall it is.
        return any(word in classes[name] for word in words)
    if len(words) > 1 and words[-1] in ("store", "market"):
        # A "grocery store" sells; a "store room" keeps.
        return name == "assembly"
    if len(words) > 1 and words[-1] == "hall" and words[0] not in classes["circulation"]:
        # People gather in an "exhibition hall" and pass through an "entrance hall".
        return name == ("teaching" if words[0] in classes["teaching"] else "assembly")
    return any(word in classes[name] for word in words)


def uses_of(room_type: str) -> frozenset[str]:
    """Return what a room type is used for, by the end of its name (``open_office`` is an office).

    Examples
    --------
    >>> sorted(uses_of("staff_kitchen")), sorted(uses_of("corridor")), uses_of("void")
    (['eating'], ['passing'], frozenset())
    """
    return _uses_of(default_knowledge(), room_type)


@lru_cache(maxsize=8192)
def _uses_of(knowledge: KnowledgeBase, room_type: str) -> frozenset[str]:
    name = kin_of(room_type)
    return frozenset(use for use, ends in _words_by(knowledge, "uses").items() if name.endswith(ends))


def name_groups() -> dict[str, dict[str, str]]:
    """Return the names that people use for each other: by group, each name in plain words with how closely it belongs.

    Examples
    --------
    >>> name_groups()["meeting_room"]["conference room"]
    'goal'
    """
    return _name_groups(default_knowledge())


@lru_cache(maxsize=8)
def _name_groups(knowledge: KnowledgeBase) -> dict[str, dict[str, str]]:
    groups: dict[str, dict[str, str]] = {}
    for entry in knowledge.words.values():
        for group, level in entry.called:
            groups.setdefault(group, {})[entry.word.replace("_", " ")] = level
    return groups


def interchangeable_names() -> dict[str, tuple[str, ...]]:
    """Return for each name that belongs to a group all names of that group; of its first, for a name of several.

    Examples
    --------
    >>> interchangeable_names()["canteen"]
    ('cafeteria', 'dining room', 'canteen', 'dining hall', 'mess hall', 'dining area')
    """
    return _interchangeable_names(default_knowledge())


@lru_cache(maxsize=8)
def _interchangeable_names(knowledge: KnowledgeBase) -> dict[str, tuple[str, ...]]:
    groups = _name_groups(knowledge)
    called = {entry.word.replace("_", " "): entry.called for entry in knowledge.words.values()}
    return {name: tuple(groups[own[0][0]]) for name, own in called.items() if own}

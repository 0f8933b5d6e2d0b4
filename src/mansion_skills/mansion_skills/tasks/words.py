"""Words for things and places: which objects and rooms of a building somebody may mean."""

import re
from typing import Final

from mansion_msgs_py.scene import SceneObject, SceneRoom

__all__ = [
    "COLOURS",
    "article",
    "colour_of",
    "is_plural",
    "ordinal",
    "plain",
    "room_fits",
    "thing_fits",
]

COLOURS: Final = (
    "white",
    "black",
    "grey",
    "red",
    "blue",
    "green",
    "yellow",
    "orange",
    "purple",
    "brown",
    "beige",
    "pink",
)
"""Words that materials use for colours."""

_THINGS: Final = (
    ("sofa", "couch", "settee", "loveseat"),
    ("cell phone", "cellphone", "mobile phone", "smartphone", "mobile"),
    ("fridge", "refrigerator"),
    ("toolbox", "tool box"),
    ("laptop", "notebook computer"),
    ("cloth", "rag", "dishcloth"),
    ("basketball", "basket ball"),
    ("waste bin", "trash can", "garbage can", "bin"),
    ("television", "tv"),
    ("cabinet", "cupboard"),
)
_ROOMS: Final = (
    ("bathroom", "restroom", "toilet", "washroom", "wc", "lavatory"),
    ("meeting room", "conference room"),
    ("living room", "sitting room"),
    ("kitchen", "kitchenette"),
    ("corridor", "hallway"),
    ("storage", "storage room", "storeroom"),
)
"""Words that mean the same."""

_ORDINALS: Final = (
    "first",
    "second",
    "third",
    "fourth",
    "fifth",
    "sixth",
    "seventh",
    "eighth",
    "ninth",
    "tenth",
)


def plain(text: str) -> str:
    """Return words in small letters, without articles and punctuation.

    Examples
    --------
    >>> plain("The Cell_phone")
    'cell phone'
    """
    words = re.findall(r"[a-z0-9]+", text.lower())
    return " ".join(word for word in words if word not in ("a", "an", "the", "some"))


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


def is_plural(noun: str) -> bool:
    """Whether a noun is of several things (``boots``)."""
    return noun.endswith("s") and not noun.endswith(("ss", "us", "is"))


def article(words: str, *, known: bool) -> str:
    """Return words with their article.

    Parameters
    ----------
    known : bool
        Whether there is just one.

    Examples
    --------
    >>> article("apple", known=False), article("work gloves", known=False)
    ('an apple', 'some work gloves')
    """
    if known:
        return f"the {words}"
    if is_plural(words):
        return f"some {words}"
    return f"{'an' if words[:1] in 'aeio' or words.startswith('um') else 'a'} {words}"


def ordinal(number: int) -> str:
    """Return the word for a place in a row.

    Examples
    --------
    >>> ordinal(3), ordinal(13), ordinal(22)
    ('third', '13th', '22nd')
    """
    if 1 <= number <= len(_ORDINALS):
        return _ORDINALS[number - 1]
    ending = {1: "st", 2: "nd", 3: "rd"}.get(number % 10, "th") if number % 100 // 10 != 1 else "th"
    return f"{number}{ending}"

"""Synonyms for objects and rooms, and the grammar of English nouns."""

import re
from typing import Final, NamedTuple

from mansion_knowledge import name_groups
from mansion_language import is_plural
from mansion_language.numbers import ORDINALS
from mansion_msgs_py.wording import with_article

__all__ = ["ROOMS", "OBJECTS", "Synonyms", "article", "ordinal", "plain"]


class Synonyms(NamedTuple):
    """Words for one kind of object or room.

    Attributes
    ----------
    same : tuple of str
        Synonyms without reservation.
    goal : tuple of str
        Further words that the goals of a task count as the same.
    loose : tuple of str
        Further words, also for similar objects, that an agent accepts while it searches.
    """

    same: tuple[str, ...]
    goal: tuple[str, ...] = ()
    loose: tuple[str, ...] = ()


OBJECTS: Final = (
    Synonyms(("sofa", "couch", "settee"), goal=("loveseat",)),
    Synonyms(("cell phone", "cellphone", "mobile phone", "smartphone", "mobile"), loose=("phone",)),
    Synonyms(("television", "tv"), loose=("tv set",)),
    Synonyms(("fridge", "refrigerator"), loose=("freezer",)),
    Synonyms(("laptop", "notebook computer"), loose=("laptop computer",)),
    Synonyms(("waste bin", "trash can", "garbage can", "bin"), loose=("trash bin", "dustbin", "wastebasket")),
    Synonyms(("cup",), loose=("coffee cup",)),
    Synonyms(("cloth", "rag", "dishcloth"), loose=("dish cloth", "cleaning cloth")),
    Synonyms(("toolbox", "tool box")),
    Synonyms(("basketball",), goal=("basket ball",)),
    Synonyms(("cabinet",), goal=("cupboard",)),
    Synonyms(("wardrobe",), loose=("closet",)),
    Synonyms(("bookshelf",), loose=("bookcase", "shelf", "shelves", "shelving unit")),
    Synonyms(("drawer",), loose=("dresser", "chest of drawers")),
    Synonyms(("remote",), loose=("remote control",)),
    Synonyms(("key",), loose=("keychain", "key chain")),
    Synonyms(("lift",), loose=("elevator",)),
)

ROOMS: Final = tuple(
    Synonyms(*(tuple(name for name, level in names.items() if level == wanted) for wanted in ("", "goal", "talk")))
    for names in name_groups().values()
    if "" in names.values()
)


_ORDINALS: Final = {number: word for word, number in ORDINALS.items() if number <= 10}


def plain(text: str) -> str:
    """Return a text in lower case, without articles and punctuation.

    Examples
    --------
    >>> plain("The Cell_phone")
    'cell phone'
    """
    words = re.findall(r"[a-z0-9]+", text.lower())
    return " ".join(word for word in words if word not in ("a", "an", "the", "some"))


def article(words: str, *, known: bool) -> str:
    """Return a noun phrase with its article.

    Parameters
    ----------
    known : bool
        Whether the listener knows which one is meant, since there is only one.

    Examples
    --------
    >>> article("apple", known=False), article("work gloves", known=False)
    ('an apple', 'some work gloves')
    """
    if known:
        return f"the {words}"
    if is_plural(words):
        return f"some {words}"
    return with_article(words)


def ordinal(number: int) -> str:
    """Return the ordinal of a number, in words up to ten.

    Examples
    --------
    >>> ordinal(3), ordinal(13), ordinal(22)
    ('third', '13th', '22nd')
    """
    if number in _ORDINALS:
        return _ORDINALS[number]
    ending = {1: "st", 2: "nd", 3: "rd"}.get(number % 10, "th") if number % 100 // 10 != 1 else "th"
    return f"{number}{ending}"

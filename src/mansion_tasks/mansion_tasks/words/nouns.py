"""Number, articles and order of nouns."""

import re
from typing import Final

from mansion_msgs_py.wording import with_article

__all__ = ["article", "is_plural", "ordinal", "plain", "singular"]

_ORDINALS: Final = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")


def plain(text: str) -> str:
    """Return words in small letters, without articles and punctuation.

    Examples
    --------
    >>> plain("The Cell_phone")
    'cell phone'
    """
    words = re.findall(r"[a-z0-9]+", text.lower())
    return " ".join(word for word in words if word not in ("a", "an", "the", "some"))


def is_plural(noun: str) -> bool:
    """Whether a noun is of several things (``boots``)."""
    return noun.endswith("s") and not noun.endswith(("ss", "us", "is"))


def singular(word: str) -> str:
    """Return an English noun in the singular, by its ending.

    Examples
    --------
    >>> singular("boxes"), singular("shelves"), singular("knives"), singular("gloves"), singular("glass")
    ('box', 'shelf', 'knife', 'glove', 'glass')
    """
    if word.endswith("ives"):
        return word[:-3] + "fe"
    if word.endswith(("lves", "aves")):
        return word[:-3] + "f"
    if word.endswith(("sses", "shes", "ches", "xes")):
        return word[:-2]
    if word.endswith("ies") and len(word) > 4:
        return word[:-3] + "y"
    if is_plural(word) and len(word) > 3:
        return word[:-1]
    return word


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
    return with_article(words)


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

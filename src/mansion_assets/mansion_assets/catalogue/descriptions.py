"""What categories are used for, what they look like, and the general words for them."""

from functools import cache
from importlib.resources import files
from typing import Final

import msgspec

from mansion_msgs_py.codec import prepared

__all__ = [
    "Description",
    "Hypernym",
    "described_categories",
    "description_of",
    "hypernyms",
    "hypernyms_of",
    "words_alike",
]

_DATA: Final = files("mansion_assets.catalogue").joinpath("data")


class Description(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A category in plain words.

    Attributes
    ----------
    called : str
        What people also call it, in phrases separated by semicolons: brands, slang, wider or looser words than the
        synonyms of its category, which a brief and an instruction understand too.
    use : str
        What one does with it, who needs it and where, in such phrases.
    look : str
        Its parts, material, shape and colour, in such phrases.
    """

    called: str = ""
    use: str = ""
    look: str = ""


class Hypernym(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A general term.

    Attributes
    ----------
    names : list of str
        What it is called ("seating", "something to sit on").
    categories : list of str
        Those that belong to it, the most typical first.
    """

    names: list[str]
    categories: list[str]


@cache
def described_categories() -> dict[str, Description]:
    """Return the descriptions of categories."""
    return msgspec.json.decode(_DATA.joinpath("descriptions.json").read_bytes(), type=prepared(dict[str, Description]))


def description_of(category: str) -> Description:
    """Return the description of a category; empty for one of a user's own."""
    return described_categories().get(category, Description())


@cache
def hypernyms() -> list[Hypernym]:
    """Return the general notions."""
    return msgspec.json.decode(_DATA.joinpath("hypernyms.json").read_bytes(), type=prepared(list[Hypernym]))


def hypernyms_of(category: str) -> list[str]:
    """Return the names of the general notions that a category belongs to."""
    return [name for notion in hypernyms() if category in notion.categories for name in notion.names]


@cache
def words_alike() -> dict[str, tuple[str, ...]]:
    """Return the words that mean about the same as a word, each with itself left out."""
    groups = msgspec.json.decode(_DATA.joinpath("words_alike.json").read_bytes(), type=list[list[str]])
    found: dict[str, dict[str, None]] = {}
    for group in groups:
        for word in group:
            found.setdefault(word, {}).update((other, None) for other in group if other != word)
    return {word: tuple(others) for word, others in found.items()}

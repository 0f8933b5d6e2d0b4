"""Guess the category of a model from its file name or from the words of an annotation."""

import re
from typing import Final, NamedTuple

from mansion_assets.catalogue.catalogue import Catalogue
from mansion_assets.catalogue.search import search_assets
from mansion_assets.catalogue.vocabulary import stems, vocabulary_of

__all__ = ["Named", "category_of", "plain_name", "slug"]

_NOISE: Final = frozenset(
    "sm mesh model models asset assets prop props obj glb gltf urdf lowpoly poly low high final export new copy "
    "untitled scene source data mobility textured visual".split()
)
"""Words of file names that say nothing of the thing."""

_VAGUE: Final = frozenset(
    "machine stand unit case box set light board station system table object item piece thing equipment device "
    "furniture rack bar frame holder".split()
)
"""Heads of names that alone do not say what a thing is: a pinball machine is not a washing machine."""

_ID: Final = re.compile(r"[0-9a-f]{12,}|[0-9a-f]{8}-[0-9a-f-]{20,}")


class Named(NamedTuple):
    """A category, the name in words, whether the catalogue had the category, and how many words led to it."""

    category: str
    name: str
    known: bool
    words: int = 0


def plain_name(text: str) -> str:
    """Return what a file's name or a category says in words; empty where it is a number or an id.

    Examples
    --------
    >>> plain_name("SM_OfficeChair_02"), plain_name("flip-flop (sandal)"), plain_name("80c7c462949740c18025")
    ('office chair', 'flip flop', '')
    """
    if _ID.fullmatch(text.lower()):
        return ""
    bare = re.sub(r"\([^)]*\)", " ", text)
    split = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", bare)
    words = re.findall(r"[a-z]+", split.lower())
    kept = [word for word in words if word not in _NOISE and len(word) > 1]
    return " ".join(kept[-6:])


def slug(text: str) -> str:
    """Return a text in small letters, digits and underscores that begins with a letter; ``thing`` for nothing.

    Examples
    --------
    >>> slug("Pinball Machine 3")
    'pinball_machine_3'
    """
    joined = re.sub(r"[^a-z0-9]+", "_", text.lower()).strip("_")[:60].strip("_")
    return joined if joined[:1].isalpha() else f"thing_{joined}".rstrip("_")


def category_of(words: str, catalogue: Catalogue) -> Named:
    """Return the category that words mean: the catalogue's by name or synonym, else a new one of that name.

    The head of the words counts where it is a thing by itself, so that a vintage armchair is an armchair; else the
    longest phrase of several words within them, so that a coffee table round is a coffee table.
    """
    name = plain_name(words)
    new = slug(name)
    asked = stems(name)
    if new in catalogue.categories:
        return Named(new, name, known=True, words=len(asked))
    vocabulary = vocabulary_of(catalogue)
    for start in range(len(asked)):
        window = asked[start:]
        found = vocabulary.exact(window)
        if found and (start == 0 or len(window) > 1 or window[0] not in _VAGUE):
            return Named(found[0], name, known=True, words=len(window))
    for size in range(len(asked) - 1, 1, -1):
        for start in range(len(asked) - size, -1, -1):
            found = vocabulary.exact(asked[start : start + size])
            if found:
                return Named(found[0], name, known=True, words=size)
    if len(asked) == 1 and vocabulary.generic(asked):
        hits = search_assets(catalogue, asked[0], 1)
        if hits:
            return Named(hits[0].asset.category, name, known=True, words=1)
    return Named(new, name, known=False)

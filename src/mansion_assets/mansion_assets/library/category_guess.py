"""Guess the category of a model from its file name or from the words of an annotation."""

import math
import re
from collections.abc import Iterator
from typing import Final, NamedTuple

from mansion_assets.catalogue.catalogue import Catalogue
from mansion_assets.catalogue.search import search_assets
from mansion_assets.catalogue.vocabulary import Vocabulary, stems, vocabulary_of
from mansion_msgs_py.shapes import Size3

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


_ALIKE: Final = math.log(1.6)
"""Logarithm of the factor by which each edge may differ between things of about one size."""

_THINNEST: Final = 0.02
"""Metres of an edge below which a difference says nothing."""


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


def category_of(words: str, catalogue: Catalogue, extent: Size3 | None = None) -> Named:
    """Return the category that words mean: the catalogue's by name or synonym, else a new one of that name.

    The head of the words counts where it is a thing by itself, so that a vintage armchair is an armchair; else the
    longest phrase of several words within them, so that a coffee table round is a coffee table.

    Parameters
    ----------
    extent : (w, d, h), optional
        Size of the model in its units. Where things of the first category are of another size, and those of another one
        that the words name are of this size, they mean that one: a sofa seat 2 m long is a sofa.
    """
    name = plain_name(words)
    new = slug(name)
    asked = stems(name)
    if new in catalogue.categories:
        return Named(new, name, known=True, words=len(asked))
    vocabulary = vocabulary_of(catalogue)
    found = list(_candidates(asked, vocabulary))
    if found and extent is not None and not _of_size(found[0][0], catalogue, extent):
        others = (*found, *_single_words(asked, vocabulary))
        found = [each for each in others if _of_size(each[0], catalogue, extent)] or found
    if found:
        category, number = found[0]
        return Named(category, name, known=True, words=number)
    if len(asked) == 1 and vocabulary.generic(asked):
        hits = search_assets(catalogue, asked[0], 1)
        if hits:
            return Named(hits[0].asset.category, name, known=True, words=1)
    return Named(new, name, known=False)


def _candidates(asked: tuple[str, ...], vocabulary: Vocabulary) -> Iterator[tuple[str, int]]:
    """Yield categories that the ends of a name mean, the longest end first, then phrases in it; with their words."""
    for start in range(len(asked)):
        window = asked[start:]
        if start == 0 or len(window) > 1 or window[0] not in _VAGUE:
            yield from ((category, len(window)) for category in vocabulary.exact(window))
    for size in range(len(asked) - 1, 1, -1):
        for start in range(len(asked) - size, -1, -1):
            yield from ((category, size) for category in vocabulary.exact(asked[start : start + size]))


def _single_words(asked: tuple[str, ...], vocabulary: Vocabulary) -> Iterator[tuple[str, int]]:
    """Yield categories that single words of a name mean, the last word first."""
    for word in reversed(asked):
        if word not in _VAGUE:
            yield from ((category, 1) for category in vocabulary.exact((word,)))


def _of_size(category: str, catalogue: Catalogue, extent: Size3) -> bool:
    """Whether the catalogue has something of the category whose three edges are about those of `extent`, in metres."""
    edges = sorted(extent)
    return any(
        all(
            abs(math.log(max(mine, _THINNEST) / max(its, _THINNEST))) <= _ALIKE
            for mine, its in zip(edges, sorted(asset.size), strict=True)
        )
        for asset in catalogue.by_category(category)
    )

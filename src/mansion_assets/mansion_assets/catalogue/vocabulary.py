"""The categories of the catalogue that English words name."""

import re
from functools import lru_cache
from typing import Final

from mansion_assets.catalogue.asset import Asset
from mansion_assets.catalogue.catalogue import Catalogue
from mansion_assets.catalogue.descriptions import words_alike
from mansion_language import singular
from mansion_language.colours import COLOUR_WORDS
from mansion_msgs_py.scene import SceneObject

__all__ = ["Vocabulary", "named_variants", "stems", "vocabulary_of"]

_FILLER: Final = frozenset(["a", "an", "the", "some", "any", "of", "one", "piece"])
_ALIKE: Final = frozenset(
    "cupboard cabinet closet wardrobe cart trolley sofa couch settee rug carpet rack stand shelf bookcase "
    "bookshelf fridge refrigerator pillow cushion statue sculpture tap faucet tv television telly phone telephone bike "
    "bicycle cooker stove".split()
)
"""Last words of compounds that other words, of about the same meaning, may stand for."""
_GENERIC: Final = {
    "table": ("table",),
    "chair": ("chair",),
    "lamp": ("lamp", "light"),
    "plant": ("plant",),
    "shelf": ("shelf", "shelving_unit", "bookshelf"),
    "cabinet": ("cabinet",),
    "bin": ("bin", "garbage_can"),
    "drink": ("cola_can", "juice_carton", "water_bottle", "beer_bottle", "wine_bottle"),
    "fruit": ("apple", "banana", "orange", "lemon"),
    "screen": ("monitor", "television", "wall_tv"),
}
"""Words that name many categories: those whose name ends with one of these."""


@lru_cache(maxsize=32768)
def stems(text: str) -> tuple[str, ...]:
    """Return the words of a text in small letters and in the singular, without articles.

    Examples
    --------
    >>> stems("The coffee-tables")
    ('coffee', 'table')
    """
    words = re.findall(r"[a-z0-9]+", text.lower())
    return tuple(singular(word) for word in words if word not in _FILLER)


def named_variants(catalogue: Catalogue, category: str) -> list[Asset]:
    """Return the assets of a category with names of their own: the first, which has the package's, and the user's."""
    first, *others = catalogue.by_category(category)
    return [first, *(asset for asset in others if asset.record)]


_MOST_RANKS = 65536
"""Ranks that a vocabulary remembers at most."""


class Vocabulary:
    """The names and synonyms of the catalogue's categories.

    Parameters
    ----------
    catalogue : Catalogue
    """

    def __init__(self, catalogue: Catalogue) -> None:
        self._names: dict[tuple[str, ...], dict[str, None]] = {}
        self._synonyms: dict[tuple[str, ...], dict[str, None]] = {}
        self._memory: dict[tuple[str, ...], frozenset[str]] = {}
        self.categories = catalogue.categories
        self._words_of = {name: frozenset(stems(name.replace("_", " "))) for name in catalogue.categories}
        self._ranks: dict[tuple[str, str, str], int] = {}
        for category in catalogue.categories:
            self._names.setdefault(stems(category.replace("_", " ")), {})[category] = None
            for asset in named_variants(catalogue, category):
                self._names.setdefault(stems(asset.name), {})[category] = None
                for synonym in asset.synonyms:
                    self._synonyms.setdefault(stems(synonym), {})[category] = None

    def exact(self, words: tuple[str, ...]) -> list[str]:
        """Return the categories called exactly so; by synonym where none has the name itself.

        Compounds may end with another word for the same (``wall cupboard`` of a wall cabinet) where nothing has their
        own name.
        """
        return list(self._names.get(words) or self._synonyms.get(words, {})) or self._alike(words)

    def _alike(self, words: tuple[str, ...]) -> list[str]:
        """Return the categories that a compound names with another word for its last one."""
        if len(words) < 2 or words[-1] not in _ALIKE:
            return []
        others = [(*words[:-1], other) for other in words_alike().get(words[-1], ())]
        return list(dict.fromkeys(kind for name in others for kind in self._names.get(name, {})))

    def synonymous(self, words: tuple[str, ...]) -> list[str]:
        """Return the categories with these words as a synonym, whether or not others have them as their name."""
        return list(self._synonyms.get(words, {}))

    def ending(self, words: tuple[str, ...]) -> list[str]:
        """Return the categories with a synonym that ends with these words (``rack`` of a towel rack)."""
        found = [own for name, own in self._synonyms.items() if words and name[-len(words) :] == words]
        return list(dict.fromkeys(category for own in found for category in own))

    def generic(self, words: tuple[str, ...]) -> list[str]:
        """Return the categories of which a general word (``table``) is the last part."""
        if len(words) != 1 or words[0] not in _GENERIC:
            return []
        ends = _GENERIC[words[0]]
        return [c for c in self.categories if c.endswith(ends) and not c.endswith("cabin")]

    def containing(self, words: tuple[str, ...]) -> list[str]:
        """Return the categories whose name has all of these words."""
        wanted = set(words)
        return [name for name, own in self._words_of.items() if wanted and wanted <= own]

    def nouns(self, text: str) -> list[str]:
        """Return the categories that a noun names: by name, synonym or general word, or by the end of the name."""
        words = _without_colours(stems(text))
        tails = [c for c in self.containing(words) if stems(c.replace("_", " "))[-1] in words]
        return list(dict.fromkeys((*self.exact(words), *self.generic(words), *tails)))

    def rank(self, item: SceneObject, text: str) -> int:
        """Return how well a keyword fits an object.

        3 by name, 2 by synonym or the end of the name (``desk`` of an office desk), 1 by another part of it (a desk
        phone), 0 not at all.
        """
        key = (item.category, item.name, text)
        if key not in self._ranks:
            if len(self._ranks) > _MOST_RANKS:
                self._ranks.clear()
            self._ranks[key] = self._rank(item.category, item.name, text)
        return self._ranks[key]

    def _rank(self, category: str, name: str, text: str) -> int:
        words = _without_colours(stems(text))
        if not words:
            return 0
        names = (stems(category.replace("_", " ")), stems(name))
        if words in names:
            return 3
        if category in self._meant(words):
            return 2
        fits = [name for name in names if set(words) <= set(name)]
        return max((2 if name[-1] in words else 1 for name in fits), default=0)

    def _meant(self, words: tuple[str, ...]) -> frozenset[str]:
        if words not in self._memory:
            if len(self._memory) > 4096:
                self._memory.clear()
            self._memory[words] = frozenset((*self.exact(words), *self.generic(words)))
        return self._memory[words]


def _without_colours(words: tuple[str, ...]) -> tuple[str, ...]:
    """Drop colours, unless nothing else is left (an orange)."""
    rest = tuple(word for word in words if word not in COLOUR_WORDS)
    return rest or words


@lru_cache(maxsize=4)
def vocabulary_of(catalogue: Catalogue) -> Vocabulary:
    """Return the vocabulary of a catalogue, made once."""
    return Vocabulary(catalogue)

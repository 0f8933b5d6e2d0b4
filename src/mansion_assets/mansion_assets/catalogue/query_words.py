"""The words of a search: which of them count, how much, and in which form they are compared."""

import re
from collections.abc import Sequence
from functools import cache, lru_cache
from typing import Final

import msgspec

from mansion_assets.catalogue.palette import COLOURS, FAMILIES
from mansion_language import singular

__all__ = ["QueryWord", "base", "plain_words", "query_words", "stem"]

_STOP_TEXT: Final = (
    "a an the of for to in on at with and or some something thing things that which who whom is are be am it its my "
    "your our we i you need want find get put place where used use using can from by new any one piece object item "
    "spot somewhere someone somebody anything me him her them they his their mine us away up down out off into onto "
    "one's own so before after when while without not no let lets something's s t as this these those there here what "
    "how does do did has have having kind sort type like made full please would could should than then also very too "
    "he she people person few several many much more most such each every all both other another during over under "
    "above below inside upon among around between behind beside next near go goes going several"
)
_STOP: Final = frozenset(_STOP_TEXT.split())
_PREPOSITIONS: Final = frozenset(
    "of for to in on at with that which who from by into onto under over behind beside next near where when as without "
    "made used using full while like during before after between through across against along around has above below "
    "inside outside upon among underneath".split()
)
_NEGATIONS: Final = frozenset(["without", "no", "not"])
_HEAD: Final = 1.35
_AFTER: Final = 0.9
_LOOK: Final = 0.4
"""Weight of a word for a colour or material that another word follows; other words have about 1."""

_WHOLE: Final = frozenset(
    "boxing ceiling clothing wedding building string spring evening morning during ring king wing sling thing ping "
    "bring nothing shed bed red speed feed seed need weed reed hundred".split()
)
"""Words whose ending only looks like that of a verb's form."""


class QueryWord(msgspec.Struct, frozen=True):
    """A word of a query and how much it says."""

    text: str
    weight: float


def plain_words(text: str) -> list[str]:
    """Return the words of a text in small letters and in the singular."""
    letters = text.lower().replace("'s", "").replace("\u2019s", "")
    return [base(word) for word in re.findall(r"[a-z0-9]+", letters)]


@lru_cache(maxsize=16384)
def base(word: str) -> str:
    """Return the singular of a word."""
    return singular(word)


@lru_cache(maxsize=16384)
def stem(word: str) -> str:
    """Return what the forms of a verb and the nouns of its doer have in common ("bake", "baking", "baked").

    Examples
    --------
    >>> [stem(word) for word in ("baking", "bakes", "cutting", "carried", "boxing", "dryer", "sewn")]
    ['bak', 'bak', 'cut', 'carry', 'boxing', 'dry', 'sewn']
    """
    word = base(word)
    if word in _WHOLE:
        return word
    for ending in ("ing", "ied", "ed", "ier", "er", "or", "e"):
        root = word[: -len(ending)]
        if word.endswith(ending) and ending in ("ied", "ier") and len(root) > 1:
            return root + "y"
        if not word.endswith(ending) or len(root) < 3 or not re.search("[aeiouy]", root):
            continue
        if len(root) > 3 and root[-1] == root[-2] and root[-1] not in "lsz":
            return root[:-1]
        return root
    return word


@cache
def _looks() -> frozenset[str]:
    """Return the words for colours and materials, which seldom name the object that is wanted."""
    return frozenset(base(word) for word in (*COLOURS, *FAMILIES))


def query_words(query: str) -> list[QueryWord]:
    """Return the words of a query that describe the object, each with its weight.

    The last word before the first preposition names the thing ("table" in "table for examining patients"), or the
    first one what is done with it ("to cut bread with"): it counts most. Colours and materials before another word
    count little, words that follow "without" not at all.
    """
    letters = query.lower().replace("'s", "").replace("\u2019s", "")
    raw = re.findall(r"[a-z0-9]+", letters)
    places = {word: number for number, word in reversed(list(enumerate(raw)))}
    wanted = [number for word, number in reversed(places.items()) if word not in _STOP] or list(range(len(raw)))
    head = _head(raw, wanted)
    out = []
    for number in wanted:
        if number and raw[number - 1] in _NEGATIONS:
            continue
        word = base(raw[number])
        last = number == wanted[-1]
        weight = _HEAD if number == head else 1.0 if head is None or number < head else _AFTER
        if word in _looks() and not last and number != head:
            weight = _LOOK
        out.append(QueryWord(word, weight))
    return out


def _head(raw: Sequence[str], wanted: Sequence[int]) -> int | None:
    first = next((number for number in range(len(raw)) if raw[number] in _PREPOSITIONS), len(raw))
    before = [number for number in wanted if number < first]
    if before:
        return before[-1]
    return wanted[0] if wanted and raw[0] in ("to", "for") else None

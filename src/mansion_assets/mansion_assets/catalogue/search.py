"""Text search over the catalogue: BM25 over words, character trigrams for spelling, phrases of synonyms.

BM25 after S. Robertson and H. Zaragoza, "The Probabilistic Relevance Framework: BM25 and Beyond", Foundations and
Trends in Information Retrieval 3(4), 2009, with k1 = 1.2 and b = 0.4.
"""

import math
import re
from collections import Counter
from collections.abc import Sequence
from difflib import SequenceMatcher
from functools import cache, lru_cache
from importlib.resources import files
from typing import Final

import msgspec

from mansion_assets.catalogue.asset import Asset
from mansion_assets.catalogue.catalogue import Catalogue
from mansion_assets.catalogue.palette import COLOURS, FAMILIES
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["PROPERTIES", "SearchHit", "having", "mixed", "search_assets", "use_of", "uses_by_category", "word_scores"]

_FILE: Final = "uses.json"


@cache
def uses_by_category() -> dict[str, str]:
    """Return what categories are used for; not all have an entry."""
    text = files("mansion_assets.catalogue").joinpath("data", _FILE).read_bytes()
    return msgspec.json.decode(text, type=dict[str, str])


def use_of(category: str) -> str:
    """Return what a category is used for, in a few words; empty where nothing is known."""
    return uses_by_category().get(category, "")


PROPERTIES: Final[dict[str, str]] = {
    "pickupable": "pickupable",
    "pickable": "pickupable",
    "canpickup": "pickupable",
    "receptacle": "receptacle",
    "openable": "openable",
    "canopen": "openable",
    "toggleable": "toggleable",
    "cantoggleonoff": "toggleable",
    "thor": "thor",
}
"""Accepted property names, in small letters without separators, and the field that each tests."""

_STOP_TEXT: Final = (
    "a an the of for to in on at with and or some something thing things that which is are it my your our we i "
    "you need want find get put place where used use can from by new any one piece object item spot somewhere "
    "someone somebody anything me him her them his their mine us away up down out off into onto one's own so "
    "before after when while without not no let lets something's s"
)
_STOP: Final = frozenset(_STOP_TEXT.split())
_K1, _B = 1.2, 0.4
_LOOK: Final = 0.4
"""Weight of a word for a colour or material that another word follows; other words have 1."""

_WEIGHTS: Final = (("name", 3.0), ("synonym", 2.2), ("use", 1.2), ("tag", 0.8), ("room", 0.12))


class SearchHit(msgspec.Struct, frozen=True):
    """An asset and how well it fits; scores compare within one search only."""

    asset: Asset
    score: float


def _stem(word: str) -> str:
    for ending, repl in (("ies", "y"), ("sses", "ss"), ("shes", "sh"), ("ches", "ch"), ("xes", "x"), ("ves", "f")):
        if word.endswith(ending) and len(word) > len(ending) + 1:
            return word[: -len(ending)] + repl
    if word.endswith("s") and not word.endswith(("ss", "us", "is")) and len(word) > 3:
        word = word[:-1]
    if word.endswith("ing") and len(word) > 5:
        word = word[:-3]
        return word[:-1] if len(word) > 2 and word[-1] == word[-2] else word
    return word


def _words(text: str) -> list[str]:
    return [_stem(w) for w in re.findall(r"[a-z0-9]+", text.lower())]


def _content(text: str) -> list[str]:
    raw = re.findall(r"[a-z0-9]+", text.lower())
    return [_stem(w) for w in raw if w not in _STOP] or [_stem(w) for w in raw]


@cache
def _looks() -> frozenset[str]:
    """Return the words for colours and materials, which seldom name the object that is wanted."""
    return frozenset(_stem(word) for word in (*COLOURS, *FAMILIES))


def _trigrams(word: str) -> set[str]:
    padded = f" {word} "
    return {padded[i : i + 3] for i in range(len(padded) - 2)}


class _Index:
    """The words and phrases of each category."""

    def __init__(self, catalogue: Catalogue) -> None:
        self.categories = catalogue.categories
        self.terms: list[Counter[str]] = []
        self.phrases: list[list[tuple[str, ...]]] = []
        for name in self.categories:
            asset = catalogue.by_category(name)[0]
            fields = {
                "name": [asset.name, name.replace("_", " ")],
                "synonym": list(asset.synonyms),
                "use": [use_of(name)],
                "tag": list(asset.tags),
                "room": [room.replace("_", " ") for room in asset.rooms[:12]],
            }
            terms: Counter[str] = Counter()
            for field, weight in _WEIGHTS:
                for word in {w for text in fields[field] for w in _words(text)}:
                    terms[word] += weight  # type: ignore[assignment]
            self.terms.append(terms)
            texts = [*fields["name"], *fields["synonym"]]
            self.phrases.append(sorted({tuple(_words(t)) for t in texts}, key=lambda p: (-len(p), p)))
        self.mean = sum(sum(t.values()) for t in self.terms) / max(1, len(self.terms))
        count = Counter(word for terms in self.terms for word in terms)
        total = len(self.terms)
        self.idf = {w: math.log(1 + (total - n + 0.5) / (n + 0.5)) for w, n in count.items()}
        self.grams = {word: _trigrams(word) for word in self.idf}

    def near(self, word: str) -> list[tuple[str, float]]:
        """Return the index's words like a misspelt or compound one, with a weight below 1."""
        grams = _trigrams(word)
        found = []
        for other, theirs in self.grams.items():
            share = 2 * len(grams & theirs) / (len(grams) + len(theirs))
            if len(other) > 3 and len(word) > 3 and (word.startswith(other) or word.endswith(other)):
                share = max(share, 0.62)
            if word[0] == other[0] and abs(len(word) - len(other)) <= 2 and len(word) > 4:
                share = max(share, SequenceMatcher(None, word, other).ratio() - 0.15)
            if share >= 0.45:
                found.append((other, 0.8 * share))
        found.sort(key=lambda pair: (-pair[1], pair[0]))
        return found[:3]

    def joined(self, words: list[str]) -> list[str]:
        """Return words in which those that the index writes as one (key board) are one."""
        out: list[str] = []
        for word in words:
            if out and out[-1] + word in self.idf:
                out[-1] += word
            else:
                out.append(word)
        return out

    def scores(self, query: str) -> list[float]:
        """Return each category's score."""
        words = self.joined(_content(query))
        weighted: list[tuple[str, float]] = []
        for number, word in enumerate(words, 1):
            if word in _looks() and number < len(words):
                weighted.append((word, _LOOK))
            else:
                weighted += [(word, 1.0)] if word in self.idf else self.near(word)
        out = []
        asked = tuple(_words(query))
        bare = tuple(words)
        for terms, phrases in zip(self.terms, self.phrases, strict=True):
            length = 1 - _B + _B * sum(terms.values()) / self.mean
            score = sum(
                weight * self.idf[w] * terms[w] * (_K1 + 1) / (terms[w] + _K1 * length)
                for w, weight in weighted
                if w in terms
            )
            out.append(score + _phrase_bonus(phrases, asked, bare))
        return out


def _phrase_bonus(phrases: Sequence[tuple[str, ...]], asked: tuple[str, ...], bare: tuple[str, ...]) -> float:
    """Reward a name or synonym that the query is, ends with, or contains, the longest first."""
    best = 0.0
    for phrase in phrases:
        n = len(phrase)
        if phrase in (asked, bare):
            best = max(best, 14.0)
        elif n <= len(bare) and any(bare[i : i + n] == phrase for i in range(len(bare) - n + 1)):
            best = max(best, 3.0 * n + (1.5 if bare[-n:] == phrase else 0.0))
    return best


@lru_cache(maxsize=4)
def _index(catalogue: Catalogue) -> _Index:
    return _Index(catalogue)


def search_assets(catalogue: Catalogue, query: str, top_k: int = 5, properties: Sequence[str] = ()) -> list[SearchHit]:
    """Return the assets that fit a text best, the best first.

    Parameters
    ----------
    query : str
        Free text; colours and materials in it choose among the variants of a category.
    top_k : int
        Greatest number of hits.
    properties : sequence of str
        Each must hold: ``pickupable``, ``receptacle``, ``openable``, ``toggleable``, ``thor`` (has an AI2-THOR id);
        AI2-THOR's own names (``CanPickup``, ...) count too.

    Notes
    -----
    The first hits come from different categories where several fit about as well; further variants follow.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for an unknown property.
    """
    fields = [_field(name) for name in properties]
    index = _index(catalogue)
    scores = index.scores(query)
    order = sorted(range(len(scores)), key=lambda i: (-scores[i], i))
    groups: list[list[SearchHit]] = []
    for i in order:
        if scores[i] <= 0.0 or len(groups) > top_k:
            break
        variants = [a for a in catalogue.by_category(index.categories[i]) if _holds(a, fields)]
        hits = [SearchHit(a, round(scores[i] + _look(a, query), 4)) for a in variants]
        hits.sort(key=lambda hit: -hit.score)
        if hits:
            groups.append(hits)
    return mixed(groups, top_k)


def mixed(groups: Sequence[Sequence[SearchHit]], top_k: int) -> list[SearchHit]:
    """Return the first hits of groups, each sorted: in turn from those that fit about as well as the first group."""
    best = groups[0][0].score if groups else 0.0
    near = [g[0].score >= 0.45 * best for g in groups]
    close = [g for g, is_near in zip(groups, near, strict=True) if is_near]
    far = [hit for g, is_near in zip(groups, near, strict=True) if not is_near for hit in g]
    depth = max((len(g) for g in close), default=0)
    turns = [g[level] for level in range(depth) for g in close if level < len(g)]
    return [*turns, *far][:top_k]


def word_scores(catalogue: Catalogue, query: str) -> dict[str, float]:
    """Return how well each category fits a text by its words; they compare within one search only."""
    index = _index(catalogue)
    return dict(zip(index.categories, index.scores(query), strict=True))


def having(catalogue: Catalogue, properties: Sequence[str]) -> list[Asset]:
    """Return the assets that have all the properties (see `search_assets`), in the catalogue's order.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for an unknown property.
    """
    fields = [_field(name) for name in properties]
    return [asset for asset in catalogue.assets.values() if _holds(asset, fields)]


def _field(name: str) -> str:
    field = PROPERTIES.get(re.sub(r"[^a-z]", "", name.lower()))
    if field is None:
        accepted = ", ".join(sorted(set(PROPERTIES.values())))
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, f"unknown property {name!r}; accepted: {accepted}", path="$.properties"
        )
    return field


def _holds(asset: Asset, fields: Sequence[str]) -> bool:
    return all(asset.asset_id is not None if field == "thor" else bool(getattr(asset, field)) for field in fields)


def _look(asset: Asset, query: str) -> float:
    """Return a small bonus for each colour or material that the query names and the asset has."""
    words = set(re.findall(r"[a-z]+", query.lower()))
    named = words & (COLOURS.keys() | FAMILIES.keys())
    parts = set(asset.material.split("_"))
    return 0.5 * len(named & parts)

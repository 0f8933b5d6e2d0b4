"""An index of the catalogue's words: BM25F over names, synonyms, uses, looks and general notions.

BM25F after S. Robertson and H. Zaragoza, "The Probabilistic Relevance Framework: BM25 and Beyond", Foundations and
Trends in Information Retrieval 3(4), 2009.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from difflib import SequenceMatcher
from functools import lru_cache
from typing import Final

from mansion_assets.catalogue.catalogue import Catalogue
from mansion_assets.catalogue.descriptions import description_of, hypernyms, hypernyms_of, words_alike
from mansion_assets.catalogue.query_words import QueryWord, plain_words, query_words, stem
from mansion_assets.catalogue.vocabulary import named_variants
from mansion_knowledge.common_words import common_words

__all__ = ["WordIndex", "word_index"]

_FIELDS: Final = (
    ("name", 3.0, 0.3),
    ("synonym", 2.2, 0.2),
    ("called", 1.9, 0.2),
    ("use", 1.5, 0.4),
    ("look", 1.2, 0.4),
    ("hypernym", 0.7, 0.4),
    ("tag", 0.5, 0.3),
    ("room", 0.12, 0.2),
)
"""Fields with their weight and how much their length counts (b)."""

_K1: Final = 1.2
_FORM: Final = 0.75
"""Weight of a word that is there in another form."""
_ALIKE: Final = 0.55
"""Weight of a word that means about the same."""
_SURE: Final = 0.54
"""Weight from which a word is taken for a misspelling rather than a compound."""
_EXACT: Final = 14.0
"""Reward of a category of which the query is a name or synonym."""
_OWN: Final = 3.0
"""Further reward of one of which it is the very name."""
_CALLED: Final = 8.0
"""Reward of one that people also call so, below the most typical members of a general notion of that name."""
_LOOSELY: Final = 0.6
"""Share of a contained name's reward for what people also call a category."""
_NOTION: Final = 10.0
"""Reward of the most typical member of a general notion that the query names."""


class WordIndex:
    """The words and phrases of each category.

    Parameters
    ----------
    catalogue : Catalogue
    """

    def __init__(self, catalogue: Catalogue) -> None:
        self.categories = catalogue.categories
        numbers = {name: number for number, name in enumerate(self.categories)}
        texts = [_texts_of(catalogue, name) for name in self.categories]
        self._words = _postings(texts, plain_words)
        self._stems = _postings(texts, lambda text: [stem(word) for word in plain_words(text)])
        self._phrases = _phrases(texts, ("name", "synonym"))
        self._names = _phrases(texts, ("name",))
        self._called = _phrases(texts, ("called",))
        self._notions: dict[tuple[str, ...], list[int]] = {}
        self._bare_notions: dict[tuple[str, ...], list[int]] = {}
        for notion in hypernyms():
            members = [numbers[name] for name in notion.categories if name in numbers]
            for name in notion.names:
                self._notions.setdefault(tuple(plain_words(name)), []).extend(members)
                self._bare_notions.setdefault(tuple(w.text for w in query_words(name)), []).extend(members)
        self._grams: dict[str, list[str]] = {}
        for word in self._words:
            for gram in _trigrams(word):
                self._grams.setdefault(gram, []).append(word)
        self._near: dict[str, list[tuple[str, float]]] = {}

    def scores(self, query: str) -> list[float]:
        """Return how well each category fits a query, in the order of `categories`."""
        wanted = self._spelt(self._joined(query_words(query)))
        total = [0.0] * len(self.categories)
        for word in wanted:
            for number, value in self._fits(word.text).items():
                total[number] += word.weight * value
        for number, bonus in self._bonus(query, wanted).items():
            total[number] += bonus
        return total

    def is_name(self, query: str) -> bool:
        """Return whether a query is the name or a synonym of a category, maybe with an article."""
        return any(
            words in self._phrases for words in (tuple(plain_words(query)), tuple(w.text for w in query_words(query)))
        )

    def knows(self, word: str) -> bool:
        """Return whether a word, a form of it or a word alike is in the index."""
        return word in self._words or stem(word) in self._stems or word in words_alike()

    def _fits(self, word: str) -> dict[int, float]:
        """Return how well categories fit one word: as it stands, in another form, by a word alike, or misspelt."""
        out: dict[int, float] = dict(self._words.get(word, {}))
        _raise(out, self._stems.get(stem(word), {}), _FORM)
        for other in words_alike().get(word, ()):
            _raise(out, self._words.get(other, {}), _ALIKE)
        if not out:
            for other, weight in self._like(word):
                _raise(out, self._words[other], weight)
        return out

    def _like(self, word: str) -> list[tuple[str, float]]:
        """Return words of the index that a word unknown to it is made of or is a misspelling of."""
        if word not in self._near:
            misspelt = self._misspelt(word)
            sure = misspelt and misspelt[0][1] >= _SURE
            self._near[word] = misspelt if sure else self._parts(word) or misspelt
        return self._near[word]

    def _parts(self, word: str) -> list[tuple[str, float]]:
        """Return the two words that a compound is made of, or the known one at its end."""
        for cut in range(3, len(word) - 2):
            if word[:cut] in self._words and word[cut:] in self._words:
                return [(word[:cut], 0.6), (word[cut:], 0.9)]
        return [(word[cut:], 0.5) for cut in range(3, len(word) - 3) if word[cut:] in self._words][:1]

    def _misspelt(self, word: str) -> list[tuple[str, float]]:
        common = word in common_words()
        grams = _trigrams(word)
        shared: dict[str, int] = {}
        for gram in sorted(grams):
            for other in self._grams.get(gram, ()):
                shared[other] = shared.get(other, 0) + 1
        found = []
        for other, count in shared.items():
            share = 2 * count / (len(grams) + len(_trigrams(other)))
            if word[0] == other[0] and abs(len(word) - len(other)) <= 2 and len(word) > 3:
                share = max(share, SequenceMatcher(None, word, other).ratio() - 0.15)
            start = _shared_start(word, other)
            if start >= 5 and start >= 0.6 * max(len(word), len(other)):
                share = max(share, 0.6)
            elif common:
                continue
            if share >= 0.5:
                found.append((other, 0.8 * share))
        found.sort(key=lambda pair: (-pair[1], pair[0]))
        return [pair for pair in found[:3] if pair[1] >= 0.85 * found[0][1]]

    def _joined(self, words: Sequence[QueryWord]) -> list[QueryWord]:
        """Return words in which those that the index writes as one (key board) are one."""
        out: list[QueryWord] = []
        for word in words:
            if out and out[-1].text + word.text in self._words:
                out[-1] = QueryWord(out[-1].text + word.text, max(out[-1].weight, word.weight))
            else:
                out.append(word)
        return out

    def _spelt(self, words: Sequence[QueryWord]) -> list[QueryWord]:
        """Return words in which a compound is its two parts and a clear misspelling is what was meant."""
        out: list[QueryWord] = []
        for word in words:
            like = [] if self.knows(word.text) else self._like(word.text)
            parts = [other for other, _ in like]
            if len(like) == 2 and "".join(parts) == word.text:
                out += [QueryWord(parts[0], min(1.0, word.weight)), QueryWord(parts[1], word.weight)]
            elif like and like[0][1] >= _SURE:
                out.append(QueryWord(parts[0], word.weight))
            else:
                out.append(word)
        return out

    def _bonus(self, query: str, wanted: Sequence[QueryWord]) -> dict[int, float]:
        """Reward names, synonyms and general notions that the query is, or contains."""
        asked = tuple(plain_words(query))
        bare = tuple(word.text for word in wanted)
        best = max((word.weight for word in wanted), default=0.0)
        out: dict[int, float] = {}
        for phrase in (asked, bare):
            _raise(out, dict.fromkeys(self._called.get(phrase, ()), _CALLED), 1.0)
            _raise(out, dict.fromkeys(self._phrases.get(phrase, ()), _EXACT), 1.0)
            _raise(out, dict.fromkeys(self._names.get(phrase, ()), _EXACT + _OWN), 1.0)
        for start in range(len(bare)):
            for end in range(start + 1, len(bare) + 1):
                if end - start == len(bare):
                    continue
                head = wanted[end - 1].weight >= best
                bonus = (3.0 if head or end - start > 1 else 1.2) * (end - start) + (1.5 if head else 0.0)
                _raise(out, dict.fromkeys(self._phrases.get(bare[start:end], ()), bonus), 1.0)
                _raise(out, dict.fromkeys(self._called.get(bare[start:end], ()), bonus), _LOOSELY)
        members = self._notions.get(asked) or self._bare_notions.get(bare)
        for rank, number in enumerate(members or ()):
            _raise(out, {number: _NOTION - 0.2 * min(rank, 15)}, 1.0)
        return out


def _texts_of(catalogue: Catalogue, category: str) -> dict[str, list[str]]:
    variants = named_variants(catalogue, category)
    asset = variants[0]
    known = description_of(category)
    return {
        "name": [asset.name, category.replace("_", " "), *_others([asset.name], [[v.name] for v in variants])],
        "synonym": [*asset.synonyms, *_others(asset.synonyms, [v.synonyms for v in variants])],
        "called": [phrase for phrase in known.called.split("; ") if phrase],
        "use": [known.use],
        "look": [known.look],
        "hypernym": hypernyms_of(category),
        "tag": list(asset.tags),
        "room": [room.replace("_", " ") for room in asset.rooms[:12]],
    }


def _others(first: Sequence[str], groups: Iterable[Sequence[str]]) -> list[str]:
    """Return the phrases of all groups that are not among the first, each once."""
    return [phrase for phrase in dict.fromkeys(phrase for group in groups for phrase in group) if phrase not in first]


def _postings(texts: Sequence[dict[str, list[str]]], split: Callable[[str], list[str]]) -> dict[str, dict[int, float]]:
    """Return for each word the categories that have it, with its part of their score."""
    fields = [{name: [w for text in each[name] for w in split(text)] for name, _, _ in _FIELDS} for each in texts]
    counts: dict[str, dict[int, float]] = {}
    for name, weight, share in _FIELDS:
        mean = sum(len(each[name]) for each in fields) / max(1, len(fields)) or 1.0
        for number, each in enumerate(fields):
            length = 1 - share + share * len(each[name]) / mean
            for word in dict.fromkeys(each[name]):
                places = counts.setdefault(word, {})
                places[number] = places.get(number, 0.0) + weight / length
    total = len(texts)
    out: dict[str, dict[int, float]] = {}
    for word, places in counts.items():
        rarity = math.log(1 + (total - len(places) + 0.5) / (len(places) + 0.5))
        out[word] = {n: rarity * count * (_K1 + 1) / (count + _K1) for n, count in places.items()}
    return out


def _phrases(texts: Iterable[dict[str, list[str]]], fields: Sequence[str]) -> dict[tuple[str, ...], list[int]]:
    out: dict[tuple[str, ...], list[int]] = {}
    for number, each in enumerate(texts):
        for phrase in dict.fromkeys(tuple(plain_words(text)) for field in fields for text in each[field]):
            out.setdefault(phrase, []).append(number)
    return out


def _raise(scores: dict[int, float], others: dict[int, float], weight: float) -> None:
    for number, value in others.items():
        scores[number] = max(scores.get(number, 0.0), weight * value)


def _trigrams(word: str) -> set[str]:
    padded = f" {word} "
    return {padded[i : i + 3] for i in range(len(padded) - 2)}


def _shared_start(one: str, other: str) -> int:
    return next((n for n, (a, b) in enumerate(zip(one, other, strict=False)) if a != b), min(len(one), len(other)))


@lru_cache(maxsize=4)
def word_index(catalogue: Catalogue) -> WordIndex:
    """Return the index of a catalogue, made once."""
    return WordIndex(catalogue)

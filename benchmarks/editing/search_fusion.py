"""Ways to join words and embeddings in the search of assets.

``python benchmarks/editing/search_fusion.py [LIST.json ...]``

Each way has a few settings; the best on four fifths of the categories is measured on the last fifth, in turn. A query
is answered when one of the first three categories is accepted. The model is ``wordllama`` (the extra ``vectors``).
Lists as in `search.py`.
"""

import argparse
from pathlib import Path

import numpy as np
import numpy.typing as npt
from search import Wanted, named, read_list

from mansion_assets.catalogue import Catalogue, load_catalogue
from mansion_assets.catalogue.query_words import query_words
from mansion_assets.catalogue.search import word_scores
from mansion_assets.catalogue.word_index import word_index
from mansion_assets.retrieval.static_vectors import packaged_encoder
from mansion_assets.retrieval.vectors import CatalogueVectors

HERE = Path(__file__).parent
LISTS = tuple(HERE / f"queries_{kind}.json" for kind in ("synonyms", "uses", "descriptions"))
FOLDS = 5

Scores = npt.NDArray[np.float64]
Flags = npt.NDArray[np.bool_]


def main() -> None:
    """Print a line for each way."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("lists", nargs="*", type=Path, default=LISTS, help="lists of queries")
    catalogue = load_catalogue()
    queries = [wanted for file in parser.parse_args().lists for wanted in read_list(file)]
    accepted = np.array([_accepted(catalogue, wanted) for wanted in queries])
    words, likeness = _by_words(catalogue, queries), _by_embeddings(catalogue, queries)
    unknown = np.array([_has_unknown_word(catalogue, wanted.query) for wanted in queries])
    fold = accepted.argmax(axis=1) % FOLDS
    for name, settings in _ways(words, likeness, unknown).items():
        right = [np.take_along_axis(accepted, _order(scores)[:, :3], 1).any(axis=1) for scores in settings]
        held = np.zeros(len(queries), dtype=bool)
        for number in range(FOLDS):
            best = max(right, key=lambda one: one[fold != number].mean())
            held[fold == number] = best[fold == number]
        print(f"{name:42} {100 * held.mean():.1f}% of {len(queries)}")


def _ways(words: Scores, likeness: Scores, unknown: Flags) -> dict[str, list[Scores]]:
    best = words / np.maximum(words.max(axis=1, keepdims=True), 1e-9)
    rank, other = _order(words).argsort(axis=1), _order(likeness).argsort(axis=1)
    weighted = {weight: likeness + weight * best for weight in (0.2, 0.3, 0.4, 0.6, 0.8)}
    return {
        "words": [words],
        "embeddings": [likeness],
        "weighted, the best by words as 1": list(weighted.values()),
        "weighted, scores of words as they are": [likeness + words / size for size in (12.0, 20.0, 25.0, 40.0, 50.0)],
        "reciprocal ranks": [1 / (k + rank) * (words > 0) + 1 / (k + other) for k in (2.0, 5.0, 20.0, 60.0)],
        "embeddings where a word is unknown": [np.where(unknown[:, None], one, best) for one in weighted.values()],
    }


def _order(scores: Scores) -> npt.NDArray[np.intp]:
    return np.argsort(-scores, axis=1, kind="stable")


def _accepted(catalogue: Catalogue, wanted: Wanted) -> list[bool]:
    return [
        any(named(asset, wanted.any_of) for asset in catalogue.by_category(category))
        for category in catalogue.categories
    ]


def _by_words(catalogue: Catalogue, queries: list[Wanted]) -> Scores:
    return np.array([list(word_scores(catalogue, wanted.query).values()) for wanted in queries])


def _by_embeddings(catalogue: Catalogue, queries: list[Wanted]) -> Scores:
    encoder = packaged_encoder()
    vectors = CatalogueVectors(encoder)
    place = {asset.key: number for number, asset in enumerate(catalogue.assets.values())}
    rows = [[place[asset.key] for asset in catalogue.by_category(name)] for name in catalogue.categories]
    found = [vectors.likeness(catalogue, asked) for asked in encoder.encode([wanted.query for wanted in queries])]
    return np.array([[one[own].max() for own in rows] for one in found])


def _has_unknown_word(catalogue: Catalogue, query: str) -> bool:
    index = word_index(catalogue)
    return not all(index.knows(word.text) for word in query_words(query))


if __name__ == "__main__":
    main()

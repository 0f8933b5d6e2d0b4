"""Asset search by words and by embeddings: ``python benchmarks/editing/search.py [LIST.json ...] [--model FOLDER]``.

A list holds queries with the categories that answer each: rows ``[query, categories]`` or objects with ``query`` and
``any_of``. A query is answered when an asset among the first three is of one of them, by its category, name or a
synonym. Embeddings are measured with the sentence-transformers model of a folder (the extra ``embeddings``), else with
the one that ``MANSION_EMBEDDINGS_MODEL`` names (``wordllama`` with the extra ``vectors``).
"""

import argparse
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import msgspec

from mansion_assets.catalogue import Asset, Catalogue, load_catalogue
from mansion_assets.retrieval.configured import configured_retriever
from mansion_assets.retrieval.embedding_retriever import EmbeddingRetriever
from mansion_assets.retrieval.encoders import FolderEncoder
from mansion_assets.retrieval.retriever import Retriever, TextRetriever
from mansion_language import singular

TESTS = Path(__file__).parents[2] / "tests" / "assets" / "catalogue"
LISTS = (
    TESTS / "search_queries.json",
    TESTS / "search_queries_worded.json",
    *(
        Path(__file__).with_name(f"queries_{name}.json")
        for name in (
            *("training", "checking", "first_sight"),
            *("synonyms", "uses", "descriptions"),
            *("fresh", "fresh_2"),
        )
    ),
)


class Wanted(msgspec.Struct, frozen=True):
    """A query and the names of the categories that answer it."""

    query: str
    any_of: list[str]


def read_list(file: Path) -> list[Wanted]:
    """Return the queries of a list of either form."""
    rows: list[Any] = msgspec.json.decode(file.read_bytes())
    return [Wanted(*row) if isinstance(row, list) else msgspec.convert(row, Wanted) for row in rows]


def named(asset: Asset, names: Sequence[str]) -> bool:
    """Return whether one of the names is the asset's category, name or synonym."""
    own = {_plain(text) for text in (asset.category, asset.name, *asset.synonyms)}
    return any(_plain(name) in own for name in names)


def _plain(name: str) -> str:
    return " ".join(singular(word) for word in name.lower().replace("_", " ").replace("-", " ").split())


def missed(retriever: Retriever, catalogue: Catalogue, queries: Sequence[Wanted]) -> list[tuple[Wanted, list[str]]]:
    """Return the queries without an accepted category, with what came instead."""
    out = []
    for wanted in queries:
        found = retriever.retrieve(catalogue, wanted.query, 3, ())
        assert not found.note, found.note
        if not any(named(hit.asset, wanted.any_of) for hit in found.hits):
            out.append((wanted, [hit.asset.category for hit in found.hits]))
    return out


def retrievers(model: Path | None) -> dict[str, Retriever]:
    """Return what is measured, by name."""
    out: dict[str, Retriever] = {"words": TextRetriever()}
    if model:
        encoder = FolderEncoder(model.resolve())
        return {**out, "embeddings": EmbeddingRetriever(encoder, words=0.0), "both": EmbeddingRetriever(encoder)}
    configured = configured_retriever()
    return out if isinstance(configured, TextRetriever) else {**out, "both": configured}


def main() -> None:
    """Print a line for each retriever and list."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("lists", nargs="*", type=Path, default=LISTS, help="lists of queries, else our own")
    parser.add_argument("--model", type=Path, help="folder of an embedding model")
    parser.add_argument("--show", action="store_true", help="print the queries that were missed")
    given = parser.parse_args()
    catalogue = load_catalogue()
    for name, retriever in retrievers(given.model).items():
        retriever.retrieve(catalogue, "mug", 3, ())
        for file in given.lists:
            queries = read_list(file)
            start = time.process_time()
            wrong = missed(retriever, catalogue, queries)
            each = 1000 * (time.process_time() - start) / len(queries)
            right = len(queries) - len(wrong)
            share = 100 * right / len(queries)
            print(f"{name:10} {file.name:28} {right} of {len(queries)} ({share:.1f}%), {each:.1f} ms CPU each")
            if given.show:
                for wanted, names in wrong:
                    print(f"    {wanted.query}: {', '.join(names)}; not {', '.join(wanted.any_of)}")


if __name__ == "__main__":
    main()

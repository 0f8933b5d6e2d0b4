"""Asset search by words, by embeddings and by both: ``python benchmarks/editing/search.py [--model FOLDER]``.

A query is answered when an asset of an accepted category is among the first three. The model's folder is one of
sentence-transformers (the extra ``embeddings``).
"""

import argparse
import time
from collections.abc import Sequence
from pathlib import Path

import msgspec

from mansion_assets.catalogue import Catalogue, load_catalogue
from mansion_assets.retrieval.embedding import EmbeddingRetriever
from mansion_assets.retrieval.encoders import FolderEncoder
from mansion_assets.retrieval.retriever import Retriever, TextRetriever

LISTS = Path(__file__).parents[2] / "tests" / "scene" / "catalogue"
FILES = ("search_queries.json", "search_queries_worded.json")


def missed(
    retriever: Retriever, catalogue: Catalogue, queries: Sequence[tuple[str, list[str]]]
) -> list[tuple[str, list[str]]]:
    """Return the queries without an accepted category, with what came instead."""
    out = []
    for query, accepted in queries:
        found = retriever.retrieve(catalogue, query, 3, ())
        assert not found.note, found.note
        names = [hit.asset.category for hit in found.hits]
        if not set(names) & set(accepted):
            out.append((query, names))
    return out


def main() -> None:
    """Print a line for each retriever and list."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--model", type=Path, help="folder of a sentence-transformers model")
    parser.add_argument("--show", action="store_true", help="print the queries that were missed")
    given = parser.parse_args()
    retrievers: dict[str, Retriever] = {"words": TextRetriever()}
    if given.model:
        encoder = FolderEncoder(given.model.resolve())
        retrievers["embeddings"] = EmbeddingRetriever(encoder, words=0.0)
        retrievers["both"] = EmbeddingRetriever(encoder)
    catalogue = load_catalogue()
    for name, retriever in retrievers.items():
        retriever.retrieve(catalogue, "mug", 3, ())
        for file in FILES:
            queries = msgspec.json.decode((LISTS / file).read_bytes(), type=list[tuple[str, list[str]]])
            start = time.process_time()
            wrong = missed(retriever, catalogue, queries)
            each = 1000 * (time.process_time() - start) / len(queries)
            share = 100 * (1 - len(wrong) / len(queries))
            right = len(queries) - len(wrong)
            print(f"{name:10} {file:28} {right} of {len(queries)} ({share:.1f}%), {each:.1f} ms CPU each")
            if given.show:
                for query, names in wrong:
                    print(f"    {query}: {', '.join(names)}")


if __name__ == "__main__":
    main()

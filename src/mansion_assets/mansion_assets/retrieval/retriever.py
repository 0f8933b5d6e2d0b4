"""The interface of asset retrieval, and its default implementation by text search."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from mansion_assets.catalogue import Catalogue
from mansion_assets.catalogue.search import SearchHit, search_assets

__all__ = ["Retrieval", "Retriever", "TextRetriever"]


@dataclass(frozen=True)
class Retrieval:
    """Assets, the best first, and a note on how they were found."""

    hits: list[SearchHit]
    note: str = ""


class Retriever(Protocol):
    """Finds assets by words."""

    def retrieve(self, catalogue: Catalogue, query: str, top_k: int, properties: Sequence[str]) -> Retrieval:
        """Return at most `top_k` assets that have all the properties.

        Raises
        ------
        MansionError
            ``INVALID_PAYLOAD`` for an unknown property.
        """


class TextRetriever:
    """`Retriever` by the words of names, synonyms and descriptions (`mansion_assets.catalogue.search`)."""

    def retrieve(self, catalogue: Catalogue, query: str, top_k: int, properties: Sequence[str]) -> Retrieval:
        """See `Retriever.retrieve`."""
        return Retrieval(search_assets(catalogue, query, top_k, properties))

"""Retrieval by cosine similarity of embeddings, of text and of pictures, combined with text search."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Final

import numpy as np
import numpy.typing as npt

from mansion_assets.catalogue import Asset, Catalogue
from mansion_assets.catalogue.search import SearchHit, having, look_bonus, mixed, word_scores
from mansion_assets.retrieval.encoders import TextEncoder
from mansion_assets.retrieval.retriever import Retrieval, TextRetriever
from mansion_assets.retrieval.vectors import CatalogueVectors
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["EmbeddingRetriever"]

Vectors = npt.NDArray[np.float32]
Scores = npt.NDArray[np.float64]


WORDS: Final = 0.4
"""Amount that the best text match adds to a cosine; it finds misspelt and rare names that a model does not know."""


class EmbeddingRetriever:
    """`Retriever` that ranks by cosine similarity and words, and by words alone where the model gives no answer.

    Parameters
    ----------
    encoder : TextEncoder
    cache : Path, optional
        Folder that keeps the catalogue's vectors.
    pictures : mapping from asset key to (d,) unit vector, optional
        Embeddings of the assets' pictures by a model that puts texts and pictures into one space (CLIP).
    picture_encoder : TextEncoder, optional
        The text side of that model; `encoder` when absent.
    words : float
        Weight of the words; 0 leaves them out.

    Notes
    -----
    The first hits come from different categories, as in the search by words.

    With pictures an asset's score is the mean of its two standard scores over the candidates, for the cosines of text
    to text and of text to picture differ in size. An asset without picture has its text's standard score.
    """

    def __init__(
        self,
        encoder: TextEncoder,
        cache: Path | None = None,
        *,
        pictures: Mapping[str, Vectors] | None = None,
        picture_encoder: TextEncoder | None = None,
        words: float = WORDS,
    ) -> None:
        self._encoder = encoder
        self._vectors = CatalogueVectors(encoder, cache)
        self._pictures = dict(pictures or {})
        self._picture_encoder = picture_encoder
        self._words = words

    def retrieve(self, catalogue: Catalogue, query: str, top_k: int, properties: Sequence[str]) -> Retrieval:
        """See `mansion_assets.retrieval.retriever.Retriever.retrieve`."""
        candidates = having(catalogue, properties)
        if not query.strip() or not candidates:
            return Retrieval([])
        try:
            asked = self._encoder.encode([query])[0]
            likeness = self._vectors.likeness(catalogue, asked)
        except MansionError as error:
            found = TextRetriever().retrieve(catalogue, query, top_k, properties)
            return Retrieval(found.hits, f"found by words alone: {error.info.message}")
        rows = {key: row for row, key in enumerate(catalogue.assets)}
        scores: Scores = likeness[[rows[asset.key] for asset in candidates]]
        scores = scores + self._words * _by_words(catalogue, query, candidates)
        note = ""
        if self._pictures:
            try:
                scores = self._combined(scores, [a.key for a in candidates], query, asked)
            except MansionError as error:
                note = f"pictures left out: {error.info.message}"
        order = np.argsort(-scores.round(6), kind="stable")
        groups: dict[str, list[SearchHit]] = {}
        for i in order:
            hit = SearchHit(candidates[i], round(float(scores[i]), 4))
            groups.setdefault(hit.asset.category, []).append(hit)
        for group in groups.values() if catalogue.preferred else ():
            group.sort(key=lambda hit: (-look_bonus(hit.asset, query), hit.asset.key not in catalogue.preferred))
        return Retrieval(mixed(list(groups.values()), top_k), note)

    def _combined(self, scores: Scores, keys: Sequence[str], query: str, asked: Vectors) -> Scores:
        if self._picture_encoder is not None:
            asked = self._picture_encoder.encode([query])[0]
        shown = [number for number, key in enumerate(keys) if key in self._pictures]
        if not shown:
            return scores
        pictures = np.array([self._pictures[keys[number]] for number in shown])
        if pictures.shape[1] != len(asked):
            raise MansionError(
                ErrorCode.UNAVAILABLE,
                f"their vectors have {pictures.shape[1]} numbers and the query's has {len(asked)}; "
                "name the model that made them in MANSION_ASSET_EMBEDDINGS_MODEL",
            )
        out = _standard(scores)
        out[shown] = (out[shown] + _standard((pictures @ asked).astype(np.float64))) / 2
        return out


def _by_words(catalogue: Catalogue, query: str, candidates: Sequence[Asset]) -> Scores:
    """Return how well candidates fit by words, 1 for the best category."""
    fits = word_scores(catalogue, query)
    best = max(fits.values(), default=0.0)
    return np.array([fits[asset.category] / best if best > 0.0 else 0.0 for asset in candidates])


def _standard(scores: Scores) -> Scores:
    spread = float(scores.std())
    return np.asarray((scores - scores.mean()) / spread if spread > 1e-9 else np.zeros_like(scores))

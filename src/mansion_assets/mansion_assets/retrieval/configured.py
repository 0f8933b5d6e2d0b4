"""The retriever that environment variables configure."""

import os
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from mansion_assets.retrieval.embedding_retriever import EmbeddingRetriever
from mansion_assets.retrieval.encoders import EndpointEncoder, FolderEncoder, TextEncoder
from mansion_assets.retrieval.retriever import Retriever, TextRetriever
from mansion_assets.retrieval.static_vectors import PACKAGED, packaged_encoder
from mansion_assets.retrieval.vectors import picture_vectors
from mansion_llm.embeddings import EmbeddingsClient, load_embedding_settings
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["configured_retriever"]

_MODEL = "MANSION_EMBEDDINGS_MODEL"
_PICTURES = "MANSION_ASSET_EMBEDDINGS"


def configured_retriever(environment: Mapping[str, str] | None = None) -> Retriever:
    """Return text search, or embeddings where ``MANSION_EMBEDDINGS_MODEL`` names a model.

    Parameters
    ----------
    environment : mapping, optional
        The process's own when absent. The model is one of the endpoint ``MANSION_EMBEDDINGS_BASE_URL``, else a folder,
        else ``wordllama`` of the extra ``vectors``.
        ``MANSION_ASSET_EMBEDDINGS`` names a file of picture vectors, ``MANSION_ASSET_EMBEDDINGS_MODEL`` the model that
        embeds the query for them, ``MANSION_EMBEDDINGS_CACHE`` the folder that keeps the catalogue's vectors.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` or ``NOT_FOUND`` naming the variable or file at fault; ``UNAVAILABLE`` for a missing extra.
    """
    environment = os.environ if environment is None else environment
    load_embedding_settings(environment)
    model = environment.get(_MODEL, "").strip()
    file = environment.get(_PICTURES, "").strip()
    if not model:
        if file:
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD, f"{_PICTURES} needs a model that embeds the query: set {_MODEL}"
            )
        return TextRetriever()
    other = environment.get(_PICTURES + "_MODEL", "").strip()
    home = Path(environment.get("XDG_CACHE_HOME") or "~/.cache") / "mansion" / "embeddings"
    return EmbeddingRetriever(
        _encoder(model, environment, _MODEL),
        Path(environment.get("MANSION_EMBEDDINGS_CACHE") or home).expanduser(),
        pictures=picture_vectors(Path(file).expanduser()) if file else None,
        picture_encoder=_encoder(other, environment, _PICTURES + "_MODEL") if other else None,
    )


def _encoder(model: str, environment: Mapping[str, str], variable: str) -> TextEncoder:
    folder = Path(model).expanduser()
    settings = load_embedding_settings(environment)
    if folder.is_dir() and (settings is None or folder.is_absolute()):
        return FolderEncoder(folder.resolve())
    if settings is None:
        if model == PACKAGED:
            return packaged_encoder()
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"{variable} names neither a folder nor {PACKAGED}; for an endpoint's set MANSION_EMBEDDINGS_BASE_URL",
        )
    return EndpointEncoder(EmbeddingsClient(replace(settings, model=model)))

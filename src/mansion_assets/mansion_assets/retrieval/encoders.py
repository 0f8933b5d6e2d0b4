"""Text encoders: the embedding model of an endpoint, or one in a local folder."""

import hashlib
import importlib
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from mansion_llm.embeddings import EmbeddingsClient
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["EndpointEncoder", "FolderEncoder", "TextEncoder", "unit_rows"]

Vectors = npt.NDArray[np.float32]


class TextEncoder(Protocol):
    """Embeds texts.

    Attributes
    ----------
    name : str
        Name that distinguishes the vectors of different models.
    """

    @property
    def name(self) -> str:
        """Name of the model and where it is."""

    def encode(self, texts: Sequence[str]) -> Vectors:
        """Return unit vectors, shape (n, d).

        Raises
        ------
        MansionError
            ``UNAVAILABLE`` when there is no answer, or one that holds no vectors.
        """


def unit_rows(rows: object, count: int, source: str) -> Vectors:
    """Return `count` rows of numbers, scaled to length one, as an array of shape (count, d).

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` for another number of rows, rows of different lengths, or a vector without a direction.
    """
    try:
        array = np.asarray(rows, dtype=np.float64)
    except (ValueError, TypeError):
        raise MansionError(ErrorCode.UNAVAILABLE, f"{source}: vectors of different lengths, or no numbers") from None
    if array.ndim != 2 or array.shape[0] != count or not array.shape[1]:
        raise MansionError(ErrorCode.UNAVAILABLE, f"{source}: vectors of shape {array.shape} for {count} texts")
    lengths = np.linalg.norm(array, axis=1, keepdims=True)
    if not np.isfinite(lengths).all() or not (lengths > 0.0).all():
        raise MansionError(ErrorCode.UNAVAILABLE, f"{source}: a vector is zero or not finite")
    return np.asarray(array / lengths, dtype=np.float32)


class EndpointEncoder:
    """`TextEncoder` over an OpenAI-compatible endpoint."""

    def __init__(self, client: EmbeddingsClient) -> None:
        self._client = client

    @property
    def name(self) -> str:
        """See `TextEncoder.name`."""
        return f"{self._client.settings.model} at {self._client.settings.place}"

    def encode(self, texts: Sequence[str]) -> Vectors:
        """See `TextEncoder.encode`."""
        return unit_rows(self._client.embed(texts), len(texts), self.name)


class FolderEncoder:
    """`TextEncoder` over the ``sentence-transformers`` package and a model's folder; loaded with the first text.

    The name covers the sizes and times of the folder's files, so that another model in the same place is another one.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._model: Any = None
        self._name = f"{folder.name} {_fingerprint(folder)}"

    @property
    def name(self) -> str:
        """See `TextEncoder.name`."""
        return self._name

    def encode(self, texts: Sequence[str]) -> Vectors:
        """See `TextEncoder.encode`."""
        if self._model is None:
            self._model = _load(self._folder)
        rows = self._model.encode(list(texts), show_progress_bar=False)
        return unit_rows(rows, len(texts), self.name)


def _load(folder: Path) -> Any:
    try:
        package = importlib.import_module("sentence_transformers")
    except ImportError:
        raise MansionError(
            ErrorCode.UNAVAILABLE,
            f"the model {folder.name} needs the extra `embeddings`: pip install sentence-transformers",
            details={"extra": "embeddings", "package": "sentence-transformers"},
        ) from None
    try:
        return package.SentenceTransformer(str(folder), local_files_only=True)
    except (OSError, ValueError, KeyError, RuntimeError, TypeError) as error:
        raise MansionError(
            ErrorCode.UNAVAILABLE, f"{folder} holds no sentence-transformers model: {str(error)[:200]}"
        ) from None


def _fingerprint(folder: Path) -> str:
    entries = [
        f"{file.relative_to(folder).as_posix()} {file.stat().st_size} {file.stat().st_mtime_ns}"
        for file in sorted(folder.rglob("*"))
        if file.is_file()
    ]
    return hashlib.sha256("\n".join(entries).encode()).hexdigest()[:16]

"""Text embeddings from the OpenAI-compatible endpoint that the environment names (``POST /v1/embeddings``)."""

import os
from collections.abc import Mapping, Sequence
from typing import Protocol

from mansion_llm.secret import Secret
from mansion_llm.settings import LlmSettings
from mansion_llm.transport import OpenAITransport, TransportError
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["EmbeddingTransport", "EmbeddingsClient", "load_embedding_settings"]

_PREFIX = "MANSION_EMBEDDINGS_"
_BATCH = 128
_PATIENCE = 3
"""Requests in a row that may fail before the client stops asking."""


class EmbeddingTransport(Protocol):
    """Sends some texts and returns a vector of each, or raises `TransportError`."""

    def embed(self, texts: list[str]) -> list[list[float]]:
        """Ask once."""


def load_embedding_settings(environment: Mapping[str, str] | None = None) -> LlmSettings | None:
    """Return where the embedding model is, None where no endpoint is named.

    Parameters
    ----------
    environment : mapping, optional
        The process's own when absent. ``MANSION_EMBEDDINGS_BASE_URL`` and ``_MODEL`` name the endpoint and its model,
        ``_API_KEY`` (else ``OPENAI_API_KEY``) the key, ``_TIMEOUT`` the seconds that a request may take (20).

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` naming the variable at fault.
    """
    environment = os.environ if environment is None else environment
    url = environment.get(_PREFIX + "BASE_URL", "").strip()
    if not url:
        return None
    model = environment.get(_PREFIX + "MODEL", "").strip()
    if not model:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"{_PREFIX}BASE_URL names an endpoint without a model; set {_PREFIX}MODEL too",
            details={"missing": [_PREFIX + "MODEL"]},
        )
    try:
        timeout = float(environment.get(_PREFIX + "TIMEOUT", "") or 20.0)
    except ValueError:
        timeout = 0.0
    if not 0.01 <= timeout <= 3600.0:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{_PREFIX}TIMEOUT must be 0.01 to 3600 seconds")
    key = environment.get(_PREFIX + "API_KEY") or environment.get("OPENAI_API_KEY", "")
    return LlmSettings(base_url=url, model=model, api_key=Secret(key.strip()), timeout=timeout)


class EmbeddingsClient:
    """Client of one embedding model.

    Parameters
    ----------
    settings : LlmSettings
        Address, model, key and timeout are used.
    transport : EmbeddingTransport, optional
        Over the ``openai`` package when absent, made with the first request.
    """

    def __init__(self, settings: LlmSettings, *, transport: EmbeddingTransport | None = None) -> None:
        self.settings = settings
        self._transport = transport
        self._failures = 0

    def embed(self, texts: Sequence[str]) -> list[list[float]]:
        """Return a vector of each text, in order.

        Raises
        ------
        MansionError
            ``UNAVAILABLE`` when the package is missing or the endpoint fails; after three failures in a row it is
            not asked again.
        """
        if self._failures >= _PATIENCE:
            raise MansionError(ErrorCode.UNAVAILABLE, f"{self.settings.place} failed too often and is no longer asked")
        if self._transport is None:
            self._transport = OpenAITransport(self.settings)
        vectors: list[list[float]] = []
        try:
            for start in range(0, len(texts), _BATCH):
                vectors += self._transport.embed(list(texts[start : start + _BATCH]))
        except TransportError as error:
            self._failures += 1
            raise MansionError(ErrorCode.UNAVAILABLE, str(error)) from None
        self._failures = 0
        return vectors

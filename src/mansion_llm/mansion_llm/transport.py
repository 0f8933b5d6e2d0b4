"""One request to an OpenAI-compatible endpoint, and the kinds of failure it can end with."""

import base64
from dataclasses import dataclass
from typing import Any, Literal, Protocol

from mansion_llm.prompt import Message
from mansion_llm.secret import scrub
from mansion_llm.settings import LlmSettings
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["ChatReply", "ChatTransport", "OpenAITransport", "TransportError"]

Failure = Literal["busy", "slow", "failing", "unreachable", "refused", "rejected"]
"""``refused``: key, model or address are wrong. ``rejected``: this request's form is not taken (400, 422)."""


@dataclass(frozen=True)
class ChatReply:
    """The text of an answer and its size; `cut` when the endpoint stopped at the token limit."""

    text: str
    input_tokens: int = 0
    output_tokens: int = 0
    cut: bool = False


class TransportError(Exception):
    """A request without an answer.

    Parameters
    ----------
    retry_after : float, optional
        Seconds that the endpoint asks to wait.
    """

    def __init__(self, kind: Failure, message: str, retry_after: float | None = None) -> None:
        super().__init__(message)
        self.kind, self.retry_after = kind, retry_after

    @property
    def passing(self) -> bool:
        """Whether the same request may succeed later."""
        return self.kind in ("busy", "slow", "failing", "unreachable")


class ChatTransport(Protocol):
    """Sends one talk and returns the answer, or raises `TransportError`."""

    def complete(self, messages: list[Message], response_format: dict[str, Any] | None) -> ChatReply:
        """Ask once."""


class OpenAITransport:
    """`ChatTransport` over the ``openai`` package.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` when the package is not installed.
    """

    def __init__(self, settings: LlmSettings) -> None:
        try:
            import openai
        except ImportError:
            raise MansionError(
                ErrorCode.UNAVAILABLE, "a language-model endpoint needs the openai package: pip install openai"
            ) from None
        self._openai: Any = openai
        self._settings = settings
        self._client = openai.OpenAI(
            base_url=settings.base_url,
            # The package insists on a key; endpoints without keys ignore it.
            api_key=settings.api_key.reveal() or "none",
            timeout=settings.timeout,
            max_retries=0,
        )
        self._tuning: dict[str, Any] = {"max_tokens": settings.max_tokens}
        if settings.temperature is not None:
            self._tuning["temperature"] = settings.temperature

    def complete(self, messages: list[Message], response_format: dict[str, Any] | None) -> ChatReply:
        """See `ChatTransport.complete`."""
        settings = self._settings
        options: dict[str, Any] = {"model": settings.model, "messages": [_wire(m) for m in messages]}
        if response_format is not None:
            options["response_format"] = response_format
        try:
            while True:
                try:
                    completion = self._client.chat.completions.create(**options, **self._tuning)
                    return _reply(completion, self._clean)
                except self._openai.BadRequestError as error:
                    if not self._retuned(str(error)):
                        raise
        except TransportError:
            raise
        except self._openai.OpenAIError as error:
            raise self._failure(error) from None
        except (ValueError, TypeError, AttributeError, LookupError) as error:
            raise TransportError("failing", self._clean(f"the endpoint's reply has no answer: {error}")) from None

    def embed(self, texts: list[str]) -> list[list[float]]:
        """Return the model's embedding of each text, in the order of the texts; ask once.

        Raises
        ------
        TransportError
            For every failure, an answer of another form among them.
        """
        try:
            # Without the format the package asks for base64, which not every endpoint knows.
            answer = self._client.embeddings.create(model=self._settings.model, input=texts, encoding_format="float")
            rows = sorted(answer.data, key=lambda row: int(row.index))
            if [int(row.index) for row in rows] != list(range(len(texts))):
                raise ValueError(f"{len(rows)} vectors for {len(texts)} texts")
            return [[float(value) for value in row.embedding] for row in rows]
        except self._openai.OpenAIError as error:
            raise self._failure(error) from None
        except (ValueError, TypeError, AttributeError, LookupError) as error:
            raise TransportError("failing", self._clean(f"the endpoint's reply holds no embeddings: {error}")) from None

    def _retuned(self, refusal: str) -> bool:
        """Rename or drop a parameter that the model refuses by name; tell whether something changed."""
        if "max_completion_tokens" in refusal and "max_tokens" in self._tuning:
            self._tuning["max_completion_tokens"] = self._tuning.pop("max_tokens")
            return True
        return "temperature" in refusal and self._tuning.pop("temperature", None) is not None

    def _clean(self, text: str) -> str:
        return scrub(text, self._settings.api_key)

    def _failure(self, error: Exception) -> TransportError:
        place = self._settings.place
        if isinstance(error, self._openai.APITimeoutError):
            return TransportError("slow", f"{place} gave no answer in {self._settings.timeout:g} s")
        if isinstance(error, self._openai.APIStatusError):
            status = int(getattr(error, "status_code", 0))
            text = self._clean(f"{place} answered {status}: {str(error)[:300]}")
            return TransportError(_kind(status), text, _retry_after(error))
        if isinstance(error, self._openai.APIConnectionError):
            return TransportError("unreachable", f"{place} cannot be reached")
        return TransportError("failing", self._clean(f"{place}: {str(error)[:300]}"))


def _kind(status: int) -> Failure:
    if status in (429, 503, 529):
        return "busy"
    if status in (408, 409, 425) or status >= 500:
        return "failing"
    if status in (401, 402, 403, 404, 405):
        return "refused"
    return "rejected"


def _retry_after(error: Exception) -> float | None:
    headers = getattr(getattr(error, "response", None), "headers", None) or {}
    try:
        return max(0.0, float(headers.get("retry-after", "")))
    except (TypeError, ValueError):
        return None


def _wire(message: Message) -> dict[str, Any]:
    if not message.pictures:
        return {"role": message.role, "content": message.text}
    parts: list[dict[str, Any]] = [{"type": "text", "text": message.text}]
    for picture in message.pictures:
        data = base64.b64encode(picture).decode()
        parts.append({"type": "image_url", "image_url": {"url": f"data:image/png;base64,{data}"}})
    return {"role": message.role, "content": parts}


def _reply(completion: Any, clean: Any) -> ChatReply:
    """Read a completion; endpoints leave out what they like."""
    choices = getattr(completion, "choices", None)
    if not choices:
        raise TransportError("failing", "the endpoint's reply holds no choice")
    choice = choices[0]
    text = getattr(getattr(choice, "message", None), "content", None)
    usage = getattr(completion, "usage", None)
    return ChatReply(
        text=clean(text) if isinstance(text, str) else "",
        input_tokens=_count(usage, "prompt_tokens"),
        output_tokens=_count(usage, "completion_tokens"),
        cut=getattr(choice, "finish_reason", None) == "length",
    )


def _count(usage: Any, name: str) -> int:
    value = getattr(usage, name, 0)
    return value if isinstance(value, int) and value >= 0 else 0

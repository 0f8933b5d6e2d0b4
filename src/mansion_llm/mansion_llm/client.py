"""Ask for a value of a type: find it in the answer, check it, ask again with the faults, and count what it took."""

import logging
import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Generic, TypeVar

import msgspec

from mansion_llm.extraction import json_candidates
from mansion_llm.prompt import Message, Prompt, request_digest
from mansion_llm.settings import WITHOUT_MODEL, LlmSettings, load_settings
from mansion_llm.store import AnswerStore, CacheFolder, Recorder, Recording, RunSettings, StoredAnswer
from mansion_llm.structured import Mode, answer_schema, response_format, weaker_mode
from mansion_llm.transport import ChatReply, ChatTransport, OpenAITransport, TransportError
from mansion_msgs_py.codec import decode, to_builtins
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.usage import LlmUsage

__all__ = ["Answer", "Fault", "LlmClient"]


T = TypeVar("T")
_log = logging.getLogger(__name__)

LONGEST_WAIT = 60.0
MOST_FAULTS = 20
PATIENCE = 3
"""Requests in a row that may fail for good before the client stops asking."""


@dataclass(frozen=True)
class Fault:
    """What is wrong with an answer, and which piece of it."""

    text: str
    piece: str = ""


@dataclass(frozen=True)
class Answer(Generic[T]):
    """The end of a question.

    Attributes
    ----------
    value : object, optional
        The best value received (fewest faults); ``None`` when none could be read.
    faults : list of Fault
        What is still wrong with it.
    reason : str
        Why there is no faultless value, for a report; empty when there is one.
    """

    value: T | None
    faults: list[Fault] = field(default_factory=list)
    reason: str = ""

    @property
    def good(self) -> bool:
        """Whether there is a value without faults."""
        return self.value is not None and not self.faults

    def faulty_pieces(self) -> set[str]:
        """Return the pieces with faults."""
        return {fault.piece for fault in self.faults}


class LlmClient:
    """Client of one model.

    Parameters
    ----------
    settings : LlmSettings
    transport : ChatTransport, optional
        Over the ``openai`` package when absent; never made in replay.
    sleep, clock : callables
        For tests.
    otherwise : str
        What the user can do without a model, for messages.
    cancelled : callable
        Asked before each request whether the answers are not wanted any more; a question is ``CANCELED`` then.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` when no model is configured.
    """

    def __init__(
        self,
        settings: LlmSettings,
        *,
        transport: ChatTransport | None = None,
        sleep: Callable[[float], None] = time.sleep,
        clock: Callable[[], float] = time.perf_counter,
        otherwise: str = WITHOUT_MODEL,
        cancelled: Callable[[], bool] = lambda: False,
    ) -> None:
        settings.require_endpoint(otherwise)
        self.settings, self._otherwise, self._cancelled = settings, otherwise, cancelled
        self._sleep, self._clock = sleep, clock
        self._stores: list[AnswerStore] = []
        recording = Recording(settings.replay) if settings.replay is not None else None
        if recording is not None and recording.run is not None:
            settings = self.settings = replace(settings, **to_builtins(recording.run))
        self._replay = recording
        self.model = recording.model if recording is not None else settings.model
        if recording is not None:
            self._stores.append(recording)
        elif settings.cache is not None:
            self._stores.append(CacheFolder(settings.cache / f"temperature_{settings.temperature}"))
        self._recorder = _recorder(settings)
        self._transport = transport
        if transport is None and recording is None:
            self._transport = OpenAITransport(settings)
        self._mode: Mode = "schema" if settings.structured == "auto" else settings.structured
        self._pictures = settings.images != "no"
        self._failures = 0
        self._meter = _Meter(self.model, settings.input_price, settings.output_price)

    @classmethod
    def from_environment(
        cls,
        environment: Mapping[str, str] | None = None,
        *,
        otherwise: str = WITHOUT_MODEL,
        cancelled: Callable[[], bool] = lambda: False,
    ) -> "LlmClient":
        """Return the client that the environment and the configuration file describe."""
        return cls(load_settings(environment), otherwise=otherwise, cancelled=cancelled)

    @property
    def usage(self) -> LlmUsage:
        """What has been asked so far."""
        return self._meter.usage()

    def wants(self, piece: str) -> bool:
        """Whether the model is to be asked for a piece (see `mansion_llm.settings.PIECES`)."""
        return piece in self.settings.pieces

    def ask(
        self,
        prompt: Prompt,
        kind: type[T],
        check: Callable[[T], list[Fault]] = lambda value: [],
        *,
        array_field: str = "",
        repairs: int | None = None,
    ) -> Answer[T]:
        """Return the model's answer as a value of `kind`.

        Parameters
        ----------
        prompt : Prompt
        kind : type
            A msgspec Struct.
        check : callable
            Returns what is wrong with a value.
        array_field : str
            The field that a bare array fills, for models that leave the object around it out.
        repairs : int, optional
            How often a faulty answer is asked for again at most, where that is less than the settings allow.

        Raises
        ------
        MansionError
            ``UNAVAILABLE`` when the key, the model or the address is refused, or a recording lacks the answer;
            ``CANCELED``. A busy or broken endpoint gives an `Answer` without value and the reason instead.
        """
        schema = answer_schema(kind)
        messages = prompt.messages()
        best: Answer[T] = Answer(None, reason="no answer")
        most = self.settings.repairs if repairs is None else min(repairs, self.settings.repairs)
        for attempt in range(most + 1):
            try:
                reply = self._complete(prompt.name, messages, schema)
            except TransportError as error:
                return best if best.value is not None else Answer(None, reason=str(error))
            value, faults = _read(reply, kind, array_field)
            faults = faults if value is None else check(value)
            if value is not None and not faults:
                return Answer(value)
            if best.value is None or (value is not None and len(faults) < len(best.faults)):
                best = Answer(value, faults, _reason(faults))
            _log.info("%s: answer %d has %d faults", prompt.name, attempt + 1, len(faults))
            if attempt < most:
                self._meter.asked_again()
                messages = [*prompt.messages(), Message("assistant", reply.text), _repair(faults)]
        return best

    def _complete(self, name: str, messages: list[Message], schema: dict[str, Any]) -> ChatReply:
        digest = request_digest(self.model, messages, schema)
        for store in self._stores:
            found = store.get(digest)
            if found is not None:
                if not found.failure:
                    self._meter.answer(found, from_store=True)
                if self._recorder is not None:
                    self._recorder.put(found)
                if found.failure:
                    raise TransportError("unreachable", found.failure)
                return ChatReply(found.text, found.input_tokens, found.output_tokens, found.cut)
        if self._replay is not None:
            raise MansionError(
                ErrorCode.UNAVAILABLE,
                f"the recording holds no answer to this {name} question; it was made from another "
                f"request, seed or version (record it again, or {self._otherwise})",
                details={"prompt": name, "digest": digest},
            )
        started = self._clock()
        try:
            reply = self._with_patience(name, messages, schema)
        except TransportError as error:
            if self._recorder is not None:
                failed = StoredAnswer(digest=digest, prompt=name, text="", failure=str(error))
                self._recorder.put(failed)
            raise
        answer = StoredAnswer(
            digest=digest,
            prompt=name,
            text=reply.text,
            model=self.model,
            input_tokens=reply.input_tokens,
            output_tokens=reply.output_tokens,
            seconds=round(self._clock() - started, 3),
            cut=reply.cut,
        )
        self._meter.answer(answer, from_store=False)
        for keeper in [*self._stores, *([self._recorder] if self._recorder else [])]:
            keeper.put(answer)
        return reply

    def _with_patience(self, name: str, messages: list[Message], schema: dict[str, Any]) -> ChatReply:
        """Ask until there is an answer: wait for a busy endpoint, ask in a plainer form where the form is refused."""
        if self._failures >= PATIENCE:
            raise TransportError("unreachable", "the endpoint failed too often and is no longer asked")
        waits = 0
        while True:
            if self._cancelled():
                raise MansionError(ErrorCode.CANCELED, f"the {name} question was cancelled")
            try:
                reply = self._once(name, messages, schema)
            except TransportError as error:
                if error.kind == "refused":
                    raise MansionError(
                        ErrorCode.UNAVAILABLE,
                        f"{error}; check MANSION_LLM_BASE_URL, MANSION_LLM_MODEL and "
                        f"MANSION_LLM_API_KEY (or {self._otherwise})",
                    ) from None
                if error.kind == "rejected" and self._plainer(messages):
                    continue
                if not error.passing or waits >= self.settings.retries:
                    self._failures += 1
                    raise
                self._meter.retry()
                self._sleep(self._wait(waits, error))
                waits += 1
            else:
                self._failures = 0
                return reply

    def _once(self, name: str, messages: list[Message], schema: dict[str, Any]) -> ChatReply:
        assert self._transport is not None
        if not self._pictures:
            messages = [Message(m.role, m.text) for m in messages]
        return self._transport.complete(messages, response_format(self._mode, name, schema))

    def _plainer(self, messages: list[Message]) -> bool:
        """Drop structured output, then pictures, as far as the settings leave it open."""
        weaker = weaker_mode(self._mode) if self.settings.structured == "auto" else None
        if weaker is not None:
            self._mode = weaker
            return True
        if self._pictures and self.settings.images == "auto" and any(m.pictures for m in messages):
            self._pictures = False
            self._mode = "schema" if self.settings.structured == "auto" else self._mode
            return True
        return False

    def _wait(self, waits: int, error: TransportError) -> float:
        wait = self.settings.backoff * 2.0**waits
        if error.retry_after is not None:
            wait = max(wait, error.retry_after)
        return min(wait, LONGEST_WAIT)


def _recorder(settings: LlmSettings) -> Recorder | None:
    if settings.record is None:
        return None
    run = RunSettings(
        pieces=settings.pieces,
        repairs=settings.repairs,
        input_price=settings.input_price,
        output_price=settings.output_price,
    )
    return Recorder(settings.record, run)


def _read(reply: ChatReply, kind: type[T], array_field: str) -> tuple[T | None, list[Fault]]:
    """Return the first value of the right type in an answer, or what keeps it from being read."""
    problem = "the answer holds no JSON"
    for candidate in json_candidates(reply.text):
        if array_field and candidate.startswith("["):
            candidate = f'{{"{array_field}": {candidate}}}'
        if not candidate.startswith("{"):
            continue
        try:
            value = decode(kind, candidate)
        except MansionError as error:
            if problem == "the answer holds no JSON" or "not JSON" in problem:
                problem = f"{error.info.path}: {error.info.message}"
            continue
        return value, []
    if reply.cut:
        problem = "the answer was cut off at the token limit; answer more briefly"
    return None, [Fault(problem)]


def _repair(faults: list[Fault]) -> Message:
    listed = "\n".join(f"- {fault.text}" for fault in faults[:MOST_FAULTS])
    return Message(
        "user",
        f"Your answer cannot be used. Faults:\n{listed}\n"
        "Send the whole answer again with these faults corrected, as JSON alone, in the same form.",
    )


def _reason(faults: list[Fault]) -> str:
    more = f" (and {len(faults) - 1} more)" if len(faults) > 1 else ""
    return f"{faults[0].text}{more}" if faults else ""


class _Meter:
    """The running account of a client that several threads may use.

    Parameters
    ----------
    input_price, output_price : float
        Price of a million tokens.
    """

    def __init__(self, model: str, input_price: float, output_price: float) -> None:
        self._usage = LlmUsage(model=model)
        self._prices = input_price * 1e-6, output_price * 1e-6
        self._lock = threading.Lock()

    def answer(self, answer: StoredAnswer, *, from_store: bool) -> None:
        """Count an answer; one from a store with what it took when it was made."""
        price_in, price_out = self._prices
        with self._lock:
            usage = self._usage
            self._usage = msgspec.structs.replace(
                usage,
                answers=usage.answers + 1,
                from_store=usage.from_store + from_store,
                input_tokens=usage.input_tokens + answer.input_tokens,
                output_tokens=usage.output_tokens + answer.output_tokens,
                seconds=usage.seconds + answer.seconds,
                cost=usage.cost + (answer.input_tokens * price_in + answer.output_tokens * price_out),
            )

    def retry(self) -> None:
        """Count a repeated request."""
        with self._lock:
            self._usage = msgspec.structs.replace(self._usage, retries=self._usage.retries + 1)

    def asked_again(self) -> None:
        """Count a faulty answer that is asked for again."""
        with self._lock:
            self._usage = msgspec.structs.replace(self._usage, asked_again=self._usage.asked_again + 1)

    def usage(self) -> LlmUsage:
        """Return the account so far."""
        with self._lock:
            return msgspec.structs.replace(
                self._usage, cost=round(self._usage.cost, 6), seconds=round(self._usage.seconds, 3)
            )

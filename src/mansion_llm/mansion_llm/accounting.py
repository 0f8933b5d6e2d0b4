"""Count answers, tokens, time and cost while several threads ask."""

import threading

import msgspec

from mansion_llm.store import StoredAnswer
from mansion_msgs_py.usage import LlmUsage

__all__ = ["Meter"]


class Meter:
    """The running account of a client.

    Parameters
    ----------
    input_price, output_price : float
        Of a million tokens.
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

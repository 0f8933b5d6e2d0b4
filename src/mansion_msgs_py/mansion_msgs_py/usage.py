"""Usage of a language model, as reports state it: answers, tokens, time and cost."""

import msgspec

__all__ = ["LlmUsage", "total_usage"]


class LlmUsage(msgspec.Struct, frozen=True, kw_only=True):
    """Answers of a language model and what they took.

    Attributes
    ----------
    model : str
    answers : int
        Answers received, faulty ones included.
    asked_again : int
        Answers that had faults and were asked for again.
    from_store : int
        Answers that came from the cache or from a recording; their tokens and cost are those of the day they were made.
    retries : int
        Requests repeated because the endpoint was busy, slow or failing.
    input_tokens, output_tokens : int
    cost : float
        In the currency of the configured prices; 0 where none are configured.
    seconds : float
        Waiting for the endpoint.
    """

    model: str = ""
    answers: int = 0
    asked_again: int = 0
    from_store: int = 0
    retries: int = 0
    input_tokens: int = 0
    output_tokens: int = 0
    cost: float = 0.0
    seconds: float = 0.0


def total_usage(parts: list[LlmUsage]) -> LlmUsage | None:
    """Return the sum of several accounts; ``None`` for none.

    Examples
    --------
    >>> total_usage([LlmUsage(answers=2), LlmUsage(answers=1)]).answers
    3
    """
    if not parts:
        return None
    return LlmUsage(
        model=parts[0].model,
        answers=sum(part.answers for part in parts),
        asked_again=sum(part.asked_again for part in parts),
        from_store=sum(part.from_store for part in parts),
        retries=sum(part.retries for part in parts),
        input_tokens=sum(part.input_tokens for part in parts),
        output_tokens=sum(part.output_tokens for part in parts),
        cost=round(sum(part.cost for part in parts), 6),
        seconds=round(sum(part.seconds for part in parts), 3),
    )

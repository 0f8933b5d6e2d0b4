"""Give rooms that are called en suite their bathrooms: "five ensuite bedrooms"."""

import re
from dataclasses import replace
from typing import Final

from mansion_planner.brief.facts import RoomFact, Span
from mansion_planner.brief.suites import PRIVATE, SLEEPING

__all__ = ["with_bathrooms_by_name"]

_CALLED: Final = re.compile(r"\ben[- ]?suite\b", re.IGNORECASE)

_BATHROOM: Final = "ensuite_bathroom"


def with_bathrooms_by_name(fact: RoomFact) -> RoomFact:
    """Return rooms to sleep in whose name says that each has a bathroom with that bathroom; others as they are.

    Examples
    --------
    >>> fact = RoomFact("bedroom", "ensuite_bedroom", Span("five ensuite bedrooms", 0, 21), 5)
    >>> with_bathrooms_by_name(fact).suite[0].span
    Span(words='ensuite', start=5, end=12)
    """
    called = _CALLED.search(fact.span.words)
    if called is None or fact.room_type not in SLEEPING or any(child.room_type in PRIVATE for child in fact.suite):
        return fact
    start = fact.span.start + called.start()
    span = Span(called[0], start, fact.span.start + called.end())
    return replace(fact, suite=(*fact.suite, RoomFact(_BATHROOM, _BATHROOM, span, label="ensuite bathroom")))

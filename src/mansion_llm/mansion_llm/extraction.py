"""Find the JSON value in an answer: alone, in a code fence, or in prose."""

import json
import re
from collections.abc import Iterator

__all__ = ["json_candidates"]

_FENCE = re.compile(r"```[a-zA-Z0-9_-]*\s*\n(.*?)```", re.DOTALL)
_THOUGHT = re.compile(r"<think(?:ing)?>.*?</think(?:ing)?>", re.DOTALL | re.IGNORECASE)
_TRAILING = re.compile(r",(\s*[}\]])")
MOST_CANDIDATES = 24
MOST_STARTS = 400


def json_candidates(text: str) -> Iterator[str]:
    """Yield texts that may be the answer, the likeliest first.

    The whole answer, then fenced blocks from the last to the first, then every balanced object or array in prose, the
    longest first. Commas before a closing bracket are dropped. Nothing is made up: an answer that was cut off yields
    only the whole values in it.

    Examples
    --------
    >>> list(json_candidates('Sure! Here you are: {"floors": 2,} Anything else?'))[-1]
    '{"floors": 2}'
    """
    text = _THOUGHT.sub("", text).strip().lstrip("\ufeff")
    seen: set[str] = set()
    for candidate in _in_order(text):
        tidy = candidate.strip()
        for form in (tidy, _without_trailing_commas(tidy)):
            if form and form not in seen and len(seen) < MOST_CANDIDATES:
                seen.add(form)
                yield form


def _in_order(text: str) -> Iterator[str]:
    yield text
    yield from reversed(_FENCE.findall(text))
    yield from sorted(_balanced(text), key=len, reverse=True)


def _balanced(text: str) -> list[str]:
    """Return the outermost balanced objects and arrays; brackets within strings do not count."""
    found = []
    at, starts = 0, 0
    while at < len(text) and starts < MOST_STARTS:
        if text[at] not in "{[":
            at += 1
            continue
        starts += 1
        end = _end_of_value(text, at)
        if end is None:
            at += 1
        else:
            found.append(text[at:end])
            at = end
    return found


def _end_of_value(text: str, start: int) -> int | None:
    closers: list[str] = []
    quoted = escaped = False
    for at in range(start, len(text)):
        char = text[at]
        if quoted:
            quoted = escaped or char != '"'
            escaped = char == "\\" and not escaped
        elif char == '"':
            quoted = True
        elif char in "{[":
            closers.append("}" if char == "{" else "]")
        elif char in "}]":
            if closers.pop() != char:
                return None
            if not closers:
                return at + 1
    return None


def _without_trailing_commas(text: str) -> str:
    """Drop commas before closing brackets, unless the text is JSON already or the comma is in a string."""
    if text[:1] not in ("{", "["):
        return text
    try:
        json.loads(text)
    except ValueError:
        pieces = re.split(r'("(?:[^"\\]|\\.)*")', text)
        return "".join(p if k % 2 else _TRAILING.sub(r"\1", p) for k, p in enumerate(pieces))
    except RecursionError:
        return text
    return text

"""Find the words that a model quotes from a brief: exactly, or but for case, white space and typographic marks."""

import re
from collections.abc import Collection

from mansion_planner.brief.facts import Span

__all__ = ["find_quote"]

_PLAIN = str.maketrans("’‘‚“”„«»–—‑\u00a0", '\'\'\'"""""--- ')
_AROUND = " \t\r\n\"'.,;:!?"


def find_quote(text: str, quote: str, taken: Collection[tuple[int, int]] = ()) -> Span | None:
    """Return where `quote` stands in `text`, or ``None`` where it does not.

    Parameters
    ----------
    taken : collection of (int, int)
        Places that come last: the same words quoted again mean their next occurrence.

    Examples
    --------
    >>> find_quote("A house with Two  bedrooms.", "two bedrooms")
    Span(words='Two  bedrooms', start=13, end=26)
    >>> find_quote("A house with two bedrooms", "a sauna") is None
    True
    """
    words = quote.translate(_PLAIN).strip(_AROUND).split()
    if not words:
        return None
    pattern = r"\s+".join(re.escape(word) for word in words)
    plain = text.translate(_PLAIN)
    # Scripts without spaces between words have no word boundaries around a quote.
    for whole in (rf"(?<!\w){pattern}(?!\w)", pattern):
        places = [match.span() for match in re.finditer(whole, plain, re.IGNORECASE)]
        if places:
            start, end = next((place for place in places if place not in taken), places[0])
            return Span(text[start:end], start, end)
    return None

"""Find the words that a model quotes from a text: exactly, or but for case, white space and typographic marks."""

import re
from collections.abc import Collection

__all__ = ["find_quote"]

_PLAIN = str.maketrans("’‘‚“”„«»–—‑\u00a0", '\'\'\'"""""--- ')
_AROUND = " \t\r\n\"'.,;:!?"


def find_quote(text: str, quote: str, taken: Collection[tuple[int, int]] = ()) -> tuple[int, int] | None:
    """Return where `quote` stands in `text` (start, end), or ``None`` where it does not.

    Parameters
    ----------
    taken : collection of (int, int)
        Places that come last: the same words quoted again mean their next occurrence.

    Examples
    --------
    >>> find_quote("A house with Two  bedrooms.", "two bedrooms")
    (13, 26)
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
            return next((place for place in places if place not in taken), places[0])
    return None

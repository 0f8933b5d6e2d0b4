"""Words that are English whatever a building is made of."""

from functools import cache
from pathlib import Path

__all__ = ["common_words"]


@cache
def common_words() -> frozenset[str]:
    """Return English words that are no misspelling of a word of the vocabulary.

    Those of the 20,000 most frequent (tables of the package wordfreq 3, R. Speer) that look like one are among them.
    """
    file = Path(__file__).parent / "data" / "common_words.txt"
    return frozenset(file.read_text(encoding="utf-8").split())

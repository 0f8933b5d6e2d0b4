"""Places told by what was there before it moved: ``put a glass where the laptop used to be``."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.words import DETERMINERS, Word, text_at

__all__ = ["with_former_places"]

_HAVING_BEEN: Final = (("used", "to", "be"), ("used", "to", "stand"), ("used", "to", "lie"), ("has", "been"),
                       ("had", "been"), ("was",), ("were",), ("stood",), ("lay",), ("hung",), ("sat",))  # fmt: skip
_FOLLOWED: Final = frozenset(["", ",", ".", "and", "before", "until", "now", "please"])
_LONGEST: Final = 4
"""Words of a name."""


def with_former_places(words: Sequence[Word], reader: ClauseReader) -> Sequence[Word]:
    """Return words with the furniture that something was told to come from for ``where it used to be``.

    Parameters
    ----------
    reader : ClauseReader
        Of the words.
    """
    for at in range(1, len(words)):
        found = _told_at(words, at) if words[at].text == "where" else None
        if found is None:
            continue
        name, end = found
        source = _source_of(words[:at], name, reader)
        if source:
            where, stop = words[at].start, words[end - 1].end
            placed = [replace(word, start=where, end=stop) for word in source]
            return [*words[:at], *placed, *words[end:]]
    return words


def _told_at(words: Sequence[Word], at: int) -> tuple[tuple[str, ...], int] | None:
    """Return the name of ``where the laptop used to be`` with the end of these words; None for others."""
    if text_at(words, at + 1) not in DETERMINERS:
        return None
    for verb in range(at + 3, at + 3 + _LONGEST):
        said = next((v for v in _HAVING_BEEN if tuple(w.raw for w in words[verb : verb + len(v)]) == v), ())
        end = verb + len(said)
        if said and text_at(words, end) in _FOLLOWED:
            end += text_at(words, end) in ("before", "until")
            return tuple(word.text for word in words[at + 2 : verb]), end
    return None


def _source_of(words: Sequence[Word], name: tuple[str, ...], reader: ClauseReader) -> list[Word]:
    """Return ``on the desk`` for the one place from which a thing of this name was told to go; else no words."""
    found: list[list[Word]] = []
    for at in range(len(words)):
        item = reader.item(at) if words[at].text in DETERMINERS else None
        if item is None or item.phrase.noun.words != name:
            continue
        read = next((place for place in item.places if place.source and place.place.anchor is not None), None)
        start = 0 if read is None else next((k for k in range(read.start, read.end) if words[k].text in DETERMINERS), 0)
        if read is not None and start:
            joint = "in" if read.place.relation == "in" else "on"
            found.append([replace(words[read.start], text=joint, raw=joint), *words[start : read.end]])
    return found[0] if len(found) == 1 else []

"""Matching of any room type to one that has an object program, by synonyms and similarity."""

import re
from collections.abc import Iterable
from typing import Literal, TypeAlias

from mansion_assets.catalogue.records import RoomRecord
from mansion_knowledge import default_knowledge, kin_of
from mansion_language import singular

__all__ = ["FALLBACK", "RoomIndex", "normalise"]

FALLBACK = "generic_room"
"""Room type that is used where no other is similar enough."""

How: TypeAlias = Literal["exact", "synonym", "similar", "fallback"]

_NUMBER = re.compile(r"[_\s\-]*\d+$")
_WEAK_WORDS = frozenset(
    ("room", "area", "space", "zone", "hall", "main", "small", "large", "shared", "common", "general", "the", "and")
)


def normalise(room_type: str) -> str:
    """Return a room type in snake case, without a trailing number.

    Examples
    --------
    >>> normalise("Meeting Room 2")
    'meeting_room'
    """
    text = _NUMBER.sub("", room_type.strip())
    text = re.sub(r"(?<=[a-z])(?=[A-Z])", "_", text).lower()
    return re.sub(r"[^a-z0-9]+", "_", text).strip("_")


def _words(name: str) -> list[str]:
    return [singular(word) for word in name.split("_") if word]


def _trigrams(name: str) -> set[str]:
    text = f"  {name} "
    return {text[i : i + 3] for i in range(len(text) - 2)}


class RoomIndex:
    """Index of the records of room types by name, synonym and similarity.

    Parameters
    ----------
    records : iterable of RoomRecord
    """

    def __init__(self, records: Iterable[RoomRecord]) -> None:
        self._names: dict[str, tuple[str, How]] = {}
        entries = list(records)
        own = {record.room_type for record in entries}
        for word in default_knowledge().words.values():
            if word.like in own:
                self._names.setdefault(word.word, (word.like, "synonym"))
        for record in entries:
            for synonym in record.synonyms:
                self._names.setdefault(normalise(synonym), (record.room_type, "synonym"))
        for record in entries:
            self._names[record.room_type] = (record.room_type, "exact")
        for name in list(self._names):
            flat = "_".join(_words(name))
            self._names.setdefault(flat, (self._names[name][0], "synonym"))
        self._memo: dict[str, tuple[str, How]] = {}

    def resolve(self, room_type: str) -> tuple[str, How]:
        """Return the matching room type, and how it was found.

        The last word counts most (a `staff_kitchen` is a kitchen), words such as ``room`` count little, and spelling
        decides between equals; below a similarity of 0.34 the fallback is used.
        """
        asked = normalise(room_type)
        if asked not in self._memo:
            self._memo[asked] = self._find(asked)
        return self._memo[asked]

    def _find(self, asked: str) -> tuple[str, How]:
        found = self._names.get(asked)
        kin = kin_of(asked)
        if kin != asked and (found is None or found[1] != "exact"):
            return self.resolve(kin)[0], "similar"
        if found is not None:
            return found
        flat = "_".join(_words(asked))
        if flat in self._names:
            return self._names[flat][0], "synonym"
        best, best_score = FALLBACK, 0.34
        for name, (target, _) in self._names.items():
            score = _similarity(asked, name)
            if score > best_score + 1e-9:
                best, best_score = target, score
        return best, "fallback" if best == FALLBACK else "similar"


def _similarity(asked: str, name: str) -> float:
    first, second = _words(asked), _words(name)
    weight = {word: 0.15 if word in _WEAK_WORDS else 1.0 for word in first + second}
    shared = sum(weight[word] for word in first if word in second)
    total = sum(weight[w] for w in first) + sum(weight[w] for w in second) - shared
    head_first = [w for w in first if w not in _WEAK_WORDS][-1:]
    head_second = [w for w in second if w not in _WEAK_WORDS][-1:]
    head = 0.25 if head_first and head_first == head_second else 0.0
    a, b = _trigrams(asked), _trigrams(name)
    spelling = len(a & b) / max(1, len(a | b))
    return 0.75 * shared / max(total, 1e-9) + head + 0.35 * spelling * (shared < 0.5) + 0.05 * spelling

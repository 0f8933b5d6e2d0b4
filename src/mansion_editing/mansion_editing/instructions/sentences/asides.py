"""Sentences with a clause that asks for nothing: it is passed over, and what it names must be as it was afterwards."""

from abc import abstractmethod
from collections.abc import Sequence
from typing import Final

import msgspec

from mansion_editing.instructions.clauses.outcomes import everything_at
from mansion_editing.instructions.clauses.reader import ClauseReader
from mansion_editing.instructions.phrases.words import Word
from mansion_editing.instructions.sentences.bystanding import (
    asks_for_nothing,
    is_exclamation,
    is_purpose,
    is_rhetorical,
)
from mansion_editing.instructions.sentences.progress import Progress
from mansion_editing.instructions.statements import Amount, Mention, Place, Things

__all__ = ["Asides"]

_CUTS: Final = frozenset([",", "(", ")", "-", ":"])
_JOINTS: Final = frozenset("and but so as since".split())
_TAKING_UP: Final = frozenset("it its them they one there that this those these another ones".split())
"""Words by which a sentence goes on with what the one before it told of."""


class Asides(Progress):
    """Reads a sentence again without what asks for nothing, where it was not understood as a whole."""

    @abstractmethod
    def _read_sentence(self, words: Sequence[Word], *, marked: bool) -> None:
        """Read one sentence into statements."""

    def _read_beside_asides(self, words: Sequence[Word], later: Sequence[Word], *, marked: bool) -> None:
        """Read a sentence; a clause of it that is not understood and asks for nothing is passed over.

        Parameters
        ----------
        later : sequence of Word
            The sentence after it, which may go on with what this one tells of.
        """
        first = self._so_far()
        self._read_sentence(words, marked=marked)
        if len(self.unknown) == len(first["unknown"]):
            return
        whole = self._so_far()
        for start, end in _parts(words):
            part, rest = words[start:end], [*words[:start], *words[end:]]
            before = start == 0
            if not self._is_aside(part, followed=before and bool(rest or later), marked=marked):
                continue
            self._go_back(first)
            if before:
                self._pass_over(part, rest or later)
            if rest:
                self._read_sentence(_trimmed(rest), marked=marked and before)
            if len(self.unknown) == len(first["unknown"]):
                if not before:
                    self._pass_over(part, later if end == len(words) else [])
                return
        self._go_back(whole)

    def _is_aside(self, words: Sequence[Word], *, followed: bool, marked: bool) -> bool:
        if marked or is_rhetorical(words):
            return is_rhetorical(words)
        last = words[-1].end if words else 0
        called = self.text[last : last + 1] == "!" and is_exclamation(words, self.lexicon)
        return called or is_purpose(words, self.lexicon) or asks_for_nothing(words, self.lexicon, followed=followed)

    def _pass_over(self, words: Sequence[Word], later: Sequence[Word]) -> None:
        """Note a clause that asks for nothing, with what it names unless the next one goes on with that."""
        words = _trimmed(words)
        reader = ClauseReader(words, self.lexicon, self.floors, lambda a, b: self._quote(words, a, b))
        named = _named(reader)
        nouns = {text for things in named for text in things.noun.split()}
        taken_up = any(word.text in _TAKING_UP or word.text in nouns for word in later)
        if taken_up and named:
            self.topic = named[0] if named[0].noun else self.topic
        quote = self._quote(words, 0, len(words))
        self.statements.append(Mention(quote=quote, passed_over=True, untouched=() if taken_up else named))

    def _so_far(self) -> dict[str, object]:
        """Return how far the instruction is read, to come back to it."""
        return {name: list(value) if isinstance(value, list) else value for name, value in vars(self).items()}

    def _go_back(self, so_far: dict[str, object]) -> None:
        for name, value in so_far.items():
            setattr(self, name, list(value) if isinstance(value, list) else value)


def _parts(words: Sequence[Word]) -> list[tuple[int, int]]:
    """Return the stretches of a sentence that may be asides, the longest first: all of it, its beginnings and ends."""
    count = len(words)
    cuts = [at for at in range(1, count) if words[at].text in _CUTS | _JOINTS]
    ends = [(at, count) for at in cuts]
    beginnings = [(0, at) for at in reversed(cuts)]
    inner = [(one, other) for one in cuts for other in reversed(cuts) if one < other]
    return [(0, count), *ends, *beginnings, *inner]


def _trimmed(words: Sequence[Word]) -> Sequence[Word]:
    """Return words without marks and joints around them."""
    start, end = 0, len(words)
    while start < end and words[start].text in _CUTS | (_JOINTS - {"as", "so"}):
        start += 1
    while end > start and words[end - 1].text in _CUTS | (_JOINTS - {"as"}):
        end -= 1
    return words[start:end]


def _named(reader: ClauseReader) -> tuple[Things, ...]:
    """Return the things and rooms that words name as those that are there."""
    found: list[Things] = []
    at = 0
    while at < len(reader.words):
        item = reader.item(at)
        if item is None or item.end <= at:
            at += 1
            continue
        if item.is_room:
            found.append(everything_at(Place(rooms=item.rooms())))
        elif item.phrase.definite and not item.phrase.refers and item.phrase.noun.kind == "object":
            whole = Amount(kind="all", number=0)
            found.append(msgspec.structs.replace(item.things(), amount=whole, plural=True))
        at = item.end
    return tuple(found)

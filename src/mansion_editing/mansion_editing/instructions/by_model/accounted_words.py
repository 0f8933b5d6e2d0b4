"""Which words of an instruction its statements account for: all of a quote, and what asks for something beside it."""

from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import Final

from mansion_assets.catalogue.vocabulary import stems
from mansion_editing.instructions.by_model.leaves import leaves_of
from mansion_editing.instructions.by_model.said_words import NEGATIONS, SaidWords, Span, is_content
from mansion_editing.instructions.meaning.room_words import best_named
from mansion_editing.instructions.phrases.verb_words import GERUNDS, PARTICIPLES, VERB_WORDS
from mansion_editing.instructions.phrases.word_sets import AFTER_THANKS, BEING_SOMEWHERE, LEFT_ALONE, OPINIONS
from mansion_editing.instructions.phrases.words import COURTESIES, PARTICIPLES_OF_REST, STATE_WORDS, VAGUE, Word
from mansion_editing.instructions.statements import Mention, Statement
from mansion_language.colours import COLOUR_WORDS

__all__ = ["AccountedWords"]

_UNITS: Final = frozenset("metre m m2 square cm degree side time per room".split())
_STOREYS: Final = frozenset(
    "floor level storey ground basement upstairs downstairs top upper lower bottom above below".split()
)
_OPEN: Final = (NEGATIONS | frozenset(["remove", "everything", "want"])) - {"except"}
"""Function words that ask for something where no statement has them."""

_BESIDE: Final = (
    VERB_WORDS | STATE_WORDS.keys() | VAGUE | BEING_SOMEWHERE | LEFT_ALONE | OPINIONS | PARTICIPLES_OF_REST | _UNITS
)
"""Words that say how things are put, which no field of a statement repeats."""

_LONGEST: Final = 4
"""Words of a name at most."""


class AccountedWords:
    """The words of an instruction, and the statements that were read from them.

    Parameters
    ----------
    words : SaidWords
    statements : sequence of (Statement, Span)
        Each with the place of its quote.
    """

    def __init__(self, words: SaidWords, statements: Sequence[tuple[Statement, Span]]) -> None:
        self._words = words
        self._placed = [(span, _Said(statement, words)) for statement, span in statements]

    def left(self, span: Span) -> list[str]:
        """Return the words of a quote that neither its statement nor another one of the same words says."""
        if not self._words.is_english:
            return []
        quoted = self._words.within(span)
        verb = next((word for word in quoted if is_content(word)), None)
        return [
            word.raw
            for word in quoted
            if is_content(word)
            and word.text not in _BESIDE
            and not any(said.says(word) for place, said in self._placed if place[0] <= word.start < place[1])
            and not (word is verb and self._words.may_be_verb(word))
        ]

    def uncovered(self, others: Iterable[Span]) -> list[str]:
        """Return the pieces of the text that ask for something and are in no quote.

        A word that a statement says is accounted for wherever it stands ("In the bar, ..."), unless it is a verb.

        Parameters
        ----------
        others : iterable of Span
            Further parts that are accounted for.
        """
        held = [*others, *(place for place, _ in self._placed)]
        pieces: list[list[Word]] = [[]]
        for word in self._words.words:
            if word.kind == "mark" or any(start < word.end and word.start < end for start, end in held):
                pieces.append([])
            else:
                pieces[-1].append(word)
        return [self._words.text[p[0].start : p[-1].end] for p in pieces if p and self._is_asking(p)]

    def _is_asking(self, piece: Sequence[Word]) -> bool:
        if not self._words.is_english:
            return len(piece) > 2 or sum(len(word.raw) for word in piece) > 11
        thanks = piece[0].text in COURTESIES
        return any(
            word.text in _OPEN
            or (is_content(word) and not (thanks and word.text in AFTER_THANKS) and not self._is_said(word))
            for word in piece
        )

    def _is_said(self, word: Word) -> bool:
        return any(said.says(word) for _, said in self._placed)


class _Said:
    """The words that one statement stands for."""

    def __init__(self, statement: Statement, words: SaidWords) -> None:
        self._words, self._all = words, isinstance(statement, Mention)
        leaves = leaves_of(statement)
        self._texts = {stem for leaf in leaves if isinstance(leaf.value, str) for stem in _all_stems(leaf.value)}
        self._numbers = {float(leaf.value) for leaf in leaves if isinstance(leaf.value, float)} | {1.0}
        self._parts = {leaf.part for leaf in leaves}
        self._nouns = [stems(str(leaf.value)) for leaf in leaves if leaf.part in ("noun", "anchor")]
        self._rooms = [str(leaf.value) for leaf in leaves if leaf.part == "room"]

    def says(self, word: Word) -> bool:
        """Whether the statement says a word, or what it stands for."""
        if self._all or {word.text, *stems(word.raw)} & self._texts:
            return True
        if word.kind in ("number", "ordinal", "level", "code"):
            return word.value in self._numbers or (word.kind == "ordinal" and "amount" in self._parts)
        if word.text in _STOREYS and self._parts & {"floor", "same"}:
            return True
        if COLOUR_WORDS.get(word.text, "") in self._texts or word.text in GERUNDS or (word.raw,) in PARTICIPLES:
            return True
        return word in self._named or self._is_of_room(word)

    @cached_property
    def _named(self) -> list[Word]:
        """Words of names that mean the kind of one of the nouns: telly for television."""
        words = self._words.words
        return [
            word
            for first in range(len(words))
            for last in range(first + 1, min(first + _LONGEST, len(words)) + 1)
            if any(self._words.same_kind(noun, [one.text for one in words[first:last]]) for noun in self._nouns)
            for word in words[first:last]
        ]

    def _is_of_room(self, word: Word) -> bool:
        """Whether a word means the same rooms as the statement's."""
        meant = {room.id for room in best_named(self._words.rooms, word.text)}
        return bool(meant) and any(
            meant == {room.id for room in best_named(self._words.rooms, name)} for name in self._rooms
        )


def _all_stems(text: str) -> set[str]:
    words = text.lower().replace("_", " ")
    return {*words.split(), *stems(words), *(COLOUR_WORDS.get(word, word) for word in words.split())}

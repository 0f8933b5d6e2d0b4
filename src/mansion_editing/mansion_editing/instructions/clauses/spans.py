"""The words of a sentence: where its phrases, verbs and clauses begin and end."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from typing import Final, Self

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.noun_phrases import NounPhrase, noun_phrase
from mansion_editing.instructions.phrases.nouns import Noun
from mansion_editing.instructions.phrases.places import read_place
from mansion_editing.instructions.phrases.verb_words import PARTICIPLES, Deed
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_sets import (
    AFTER_THANKS,
    BEFORE_VERBS,
    BEGIN_CLAUSES,
    BETWEEN_CLAUSES,
    PREDICATE_VERBS,
)
from mansion_editing.instructions.phrases.words import BE, COURTESIES, MODALS, STATE_WORDS, Word, text_at
from mansion_editing.instructions.statements import Place, Statement, Things

__all__ = ["Spans"]

_SKIPPED: Final = COURTESIES | BETWEEN_CLAUSES


class Spans(ABC):
    """Reads the words of one sentence.

    Parameters
    ----------
    words : sequence of Word
    lexicon : Lexicon
    floors : sequence of int
        Those of the building.
    quote : callable
        Returns the text between two places in the words.
    frame : Place
        A place that the sentence began with ("in the lobby, ...").
    """

    def __init__(
        self, words: Sequence[Word], lexicon: Lexicon, floors: Sequence[int], quote: Callable[[int, int], str]
    ) -> None:
        self.words, self.lexicon, self.floors, self.quote = words, lexicon, floors, quote
        self.frame = Place()
        self.last_noun: Noun | None = None
        self.topic: Things | None = None
        self.affirmed: Things | None = None
        self.follows = False
        self.last_holder = ""

    def until(self, end: int) -> Self:
        """Return a reader of the words before a place."""
        return type(self)(self.words[:end], self.lexicon, self.floors, self.quote)

    @abstractmethod
    def read(self, at: int) -> tuple[list[Statement], int]:
        """Read the clause at a place.

        Raises
        ------
        NotUnderstood
            Where the words make no clause.
        """

    def text(self, at: int) -> str:
        """Return a word, empty beyond the end."""
        return text_at(self.words, at)

    def phrase(self, at: int) -> NounPhrase | None:
        """Read a noun phrase."""
        return noun_phrase(self.words, at, self.lexicon, self.floors)

    def phrase_of(self, noun: str) -> Noun | None:
        """Return a noun of the sentence by its words, which ``one`` may mean later."""
        for at in range(len(self.words)):
            found = self.phrase(at)
            if found is not None and " ".join(found.noun.words) == noun:
                return found.noun
        return None

    def conjunction(self, at: int) -> int:
        """Return the place after a comma or a conjunction between noun phrases, 0 where there is none."""
        place = at
        if self.text(place) == ",":
            place += 1
        if self.text(place) in ("and", "plus", "&", "+", "or", "nor") or (
            self.text(place) == "as" and self.text(place + 1) == "well"
        ):
            place += 3 if self.text(place) == "as" else 1
        if self.text(place) == "also":
            place += 1
        if place > at and self.text(place) == "of" and {"rid", "dispose"} & {word.text for word in self.words[:at]}:
            place += 1  # "get rid of the apple and of the pears"
        return place if place > at else 0

    def starts_clause(self, at: int) -> bool:
        """Whether a clause with a verb of its own begins at a place."""
        while self.text(at) in BEFORE_VERBS:
            if self.text(at) == "do" and self.text(at + 1) != "not":
                break
            at += 1
        if verb_at(self.words, at, self.lexicon) is not None:
            return True
        return self.text(at) in BEGIN_CLAUSES

    def predicate_follows(self, at: int) -> bool:
        """Whether the words at a place make the noun phrase before them the subject of a clause."""
        word = self.text(at)
        if word in (",", "-", ":"):
            return False
        following = self.text(at + 1)
        turns = (word, following) == ("turn", "into") or (word == "keep" and following in STATE_WORDS)
        if word in MODALS or word in PREDICATE_VERBS or turns:
            return True
        if word in STATE_WORDS:
            return not self.is_preposition(at)
        if word in ("switched", "turned", "left", "kept", "powered") and self.text(at + 1) in STATE_WORDS:
            return True
        return self._participle(at) is not None

    def tells_of_door(self, at: int) -> bool:
        """Whether ``with the door shut`` begins at a place, which tells how furniture is, not what comes with it."""
        part = at + 1 + (self.text(at + 1) in ("the", "its", "their"))
        return self.text(at) == "with" and self.text(part) in ("door", "lid")

    def is_preposition(self, at: int) -> bool:
        """Whether ``on`` or ``off`` begins a place, and is no state: ``on the desk``, ``on the upper floor``."""
        if self.text(at) not in ("on", "off"):
            return False
        place = read_place(self.words, at, self.lexicon, self.floors)
        return self.phrase(at + 1) is not None or (place is not None and place.end > at + 1)

    def bothers(self, at: int) -> bool:
        """Whether ``in the way`` stands at a place, which only says that something bothers."""
        return (self.text(at), self.text(at + 1), self.text(at + 2)) == ("in", "the", "way")

    def _participle(self, at: int) -> tuple[Deed, int] | None:
        for length in (2, 1):
            span = tuple(w.text for w in self.words[at : at + length])
            if len(span) == length and span in PARTICIPLES:
                return PARTICIPLES[span], at + length
        return None

    def skip(self, at: int) -> int:
        """Return the place after courtesies, adverbs and marks."""
        asking = self.text(at) == "," and self.text(at + 1) in ("would", "could", "will", "can")
        if asking and at + 3 >= len(self.words):
            return len(self.words)
        while at < len(self.words) and self.text(at) in _SKIPPED:
            if self.text(at) in ("thank", "thanks"):
                while self.text(at + 1) in AFTER_THANKS:
                    at += 1
            if self.words[at].raw in ("there's", "theres"):
                break
            if self.text(at) == "there" and (self.text(at + 1) in BE or self.text(at + 1) in MODALS
                                             or self.text(at + 1) in ("need", "has", "have", "not")):  # fmt: skip
                break
            if self.text(at) == "for" and self.text(at + 1) not in ("now", "me", "us"):
                break
            if self.text(at) == "next" and self.text(at + 1) == "to":
                break
            if self.words[at].kind == "word" and self.lexicon.is_own_room((self.text(at), self.text(at + 1))):
                break  # "team room: lights off" calls no team
            if self.text(at) == "for" and self.text(at + 1) in ("me", "us"):
                at += 1
            if self.text(at) == "as" and self.text(at + 1) not in ("well", "soon"):
                break
            at += 1
        return at

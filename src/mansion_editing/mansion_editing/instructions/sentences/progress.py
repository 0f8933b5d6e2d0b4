"""How far an instruction is read: its words, what was read so far, and what the next clause may refer to."""

from collections.abc import Sequence

from mansion_editing.instructions.phrases.clock_times import without_times_of_headings
from mansion_editing.instructions.phrases.following_numbers import limits_before, totals_before
from mansion_editing.instructions.phrases.frames import without_frames
from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.mending import mended
from mansion_editing.instructions.phrases.notation import written_out
from mansion_editing.instructions.phrases.nouns import Noun
from mansion_editing.instructions.phrases.plain_speech import in_plain_words
from mansion_editing.instructions.phrases.remarks import without_remarks
from mansion_editing.instructions.phrases.rewordings import reworded
from mansion_editing.instructions.phrases.storeys import counted_from_ground
from mansion_editing.instructions.phrases.verb_words import Deed
from mansion_editing.instructions.phrases.verbs import verb_at
from mansion_editing.instructions.phrases.word_order import in_usual_order
from mansion_editing.instructions.phrases.words import Word, split_words
from mansion_editing.instructions.sentences.bystanding import fills_gaps
from mansion_editing.instructions.statements import Place, Statement, Things
from mansion_editing.state import SceneState

__all__ = ["Progress"]


class Progress:
    """The words of one instruction, and what was read of them."""

    def __init__(self, text: str, state: SceneState, brief: str = "") -> None:
        self.text = text
        self.lexicon = Lexicon(state)
        self.floors = state.floors
        words = without_times_of_headings(split_words(text, self.lexicon.speller, self.lexicon.kept))
        said = in_plain_words(reworded(mended(written_out(words, text), self.lexicon)))
        plain = in_usual_order(without_frames(said))
        self.words = without_remarks(totals_before(limits_before(plain)))
        self.words = counted_from_ground(self.words, text, brief, self.floors)
        self.statements: list[Statement] = []
        self.unknown: list[str] = []
        self.topic: Things | None = None
        self.spared: tuple[Things, ...] = ()
        self.exception = ""
        self.frames: tuple[Place, ...] = ()
        self.heading = Place()
        self.last_noun: Noun | None = None
        self.listed: list[Word] = []
        self.told: list[tuple[str, Place]] = []
        self.complaints: list[tuple[str, str]] = []
        self.clause: list[Statement] = []
        self.scene: tuple[Things, ...] = ()
        self.counted: tuple[Things, ...] = ()
        self.later: list[Word] = []
        self.whose: list[Word] = []
        self.given_later = False
        self.is_last = False
        self.undecided = False

    def _quote(self, words: Sequence[Word], start: int, end: int) -> str:
        said = words[start:end]
        return self.text[min(word.start for word in said) : max(word.end for word in said)] if said else ""

    def _names_anything(self, words: Sequence[Word]) -> bool:
        """Whether words name an object or a room of the building."""
        return any(self.lexicon.is_object((w.text,)) or self.lexicon.is_own_room((w.text,)) for w in words)

    def _words_of(self, quote: str) -> list[Word]:
        """Return the words that a quote was taken from."""
        start = self.text.find(quote)
        return [word for word in self.words if start <= word.start and word.end <= start + len(quote)]

    def _begins_with_order(self, quote: str, deeds: Sequence[Deed] = ()) -> bool:
        """Whether a quote begins with a verb that asks for something, one of some `deeds` where they are given."""
        words = self._words_of(quote)
        at = next((k for k, word in enumerate(self.words) if words and word.start >= words[0].start), len(self.words))
        verb = verb_at(self.words, at, self.lexicon)
        if verb is None or fills_gaps(words):
            return False
        return verb[0] in deeds if deeds else verb[0] not in ("leave", "keep", "make", "want")

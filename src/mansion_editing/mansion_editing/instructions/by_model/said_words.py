"""Whether a model's statement says what its quote says, and nothing else: the words of either looked up in the other.

Only English is compared. A model that reads another language translates, which no table of words can verify; there
too a deletion needs a word of deletion, as far as these are known.
"""

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from typing import Final

from mansion_assets.catalogue.vocabulary import stems, vocabulary_of
from mansion_editing.instructions.by_model.leaves import Leaf, leaves_of
from mansion_editing.instructions.meaning.nouns import names_many
from mansion_editing.instructions.meaning.room_words import best_named
from mansion_editing.instructions.phrases.lexicon import ANYTHING, Lexicon
from mansion_editing.instructions.phrases.storeys import read_storeys
from mansion_editing.instructions.phrases.verb_words import BY_WORDS, GERUNDS, PARTICIPLES, VERB_WORDS
from mansion_editing.instructions.phrases.words import FUNCTION_WORDS, STATE_WORDS, UNRECORDED, VAGUE, Word, split_words
from mansion_editing.instructions.statements import (
    Ask,
    Clear,
    Ensure,
    Forbid,
    Furnish,
    Keep,
    Mention,
    Reach,
    Remove,
    Replace,
    Reshape,
    Statement,
)
from mansion_editing.state import SceneState
from mansion_language.colours import COLOUR_WORDS
from mansion_llm.quotes import find_quote
from mansion_msgs_py.scene import SceneRoom

__all__ = ["SaidWords", "Span"]

Span = tuple[int, int]
"""Characters of the text, the end exclusive."""

ENGLISH: Final = 0.3
"""Least share of words that are function words or verbs of instructions in an English text."""

_NEGATIONS: Final = frozenset("not never no without nothing nobody neither nor none except".split())
_REMOVING: Final = frozenset(["remove", "clear", "tidy", "take", "replace", "swap", "furnish", "change"])
_LOWERING: Final = frozenset(
    "no none not never without only exactly just precisely most maximum fewer less limit nothing reduce cut".split()
)
_AMOUNT_WORDS: Final[dict[str, frozenset[str]]] = {
    "exactly": _LOWERING,
    "at_most": _LOWERING | {"more", "than", "up"},
    "at_least": frozenset("least minimum more enough".split()),
    "more": frozenset("more another extra additional further else other again second".split()),
    "fewer": frozenset("fewer less".split()),
    "all_but": frozenset("but except one only just save".split()),
    "none": _LOWERING,
}
_UNITS: Final = frozenset(
    "metre m m2 square cm degree floor level storey ground basement upstairs downstairs room side time per".split()
)
_REMOVING_ABROAD: Final = tuple(
    "entfern lösch weg raus räum nimm nehm leer ersetz tausch "  # German
    "supprim enlev enlèv retir ôte ote vide débarrass remplac "  # French
    "quita elimin saca borra vacía vacia reemplaz sustitu cambi "  # Spanish
    "rimuov togli leva elimina svuot sostitu remov tira esvazi substitu "  # Italian, Portuguese
    "verwijder haal leeg vervang bort fjern tøm töm erstat ersätt "  # Dutch, Swedish, Danish, Norwegian
    "usuń usun zabierz opróżnij zamień odstraň удал убер очист замен kaldır sil "  # Slavic languages, Turkish
    "删除 移除 拿走 清空 换 取り除 片付 どけ 撤去".split()
)
"""Beginnings of words of deletion in other languages."""

_LONGEST: Final = 4
"""Words of a name at most."""


class SaidWords:
    """The words of one instruction.

    Parameters
    ----------
    text : str
    state : SceneState
        Gives the names of rooms and objects.
    """

    def __init__(self, text: str, state: SceneState) -> None:
        self.text, self._state = text, state
        self._lexicon = Lexicon(state)
        self.words = split_words(text, self._lexicon.speller, self._lexicon.kept)

    @cached_property
    def is_english(self) -> bool:
        """Whether the text is English, by its function words and verbs."""
        plain = [word for word in self.words if word.kind == "word"]
        known = sum(word.text in FUNCTION_WORDS or word.text in VERB_WORDS for word in plain)
        return known >= ENGLISH * len(plain)

    def within(self, span: Span) -> list[Word]:
        """Return the words of a part of the text."""
        return [word for word in self.words if span[0] <= word.start and word.end <= span[1]]

    def fault(self, statement: Statement, span: Span) -> str:
        """Return how a statement differs from its quote, empty where it says the same.

        Parameters
        ----------
        span : (int, int)
            Of the quote.
        """
        wrong = self.wrong_sense(statement, span)
        if wrong or isinstance(statement, Mention) or not self.is_english:
            return wrong
        quoted = self.within(span)
        return self._unsaid(statement, quoted) or self._left(statement, quoted)

    # The sense --------------------------------------------------------------------------------------------------------

    def wrong_sense(self, statement: Statement, span: Span) -> str:
        """Return why a statement removes what no word removes, or does what a word forbids; empty for neither."""
        if isinstance(statement, Mention):
            return ""
        quoted = self.within(span)
        if not self.is_english:
            removing = any(word.raw.startswith(_REMOVING_ABROAD) for word in quoted)
            return "no known word of the quote asks for a removal" if _removes(statement) and not removing else ""
        if _removes(statement) and not _asks_to_remove(quoted):
            return "no word of the quote asks for anything to be removed"
        clause = [*self._before(span), *quoted]
        negated = sorted({word.text for word in clause if word.text in _NEGATIONS})
        if negated and not _is_negative(statement):
            return f"the words around the quote say {negated[0]!r}, the statement does not"
        return ""

    def _before(self, span: Span) -> list[Word]:
        """Return the words of the clause before a quote."""
        out: list[Word] = []
        for word in self.words:
            if word.end > span[0]:
                break
            ends = word.kind == "mark" or word.text in ("and", "but", "then", "so")
            out = [] if ends else [*out, word]
        return out

    # From the statement to the text -----------------------------------------------------------------------------------

    def _unsaid(self, statement: Statement, quoted: Sequence[Word]) -> str:
        for leaf in leaves_of(statement):
            if not self._is_said(leaf, quoted):
                return f"the quote does not say {leaf.part} {_shown(leaf)}"
        return ""

    def _is_said(self, leaf: Leaf, quoted: Sequence[Word]) -> bool:
        part, value = leaf
        if part in ("noun", "anchor"):
            return self._is_named(str(value), quoted)
        if part == "room":
            return self._is_room_said(str(value))
        if part == "number":
            return float(value) in _numbers(quoted)
        if part == "ordinal":
            return float(value) in _numbers(quoted) or float(value) in (1.0, -1.0)
        if part == "floor":
            return value in self._floors
        if part == "colour":
            colours = [COLOUR_WORDS.get(word.text, word.text) for word in quoted]
            return all(COLOUR_WORDS.get(one, one) in colours for one in str(value).lower().split())
        if part == "material":
            return all(any(word.text[:4] == one[:4] for word in quoted) for one in stems(str(value).replace("_", " ")))
        if part == "name":
            return find_quote(self.text, str(value)) is not None
        if part == "spot":
            return any(
                word.text == value or (value == "middle" and word.text in ("middle", "centre")) for word in quoted
            )
        if part == "amount":
            return _is_amount_said(str(value), quoted)
        return True

    def _is_named(self, noun: str, quoted: Sequence[Word]) -> bool:
        wanted = stems(noun.replace("_", " "))
        said = {stem for word in quoted for stem in (word.text, *stems(word.raw))}
        if set(wanted) <= said or noun in [word.text for word in quoted]:
            return True
        return any(self.same_kind(wanted, name) for name in _names(quoted))

    def same_kind(self, one: Sequence[str], other: Sequence[str]) -> bool:
        """Whether two names mean the same kind of object."""
        vocabulary = vocabulary_of(self._state.catalogue)
        kinds = [{*vocabulary.exact(tuple(n)), *vocabulary.synonymous(tuple(n))} for n in (one, other)]
        return not kinds[0].isdisjoint(kinds[1])

    def _is_room_said(self, words: str) -> bool:
        said = {stem for word in self.words for stem in (word.text, *stems(word.raw))}
        if set(stems(words.replace("_", " "))) <= said:
            return True
        rooms = self._rooms
        meant = {room.id for room in best_named(rooms, words)}
        return any(meant and meant == {room.id for room in best_named(rooms, " ".join(n))} for n in _names(self.words))

    @cached_property
    def _rooms(self) -> list[SceneRoom]:
        return [room for _, room in self._state.rooms()]

    @cached_property
    def _floors(self) -> frozenset[float]:
        floors = self._state.floors
        read = (read_storeys(self.words, at, floors) for at in range(len(self.words)))
        return frozenset(float(floor) for found in read if found is not None for floor in found[0])

    # From the text to the statement -----------------------------------------------------------------------------------

    def _left(self, statement: Statement, quoted: Sequence[Word]) -> str:
        """Return which words of a quote its statement does not say."""
        leaves = leaves_of(statement)
        said = {stem for leaf in leaves if isinstance(leaf.value, str) for stem in _all_stems(leaf.value)}
        numbers = {float(leaf.value) for leaf in leaves if isinstance(leaf.value, float)} | {1.0}
        nouns = [stems(str(leaf.value)) for leaf in leaves if leaf.part in ("noun", "anchor")]
        covered = {
            number
            for first in range(len(quoted))
            for last in range(first + 1, min(first + _LONGEST, len(quoted)) + 1)
            if any(self.same_kind(noun, [w.text for w in quoted[first:last]]) for noun in nouns)
            for number in range(first, last)
        }
        verb = next((number for number, word in enumerate(quoted) if is_content(word)), -1)
        left = [
            word.raw
            for number, word in enumerate(quoted)
            if number not in covered
            and is_content(word)
            and not self._is_expressed(word, said, numbers)
            and not (number == verb and self._may_be_verb(word))
        ]
        return f"the statement does not say {', '.join(map(repr, left))} of its quote" if left else ""

    def _may_be_verb(self, word: Word) -> bool:
        """Whether a word is one that the rules do not know, as a verb of the model's may be."""
        named = self._lexicon.is_object((word.text,)) or self._lexicon.is_room((word.text,))
        return word.kind == "word" and not named and not word.plural and word.text not in COLOUR_WORDS

    def _is_expressed(self, word: Word, said: set[str], numbers: set[float]) -> bool:
        if word.kind in ("number", "ordinal", "level", "code"):
            return word.value in numbers or word.raw in said
        if word.text in _UNITS or word.text in VERB_WORDS or word.text in STATE_WORDS or word.text in VAGUE:
            return True
        if word.text in COLOUR_WORDS and COLOUR_WORDS[word.text] in said:
            return True
        if {word.text, *stems(word.raw)} & said or word.text in GERUNDS or (word.raw,) in PARTICIPLES:
            return True
        rooms = self._rooms
        spoken = [one for one in said if best_named(rooms, one)]
        meant = {room.id for room in best_named(rooms, word.text)}
        return bool(meant) and any(meant == {room.id for room in best_named(rooms, one)} for one in spoken)

    def uncovered(self, spans: Iterable[Span]) -> list[str]:
        """Return the pieces of the text with words of content that none of some parts of it has."""
        held = list(spans)
        pieces: list[list[Word]] = [[]]
        for word in self.words:
            inside = any(start < word.end and word.start < end for start, end in held)
            if inside or word.kind == "mark":
                pieces.append([])
            else:
                pieces[-1].append(word)
        telling = [piece for piece in pieces if any(is_content(word) or word.text in _OPEN for word in piece)]
        if not self.is_english:
            telling = [piece for piece in telling if len(piece) > 2 or sum(len(word.raw) for word in piece) > 11]
        return [self.text[piece[0].start : piece[-1].end] for piece in telling]


_OPEN: Final = (_NEGATIONS | frozenset(["remove", "everything", "want"])) - {"except"}
"""Function words that ask for something where no statement has them."""


def is_content(word: Word) -> bool:
    """Whether a word says something of its own."""
    if word.kind in ("mark", "unit"):
        return False
    return word.kind != "word" or (word.text not in FUNCTION_WORDS and word.text not in UNRECORDED)


def _names(words: Sequence[Word]) -> Iterator[tuple[str, ...]]:
    for first in range(len(words)):
        for last in range(first + 1, min(first + _LONGEST, len(words)) + 1):
            run = words[first:last]
            if all(word.kind in ("word", "number", "id") for word in run) and is_content(run[-1]):
                yield tuple(word.text for word in run)


def _all_stems(text: str) -> set[str]:
    words = text.lower().replace("_", " ")
    return {*words.split(), *stems(words), *(COLOUR_WORDS.get(word, word) for word in words.split())}


def _numbers(words: Sequence[Word]) -> set[float]:
    values = {word.value for word in words if word.kind in ("number", "ordinal", "level")}
    more = {"both": 2.0, "pair": 2.0, "couple": 2.0, "dozen": 12.0, "second": 2.0, "half": 0.5, "around": 180.0}
    return values | {-value for value in values} | {more[word.text] for word in words if word.text in more}


def _is_amount_said(kind: str, words: Sequence[Word]) -> bool:
    if kind == "all":
        wholes = frozenset("all every each everything any both whole anything no nothing them rest".split())
        return any(
            word.plural or word.text in wholes or word.text in ANYTHING or names_many(word.text) for word in words
        )
    return any(word.text in _AMOUNT_WORDS.get(kind, frozenset()) for word in words)


def _removes(statement: Statement) -> bool:
    if isinstance(statement, Ensure):
        return statement.things.amount.kind in ("exactly", "at_most", "fewer", "none")
    return isinstance(statement, Remove | Clear | Replace | Furnish)


def _asks_to_remove(words: Sequence[Word]) -> bool:
    texts = [word.text for word in words]
    for table in (BY_WORDS, PARTICIPLES):
        for verb, deed in table.items():
            size = len(verb)
            found = any(tuple(texts[at : at + size]) == verb for at in range(len(texts) - size + 1))
            raw = any(tuple(w.raw for w in words[at : at + size]) == verb for at in range(len(words) - size + 1))
            if deed in _REMOVING and (found or raw):
                return True
    return any(text in _LOWERING or text in ("away", "out", "instead", "gone") for text in texts)


def _is_negative(statement: Statement) -> bool:
    """Whether a statement may stand for words with a negation."""
    if isinstance(statement, Forbid | Keep | Ask | Reach | Reshape):
        return True
    leaves = leaves_of(statement)
    if any(leaf.part == "outside" or (leaf.part == "amount" and leaf.value != "all") for leaf in leaves):
        return True
    things = getattr(statement, "things", None)
    return bool(getattr(statement, "spare", ()) or (things is not None and things.beside))


def _shown(leaf: Leaf) -> str:
    return f"{leaf.value:g}" if isinstance(leaf.value, float) else repr(leaf.value)

"""Whether a model's statement says what its quote says, and nothing else: the words of either looked up in the other.

Only English is compared. A model that reads another language translates, which no table of words can verify; there
too a deletion needs a word of deletion, as far as these are known.
"""

from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Final

from mansion_assets.catalogue.vocabulary import stems, vocabulary_of
from mansion_editing.instructions.by_model.leaves import Leaf, leaves_of
from mansion_editing.instructions.meaning.nouns import names_many
from mansion_editing.instructions.meaning.room_words import best_named
from mansion_editing.instructions.phrases.lexicon import ANYTHING, Lexicon
from mansion_editing.instructions.phrases.storeys import read_storeys
from mansion_editing.instructions.phrases.verb_words import BY_WORDS, PARTICIPLES, VERB_WORDS
from mansion_editing.instructions.phrases.words import (
    COURTESIES,
    FUNCTION_WORDS,
    MODALS,
    PERSONS,
    PRONOUNS,
    UNRECORDED,
    Word,
    split_words,
)
from mansion_editing.instructions.statements import (
    Add,
    Ask,
    Clear,
    Ensure,
    Finish,
    Forbid,
    Furnish,
    History,
    Keep,
    Mention,
    Move,
    Paint,
    Reach,
    Remove,
    Rename,
    Replace,
    Reshape,
    SetState,
    Statement,
    Swap,
    Turn,
)
from mansion_editing.state import SceneState
from mansion_language.colours import COLOUR_WORDS
from mansion_llm.quotes import find_quote
from mansion_msgs_py.scene import SceneRoom

__all__ = ["NEGATIONS", "SaidWords", "Span", "is_content"]

Span = tuple[int, int]
"""Characters of the text, the end exclusive."""

ENGLISH: Final = 0.3
"""Least share of words that are function words or verbs of instructions in an English text."""

NEGATIONS: Final = frozenset("not never no without nothing nobody neither nor none except".split())
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

_ANYBODY: Final = frozenset("someone somebody anyone anybody everyone everybody".split())
_QUESTIONS: Final = frozenset("is are how where which does has".split())
_STAYING: Final = NEGATIONS | frozenset(
    "keep leave stay remain untouched alone preserve spare save maintain hold let avoid refrain stop still".split()
)
_KINDS_OF_DEEDS: Final[dict[str, tuple[type, ...]]] = {
    "remove": (Remove, Clear, Replace, Move, Ensure),
    "switch": (SetState, Turn),
    "open": (SetState,),
    "close": (SetState,),
    "paint": (Paint, Finish),
    "rename": (Rename,),
    "swap": (Swap, Replace, Reshape),
    "move": (Move, Swap),
    "add": (Add, Ensure, Move, Reshape),
}
"""What a clause that begins with a verb for a deed can be, where the verb leaves no doubt."""

_BEFORE_NOUN: Final = 3
"""Words before a noun among which its number is: two of the hammers."""

_PRONOUNS: Final = PRONOUNS | frozenset("its their there one ones each other same both her his".split())
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
        """Whether the text is English, by its function words, its verbs and the names of things and rooms."""
        plain = [word for word in self.words if word.kind == "word"]
        known = sum(word.text in FUNCTION_WORDS or word.text in VERB_WORDS or self._is_noun(word) for word in plain)
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
        return self._unsaid(statement, span)

    # The sense --------------------------------------------------------------------------------------------------------

    def wrong_sense(self, statement: Statement, span: Span) -> str:
        """Return why a statement removes what no word removes, or does what a word forbids; empty for neither."""
        quoted = self.within(span)
        if isinstance(statement, Mention) and not self.is_english:
            return ""
        if not self.is_english:
            removing = any(word.raw.startswith(_REMOVING_ABROAD) for word in quoted)
            return "no known word of the quote asks for a removal" if _removes(statement) and not removing else ""
        if _removes(statement) and not _asks_to_remove(quoted):
            return "no word of the quote asks for anything to be removed"
        deed = _leading_deed(quoted)
        if deed and not isinstance(statement, (*_KINDS_OF_DEEDS.get(deed, (object,)), History)):
            return f"the quote asks to {deed}, the statement does not"
        if isinstance(statement, Mention):
            return ""
        if quoted and quoted[0].text in _QUESTIONS and not isinstance(statement, Ask | Reach):
            return "the quote is a question, the statement is none"
        clause = [*self._before(span), *quoted]
        if isinstance(statement, Forbid | Keep) and not any(word.text in _STAYING for word in clause):
            return "no word of the quote forbids anything, or lets anything stay"
        negated = sorted({word.text for word in clause if word.text in NEGATIONS})
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

    def _unsaid(self, statement: Statement, span: Span) -> str:
        quoted = self.within(span)
        told = [word for word in self.words if word.start < span[0]] if self._refers_back(quoted) else []
        for leaf in leaves_of(statement):
            if leaf.part in ("noun", "anchor") and self._is_named(str(leaf.value), [*told, *quoted]):
                continue
            if leaf.part == "amount" and isinstance(statement, Keep | Ask):
                continue
            if leaf == Leaf("amount", "all") and self._are_several(statement, [*told, *quoted]):
                continue
            if not self._is_said(leaf, [*told, *quoted] if leaf.part in ("number", "amount") else quoted):
                return f"the quote does not say {leaf.part} {_shown(leaf)}"
        return ""

    def _are_several(self, statement: Statement, quoted: Sequence[Word]) -> bool:
        """Whether a noun of the statement stands in the plural, without a number."""
        nouns = {
            stem for leaf in leaves_of(statement) if leaf.part in ("noun", "anchor") for stem in stems(str(leaf.value))
        }
        return any(
            word.plural
            and (word.text in nouns or not nouns)
            and not any(one.kind == "number" or one.text == "one" for one in quoted[max(0, at - _BEFORE_NOUN) : at])
            for at, word in enumerate(quoted)
        )

    @staticmethod
    def _refers_back(quoted: Sequence[Word]) -> bool:
        """Whether a pronoun stands for what was named before."""
        return any(word.text in _PRONOUNS for word in quoted)

    def _is_said(self, leaf: Leaf, quoted: Sequence[Word]) -> bool:
        part, value = leaf
        if part in ("noun", "anchor"):
            return False
        if part == "room":
            return self._is_room_said(str(value))
        if part == "number":
            return float(value) in _numbers(quoted, "number")
        if part == "ordinal":
            return float(value) in (1.0, -1.0) or float(value) in _numbers(quoted, "ordinal", "number")
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
        rooms = self.rooms
        meant = {room.id for room in best_named(rooms, words)}
        return any(meant and meant == {room.id for room in best_named(rooms, " ".join(n))} for n in _names(self.words))

    @cached_property
    def rooms(self) -> list[SceneRoom]:
        """The rooms of the building."""
        return [room for _, room in self._state.rooms()]

    @cached_property
    def _floors(self) -> frozenset[float]:
        floors = self._state.floors
        read = (read_storeys(self.words, at, floors) for at in range(len(self.words)))
        return frozenset(float(floor) for found in read if found is not None for floor in found[0])

    def may_be_verb(self, word: Word) -> bool:
        """Whether a word is one that the rules do not know, as a verb of the model's may be."""
        return word.kind == "word" and not (self._is_noun(word) or word.plural or word.text in COLOUR_WORDS)

    def _is_noun(self, word: Word) -> bool:
        return self._lexicon.is_object((word.text,)) or self._lexicon.is_room((word.text,))


def is_content(word: Word) -> bool:
    """Whether a word says something of its own."""
    if word.kind in ("mark", "unit"):
        return False
    plain = word.text in FUNCTION_WORDS or word.text in UNRECORDED or word.text in _ANYBODY
    return word.kind != "word" or not plain


def _names(words: Sequence[Word]) -> Iterator[tuple[str, ...]]:
    for first in range(len(words)):
        for last in range(first + 1, min(first + _LONGEST, len(words)) + 1):
            run = words[first:last]
            if all(word.kind in ("word", "number", "id") for word in run) and is_content(run[-1]):
                yield tuple(word.text for word in run)


def _numbers(words: Sequence[Word], *kinds: str) -> set[float]:
    values = {word.value for word in words if word.kind in kinds}
    more = {"both": 2.0, "pair": 2.0, "couple": 2.0, "dozen": 12.0, "half": 0.5, "around": 180.0}
    return values | {-value for value in values} | {more[word.text] for word in words if word.text in more}


def _is_amount_said(kind: str, words: Sequence[Word]) -> bool:
    if kind == "all":
        wholes = frozenset("all every each everything any both whole anything no nothing them rest".split())
        return any(word.text in wholes or word.text in ANYTHING or names_many(word.text) for word in words)
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


def _leading_deed(words: Sequence[Word]) -> str:
    """Return what the verb asks for that a clause begins with, empty for none or for one of several meanings."""
    at = 0
    opening = COURTESIES | MODALS | PERSONS | frozenset(["you", "and", "then", "also", "just", "to"])
    while at < len(words) and (words[at].text in opening or words[at].kind == "mark"):
        at += 1
    for size in (3, 2, 1):
        deed = BY_WORDS.get(tuple(word.text for word in words[at : at + size]))
        if deed is not None:
            return deed
    return ""


def _is_negative(statement: Statement) -> bool:
    """Whether a statement may stand for words with a negation."""
    if isinstance(statement, Clear | Forbid | Keep | Ask | Reach | Reshape):
        return True
    leaves = leaves_of(statement)
    if any(leaf.part == "outside" or (leaf.part == "amount" and leaf.value != "all") for leaf in leaves):
        return True
    things = getattr(statement, "things", None)
    return bool(getattr(statement, "spare", ()) or (things is not None and things.beside))


def _shown(leaf: Leaf) -> str:
    return f"{leaf.value:g}" if isinstance(leaf.value, float) else repr(leaf.value)

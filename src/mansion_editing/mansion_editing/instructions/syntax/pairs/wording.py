"""What the rules that join clauses have in common: their type, words of clauses, and articles."""

from collections.abc import Callable, Sequence
from typing import Final, TypeAlias

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.syntax.clauses import Clause
from mansion_editing.instructions.syntax.tagged_words import TaggedWord, joined
from mansion_language.inflection import singular

__all__ = [
    "IT",
    "SETTING",
    "SURFACES",
    "Joined",
    "Rule",
    "names_only_room",
    "said_in",
    "texts_of",
    "with_article",
    "with_the",
]

Joined: TypeAlias = tuple[int, str] | None
"""The number of the clause after those that are put as one order, and the order."""

Rule: TypeAlias = Callable[[Sequence[Clause], int, Sequence[TaggedWord], Lexicon], "tuple[int, str] | None"]

IT: Final = frozenset(["it", "them", "those", "that", "these"])

SETTING: Final = frozenset(["add", "bring", "move", "set", "take", "leave"])


def said_in(clause: Clause, words: Sequence[TaggedWord]) -> Sequence[TaggedWord]:
    return words[clause.start : clause.end]


def texts_of(words: Sequence[TaggedWord]) -> list[str]:
    return [word.text for word in words]


def with_the(words: Sequence[TaggedWord]) -> str:
    bare = words[0].tag in ("noun", "adjective")
    return f"the {joined(words)}" if bare else joined(words)


def names_only_room(words: Sequence[TaggedWord], lexicon: Lexicon) -> bool:
    """Whether words name a room of the building, and nothing else."""
    named = [word for word in words if word.tag != "determiner"]
    return lexicon.is_own_room(tuple(singular(word.text) for word in named))


SURFACES: Final = {"floor": "floor", "wall": "walls", "ceiling": "ceiling"}


def with_article(words: Sequence[TaggedWord]) -> str:
    several = singular(words[-1].text) != words[-1].text
    article = "" if several else "an " if words[0].text[:1] in tuple("aeiou") else "a "
    return f"{article}{joined(words)}"

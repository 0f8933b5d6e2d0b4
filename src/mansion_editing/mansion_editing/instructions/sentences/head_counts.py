"""Clauses that only tell how many people there are: ``we're four for dinner``, ``there will be ten of us``."""

from collections.abc import Sequence
from itertools import takewhile
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.word_sets import PEOPLE
from mansion_editing.instructions.phrases.words import ADVERBS, BE, MODALS, PERSONS, PREPOSITIONS, Word

__all__ = ["counts_people"]

_WHO: Final = frozenset("we you us".split())
_BEFORE: Final = BE | ADVERBS | frozenset("there already about roughly around will".split())
"""Words between a subject and its number."""

_ASKING: Final = frozenset(
    "short too missing more less fewer without enough no not none instead only another each per all both".split()
)
"""Words that tell of a number that shall be another one: ``we're two short``."""


def counts_people(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether a clause says of people how many they are, where and when, and nothing of any thing."""
    at = next((k for k, word in enumerate(words) if word.kind == "number"), len(words))
    if at == len(words) or any(word.kind != "word" for word in [*words[:at], *words[at + 1 :]]):
        return False
    said = [word.text for word in words[:at] if word.text not in _BEFORE]
    being = any(word.text in BE or word.raw.endswith(("'re", "'ll")) for word in words[:at])
    rest = list(words[at + 1 :])
    of_them = rest[:1] != [] and rest[0].text == "of" and rest[1:2] != [] and rest[1].text in _WHO
    rest = rest[2:] if of_them else rest
    people = list(takewhile(lambda word: word.text in PEOPLE | PERSONS | {"people"}, rest))
    rest = rest[len(people) :]
    named = of_them or (bool(people) and "there" in {word.text for word in words[:at]})
    if not being or not (said in (["we"], ["you"]) or (said == [] and named)):
        return False
    follows = not rest or rest[0].text in PREPOSITIONS | ADVERBS
    telling = not {word.text for word in rest} & (_ASKING | MODALS)
    return follows and telling and not any(lexicon.is_object((word.text,)) for word in rest)

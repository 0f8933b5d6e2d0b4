"""Orders that only give a number to what was told of: ``make it two``, ``bring each of these up to four``."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.syntax.mentions import Mentioned
from mansion_editing.instructions.syntax.tagged_words import TaggedWord, joined
from mansion_language.inflection import plural, singular

__all__ = ["made_number", "with_number_made"]

_MAKING: Final = frozenset("make bring raise get increase reduce lower cut take keep limit".split())
_IT: Final = frozenset("it that them these those each both all of up down to number the at".split())


def made_number(words: Sequence[TaggedWord]) -> TaggedWord | None:
    """Return the number that an order gives to what was told of before; None for other clauses."""
    said = [word for word in words if word.tag not in ("adverb", "interjection", "mark")]
    if len(said) < 3 or said[0].verb not in _MAKING or said[-1].tag != "number":
        return None
    return said[-1] if all(word.text in _IT for word in said[1:-1]) else None


def with_number_made(
    number: TaggedWord, things: Sequence[Mentioned], words: Sequence[TaggedWord], room: str
) -> list[TaggedWord]:
    """Return ``there should be exactly two monitors in the hall`` for ``make it two``; empty without things told of."""
    if not things:
        return []
    many = number.text not in ("one", "1")
    nouns = [plural(singular(one.noun)) if many else singular(one.noun) for one in things]
    named = [f"{number.text} {noun}" for noun in nouns]
    told = next((joined(words[one.end : one.stop]) for one in things if one.stop > one.end), "")
    place = told or (f"in {room}" if room else "")
    listed = f"{', '.join(named[:-1])} and {named[-1]}" if len(named) > 1 else named[0]
    order = f"there should be exactly {listed} {place}".strip()
    return [replace(number, text="there", raw=order, tag="there")]

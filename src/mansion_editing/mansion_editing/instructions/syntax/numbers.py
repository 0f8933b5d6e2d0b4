"""Numbers in instructions: ``make it two`` as an order, ``in corridor 4`` for ``along corridor four``."""

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.syntax.mentions import Mentioned
from mansion_editing.instructions.syntax.noun_groups import end_of_noun_group
from mansion_editing.instructions.syntax.tagged_words import TaggedWord, joined, tagged
from mansion_language.inflection import plural, singular
from mansion_language.numbers import CARDINALS

__all__ = ["made_number", "with_number_made", "with_room_numbers"]

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


_NUMBERED: Final = re.compile(r"\b(along|throughout|two|three|four|five|six|seven|eight|nine|ten)\b", re.IGNORECASE)
_ALONG: Final = frozenset(["along", "throughout"])


def with_room_numbers(text: str, lexicon: Lexicon) -> str:
    """Return a text with the rooms that it names as a plan has them."""
    if not _NUMBERED.search(text):
        return text
    words = tagged(text, lexicon)
    changed = _in_figures(words, lexicon)
    return text if changed == words else joined(changed)


def _in_figures(words: Sequence[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    out: list[TaggedWord] = []
    for at, word in enumerate(words):
        following = words[at + 1] if at + 1 < len(words) else None
        named = out[-1] if out else None
        ends = following is None or following.tag not in ("noun", "adjective", "number", "verb")
        numbers = word.tag == "number" and word.text in CARDINALS and word.text != "one" and ends
        if numbers and named is not None and named.tag == "noun" and lexicon.is_own_room((singular(named.text),)):
            figure = f"{CARDINALS[word.text]:g}"
            out.append(replace(word, text=figure, raw=figure))
        elif word.text in _ALONG and _is_room(words, at + 1, lexicon):
            out.append(replace(word, text="in", raw="in"))
        else:
            out.append(word)
    return out


def _is_room(words: Sequence[TaggedWord], at: int, lexicon: Lexicon) -> bool:
    end = end_of_noun_group(words, at)
    nouns = tuple(singular(word.text) for word in words[at:end] if word.tag == "noun")
    return bool(nouns) and lexicon.is_own_room(nouns) and not lexicon.is_called(nouns)

"""Numbers of rooms in figures: ``corridor 4`` for ``corridor four``, and ``in`` a corridor for ``along`` it."""

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.syntax.noun_groups import end_of_noun_group
from mansion_editing.instructions.syntax.tagged_words import TaggedWord, joined, tagged
from mansion_language.inflection import singular
from mansion_language.numbers import CARDINALS

__all__ = ["with_room_numbers"]

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

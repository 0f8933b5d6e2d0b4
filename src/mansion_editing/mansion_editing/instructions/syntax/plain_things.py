"""Things of a request in plain words: the colour before the noun, one of several alternatives, one for each place."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.verb_words import BY_WORDS
from mansion_editing.instructions.syntax.noun_groups import end_of_noun_group
from mansion_editing.instructions.syntax.requests import names_something
from mansion_editing.instructions.syntax.tagged_words import TaggedWord
from mansion_language.colours import COLOUR_WORDS
from mansion_language.inflection import singular

__all__ = [
    "with_colour_first",
    "with_lamp_of_ceiling",
    "with_one_for_each",
    "without_alternatives",
    "without_contrast",
    "without_load",
    "without_simile",
]

_NEW: Final = frozenset("a an another some any".split())
_ADDING: Final = frozenset(["add", "bring", "equip", "furnish", "want", "give", "set"])
_ALL_OF_THEM: Final = frozenset("the both these those all".split())
_WISHING: Final = frozenset("need want like have get".split())


def with_colour_first(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``a blue mat`` for ``a mat in blue``, and ``paint the hall green`` for ``... in a calming green``."""
    for at in range(1, len(words) - 1):
        end = _end_of_colour(words, at + 1)
        if words[at].text != "in" or not end:
            continue
        colour = words[end - 1]
        head = at - 1
        if words[0].verb and BY_WORDS.get((words[0].verb,)) == "paint":
            return [*words[:at], colour, *words[end:]]
        if words[head].tag == "noun" and names_something(words[head:at], lexicon):
            start = _start_of_name(words, at, lexicon)
            return [*words[:start], replace(colour, tag="adjective"), *words[start:at], *words[end:]]
    return words


def _end_of_colour(words: Sequence[TaggedWord], at: int) -> int:
    """Return the end of ``blue``, ``a calming green`` at a place; 0 for other words."""
    end = at
    while end < len(words) and end < at + 4 and words[end].text not in COLOUR_WORDS:
        if words[end].tag not in ("determiner", "adjective") and not words[end].form:
            return 0
        end += 1
    while end + 1 < len(words) and words[end + 1].text in COLOUR_WORDS:
        end += 1
    ends = end + 1 >= len(words) or words[end + 1].tag in ("mark", "joint", "preposition", "adverb", "interjection")
    return end + 1 if end < len(words) and words[end].text in COLOUR_WORDS and ends else 0


def _start_of_name(words: Sequence[TaggedWord], end: int, lexicon: Lexicon) -> int:
    """Return where the longest name of a thing that ends at a place begins."""
    for start in range(max(0, end - 3), end):
        span = words[start:end]
        if all(word.tag == "noun" for word in span) and lexicon.is_object(tuple(singular(w.text) for w in span)):
            return start
    return end - 1


def without_alternatives(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``put a crate there`` for ``put a crate or a box there``: of new things either will do."""
    wishing = any(word.verb in _WISHING for word in words[:6])
    adding = words[0].form == "base" and BY_WORDS.get((words[0].verb,)) in _ADDING
    denied = any(word.text in ("no", "not", "neither", "either", "without", "never") for word in words)
    if not (wishing or adding) or denied:
        return words
    for at in range(2, len(words) - 1):
        if words[at].text != "or" or words[at + 1].text in ("else", "so", "more", "less"):
            continue
        end = end_of_noun_group(words, at + 1)
        new = words[at + 1].text in _NEW or words[at + 1].tag in ("noun", "adjective")
        left = at - (words[at - 1].text == ",")
        start = _start_of_group(words, left)
        counted = start < left and (words[start].text in _NEW or words[start].tag in ("number", "noun", "adjective"))
        if end == at + 1 or not new or not counted:
            continue
        nouns = [word for word in words[start:left] if word.tag == "noun"]
        if nouns and all(names_something([noun], lexicon) for noun in nouns):
            return [*words[:left], *words[end:]]
        if names_something(words[at + 1 : end], lexicon):
            first = replace(words[at + 1], raw="a", text="a") if words[at + 1].text == "any" else words[at + 1]
            return [*words[:start], first, *words[at + 2 :]]
    return words


def _start_of_group(words: Sequence[TaggedWord], end: int) -> int:
    """Return where the noun group begins that ends at a place: ``a crate of firewood``."""
    start = next((k for k in range(end - 1, 0, -1) if end_of_noun_group(words, k) < end), 0) + 1
    return _start_of_group(words, start - 1) if start > 2 and words[start - 1].text == "of" else start


def with_lamp_of_ceiling(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``add a ceiling light`` for ``add a light on the ceiling``."""
    texts = [word.text for word in words]
    for at in range(1, len(words) - 3):
        hanging = texts[at + 1] in ("on", "to", "from", "at") and texts[at + 2 : at + 4] == ["the", "ceiling"]
        if singular(texts[at]) in ("lamp", "light") and texts[at - 1] not in ("floor", "table", "ceiling") and hanging:
            return [*words[:at], replace(words[at + 3], tag="noun"), words[at], *words[at + 4 :]]
    return words


def with_one_for_each(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``put one lamp in each of the two rooms`` for ``put lamps in the two rooms, one each``."""
    texts = [word.text for word in words]
    if texts[-2:] not in (["one", "each"], ["one", "apiece"]) or words[0].form != "base" or len(words) < 7:
        return words
    end = end_of_noun_group(words, 1)
    if end <= 1 or end >= len(words) or words[end].tag != "preposition" or words[end - 1].tag != "noun":
        return words
    place = end_of_noun_group(words, end + 1)
    rest = words[place : len(words) - 2]
    single = singular(words[place - 1].text) == words[place - 1].text or any(w.tag == "number" for w in words[1:end])
    if single or words[end + 1].text not in _ALL_OF_THEM or any(word.text != "," for word in rest):
        return words
    one = replace(words[-2], text="one", raw="one", tag="number")
    noun = replace(words[end - 1], raw=singular(words[end - 1].text), text=singular(words[end - 1].text))
    named = [word for word in words[1 : end - 1] if word.tag not in ("number", "determiner")]
    each = [replace(words[-1], text="each", raw="each"), replace(words[end], text="of", raw="of")]
    whole = words[end + 1 : place]
    if whole[0].text in ("both", "all"):
        whole = [replace(whole[0], text="the", raw="the"), *(w for w in whole[1:] if w.text not in ("the", "of"))]
    return [words[0], one, *named, noun, words[end], *each, *whole]


_LOAD: Final = (
    ["with", "all", "that", "is", "on", "it"], ["with", "everything", "on", "it"], ["and", "everything", "on", "it"],
    ["with", "everything", "that", "is", "on", "it"], ["with", "whatever", "is", "on", "it"],
    ["and", "all", "that", "is", "on", "it"], ["with", "what", "is", "on", "it"], ["with", "all", "on", "it"],
    ["together", "with", "everything", "on", "it"], ["and", "what", "is", "on", "it"],
)  # fmt: skip


def without_load(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``carry the desk to the hall`` for ``carry the desk with all that is on it to the hall``."""
    moved = words[0].form == "base" and BY_WORDS.get((words[0].verb,)) in ("move", "take", "bring")
    texts = [word.text for word in words]
    for said in _LOAD:
        at = next((k for k in range(2, len(texts)) if texts[k : k + len(said)] == said), 0)
        if moved and at:
            return [*words[:at], *words[at + len(said) :]]
    return words


def without_contrast(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``the sofa should face the door`` for ``the sofa should face the door, not the window``."""
    at = next((k for k in range(3, len(words) - 1) if words[k].text == "not" and words[k - 1].text == ","), 0)
    start = at + 1 + (words[at + 1].tag == "preposition") if at else 0
    end = end_of_noun_group(words, start) if at else 0
    ends = end == len(words) and end > start
    return words[: at - 1] if ends and words[start].tag in ("determiner", "possessive", "pronoun") else words


def without_simile(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``paint the walls blue`` for ``paint the walls blue, like water``."""
    at = next((k for k in range(3, len(words) - 1) if words[k].text == "like" and words[k - 1].text == ","), 0)
    end = end_of_noun_group(words, at + 1) if at else 0
    if not at or end < len(words) or words[at].verb:
        return words
    return words[: at - 1]

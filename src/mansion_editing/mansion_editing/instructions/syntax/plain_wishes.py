"""Wishes as plain orders: what shall be somewhere, be on, look so or come into a place."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.syntax.noun_groups import end_of_noun_group
from mansion_editing.instructions.syntax.requests import names_something
from mansion_editing.instructions.syntax.tagged_words import TaggedWord
from mansion_language.colours import COLOUR_WORDS
from mansion_language.inflection import singular

__all__ = [
    "WAYS",
    "as_caused",
    "as_going",
    "as_new",
    "as_painted",
    "as_running",
    "end_of_place",
    "with_lid_closed",
    "with_place_after",
    "with_seats",
    "without_emphasis",
]

WAYS: Final = frozenset("into onto to".split())
"""Prepositions by which things that are there go somewhere; in others they may only be there."""

_HENCE: Final = frozenset("therefore thus hence consequently".split())

_RUNNING: Final = frozenset("run burn glow shine work hum".split())

_WISHING: Final = frozenset("need want like".split())

_KNOWN: Final = frozenset("the both all my our your those these it them that this".split())


def with_place_after(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``put a lamp and a mug on each desk`` for ``on each desk I need a lamp and a mug``."""
    if words[0].tag != "preposition" or words[0].text in ("of", "from", "for", "with", "without", "instead"):
        return words
    subject = end_of_place(words, 0)
    verb = subject + 1
    while verb < len(words) and (words[verb].tag in ("modal", "adverb") or words[verb].text == "have"):
        verb += 1
    wishing = verb < len(words) and (words[verb].verb in _WISHING or words[verb - 1].text == "have")
    if not subject or subject >= len(words) or words[subject].text not in ("i", "we") or not wishing:
        return words
    new = verb + (words[verb].verb in _WISHING)
    new += 2 * ([word.text for word in words[new : new + 2]] == ["to", "have"])
    if end_of_noun_group(words, new) == new or words[new].text in ("the", "it", "them", "to"):
        return words
    put = replace(words[verb], text="put", raw="put", tag="verb", verb="put", form="base")
    place = words[: subject - (words[subject - 1].text == ",")]
    return [put, *words[new:], replace(place[0], raw=place[0].text), *place[1:]]


def as_caused(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``the desk should face the door`` for ``have the desk face the door``."""
    words = [word for word in words if word.text not in _HENCE] if len(words) > 3 else words
    end = end_of_noun_group(words, 1)
    causing = words[0].text in ("have", "let", "get") and 1 < end < len(words) - 1
    if not causing or words[1].text not in _KNOWN or words[end].verb not in ("face", "look", "stand", "lie", "hang"):
        return words
    should = replace(words[0], text="should", raw="should", tag="modal", verb="", form="")
    return [*words[1:end], should, *words[end:]]


def as_running(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``the lamps should be on`` for ``the lamps should burn``, and ``off`` for what shall not."""
    modal = next((k for k in range(1, len(words) - 1) if words[k].text in ("must", "should", "shall", "can", "may")), 0)
    verb = modal + 1 + (words[modal + 1].tag == "not") if modal else 0
    if not verb or verb >= len(words) or words[verb].verb not in _RUNNING or words[0].tag in ("somebody", "verb"):
        return words
    if names_something(words[verb:], lexicon) or any(word.tag == "not" for word in words[verb:]):
        return words
    should = replace(words[modal], text="should", raw="should")
    state = "off" if words[modal + 1].tag == "not" else "on"
    on = replace(words[verb], text=state, raw=state, tag="adverb", verb="", form="")
    return [*words[:modal], should, replace(should, text="be", raw="be", tag="be"), on]


def as_painted(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``paint the wardrobe white`` for ``I would like the wardrobe in white``, ``to be white``."""
    wish = next((k for k in range(1, min(4, len(words))) if words[k].verb in _WISHING), 0)
    colour = words[-1]
    if words[0].text not in ("i", "we") or not wish or colour.text not in COLOUR_WORDS:
        return words
    joint = len(words) - 2
    if [word.text for word in words[joint - 1 : joint + 1]] == ["to", "be"]:
        joint -= 1
    elif words[joint].text != "in":
        return words
    named = words[wish + 1 : joint]
    if not named or named[0].text not in _KNOWN:
        return words
    paint = replace(words[wish], text="paint", raw="paint", verb="paint", form="base")
    return [paint, *named, colour]


def as_new(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``add a new bath mat`` for ``new bath mat``."""
    named = end_of_noun_group(words, 0)
    if words[0].text != "new" or named < 2 or any(word.is_finite or word.form == "base" for word in words):
        return words
    several = singular(words[named - 1].text) != words[named - 1].text
    first = replace(words[0], raw="new")
    article = [] if several else [replace(first, text="a", raw="a", tag="determiner")]
    return [replace(first, text="add", raw="add", tag="verb", verb="add", form="base"), *article, first, *words[1:]]


def with_lid_closed(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``close the lid`` for ``put the lid down``, ``lower the lid``."""
    texts = [word.text for word in words]
    lid = next((k for k in range(1, len(words)) if singular(texts[k]) == "lid"), 0)
    down = "down" in texts or words[0].verb == "lower"
    if words[0].verb not in ("put", "flip", "lower", "pull", "push", "bring") or not lid or not down:
        return words
    rest = [word for word in words[1:] if word.text != "down"]
    return [replace(words[0], text="close", raw="close", verb="close"), *rest]


def without_emphasis(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``take the rug away`` for ``do take the rug away``."""
    if words[0].tag == "do" and len(words) > 2 and words[1].form == "base":
        words = words[1:]
    return words


def with_seats(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``a dining table and six chairs`` for ``a dining table for six with chairs``."""
    texts = [word.text for word in words]
    at = next((k for k in range(2, len(words) - 3) if texts[k] == "for" and words[k + 1].tag == "number"), 0)
    if not at or texts[at + 2] != "with" or singular(texts[at + 3]) not in ("chair", "stool", "seat"):
        return words
    joint = replace(words[at + 2], text="and", raw="and", tag="joint")
    return [*words[: at - (texts[at - 1] == "in")], joint, words[at + 1], *words[at + 3 :]]


def as_going(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``move all of the plates into the sink`` for ``all of the plates into the sink``."""
    goal = next((k for k in range(1, len(words)) if words[k].text in WAYS), 0)
    known = words[0].text in ("the", "all", "both", "those", "these", "my", "our", "that", "this", "every")
    if not goal or not known or any(word.is_finite or word.form == "base" for word in words):
        return words
    told = any(word.text in ("it", "them", "those", "these") for word in words[:goal])
    if not (told or names_something(words[:goal], lexicon)) or not names_something(words[goal:], lexicon):
        return words
    first = replace(words[0], raw=words[0].text)
    return [replace(first, text="move", raw="move", tag="verb", verb="move", form="base"), first, *words[1:]]


def end_of_place(words: Sequence[TaggedWord], at: int) -> int:
    """Return the end of the place that begins at a word; the word where none does."""
    while at < len(words) and words[at].tag == "preposition":
        end = end_of_noun_group(words, at + 1)
        if end == at + 1:
            return at
        at = end + (end < len(words) and words[end].text == ",")
    return at

"""How things that are there shall look or be, without ``should be``: ``I want the chair grey``, ``Laptop: open``."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.runs import SHADES
from mansion_editing.instructions.phrases.words import STATE_WORDS
from mansion_editing.instructions.syntax.tagged_words import TaggedWord
from mansion_language.colours import COLOUR_WORDS

__all__ = ["with_wished_colour", "with_wished_states"]

_WISHING: Final = frozenset("want prefer like love fancy need have see".split())
_KNOWN: Final = frozenset("the our my your his her their its this that these those both all it them".split())
_AROUND_STATES: Final = frozenset("and both all switched turned wide please , still fully half".split())


def with_wished_colour(words: list[TaggedWord], lexicon: Lexicon) -> list[TaggedWord]:
    """Return ``the chair should be grey`` for ``I would prefer the chair in grey``."""
    wish = next((k for k in range(1, min(4, len(words))) if words[k].verb in _WISHING), 0)
    end = len(words)
    while end and words[end - 1].text in ("please", ","):
        end -= 1
    colour = end - 1
    if words[0].tag != "somebody" or not wish or colour <= wish + 1 or words[colour].text not in COLOUR_WORDS:
        return words
    colour -= words[colour - 1].text in SHADES
    start, stop = wish + 1, colour - (words[colour - 1].text == "in")
    thing = words[start:stop]
    known = bool(thing) and (thing[0].text in _KNOWN or thing[0].raw.startswith("the "))
    if not known or any(word.is_finite or word.tag == "mark" for word in thing):
        return words
    return [*thing, *_should_be(words[wish]), *words[colour:end]]


def with_wished_states(words: Sequence[TaggedWord]) -> list[TaggedWord]:
    """Return ``the laptop on the desk should be open and on`` for ``laptop on the desk: open and on``."""
    said = list(words)
    for at in range(1, len(said) - 1):
        if said[at].text not in (":", "-"):
            continue
        start = next((k + 1 for k in range(at - 1, -1, -1) if said[k].text in ".!?;:"), 0)
        end = next((k for k in range(at + 1, len(said)) if said[k].text in ".!?;"), len(said))
        states = said[at + 1 : end]
        stated = any(word.text in STATE_WORDS for word in states)
        stated = stated and all(word.text in STATE_WORDS or word.text in _AROUND_STATES for word in states)
        thing = said[start:at]
        if not stated or not thing or any(word.is_finite or word.tag in ("joint", "mark") for word in thing):
            continue
        return [*said[:at], *_should_be(said[at]), *with_wished_states(said[at + 1 :])]
    return said


def _should_be(word: TaggedWord) -> list[TaggedWord]:
    should = replace(word, text="should", raw="should", tag="modal", verb="", form="")
    return [should, replace(should, text="be", raw="be", tag="be")]

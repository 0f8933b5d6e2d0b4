"""The sentence of a request: a template with its blanks filled in."""

import re
from collections.abc import Mapping
from typing import Final

import numpy as np

from mansion_language.numbers import NUMBER_WORDS
from mansion_world.mixture import load_clutter_sentences, load_sentences

__all__ = ["fill_wording", "fitting_wordings", "saying_clutter", "values_in_words"]

_PLACE: Final = re.compile(r"\{(?:(an?|An?):)?(\w+)\}")
_VOWEL_SOUND: Final = re.compile(r"(?i)[aeiou]|8|11|18|[lfmnrsx]-")


def fitting_wordings(group: str, *, outline: str, style: str) -> list[tuple[int, str]]:
    """Return the wordings of a group, each with its number, that name just those of outline and style which are set.

    A group without such wordings serves all requests: then the sentence says nothing of them.
    """
    numbered = list(enumerate(load_sentences()[group]))
    wanted = {name for name, value in (("outline", outline), ("style", style)) if value}
    fitting = [(number, text) for number, text in numbered if _optional_places(text) == wanted]
    return fitting or [(number, text) for number, text in numbered if not _optional_places(text)]


def _optional_places(text: str) -> set[str]:
    return {name for _, name in _PLACE.findall(text)} & {"outline", "style"}


def values_in_words(
    floors: int, floor_area: float, *, outline: str, style: str, generator: np.random.Generator
) -> dict[str, str]:
    """Return the values of the places of a wording, in one of the forms in which people write them.

    Examples
    --------
    >>> words = values_in_words(2, 80, outline="", style="", generator=np.random.default_rng(1))
    >>> sorted(words)
    ['area', 'floors', 'outline', 'storeys', 'style']
    """
    number = NUMBER_WORDS[floors] if generator.random() < 0.7 else str(floors)
    floor = str(generator.choice(["floor", "floor", "storey"]))
    storey = str(generator.choice(["storey", "storey", "story", "floor"]))
    unit = str(generator.choice(["m2", "square metres", "square meters", "sqm"]))
    return {
        "floors": f"{number} {_plural(floor) if floors > 1 else floor}",
        "storeys": f"{number}-{storey}",
        "area": f"{floor_area:.0f} {unit}",
        "outline": outline,
        "style": style,
    }


def _plural(noun: str) -> str:
    return f"{noun}s"


def fill_wording(wording: str, values: Mapping[str, str]) -> str:
    """Return the sentence of a wording.

    Examples
    --------
    >>> fill_wording("{A:storeys} office", {"storeys": "eight-storey"})
    'An eight-storey office'
    """

    def value(place: re.Match[str]) -> str:
        word = values[place[2]]
        if not place[1]:
            return word
        return f"{place[1][0]}{'n' if _VOWEL_SOUND.match(word) else ''} {word}"

    sentence = _PLACE.sub(value, wording)
    return sentence[0].upper() + sentence[1:] if wording[0] == "{" else sentence


def saying_clutter(sentence: str, clutter: str, generator: np.random.Generator) -> str:
    """Return the sentence of a request with another one for its many or few small objects, if it is to have such.

    Examples
    --------
    >>> saying_clutter("a small office", "sparse", np.random.default_rng(1))
    'a small office. It should be uncluttered.'
    """
    if not clutter:
        return sentence
    stop = "" if sentence.endswith((".", "!", "?")) else "."
    return f"{sentence}{stop} {generator.choice(load_clutter_sentences()[clutter])}"

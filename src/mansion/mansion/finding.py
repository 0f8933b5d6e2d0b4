"""Objects and rooms by words: what the words name, and what the catalogue says that a thing is for."""

from collections.abc import Sequence
from typing import Final

from mansion.parts import Object, Room
from mansion_assets.catalogue import load_catalogue
from mansion_assets.catalogue.search import word_scores
from mansion_assets.catalogue.vocabulary import stems, vocabulary_of
from mansion_language.colours import COLOUR_WORDS, colour_of

__all__ = ["objects_fitting", "rooms_fitting"]

_NEAR: Final = 0.6
"""Share of the best score of the whole catalogue from which a kind of object is what the words describe."""

_PART: Final = 1
"""The rank of what has the words as another part of its name, ``Vocabulary.rank``."""


def objects_fitting(objects: Sequence[Object], words: str) -> list[Object]:
    """Return the objects that words name or describe, the best fits first."""
    catalogue = load_catalogue()
    vocabulary = vocabulary_of(catalogue)
    of_colour = [item for item in objects if _has_colours(item, words)]
    ranks = {item.id: vocabulary.rank(item.record, words) for item in of_colour}
    least = _PART + 1 if any(rank > _PART for rank in ranks.values()) else _PART
    scores = word_scores(catalogue, words)
    bound = max(_NEAR * max(scores.values(), default=0.0), 1e-9)
    fits = [item for item in of_colour if ranks[item.id] >= least or scores.get(item.category, 0.0) >= bound]
    return sorted(fits, key=lambda item: (-ranks[item.id], -scores.get(item.category, 0.0)))


def _has_colours(item: Object, words: str) -> bool:
    """Whether an object is of the colour that stands beside other words; a colour alone may be a thing (an orange)."""
    asked = stems(words)
    colours = {COLOUR_WORDS[word] for word in asked if word in COLOUR_WORDS}
    if not colours or all(word in COLOUR_WORDS for word in asked):
        return True
    if vocabulary_of(load_catalogue()).exact(asked):
        return True
    return colours == {colour_of(item.material)}


def rooms_fitting(rooms: Sequence[Room], words: str) -> list[Room]:
    """Return all rooms that words name, in the building's order."""
    from mansion_editing.state import SceneState
    from mansion_editing.tools.perception import find_rooms

    scenes = list({room.floor: room.scene for room in rooms}.values())
    if not scenes:
        return []
    found = {room.id for _, room in find_rooms(SceneState(scenes, load_catalogue()), words, every=True)}
    return [room for room in rooms if room.id in found]

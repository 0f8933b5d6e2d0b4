"""The explorer's memory: what it has seen, and which rooms it searches next."""

from dataclasses import dataclass, field
from math import dist
from typing import Final

from mansion_knowledge import words_by
from mansion_msgs_py.skills import LandmarkInfo
from mansion_tasks.agents.instructions import NounPhrase
from mansion_tasks.agents.interface import Observation, SeenObject
from mansion_tasks.language.matching import match_score

__all__ = ["Sighting", "SearchMemory", "room_likelihood", "plain_name", "usual_container"]


@dataclass(frozen=True)
class Sighting:
    """An object, and the floor where it was seen last."""

    item: SeenObject
    floor: int


@dataclass
class SearchMemory:
    """The memory of one episode.

    Attributes
    ----------
    searched : dict
        Landmarks that the agent has looked around at.
    unreachable : dict
        Landmarks that it could not get to.
    """

    searched: dict[str, None] = field(default_factory=dict)
    unreachable: dict[str, None] = field(default_factory=dict)
    _landmarks: dict[int, tuple[LandmarkInfo, ...]] = field(default_factory=dict)
    _seen: dict[str, Sighting] = field(default_factory=dict)

    def note(self, observation: Observation) -> None:
        """Remember what an observation shows."""
        self._landmarks[observation.floor] = observation.landmarks
        for item in observation.visible:
            self._seen[item.ref] = Sighting(item, observation.floor)

    def cores(self, floor: int, kind: str) -> list[LandmarkInfo]:
        """Return the known cores of a kind on a floor."""
        return [entry for entry in self._landmarks.get(floor, ()) if entry.kind == kind]

    def closed_objects(self, floor: int, room: str) -> list[SeenObject]:
        """Return the objects of a room that were closed_objects when they were seen last."""
        return [
            sighting.item
            for sighting in self._seen.values()
            if (sighting.floor, sighting.item.room) == (floor, room)
            and sighting.item.openable
            and sighting.item.is_open is False
        ]

    def rooms_to_search(self, observation: Observation, phrase: NounPhrase) -> list[str]:
        """Return the rooms of this floor not searched yet: named ones, then likely ones, then the nearest."""
        here = (observation.pose.x, observation.pose.y)
        rooms = [
            entry
            for entry in observation.landmarks
            if entry.kind == "room" and entry.name not in self.searched | self.unreachable
        ]
        words = (phrase.noun, *phrase.places)
        ranked = sorted(
            rooms,
            key=lambda entry: (
                -max(match_score(word, plain_name(entry.name)) for word in words),
                -room_likelihood(phrase.noun, plain_name(entry.name)),
                entry.name != observation.room,
                dist(here, (entry.pose.x, entry.pose.y)),
                entry.name,
            ),
        )
        return [entry.name for entry in ranked]

    def candidates(self, phrase: NounPhrase, *, pickupable: bool) -> list[tuple[int, Sighting]]:
        """Return what may be the object that a phrase names, the best first, each with its score.

        Every word of the phrase that is confirmed (colour, floor, room or furniture) counts.
        """
        found = []
        for name, sighting in self._seen.items():
            item = sighting.item
            noun = match_score(phrase.noun, item.category)
            if not noun or (pickupable and not item.pickupable):
                continue
            if phrase.floor not in (None, sighting.floor):
                continue
            score = noun + 4 * self._confirmed(phrase, item)
            found.append((-score, item.distance, name, sighting))
        found.sort(key=lambda entry: entry[:3])
        return [(-score, sighting) for score, _, _, sighting in found]

    def furniture(self, phrase: NounPhrase, floor: int, room: str) -> list[str]:
        """Return the objects of a room that a phrase names as the place, but the room itself."""
        return [
            sighting.item.ref
            for sighting in self._seen.values()
            if (sighting.floor, sighting.item.room) == (floor, room)
            and any(match_score(word, sighting.item.category) for word in phrase.places)
        ]

    def is_certain(self, phrase: NounPhrase, score: int) -> bool:
        """Whether a score says that all words of the phrase are confirmed, and the noun is more than a likeness."""
        return score >= 4 * (len(phrase.places) + bool(phrase.color)) + 2

    def _confirmed(self, phrase: NounPhrase, item: SeenObject) -> int:
        parent = self._seen.get(item.parent)
        carrier = parent.item.category if parent is not None else ""
        on = (carrier, plain_name(item.parent))
        color = parent.item.color if parent is not None else ""
        places = sum(
            match_score(word, plain_name(item.room)) > 1
            or (any(match_score(word, name) > 1 for name in on) and tint in ("", color))
            for word, tint in zip(phrase.places, phrase.place_colors)
        )
        return places + bool(phrase.color and phrase.color == item.color)


def plain_name(name: str) -> str:
    """Return a room's or an object's name without its floor: "meeting room 1" of ``F3/meeting_room_1``."""
    return name.rsplit("/", 1)[-1].replace("_", " ")


_KEPT: Final = (
    (
        ("apple", "banana", "bread", "egg", "lettuce", "potato", "tomato", "juice carton", "can", "cola can", "bottle",
         "water bottle", "milk carton", "cup", "mug", "glass", "plate", "bowl", "fork", "knife", "butter knife",
         "spoon", "pan", "pot", "kettle", "salt shaker", "pepper shaker", "cutting board", "spatula", "ladle",
         "dish sponge", "detergent", "wine bottle", "wine glass", "lunch box"),
        "food",
    ),
    (
        ("keyboard", "mouse", "laptop", "notebook", "pen", "pencil", "paper stack", "folder", "stapler", "headphone",
         "telephone", "monitor", "tablet", "document", "binder", "calculator", "marker", "reading lamp"),
        "office",
    ),
    (
        ("package", "box", "cardboard box", "toolbox", "spray bottle", "bucket", "broom", "crate", "basket", "drill",
         "hammer", "screwdriver"),
        "tools",
    ),
    (
        ("towel", "soap bar", "soap bottle", "toothpaste", "toothbrush", "toilet paper", "shampoo", "hand towel"),
        "washing",
    ),
    (
        ("pillow", "blanket", "alarm clock", "teddy bear", "table lamp", "hair brush"),
        "sleeping",
    ),
    (
        ("remote control", "vase", "candle", "newspaper", "magazine", "book", "cloth", "key chain", "picture frame"),
        "reading",
    ),
)  # fmt: skip
"""Categories of objects, and what the rooms where most of them are usually keep."""

_CHILLED: Final = (
    "apple", "banana", "bread", "egg", "lettuce", "potato", "tomato", "juice carton", "can", "cola can", "bottle",
    "water bottle", "milk carton", "wine bottle", "lunch box",
)  # fmt: skip


def room_likelihood(noun: str, room: str) -> int:
    """Return whether an object is likely in a room: 2 where it belongs, 0 where hardly anything is, else 1.

    Examples
    --------
    >>> [room_likelihood("potato", room) for room in ("break_room", "office 2", "corridor")]
    [2, 1, 0]
    """
    keeps = words_by("keeps")
    for items, kept in _KEPT:
        if any(match_score(noun, item) == 3 for item in items) and any(
            match_score(name, room) > 1 for name in keeps[kept]
        ):
            return 2
    return 0 if any(match_score(name, room) > 1 for name in keeps["nothing"]) else 1


def usual_container(noun: str) -> str:
    """Return the closed_objects furniture that an object is often in, empty for none.

    Examples
    --------
    >>> usual_container("potato"), usual_container("laptop")
    ('fridge', '')
    """
    return "fridge" if any(match_score(noun, item) == 3 for item in _CHILLED) else ""

"""What an agent has seen so far: objects, landmarks, places it looked around in, ways that are shut."""

from dataclasses import dataclass, field
from math import dist

from mansion_msgs_py.skills import LandmarkInfo
from mansion_tasks.agents.interface import Observation, SeenObject
from mansion_tasks.agents.priors import likelihood
from mansion_tasks.agents.reading import Phrase
from mansion_tasks.agents.words import match_score

__all__ = ["Sighting", "Surroundings", "room_words"]


@dataclass(frozen=True)
class Sighting:
    """An object, and the floor where it was seen last."""

    thing: SeenObject
    floor: int


@dataclass
class Surroundings:
    """The memory of one episode.

    Attributes
    ----------
    searched : dict
        Landmarks that the agent has looked around at.
    shut : dict
        Landmarks that it could not get to.
    """

    searched: dict[str, None] = field(default_factory=dict)
    shut: dict[str, None] = field(default_factory=dict)
    _landmarks: dict[int, tuple[LandmarkInfo, ...]] = field(default_factory=dict)
    _seen: dict[str, Sighting] = field(default_factory=dict)

    def note(self, observation: Observation) -> None:
        """Remember what an observation shows."""
        self._landmarks[observation.floor] = observation.landmarks
        for thing in observation.visible:
            self._seen[thing.ref] = Sighting(thing, observation.floor)

    def cores(self, floor: int, kind: str) -> list[LandmarkInfo]:
        """Return the known cores of a kind on a floor."""
        return [entry for entry in self._landmarks.get(floor, ()) if entry.kind == kind]

    def closed(self, floor: int, room: str) -> list[SeenObject]:
        """Return the things of a room that were closed when they were seen last."""
        return [
            sighting.thing
            for sighting in self._seen.values()
            if (sighting.floor, sighting.thing.room) == (floor, room)
            and sighting.thing.openable
            and sighting.thing.is_open is False
        ]

    def rooms_to_search(self, observation: Observation, phrase: Phrase) -> list[str]:
        """Return the rooms of this floor not searched yet: named ones, then likely ones, then the nearest."""
        here = (observation.pose.x, observation.pose.y)
        rooms = [
            entry
            for entry in observation.landmarks
            if entry.kind == "room" and entry.name not in self.searched | self.shut
        ]
        words = (phrase.noun, *phrase.places)
        ranked = sorted(
            rooms,
            key=lambda entry: (
                -max(match_score(word, room_words(entry.name)) for word in words),
                -likelihood(phrase.noun, room_words(entry.name)),
                entry.name != observation.room,
                dist(here, (entry.pose.x, entry.pose.y)),
                entry.name,
            ),
        )
        return [entry.name for entry in ranked]

    def candidates(self, phrase: Phrase, *, pickupable: bool) -> list[tuple[int, Sighting]]:
        """Return what may be the thing that a phrase names, the best first, each with its score.

        Every word of the phrase that is confirmed (colour, floor, room or furniture) counts.
        """
        found = []
        for name, sighting in self._seen.items():
            thing = sighting.thing
            noun = match_score(phrase.noun, thing.category)
            if not noun or (pickupable and not thing.pickupable):
                continue
            if phrase.floor not in (None, sighting.floor):
                continue
            score = noun + 4 * self._confirmed(phrase, thing)
            found.append((-score, thing.distance, name, sighting))
        found.sort(key=lambda entry: entry[:3])
        return [(-score, sighting) for score, _, _, sighting in found]

    def furniture(self, phrase: Phrase, floor: int, room: str) -> list[str]:
        """Return the things of a room that a phrase names as the place, but the room itself."""
        return [
            sighting.thing.ref
            for sighting in self._seen.values()
            if (sighting.floor, sighting.thing.room) == (floor, room)
            and any(match_score(word, sighting.thing.category) for word in phrase.places)
        ]

    def is_certain(self, phrase: Phrase, score: int) -> bool:
        """Whether a score says that all words of the phrase are confirmed, and the noun is no mere likeness."""
        return score >= 4 * (len(phrase.places) + bool(phrase.color)) + 2

    def _confirmed(self, phrase: Phrase, thing: SeenObject) -> int:
        parent = self._seen.get(thing.parent)
        carrier = parent.thing.category if parent is not None else ""
        on = (carrier, room_words(thing.parent))
        color = parent.thing.color if parent is not None else ""
        places = sum(
            match_score(word, room_words(thing.room)) > 1
            or (any(match_score(word, name) > 1 for name in on) and tint in ("", color))
            for word, tint in zip(phrase.places, phrase.place_colors)
        )
        return places + bool(phrase.color and phrase.color == thing.color)


def room_words(name: str) -> str:
    """Return a room's or a thing's name without its floor: "meeting room 1" of ``F3/meeting_room_1``."""
    return name.rsplit("/", 1)[-1].replace("_", " ")

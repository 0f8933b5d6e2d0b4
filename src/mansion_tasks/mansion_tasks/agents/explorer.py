"""A scripted explorer: reads the instruction, searches floor by floor and room by room, carries what it found."""

import re
from collections.abc import Generator
from typing import Any, Final

from mansion_msgs_py.task import SkillCall
from mansion_msgs_py.world import Pose2D
from mansion_tasks.agents.interface import Access, Agent, Briefing, Observation, SeenObject, Stop
from mansion_tasks.agents.priors import shut_away_in
from mansion_tasks.agents.reading import Errand, Phrase, read_instruction
from mansion_tasks.agents.recovery import escape
from mansion_tasks.agents.surroundings import Sighting, Surroundings, room_words
from mansion_tasks.agents.words import match_score

__all__ = ["Explorer"]

Course = Generator[SkillCall, None, bool]
"""Skills that lead to something; returns whether they did."""

DELIVERY: Final = 12
"""Steps kept for carrying: an incompletely confirmed thing is taken when no more than these are left."""

LEVEL: Final = 20.0
"""Degrees of tilt at which the camera still sees a room."""

LOOKS: Final = 5
"""Pieces of furniture of one room that are looked at from near."""

_DOOR = re.compile(r"OpenDoor (\S+)")


class Explorer(Agent):
    """Knows what any client of the services does: landmarks, and the names of objects in view. No map, no goals.

    It goes to each room of a floor, turns round, and remembers what it sees. A thing is taken at once when all that
    the instruction says of it is confirmed, else when everything was searched or the steps run short.
    """

    name = "explorer"
    access = Access()

    def __init__(self) -> None:
        self._now = Observation("", 0, 1, 1, (1,), Pose2D(x=0.0, y=0.0))
        self._memory = Surroundings()
        self._failed: dict[str, None] = {}
        self._course: Generator[SkillCall, None, Stop] | None = None
        self._end = Stop("nothing to do")
        self._home = 1

    def reset(self, briefing: Briefing) -> None:
        """See `Agent.reset`."""
        errand = read_instruction(briefing.instruction, briefing.floors, briefing.labels)
        self._memory, self._failed = Surroundings(), {}
        self._errand = errand
        self._course = self._work(errand)

    def act(self, observation: Observation) -> SkillCall | Stop:
        """See `Agent.act`."""
        if observation.step == 0:
            self._home = observation.floor
        self._now = observation
        self._memory.note(observation)
        if self._course is None:
            return self._end
        try:
            return next(self._course)
        except StopIteration as end:
            self._course, self._end = None, end.value
            return self._end

    def lessons(self) -> list[str]:
        """See `Agent.lessons`: each episode starts without memory."""
        return []

    def notes(self) -> dict[str, Any]:
        """See `Agent.notes`."""
        return {}

    def _work(self, errand: Errand) -> Generator[SkillCall, None, Stop]:
        carried = errand.destination is not None
        while True:
            found = yield from self._search(errand.target, pickupable=carried, rest=DELIVERY if carried else 2)
            if found is None:
                return Stop(f"found no {errand.target.noun}")
            if (yield from self._fetch(found, carried)):
                break
            self._failed[found.thing.ref] = None
        if errand.destination is None:
            return Stop(f"found {found.thing.ref}", done=True)
        if (yield from self._deliver(errand)):
            return Stop(f"delivered {found.thing.ref}", done=True)
        return Stop(f"found no place for {found.thing.ref}")

    def _search(self, phrase: Phrase, *, pickupable: bool, rest: int) -> Generator[SkillCall, None, Sighting | None]:
        """Look for a thing until one is certain, everything is searched, or `rest` steps are left."""
        for floor in self._floor_order(phrase):
            while True:
                best = self._best(phrase, pickupable, certain=True)
                if best is not None:
                    return best
                if self._now.max_steps - self._now.step <= rest:
                    return self._best(phrase, pickupable, certain=False)
                if self._now.floor != floor and not (yield from self._go_to_floor(floor)):
                    break
                rooms = self._memory.rooms_to_search(self._now, phrase)
                if not rooms:
                    break
                yield from self._look_around(rooms[0], phrase, pickupable)
        return self._best(phrase, pickupable, certain=False)

    def _best(self, phrase: Phrase, pickupable: bool, *, certain: bool) -> Sighting | None:
        for score, sighting in self._memory.candidates(phrase, pickupable=pickupable):
            if sighting.thing.ref not in self._failed and sighting.thing.ref != self._now.held:
                sure = self._memory.is_certain(phrase, score)
                return sighting if sure or not certain else None
        return None

    def _floor_order(self, phrase: Phrase) -> list[int]:
        if phrase.floor in self._now.floors:
            return [phrase.floor]
        here = self._now.floor
        return sorted(self._now.floors, key=lambda floor: (floor != self._home, abs(floor - here)))

    def _look_around(self, room: str, phrase: Phrase, pickupable: bool) -> Course:
        """Go to a room and turn round in it, unless what is sought comes into view before."""
        if not (yield from self._go_to(room)):
            self._memory.shut[room] = None
            return False
        yield from self._look_level()
        for turn in range(4):
            if self._best(phrase, pickupable, certain=True) is not None:
                return True
            if turn < 3:
                yield SkillCall(skill="Rotate", arguments={"degrees": 90.0})
        self._memory.searched[room] = None
        yield from self._open_what_is_named(phrase)
        yield from self._look_closer(phrase, pickupable)
        return True

    def _look_level(self) -> Course:
        """Lift the camera again after something was handled: what is far away lies near the horizon."""
        pitch = self._now.pitch
        if abs(pitch) <= LEVEL:
            return True
        return (yield from self._do("LookUp" if pitch < 0 else "LookDown", degrees=abs(pitch)))

    def _look_closer(self, phrase: Phrase, pickupable: bool) -> Course:
        """In a room that the phrase names, go to the furniture that it names: one place does not show it all."""
        room = self._now.room
        if not any(match_score(word, room_words(room)) for word in phrase.places):
            return False
        for name in self._memory.furniture(phrase, self._now.floor, room)[:LOOKS]:
            if self._best(phrase, pickupable, certain=True) is not None or self._hurried():
                return True
            yield from self._do("GoNearObject", object=name)
        return True

    def _open_what_is_named(self, phrase: Phrase) -> Course:
        """Open furniture of this room that the phrase names, or that such things are kept in."""
        places = (*phrase.places, shut_away_in(phrase.noun))
        for thing in self._memory.closed(self._now.floor, self._now.room):
            named = any(match_score(word, thing.category) for word in places)
            if named and thing.ref not in self._failed and not self._hurried():
                self._failed[thing.ref] = None
                if (yield from self._do("GoNearObject", object=thing.ref)):
                    yield from self._do("OpenObject", object=thing.ref)
        return True

    def _hurried(self) -> bool:
        return self._now.max_steps - self._now.step <= DELIVERY

    def _go_to_floor(self, floor: int) -> Course:
        """Ride, or walk one floor after the other; where one way fails, try the other."""
        while self._now.floor != floor:
            here = self._now.floor
            step = 1 if floor > here else -1
            ways = [self._ride(floor), self._climb(step)]
            if abs(floor - here) == 1:
                ways.reverse()
            for way in ways:
                if (yield from way):
                    break
            if self._now.floor == here:
                return False
        return True

    def _ride(self, floor: int) -> Course:
        return (
            bool(self._memory.cores(self._now.floor, "elevator"))
            and (yield from self._go_to("elevator"))
            and (yield from self._do("CallElevator"))
            and (yield from self._do("UseElevator", target_floor=floor))
        )

    def _climb(self, step: int) -> Course:
        direction = "Up" if step > 0 else "Down"
        for core in self._memory.cores(self._now.floor, "stair"):
            if (yield from self._go_to(core.name)) and (yield from self._do("TakeStairs", direction=direction)):
                return True
        return False

    def _fetch(self, sighting: Sighting, carried: bool) -> Course:
        thing = sighting.thing
        if not (yield from self._go_near(sighting)):
            return False
        return not carried or (yield from self._do("PickUp", object=thing.ref))

    def _go_near(self, sighting: Sighting) -> Course:
        if self._now.floor != sighting.floor and not (yield from self._go_to_floor(sighting.floor)):
            return False
        return (yield from self._go("GoNearObject", "object", sighting.thing.ref))

    def _deliver(self, errand: Errand) -> Course:
        """Put what is held where the errand says: in a room of that name, or with a thing of that name."""
        place = errand.destination
        assert place is not None
        floors = [place.floor] if place.floor is not None else self._floor_order(place)
        for floor in floors:
            if self._now.floor != floor and not (yield from self._go_to_floor(floor)):
                continue
            if not place.noun:
                return (yield from self._put_down())
            for room in self._rooms_named(place.noun):
                if (yield from self._go_to(room)) and (yield from self._put_down()):
                    return True
        tried = 0
        while tried < 5:
            found = yield from self._search(place, pickupable=False, rest=3)
            if found is None:
                return False
            if (yield from self._go_near(found)) and (yield from self._put(found.thing, errand.relation)):
                if errand.close:
                    yield from self._do("CloseObject", object=found.thing.ref)
                return True
            self._failed[found.thing.ref] = None
            tried += 1
        return False

    def _rooms_named(self, noun: str) -> list[str]:
        scored = [
            (-match_score(noun, room_words(entry.name)), entry.name)
            for entry in self._now.landmarks
            if entry.kind == "room" and match_score(noun, room_words(entry.name))
        ]
        return [name for _, name in sorted(scored)]

    def _put(self, thing: SeenObject, relation: str) -> Course:
        if relation == "near":
            return (yield from self._put_down())
        if relation == "in" or not thing.receptacle:
            yield from self._do("OpenObject", object=thing.ref)
            return (yield from self._do("Place", target=thing.ref, relation="in"))
        return (yield from self._do("Place", target=thing.ref, relation="on")) or (
            yield from self._do("Place", target=thing.ref, relation="in")
        )

    def _put_down(self) -> Course:
        """Put what is held on the floor before the robot, wherever there is room for it."""
        for _ in range(4):
            if (yield from self._do("Place", target="floor", relation="on")):
                return True
            yield SkillCall(skill="Rotate", arguments={"degrees": 90.0})
        return False

    def _go_to(self, landmark: str) -> Course:
        return (yield from self._go("GoToLandmark", "landmark", landmark))

    def _go(self, skill: str, argument: str, name: str) -> Course:
        """Go somewhere; open a closed door that is in the way, and get out of a corner."""
        for _ in range(3):
            if (yield from self._do(skill, **{argument: name})):
                return True
            door = _DOOR.search(self._now.last.satisfied_by) if self._now.last else None
            if door is not None:
                if not (yield from self._do("GoNearObject", object=door.group(1))):
                    return False
                if not (yield from self._do("OpenDoor", door=door.group(1))):
                    return False
                continue
            way_out = escape(self._now.last)
            if way_out is None:
                return False
            yield from way_out
        return False

    def _do(self, skill: str, **arguments: Any) -> Course:
        yield SkillCall(skill=skill, arguments=arguments)
        return self._now.succeeded

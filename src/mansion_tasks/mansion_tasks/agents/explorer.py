"""A scripted explorer: reads the instruction, searches floor by floor and room by room, carries what it found."""

import re
from collections.abc import Generator
from typing import Any, Final

from mansion_msgs_py.task import SkillCall
from mansion_msgs_py.world import Pose2D
from mansion_tasks.agents.instructions import NounPhrase, ParsedInstruction, read_instruction
from mansion_tasks.agents.interface import Access, Agent, Briefing, Observation, SeenObject, Stop
from mansion_tasks.agents.recovery import escape_moves
from mansion_tasks.agents.search_memory import SearchMemory, Sighting, plain_name, usual_container
from mansion_tasks.language.matching import match_score

__all__ = ["Explorer"]

SkillSequence = Generator[SkillCall, None, bool]
"""Skills that lead to something; returns whether they did."""

DELIVERY_STEPS: Final = 12
"""Steps kept for carrying: an incompletely confirmed object is taken when no more than these are left."""

LEVEL_TILT: Final = 20.0
"""Degrees of tilt at which the camera still sees a room."""

MAX_CLOSE_LOOKS: Final = 5
"""Pieces of furniture of one room that are looked at from near."""

_DOOR = re.compile(r"OpenDoor (\S+)")


class Explorer(Agent):
    """Knows what any client of the services does: landmarks, and the names of objects in view. No map, no goals.

    It goes to each room of a floor, turns round, and remembers what it sees. An object is taken at once when all that
    the instruction says of it is confirmed, else when everything was searched or the steps run short.
    """

    name = "explorer"
    access = Access()

    def __init__(self) -> None:
        self._now = Observation("", 0, 1, 1, (1,), Pose2D(x=0.0, y=0.0))
        self._memory = SearchMemory()
        self._failed: dict[str, None] = {}
        self._plan: Generator[SkillCall, None, Stop] | None = None
        self._end = Stop("nothing to do")
        self._first_floor = 1

    def reset(self, briefing: Briefing) -> None:
        """See `Agent.reset`."""
        errand = read_instruction(briefing.instruction, briefing.floors, briefing.labels)
        self._memory, self._failed = SearchMemory(), {}
        self._errand = errand
        self._plan = self._work(errand)

    def act(self, observation: Observation) -> SkillCall | Stop:
        """See `Agent.act`."""
        if observation.step == 0:
            self._first_floor = observation.floor
        self._now = observation
        self._memory.note(observation)
        if self._plan is None:
            return self._end
        try:
            return next(self._plan)
        except StopIteration as end:
            self._plan, self._end = None, end.value
            return self._end

    def lessons(self) -> list[str]:
        """See `Agent.lessons`: each episode starts without memory."""
        return []

    def notes(self) -> dict[str, Any]:
        """See `Agent.notes`."""
        return {}

    def _work(self, errand: ParsedInstruction) -> Generator[SkillCall, None, Stop]:
        carried = errand.destination is not None
        while True:
            found = yield from self._search(errand.target, pickupable=carried, rest=DELIVERY_STEPS if carried else 2)
            if found is None:
                return Stop(f"found no {errand.target.noun}")
            if (yield from self._fetch(found, carried=carried)):
                break
            self._failed[found.item.ref] = None
        if errand.destination is None:
            return Stop(f"found {found.item.ref}", done=True)
        if (yield from self._deliver(errand)):
            return Stop(f"delivered {found.item.ref}", done=True)
        return Stop(f"found no place for {found.item.ref}")

    def _search(
        self, phrase: NounPhrase, *, pickupable: bool, rest: int
    ) -> Generator[SkillCall, None, Sighting | None]:
        """Look for an object until one is certain, everything is searched, or `rest` steps are left."""
        for floor in self._floor_order(phrase):
            while True:
                best = self._best(phrase, pickupable=pickupable, certain=True)
                if best is not None:
                    return best
                if self._now.max_steps - self._now.step <= rest:
                    return self._best(phrase, pickupable=pickupable, certain=False)
                if self._now.floor != floor and not (yield from self._go_to_floor(floor)):
                    break
                rooms = self._memory.rooms_to_search(self._now, phrase)
                if not rooms:
                    break
                yield from self._look_around(rooms[0], phrase, pickupable=pickupable)
        return self._best(phrase, pickupable=pickupable, certain=False)

    def _best(self, phrase: NounPhrase, *, pickupable: bool, certain: bool) -> Sighting | None:
        for score, sighting in self._memory.candidates(phrase, pickupable=pickupable):
            if sighting.item.ref not in self._failed and sighting.item.ref != self._now.held:
                sure = self._memory.is_certain(phrase, score)
                return sighting if sure or not certain else None
        return None

    def _floor_order(self, phrase: NounPhrase) -> list[int]:
        if phrase.floor in self._now.floors:
            return [phrase.floor]
        here = self._now.floor
        return sorted(self._now.floors, key=lambda floor: (floor != self._first_floor, abs(floor - here)))

    def _look_around(self, room: str, phrase: NounPhrase, *, pickupable: bool) -> SkillSequence:
        """Go to a room and turn round in it, unless what is sought comes into view before."""
        if not (yield from self._go_to(room)):
            self._memory.unreachable[room] = None
            return False
        yield from self._look_level()
        for turn in range(4):
            if self._best(phrase, pickupable=pickupable, certain=True) is not None:
                return True
            if turn < 3:
                yield SkillCall(skill="Rotate", arguments={"degrees": 90.0})
        self._memory.searched[room] = None
        yield from self._open_what_is_named(phrase)
        yield from self._look_closer(phrase, pickupable=pickupable)
        return True

    def _look_level(self) -> SkillSequence:
        """Lift the camera again after something was handled: what is far away lies near the horizon."""
        pitch = self._now.pitch
        if abs(pitch) <= LEVEL_TILT:
            return True
        return (yield from self._do("LookUp" if pitch < 0 else "LookDown", degrees=abs(pitch)))

    def _look_closer(self, phrase: NounPhrase, *, pickupable: bool) -> SkillSequence:
        """In a room that the phrase names, go to the furniture that it names: one place does not show it all."""
        room = self._now.room
        if not any(match_score(word, plain_name(room)) for word in phrase.places):
            return False
        for name in self._memory.furniture(phrase, self._now.floor, room)[:MAX_CLOSE_LOOKS]:
            if self._best(phrase, pickupable=pickupable, certain=True) is not None or self._hurried():
                return True
            yield from self._do("GoNearObject", object=name)
        return True

    def _open_what_is_named(self, phrase: NounPhrase) -> SkillSequence:
        """Open furniture of this room that the phrase names, or that such objects are kept in."""
        places = (*phrase.places, usual_container(phrase.noun))
        for item in self._memory.closed_objects(self._now.floor, self._now.room):
            named = any(match_score(word, item.category) for word in places)
            if named and item.ref not in self._failed and not self._hurried():
                self._failed[item.ref] = None
                if (yield from self._do("GoNearObject", object=item.ref)):
                    yield from self._do("OpenObject", object=item.ref)
        return True

    def _hurried(self) -> bool:
        return self._now.max_steps - self._now.step <= DELIVERY_STEPS

    def _go_to_floor(self, floor: int) -> SkillSequence:
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

    def _ride(self, floor: int) -> SkillSequence:
        return (
            bool(self._memory.cores(self._now.floor, "elevator"))
            and (yield from self._go_to("elevator"))
            and (yield from self._do("CallElevator"))
            and (yield from self._do("UseElevator", target_floor=floor))
        )

    def _climb(self, step: int) -> SkillSequence:
        direction = "Up" if step > 0 else "Down"
        for core in self._memory.cores(self._now.floor, "stair"):
            if (yield from self._go_to(core.name)) and (yield from self._do("TakeStairs", direction=direction)):
                return True
        return False

    def _fetch(self, sighting: Sighting, *, carried: bool) -> SkillSequence:
        item = sighting.item
        if not (yield from self._go_near(sighting)):
            return False
        return not carried or (yield from self._do("PickUp", object=item.ref))

    def _go_near(self, sighting: Sighting) -> SkillSequence:
        if self._now.floor != sighting.floor and not (yield from self._go_to_floor(sighting.floor)):
            return False
        return (yield from self._go("GoNearObject", "object", sighting.item.ref))

    def _deliver(self, errand: ParsedInstruction) -> SkillSequence:
        """Put what is held where the errand says: in a room of that name, or with an object of that name."""
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
            if (yield from self._go_near(found)) and (yield from self._put(found.item, errand.relation)):
                if errand.close:
                    yield from self._do("CloseObject", object=found.item.ref)
                return True
            self._failed[found.item.ref] = None
            tried += 1
        return False

    def _rooms_named(self, noun: str) -> list[str]:
        scored = [
            (-match_score(noun, plain_name(entry.name)), entry.name)
            for entry in self._now.landmarks
            if entry.kind == "room" and match_score(noun, plain_name(entry.name))
        ]
        return [name for _, name in sorted(scored)]

    def _put(self, item: SeenObject, relation: str) -> SkillSequence:
        if relation == "near":
            return (yield from self._put_down())
        if relation == "in" or not item.receptacle:
            yield from self._do("OpenObject", object=item.ref)
            return (yield from self._do("Place", target=item.ref, relation="in"))
        return (yield from self._do("Place", target=item.ref, relation="on")) or (
            yield from self._do("Place", target=item.ref, relation="in")
        )

    def _put_down(self) -> SkillSequence:
        """Put what is held on the floor before the robot, wherever there is room for it."""
        for _ in range(4):
            if (yield from self._do("Place", target="floor", relation="on")):
                return True
            yield SkillCall(skill="Rotate", arguments={"degrees": 90.0})
        return False

    def _go_to(self, landmark: str) -> SkillSequence:
        return (yield from self._go("GoToLandmark", "landmark", landmark))

    def _go(self, skill: str, argument: str, name: str) -> SkillSequence:
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
            way_out = escape_moves(self._now.last)
            if way_out is None:
                return False
            yield from way_out
        return False

    def _do(self, skill: str, **arguments: Any) -> SkillSequence:
        yield SkillCall(skill=skill, arguments=arguments)
        return self._now.succeeded

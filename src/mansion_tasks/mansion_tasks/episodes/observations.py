"""Observations of agents: what the robot's skills answer, without what the agent may not know."""

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import msgspec

from mansion_language.colours import colour_of
from mansion_language.core_words import CORE_WORDS
from mansion_msgs_py.skills import LandmarkInfo, Landmarks, VisibleObject, VisibleObjects
from mansion_msgs_py.task import SkillCall, Task
from mansion_msgs_py.world import SkillResult
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World
from mansion_tasks.agents.interface import Access, MapEntry, Observation, Pictures, SeenObject
from mansion_tasks.episodes.port import SkillPort

__all__ = ["HELD", "Anonymizer", "Snapshot", "Observer", "object_map"]

HELD = "#0"
"""What the hand holds."""

_OBJECT = re.compile(r"\bF-?\d+/[\w.-]+(?:/[\w.-]+)+")
_PLACE = re.compile(r"\bF-?\d+/[\w.-]+")
_OBJECT_ARGUMENTS = ("object", "target")


class Anonymizer:
    """The numbers of one snapshot.

    Parameters
    ----------
    visible : sequence of VisibleObject
        In the order of their numbers.
    landmarks : sequence of LandmarkInfo
    held : str, optional
        Id of what the hand holds.

    Examples
    --------
    >>> anonymizer = Anonymizer([VisibleObject(id="F1/den/mug_1", category="mug", distance=1.0, bearing=0.0)], [])
    >>> anonymizer.text("F1/den/mug_1 is on F1/den/desk_2")
    '#1 is on an object'
    """

    def __init__(
        self, visible: Sequence[VisibleObject], landmarks: Sequence[LandmarkInfo], held: str | None = None
    ) -> None:
        self._objects = {item.id: f"#{k}" for k, item in enumerate(visible, start=1)}
        if held is not None:
            self._objects[held] = HELD
        self._places = {entry.name: f"L{k}" for k, entry in enumerate(landmarks, start=1)}
        self._ids = {ref: name for name, ref in self._objects.items()}
        self._names = {ref.casefold(): name for name, ref in self._places.items()}

    def seen(self, item: SeenObject, *, category: bool) -> SeenObject:
        """Return an object in view without what its picture does not show."""
        return SeenObject(
            ref=self._objects[item.ref],
            category=item.category if category else "",
            distance=item.distance,
            bearing=item.bearing,
            within_reach=item.within_reach,
        )

    def landmark(self, entry: LandmarkInfo) -> LandmarkInfo:
        """Return a landmark by its number; the kind of a core is painted on its door."""
        return msgspec.structs.replace(entry, name=self._places[entry.name])

    def place(self, room: str | None) -> str:
        """Return the number of a room, empty for one that is not a landmark."""
        return self._places.get(room or "", "")

    def object(self, name: str) -> str:
        """Return an object's number, ``an object`` for one that has none."""
        return self._objects.get(name, "an object")

    def call(self, call: SkillCall) -> SkillCall | str:
        """Return a call with ids for numbers, or what is wrong: an agent that sees numbers may use no ids."""
        arguments: dict[str, Any] = dict(call.arguments)
        for key in _OBJECT_ARGUMENTS:
            value = arguments.get(key)
            if value is None or value == "floor":
                continue
            name = self._ids.get(value) if isinstance(value, str) else None
            if name is None:
                return f"nothing in view is marked {str(value)[:40]!r}"
            arguments[key] = name
        landmark = arguments.get("landmark")
        if landmark is not None:
            wanted = landmark.casefold() if isinstance(landmark, str) else ""
            if wanted not in CORE_WORDS:
                if wanted not in self._names:
                    return f"no landmark has the number {str(landmark)[:40]!r}"
                arguments["landmark"] = self._names[wanted]
        return SkillCall(skill=call.skill, arguments=arguments)

    def text(self, text: str) -> str:
        """Return a text with numbers for ids."""
        text = _OBJECT.sub(lambda found: self.object(found.group()), text)
        return _PLACE.sub(lambda found: self.place(found.group()) or "a place", text)

    def result(self, result: SkillResult) -> SkillResult:
        """Return a skill's answer as its agent may read it: the free space stays, ids and facts go."""
        free = result.data.get("free")
        return SkillResult(
            skill=result.skill,
            status=result.status,
            message=self.text(result.message),
            satisfied_by=self.text(result.satisfied_by),
            data={} if free is None else {"free": free},
        )


@dataclass(frozen=True)
class Snapshot:
    """All there is to know before a step, of which the agent gets its part."""

    world: World
    robot: RobotBody
    visible: VisibleObjects
    landmarks: Landmarks
    anonymizer: Anonymizer


class Observer:
    """Asks the robot and tells the agent.

    Parameters
    ----------
    port : SkillPort
    task : Task
    access : Access
        What the agent may know.
    """

    def __init__(self, port: SkillPort, task: Task, access: Access) -> None:
        self._port, self._task, self._access = port, task, access

    def snapshot(self) -> Snapshot:
        """Return the present."""
        visible, landmarks = self._port.visible(), self._port.landmarks()
        world, robot = self._port.world()
        held = world.objects.held_by(robot.session)
        anonymizer = Anonymizer(visible.objects, landmarks.landmarks, held)
        return Snapshot(world, robot, visible, landmarks, anonymizer)

    def observation(
        self,
        snapshot: Snapshot,
        step: int,
        last_call: SkillCall | None,
        last: SkillResult | None,
        pictures: Pictures | None,
    ) -> Observation:
        """Return what the agent perceives; its last call is told in its own words."""
        world, robot, anonymizer, access = snapshot.world, snapshot.robot, snapshot.anonymizer, self._access
        state = world.robot_state(robot)
        seen = [seen_object(world, item) for item in snapshot.visible.objects]
        held = state.held or ""
        landmarks = snapshot.landmarks.landmarks
        if not access.names:
            seen = [anonymizer.seen(item, category=access.categories) for item in seen]
            landmarks = [anonymizer.landmark(entry) for entry in landmarks]
            last = None if last is None else anonymizer.result(last)
        return Observation(
            instruction=self._task.instruction,
            step=step,
            max_steps=self._task.max_steps,
            floor=state.floor,
            floors=tuple(world.building.floors),
            pose=state.pose,
            pitch=state.pitch,
            room=(state.room or "") if access.names else anonymizer.place(state.room),
            held=held if access.names or not held else HELD,
            landmarks=tuple(landmarks),
            visible=tuple(seen),
            last_call=last_call,
            last=last,
            pictures=pictures,
            object_map=(lambda: object_map(world)) if access.object_map else list,
        )

    def call(self, snapshot: Snapshot, call: SkillCall) -> SkillCall | str:
        """Return the agent's call with the ids of this snapshot, or what is wrong with it."""
        return call if self._access.names else snapshot.anonymizer.call(call)


def seen_object(world: World, item: VisibleObject) -> SeenObject:
    """Return an object in view with the colour that a camera sees."""
    is_open = item.states.get("open")
    return SeenObject(
        ref=item.id,
        category=item.category,
        distance=item.distance,
        bearing=item.bearing,
        color=colour_of(world.objects.kinds[item.id].material),
        room=item.room or "",
        parent=item.parent or "",
        within_reach=item.within_reach,
        pickupable=item.pickupable,
        receptacle=item.receptacle,
        openable=item.openable,
        is_open=is_open if isinstance(is_open, bool) else None,
    )


def object_map(world: World) -> list[MapEntry]:
    """Return where every object of the building is now, in the order of the scenes."""
    found = []
    for name in world.objects:
        state, kind = world.objects.state(name), world.objects.kinds[name]
        found.append(
            MapEntry(name, kind.category, colour_of(kind.material), state.floor, state.room or "", state.parent or "")
        )
    return found

"""Names that an agent must not read, behind numbers: objects as ``#1``, landmarks as ``L1``."""

import re
from collections.abc import Sequence
from typing import Any

import msgspec

from mansion_msgs_py.skills import LandmarkInfo, VisibleObject
from mansion_msgs_py.task import SkillCall
from mansion_msgs_py.world import SkillResult
from mansion_tasks.agents.interface import SeenObject

__all__ = ["HELD", "Mask"]

HELD = "#0"
"""What the hand holds."""

_OBJECT = re.compile(r"\bF-?\d+/[\w.-]+(?:/[\w.-]+)+")
_PLACE = re.compile(r"\bF-?\d+/[\w.-]+")
_OBJECT_ARGUMENTS = ("object", "target")


class Mask:
    """The numbers of one moment.

    Parameters
    ----------
    visible : sequence of VisibleObject
        In the order of their numbers.
    landmarks : sequence of LandmarkInfo
    held : str, optional
        Id of what the hand holds.

    Examples
    --------
    >>> mask = Mask([VisibleObject(id="F1/den/mug_1", category="mug", distance=1.0, bearing=0.0)], [])
    >>> mask.text("F1/den/mug_1 is on F1/den/desk_2")
    '#1 is on an object'
    """

    def __init__(
        self, visible: Sequence[VisibleObject], landmarks: Sequence[LandmarkInfo], held: str | None = None
    ) -> None:
        self._objects = {thing.id: f"#{k}" for k, thing in enumerate(visible, start=1)}
        if held is not None:
            self._objects[held] = HELD
        self._places = {entry.name: f"L{k}" for k, entry in enumerate(landmarks, start=1)}
        self._ids = {ref: name for name, ref in self._objects.items()}
        self._names = {ref.casefold(): name for name, ref in self._places.items()}

    def seen(self, thing: SeenObject, *, category: bool) -> SeenObject:
        """Return an object in view without what its picture does not show."""
        return SeenObject(
            ref=self._objects[thing.ref],
            category=thing.category if category else "",
            distance=thing.distance,
            bearing=thing.bearing,
            within_reach=thing.within_reach,
        )

    def landmark(self, entry: LandmarkInfo) -> LandmarkInfo:
        """Return a landmark by its number; the kind of a core is painted on its door."""
        return msgspec.structs.replace(entry, name=self._places[entry.name])

    def place(self, room: str | None) -> str:
        """Return the number of a room, empty for one that is no landmark."""
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
            if wanted not in ("elevator", "lift", "stairs", "stair"):
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

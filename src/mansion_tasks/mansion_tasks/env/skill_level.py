"""The skill-level action set: a skill, and the indices of its landmark, object and floor."""

from collections.abc import Sequence
from typing import Any, Final

from mansion_msgs_py.task import SkillCall
from mansion_skills.world.landmarks import Landmark

__all__ = ["SKILL_ACTIONS", "skill_call"]

_ALL: Final[tuple[tuple[str, str, dict[str, Any]], ...]] = (
    ("GoToLandmark", "landmark", {}),
    ("GoNearObject", "object", {}),
    ("PickUp", "object", {}),
    ("Place", "target", {"relation": "on"}),
    ("Place", "target", {"relation": "in"}),
    ("Place", "", {"target": "floor", "relation": "on"}),
    ("OpenObject", "object", {}),
    ("CloseObject", "object", {}),
    ("ToggleOn", "object", {}),
    ("ToggleOff", "object", {}),
    ("OpenDoor", "", {}),
    ("CloseDoor", "", {}),
    ("CallElevator", "", {}),
    ("UseElevator", "target_floor", {}),
    ("TakeStairs", "", {"direction": "Up"}),
    ("TakeStairs", "", {"direction": "Down"}),
    ("MoveAhead", "", {"distance": 0.5}),
    ("Rotate", "", {"degrees": 90.0}),
    ("Rotate", "", {"degrees": -90.0}),
    ("LookUp", "", {"degrees": 30.0}),
    ("LookDown", "", {"degrees": 30.0}),
)

SKILL_ACTIONS: Final = tuple(" ".join((skill, *(str(value) for value in fixed.values()))) for skill, _, fixed in _ALL)
"""What each value of the action's first part does."""


def skill_call(
    action: Sequence[int], landmarks: Sequence[Landmark], objects: Sequence[str], floors: Sequence[int]
) -> SkillCall | None:
    """Return the call that an action means, or ``None`` when its index names nothing.

    Parameters
    ----------
    action : sequence of int
        Skill, landmark, object, floor; a skill reads only the part that it takes.
    landmarks : sequence of Landmark
        Of the robot's floor.
    objects : sequence of str
        Ids of the objects in view, the nearest first.
    floors : sequence of int
        Of the building.
    """
    which, landmark, thing, floor = (int(part) for part in action)
    skill, key, fixed = _ALL[which]
    if key == "landmark":
        if landmark >= len(landmarks):
            return None
        return SkillCall(skill=skill, arguments={key: landmarks[landmark].name})
    if key in ("object", "target"):
        if thing >= len(objects):
            return None
        return SkillCall(skill=skill, arguments={**fixed, key: objects[thing]})
    if key == "target_floor":
        return SkillCall(skill=skill, arguments={key: floors[floor]})
    return SkillCall(skill=skill, arguments=fixed)

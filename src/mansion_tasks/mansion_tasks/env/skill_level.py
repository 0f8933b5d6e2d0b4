"""The skill-level action set: a skill, and the indices of its landmark, object and floor."""

from collections.abc import Sequence
from typing import Any, Final

from mansion_msgs_py.task import SkillCall
from mansion_skills.skills.registry import SKILLS, in_order
from mansion_skills.world.floor_view import Landmark

__all__ = ["SKILL_ACTIONS", "skill_call"]

_ORDER: Final = (
    "GoToLandmark",
    "GoNearObject",
    "PickUp",
    "Place",
    "OpenObject",
    "CloseObject",
    "ToggleOn",
    "ToggleOff",
    "OpenDoor",
    "CloseDoor",
    "CallElevator",
    "UseElevator",
    "TakeStairs",
    "MoveAhead",
    "Rotate",
    "LookUp",
    "LookDown",
)
"""Trained policies know the actions by their place in this order."""

_ALL: Final = tuple(
    (skill.name, action, skill.parameters[action.indexed].kind if action.indexed else "")
    for skill in in_order(SKILLS.values(), _ORDER)
    for action in skill.actions
)
"""Skill, action, and what the index of its argument counts: a ``landmark``, an ``object``, a ``floor`` or nothing."""

SKILL_ACTIONS: Final = tuple(" ".join((skill, *map(str, action.fixed.values()))) for skill, action, _ in _ALL)
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
        Landmarks of the robot's floor.
    objects : sequence of str
        Ids of the objects in view, the nearest first.
    floors : sequence of int
        Floors of the building.
    """
    which, landmark, thing, floor = (int(part) for part in action)
    skill, chosen, kind = _ALL[which]
    if not kind:
        return SkillCall(skill=skill, arguments=dict(chosen.fixed))
    names: Sequence[Any]
    if kind == "landmark":
        index, names = landmark, [mark.name for mark in landmarks]
    else:
        index, names = (thing, objects) if kind == "object" else (floor, floors)
    if index >= len(names):
        return None
    return SkillCall(skill=skill, arguments={**chosen.fixed, chosen.indexed: names[index]})

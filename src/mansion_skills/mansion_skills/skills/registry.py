"""All skills by name: what they take, and whether they change the world."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from mansion_msgs_py import skills as payloads
from mansion_skills.skills import asking, between_floors, doors, handling, moving, near, placing

__all__ = ["SKILLS", "Skill", "skill_named"]


@dataclass(frozen=True)
class Skill:
    """A skill.

    Attributes
    ----------
    name : str
        As the skill cards write it, ``CallElevator``.
    call : callable
        ``(world, robot, arguments, realtime)`` to a running skill, or, of a question, ``(world, robot, arguments)``
        to its answer.
    """

    name: str
    arguments: type[Any]
    call: Callable[..., Any]
    question: bool = False

    @property
    def service(self) -> str:
        """The name in snake case, ``call_elevator``."""
        return "".join(f"_{c.lower()}" if c.isupper() else c for c in self.name).lstrip("_")


_ALL = (
    Skill("CallElevator", payloads.SessionArgs, between_floors.call_elevator),
    Skill("UseElevator", payloads.UseElevatorArgs, between_floors.use_elevator),
    Skill("TakeStairs", payloads.TakeStairsArgs, between_floors.take_stairs),
    Skill("GoToLandmark", payloads.GoToLandmarkArgs, moving.go_to_landmark),
    Skill("MoveTo", payloads.MoveToArgs, moving.move_to),
    Skill("GoNearObject", payloads.NearObjectArgs, near.go_near_object),
    Skill("MoveAhead", payloads.MoveAheadArgs, moving.move_ahead),
    Skill("Rotate", payloads.RotateArgs, moving.rotate),
    Skill("LookUp", payloads.LookArgs, moving.look_up),
    Skill("LookDown", payloads.LookArgs, moving.look_down),
    Skill("OpenDoor", payloads.DoorArgs, doors.open_door),
    Skill("CloseDoor", payloads.DoorArgs, doors.close_door),
    Skill("OpenObject", payloads.ObjectArgs, handling.open_object),
    Skill("CloseObject", payloads.ObjectArgs, handling.close_object),
    Skill("PickUp", payloads.ObjectArgs, handling.pick_up),
    Skill("Place", payloads.PlaceArgs, placing.place),
    Skill("ToggleOn", payloads.ObjectArgs, handling.toggle_on),
    Skill("ToggleOff", payloads.ObjectArgs, handling.toggle_off),
    Skill("WhereAmI", payloads.SessionArgs, asking.where_am_i, question=True),
    Skill("ListLandmarks", payloads.SessionArgs, asking.list_landmarks, question=True),
    Skill("ListVisible", payloads.VisibleArgs, asking.list_visible, question=True),
    Skill("PlanRoute", payloads.RouteArgs, asking.plan_route, question=True),
)

SKILLS: dict[str, Skill] = {skill.service: skill for skill in _ALL}
"""Service name below ``skills/`` to skill."""

_BY_NAME = {skill.name.casefold(): skill for skill in _ALL} | SKILLS


def skill_named(name: str) -> Skill | None:
    """Return the skill of that name, ``CallElevator`` or ``call_elevator``, or ``None``."""
    return _BY_NAME.get(name) or _BY_NAME.get(name.casefold())

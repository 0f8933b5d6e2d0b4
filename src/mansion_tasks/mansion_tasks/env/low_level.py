"""The low-level action set: small motions at once, and what the hand does to what is in the middle of the picture."""

from collections.abc import Callable
from dataclasses import dataclass
from math import cos, radians, sin
from typing import Any, Final

from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.task import SkillCall
from mansion_msgs_py.world import ObjectState, Pose2D, SkillStatus
from mansion_skills.navigation.paths import free_run
from mansion_skills.skills.driving import SPEED, TURN_SPEED
from mansion_skills.skills.motion_primitives import PITCHES
from mansion_skills.skills.visibility import REACH
from mansion_tasks.env.visibility import View
from mansion_tasks.tasks.sandbox import Sandbox

__all__ = ["MOVE", "TILT", "TURN", "Outcome", "act", "low_level_actions"]

MOVE: Final = 0.25
"""Metres of a move."""

TURN: Final = 30.0
TILT: Final = 30.0
"""Degrees."""

_LOOK_TIME = 90.0
_MOTIONS: Final = ("move_ahead", "move_back", "rotate_left", "rotate_right", "look_up", "look_down")
_DEEDS: Final = (
    "pick_up",
    "place",
    "place_in",
    "put_down",
    "open",
    "close",
    "toggle",
    "open_door",
    "close_door",
    "call_lift",
    "stairs_up",
    "stairs_down",
)


@dataclass(frozen=True)
class Outcome:
    """What an action did.

    Attributes
    ----------
    status : SkillStatus
    message : str
    changed : bool
        Whether an object or a door is not as before.
    """

    status: SkillStatus
    message: str
    changed: bool = False


def low_level_actions(floors: list[int]) -> list[str]:
    """Return the names of the actions in a building with these floors: one ride for each floor comes last."""
    return [*_MOTIONS, *_DEEDS, *(f"ride_to_{floor}" for floor in floors)]


def act(sandbox: Sandbox, name: str, view: View) -> Outcome:
    """Do a low-level action.

    Parameters
    ----------
    name : str
        One of `low_level_actions`.
    view : View
        What the camera sees now.
    """
    if name in _MOTIONS:
        return _MOVES[name](sandbox)
    call = _call(sandbox, name, view)
    if call is None:
        return Outcome(SkillStatus.PRECONDITION_FAILURE, f"nothing in reach to {name}")
    result = sandbox.run(call)
    return Outcome(result.status, result.message, result.status is SkillStatus.SUCCESS)


def _glide(sandbox: Sandbox, distance: float) -> Outcome:
    """Go straight, as MoveAhead does; stay where something is in the way."""
    world, robot = sandbox.world, sandbox.robot
    blocked = world.blocked_for(robot.session, robot.floor)
    frame = world.view(robot.floor).map.frame
    heading = robot.pose.yaw if distance > 0 else robot.pose.yaw + 180.0
    if free_run(blocked, frame, robot.place, radians(heading), abs(distance)) < abs(distance) - 1e-9:
        return Outcome(SkillStatus.EXECUTION_FAILURE, "something is in the way")
    angle = radians(robot.pose.yaw)
    x, y = robot.pose.x + distance * cos(angle), robot.pose.y + distance * sin(angle)
    robot.move(Pose2D(x=x, y=y, yaw=robot.pose.yaw))
    world.advance(abs(distance) / SPEED)
    return Outcome(SkillStatus.SUCCESS, "moved")


def _turn(sandbox: Sandbox, degrees: float) -> Outcome:
    pose = sandbox.robot.pose
    yaw = round((pose.yaw + degrees) % 360.0, 6)
    sandbox.robot.move(Pose2D(x=pose.x, y=pose.y, yaw=yaw))
    sandbox.world.advance(abs(degrees) / TURN_SPEED)
    return Outcome(SkillStatus.SUCCESS, "turned")


def _tilt(sandbox: Sandbox, degrees: float) -> Outcome:
    pitch = sandbox.robot.pitch + degrees
    if not PITCHES[0] - 1e-9 <= pitch <= PITCHES[1] + 1e-9:
        return Outcome(SkillStatus.PRECONDITION_FAILURE, "the camera tilts no further")
    sandbox.robot.pitch = pitch
    sandbox.world.advance(abs(degrees) / _LOOK_TIME)
    return Outcome(SkillStatus.SUCCESS, "tilted")


_MOVES: Final[dict[str, Callable[[Sandbox], Outcome]]] = {
    "move_ahead": lambda sandbox: _glide(sandbox, MOVE),
    "move_back": lambda sandbox: _glide(sandbox, -MOVE),
    "rotate_left": lambda sandbox: _turn(sandbox, TURN),
    "rotate_right": lambda sandbox: _turn(sandbox, -TURN),
    "look_up": lambda sandbox: _tilt(sandbox, TILT),
    "look_down": lambda sandbox: _tilt(sandbox, -TILT),
}

_WANTED: Final[dict[str, Callable[[SceneObject, ObjectState], bool]]] = {
    "pick_up": lambda kind, state: kind.pickupable,
    "place": lambda kind, state: kind.receptacle,
    "place_in": lambda kind, state: kind.receptacle and state.states.get("open") is not False,
    "open": lambda kind, state: kind.openable and state.states.get("open") is not True,
    "close": lambda kind, state: kind.openable and state.states.get("open") is True,
    "toggle": lambda kind, state: kind.toggleable,
}


def _aimed_at(sandbox: Sandbox, name: str, view: View) -> ObjectState | None:
    """Return the thing within reach that fits an action and is nearest to the middle of the picture."""
    objects = sandbox.world.objects
    best: tuple[float, float, str] | None = None
    for thing, away, bearing in zip(view.ids, view.distances, view.bearings):
        if away > REACH:
            break
        if _WANTED[name](objects.kinds[thing], objects.state(thing)):
            key = (round(abs(float(bearing)), 3), round(float(away), 3), thing)
            best = key if best is None else min(best, key)
    return None if best is None else objects.state(best[2])


def _call(sandbox: Sandbox, name: str, view: View) -> SkillCall | None:
    """Return the skill that does an action now, or ``None`` when there is nothing to do it to."""
    skill, arguments = _SKILLS.get(name, ("", {}))
    if name.startswith("ride_to_"):
        floor = int(name.removeprefix("ride_to_"))
        return SkillCall(skill="UseElevator", arguments={"target_floor": floor})
    if name not in _WANTED:
        return SkillCall(skill=skill, arguments=arguments)
    holding = sandbox.world.objects.held_by(sandbox.robot.session) is not None
    if holding != (name in ("place", "place_in")) and name in ("pick_up", "place", "place_in"):
        return None
    aim = _aimed_at(sandbox, name, view)
    if aim is None:
        return None
    if name == "toggle":
        skill = "ToggleOff" if aim.states.get("on") is True else "ToggleOn"
    key = "target" if skill == "Place" else "object"
    return SkillCall(skill=skill, arguments={**arguments, key: aim.id})


_SKILLS: Final[dict[str, tuple[str, dict[str, Any]]]] = {
    "pick_up": ("PickUp", {}),
    "place": ("Place", {"relation": "on"}),
    "place_in": ("Place", {"relation": "in"}),
    "put_down": ("Place", {"target": "floor", "relation": "on"}),
    "open": ("OpenObject", {}),
    "close": ("CloseObject", {}),
    "open_door": ("OpenDoor", {}),
    "close_door": ("CloseDoor", {}),
    "call_lift": ("CallElevator", {}),
    "stairs_up": ("TakeStairs", {"direction": "Up"}),
    "stairs_down": ("TakeStairs", {"direction": "Down"}),
}

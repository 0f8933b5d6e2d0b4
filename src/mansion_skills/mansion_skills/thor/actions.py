"""The actions of AI2-THOR that carry out a finished skill."""

from itertools import pairwise
from math import atan2, degrees, dist
from typing import Any

from mansion_geometry.thor.house_format import AGENT_HEIGHT, thor_heading, thor_point, upright
from mansion_msgs_py.skills import SessionArgs
from mansion_msgs_py.world import Pose2D, SkillResult
from mansion_skills.skills.manipulation import PlaceArgs
from mansion_skills.skills.motion_primitives import MoveAheadArgs
from mansion_skills.skills.results import number
from mansion_skills.world.robot_body import RobotBody, turn_between
from mansion_skills.world.world import World

__all__ = ["HORIZONS", "Action", "actions_for", "teleport", "way_to"]

Action = dict[str, Any]

HORIZONS = (-30.0, 60.0)
"""How far AI2-THOR's camera tilts, degrees, down is positive."""

_HANDS = {
    "PickUp": "PickupObject",
    "OpenObject": "OpenObject",
    "CloseObject": "CloseObject",
    "ToggleOn": "ToggleObjectOn",
    "ToggleOff": "ToggleObjectOff",
    "OpenDoor": "OpenObject",
    "CloseDoor": "CloseObject",
}


def teleport(pose: Pose2D, pitch: float, **more: Any) -> Action:
    """Return the action that puts the agent at a pose; its camera tilts as far as it can."""
    return {
        "action": "Teleport",
        "position": thor_point(pose.x, pose.y, AGENT_HEIGHT),
        "rotation": upright(thor_heading(pose.yaw)),
        "horizon": min(max(-pitch, HORIZONS[0]), HORIZONS[1]),
        "standing": True,
        **more,
    }


def way_to(robot: RobotBody, start: Pose2D) -> list[Action]:
    """Return the actions along a robot's last path, corner by corner: what only AI2-THOR knows of stops it there."""
    points = [(start.x, start.y), *robot.path]
    corners = [
        Pose2D(x=x, y=y, yaw=degrees(atan2(y - before[1], x - before[0])) % 360.0)
        for before, (x, y) in pairwise(points)
        if dist(before, (x, y)) > 1e-6
    ]
    if corners and dist((corners[-1].x, corners[-1].y), robot.place) < 1e-6:
        corners.pop()
    return [*(teleport(corner, 0.0) for corner in corners), teleport(robot.pose, robot.pitch)]


def actions_for(
    world: World,
    robot: RobotBody,
    before: Pose2D,
    pitch: float,
    arguments: SessionArgs,
    result: SkillResult,
    *,
    force: bool,
) -> list[Action]:
    """Return the actions of a skill that has been done in the world, none for one that leaves the floor alone.

    Parameters
    ----------
    before, pitch : Pose2D, float
        Pose and pitch of the robot before the skill.
    arguments, result : payloads
    force : bool
        Whether hands reach whatever the agent's own visibility says.
    """
    name = result.skill
    if name in _HANDS:
        target = result.data["door" if name.endswith("Door") else "object"]
        return [{"action": _HANDS[name], "objectId": target, "forceAction": force}]
    if name == "Place":
        assert isinstance(arguments, PlaceArgs)
        return [_put(world, str(result.data["object"]), force=force)]
    if name == "MoveAhead":
        assert isinstance(arguments, MoveAheadArgs)
        distance = number(arguments.distance) or 0.0
        way = "MoveAhead" if distance >= 0 else "MoveBack"
        return [{"action": way, "moveMagnitude": abs(distance)}]
    if name == "Rotate":
        turn = turn_between(before.yaw, robot.pose.yaw)
        way = "RotateLeft" if turn >= 0 else "RotateRight"
        return [{"action": way, "degrees": round(abs(turn), 6)}]
    if name in ("LookUp", "LookDown"):
        return [{"action": name, "degrees": round(abs(robot.pitch - pitch), 6)}]
    return way_to(robot, before) if (robot.pose, robot.pitch) != (before, pitch) else []


def _put(world: World, held: str, *, force: bool) -> Action:
    """Return the action that puts down what the hand holds, onto or into something or at a place of the floor."""
    state = world.objects.state(held)
    assert state.position is not None
    if state.parent is not None:
        return {"action": "PutObject", "objectId": state.parent, "forceAction": force, "placeStationary": True}
    low = state.position[2] - world.objects.kinds[held].size[2] / 2
    return {
        "action": "PlaceObjectAtPoint",
        "objectId": held,
        "position": thor_point(state.position[0], state.position[1], low),
    }

"""MoveAhead, Rotate, LookUp and LookDown: single motions of the base and the camera."""

from math import copysign, cos, radians, sin
from typing import Annotated, Any

from mansion_msgs_py.skills import SessionArgs
from mansion_msgs_py.world import SkillChange, SkillResult, SkillStatus
from mansion_skills.skills.declaration import Action, Argument, Card, skill
from mansion_skills.skills.driving import LONGEST_MOVE, drive, free_around, in_the_way, turn_by, way_out
from mansion_skills.skills.results import Run, Step, done, invalid, number, refused
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["LookArgs", "MoveAheadArgs", "PITCHES", "RotateArgs", "look_down", "look_up", "move_ahead", "rotate"]

PITCHES = (-60.0, 60.0)
"""How far the camera tilts down and up, degrees."""


class MoveAheadArgs(SessionArgs, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Metres straight ahead; negative ones go backwards."""

    distance: Annotated[Any, Argument("number", "metres; negative goes back")] = 0.25


class RotateArgs(SessionArgs, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Degrees to turn on the spot, counter-clockwise."""

    degrees: Annotated[Any, Argument("number", "degrees, counter-clockwise")] = 90.0


class LookArgs(SessionArgs, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Degrees to tilt the camera."""

    degrees: Annotated[Any, Argument("number", "degrees")] = 30.0


@skill(
    "MoveAhead",
    "Go straight ahead, or back.",
    arguments=MoveAheadArgs,
    example='{"distance": 0.5}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.EXECUTION_FAILURE),
    card=Card("go straight ahead, metres; negative goes back", ("distance",)),
    actions=(Action(fixed={"distance": 0.5}),),
)
def move_ahead(world: World, robot: RobotBody, arguments: MoveAheadArgs, *, realtime: bool) -> Run:
    """Go straight ahead, or backwards; the robot stays where it is when something is in the way."""
    name = "MoveAhead"
    distance = number(arguments.distance, LONGEST_MOVE)
    if distance is None:
        text = f"distance {arguments.distance!r} is not a number of metres"
        wish = f"-{LONGEST_MOVE:g} to {LONGEST_MOVE:g}"
        return invalid(world, robot, name, text, wish)
    free = free_around(world, robot)
    if free["ahead" if distance >= 0 else "back"] < abs(distance) - 1e-9:
        return _blocked(world, robot, distance, free)
    before = robot.pose
    angle = radians(robot.pose.yaw)
    end = (before.x + distance * cos(angle), before.y + distance * sin(angle))
    back = distance < 0
    yield from drive(world, robot, [robot.place, end], before.yaw, realtime=realtime, backwards=back)
    return done(
        world,
        robot,
        name,
        f"moved {distance:g} m",
        SkillChange(what="pose", before=before, after=robot.pose),
        free=free_around(world, robot),
    )


def _blocked(world: World, robot: RobotBody, distance: float, free: dict[str, float]) -> SkillResult:
    """Return MoveAhead's failure: what is in the way, and how to get out of there."""
    way, angle = ("ahead", 0.0) if distance >= 0 else ("back", 180.0)
    obstacle = in_the_way(world, robot, angle, free[way])
    out = way_out(world, robot)
    text = f"only {free[way]:.2f} m of {abs(distance):.2f} m are free: {obstacle} is in the way"
    wish = f"Rotate {out.degrees:g} and MoveAhead {out.meters:g}, or GoToLandmark {out.to}".rstrip()
    if free[way] > 0.0:
        wish = f"MoveAhead {copysign(free[way], distance):g}, or {wish}"
    return refused(
        world,
        robot,
        "MoveAhead",
        SkillStatus.EXECUTION_FAILURE,
        text,
        wish,
        free=free,
        blocked_by=obstacle,
        way_out={"degrees": out.degrees, "meters": out.meters, "to": out.to},
    )


@skill(
    "Rotate",
    "Turn on the spot, counter-clockwise.",
    arguments=RotateArgs,
    example='{"degrees": 90}',
    failures=(SkillStatus.INVALID_ACTION,),
    card=Card("turn on the spot, degrees, counter-clockwise; to look around", ("degrees",)),
    actions=(Action(fixed={"degrees": 90.0}), Action(fixed={"degrees": -90.0})),
)
def rotate(world: World, robot: RobotBody, arguments: RotateArgs, *, realtime: bool) -> Run:
    """Turn on the spot."""
    name = "Rotate"
    angle = number(arguments.degrees, 3600.0)
    if angle is None:
        text = f"degrees {arguments.degrees!r} is not a number of degrees"
        return invalid(world, robot, name, text, "-3600 to 3600")
    before = robot.pose
    yield from turn_by(world, robot, angle, realtime=realtime)
    return done(
        world,
        robot,
        name,
        f"faces {robot.pose.yaw:g} degrees",
        SkillChange(what="yaw", before=before.yaw, after=robot.pose.yaw),
    )


@skill(
    "LookUp",
    "Tilt the camera up.",
    arguments=LookArgs,
    example='{"degrees": 30}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PRECONDITION_FAILURE),
    card=Card("tilt the camera up, degrees", ("degrees",)),
    actions=(Action(fixed={"degrees": 30.0}),),
)
def look_up(world: World, robot: RobotBody, arguments: LookArgs, *, realtime: bool) -> Run:
    """Tilt the camera up."""
    return (yield from _look(world, robot, "LookUp", arguments, 1.0))


@skill(
    "LookDown",
    "Tilt the camera down.",
    arguments=LookArgs,
    example='{"degrees": 30}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PRECONDITION_FAILURE),
    card=Card("tilt the camera down, degrees", ("degrees",)),
    actions=(Action(fixed={"degrees": 30.0}),),
)
def look_down(world: World, robot: RobotBody, arguments: LookArgs, *, realtime: bool) -> Run:
    """Tilt the camera down."""
    return (yield from _look(world, robot, "LookDown", arguments, -1.0))


def _look(world: World, robot: RobotBody, name: str, arguments: LookArgs, sign: float) -> Run:
    low, high = PITCHES
    angle = number(arguments.degrees, 180.0)
    if angle is None or angle < 0:
        text = f"degrees {arguments.degrees!r} is not a tilt angle"
        return invalid(world, robot, name, text, "0 to 120")
    before = robot.pitch
    after = before + sign * angle
    if not low - 1e-9 <= after <= high + 1e-9:
        text = f"the camera is at {before:g} degrees and tilts from {low:g} to {high:g}"
        limit = (high if sign > 0 else low) - before
        status = SkillStatus.PRECONDITION_FAILURE
        return refused(world, robot, name, status, text, f"at most {abs(limit):g} degrees")
    yield Step(angle / 90.0, 1.0, "tilting")
    robot.pitch = after
    return done(
        world, robot, name, f"the camera is at {after:g} degrees", SkillChange(what="pitch", before=before, after=after)
    )

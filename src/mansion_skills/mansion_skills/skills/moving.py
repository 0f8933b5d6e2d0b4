"""GoToLandmark, MoveTo, MoveAhead, Rotate, LookUp and LookDown."""

from math import copysign, cos, radians, sin

from mansion_msgs_py.shapes import Point
from mansion_msgs_py.skills import GoToLandmarkArgs, LookArgs, MoveAheadArgs, MoveToArgs, RotateArgs
from mansion_msgs_py.wording import choices
from mansion_msgs_py.world import SkillChange, SkillResult, SkillStatus
from mansion_skills.skills.motion import blocking_door, drive, path_to, turn
from mansion_skills.skills.outcome import Run, Step, done, invalid, number, refused
from mansion_skills.skills.room_to_move import LONGEST_MOVE, free_around, in_the_way, way_out
from mansion_skills.world.landmarks import landmark_named
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["PITCHES", "go_along", "go_to_landmark", "look_down", "look_up", "move_ahead", "move_to", "rotate"]

LANDMARK_SNAP = 1.5
"""How far beside a landmark's pose the robot may end where something stands in it, metres."""

POINT_SNAP = 0.1
"""The same for MoveTo, metres."""

PITCHES = (-60.0, 60.0)
"""How far the camera tilts down and up, degrees."""


def go_to_landmark(world: World, robot: RobotBody, arguments: GoToLandmarkArgs, realtime: bool) -> Run:
    """Go to a room or a core of the current floor."""
    name = "GoToLandmark"
    view = world.view(robot.floor)
    wanted = arguments.landmark if isinstance(arguments.landmark, str) else ""
    landmark = landmark_named(wanted, view.landmarks, robot.floor, robot.place)
    if landmark is None:
        known = [entry.name for entry in view.landmarks]
        near = choices(arguments.landmark, known, "landmarks")
        text = f"floor {robot.floor} has no landmark {str(arguments.landmark)[:80]!r}; {near}"
        return invalid(world, robot, name, text, "a landmark that ListLandmarks names")
    goal = (landmark.pose.x, landmark.pose.y)
    return (yield from go_along(world, robot, name, goal, landmark.pose.yaw, LANDMARK_SNAP, realtime, landmark.name))


def move_to(world: World, robot: RobotBody, arguments: MoveToArgs, realtime: bool) -> Run:
    """Go to a point of the current floor."""
    name = "MoveTo"
    x, y = number(arguments.x), number(arguments.y)
    yaw = None if arguments.yaw is None else number(arguments.yaw)
    if x is None or y is None or (yaw is None and arguments.yaw is not None):
        return invalid(world, robot, name, "x, y and yaw are to be finite numbers", "metres, degrees")
    if world.view(robot.floor).map.room_at(x, y) is None:
        text = f"({x:g}, {y:g}) is in no room of floor {robot.floor}"
        return invalid(world, robot, name, text, "a point inside a room")
    where = f"({x:g}, {y:g})"
    return (yield from go_along(world, robot, name, (x, y), yaw, POINT_SNAP, realtime, where))


def go_along(
    world: World, robot: RobotBody, name: str, goal: Point, yaw: float | None, snap: float, realtime: bool, where: str
) -> Run:
    """Plan to a point and drive there, looking ahead: what all skills that go somewhere have in common."""
    before = robot.pose
    path = path_to(world, robot, goal, snap)
    if path is None:
        return no_way(world, robot, name, goal, snap, where)
    begin = world.time
    robot.pitch = 0.0
    meters = yield from drive(world, robot, path, yaw, realtime)
    if robot.place != path[-1]:
        text = f"another robot stands in the way to {where}"
        return refused(world, robot, name, SkillStatus.EXECUTION_FAILURE, text, "try again")
    return done(
        world,
        robot,
        name,
        f"at {where}",
        SkillChange(what="pose", before=before, after=robot.pose),
        at=where,
        meters=round(meters, 3),
        seconds=round(world.time - begin, 3),
    )


def no_way(world: World, robot: RobotBody, name: str, goal: Point, snap: float, where: str) -> SkillResult:
    """Return a planning failure that says what would help."""
    door = blocking_door(world, robot, goal, snap)
    if door is not None:
        text = f"the way to {where} is blocked by the closed door {door}"
        wish = f"GoNearObject {door} and OpenDoor {door}"
    else:
        text = f"no way leads to {where}: something stands there or on the way"
        wish = "another place, or moving what stands in the way"
    return refused(world, robot, name, SkillStatus.PLANNING_FAILURE, text, wish)


def move_ahead(world: World, robot: RobotBody, arguments: MoveAheadArgs, realtime: bool) -> Run:
    """Go straight ahead, or backwards; the robot stays where it is when something is in the way."""
    name = "MoveAhead"
    distance = number(arguments.distance, LONGEST_MOVE)
    if distance is None:
        text = f"distance {arguments.distance!r} is no number of metres"
        wish = f"-{LONGEST_MOVE:g} to {LONGEST_MOVE:g}"
        return invalid(world, robot, name, text, wish)
    free = free_around(world, robot)
    if free["ahead" if distance >= 0 else "back"] < abs(distance) - 1e-9:
        return _blocked(world, robot, distance, free)
    before = robot.pose
    angle = radians(robot.pose.yaw)
    end = (before.x + distance * cos(angle), before.y + distance * sin(angle))
    back = distance < 0
    yield from drive(world, robot, [robot.place, end], before.yaw, realtime, backwards=back)
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
    thing = in_the_way(world, robot, angle, free[way])
    out = way_out(world, robot)
    text = f"only {free[way]:.2f} m of {abs(distance):.2f} m are free: {thing} is in the way"
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
        blocked_by=thing,
        way_out={"degrees": out.degrees, "meters": out.meters, "to": out.to},
    )


def rotate(world: World, robot: RobotBody, arguments: RotateArgs, realtime: bool) -> Run:
    """Turn on the spot."""
    name = "Rotate"
    angle = number(arguments.degrees, 3600.0)
    if angle is None:
        text = f"degrees {arguments.degrees!r} is no number of degrees"
        return invalid(world, robot, name, text, "-3600 to 3600")
    before = robot.pose
    yield from turn(world, robot, before.yaw + angle, realtime)
    return done(
        world,
        robot,
        name,
        f"faces {robot.pose.yaw:g} degrees",
        SkillChange(what="yaw", before=before.yaw, after=robot.pose.yaw),
    )


def look_up(world: World, robot: RobotBody, arguments: LookArgs, realtime: bool) -> Run:
    """Tilt the camera up."""
    return (yield from _look(world, robot, "LookUp", arguments, 1.0))


def look_down(world: World, robot: RobotBody, arguments: LookArgs, realtime: bool) -> Run:
    """Tilt the camera down."""
    return (yield from _look(world, robot, "LookDown", arguments, -1.0))


def _look(world: World, robot: RobotBody, name: str, arguments: LookArgs, sign: float) -> Run:
    low, high = PITCHES
    angle = number(arguments.degrees, 180.0)
    if angle is None or angle < 0:
        text = f"degrees {arguments.degrees!r} is no angle to tilt by"
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

"""OpenDoor and CloseDoor."""

from math import dist, hypot
from typing import Annotated, Any

from mansion_geometry.doorways import LEAFLESS
from mansion_geometry.plane import segment_distance
from mansion_geometry.robot_body import FLAT
from mansion_msgs_py.scene import Door
from mansion_msgs_py.skills import SessionArgs
from mansion_msgs_py.wording import with_article
from mansion_msgs_py.world import SkillChange, SkillResult, SkillStatus
from mansion_skills.skills.declaration import Action, Argument, Card, skill
from mansion_skills.skills.references import door_named
from mansion_skills.skills.results import Run, Step, done, invalid, unmet
from mansion_skills.world.objects import box_distance
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["DOOR_REACH", "DoorArgs", "close_door", "open_door"]

DOOR_REACH = 1.5
"""How near to a door the robot must stand, metres to its opening."""

DOOR_TIME = 3.0
LEAF = 0.07
"""Half the depth of a leaf with its frame, from the centre line of the opening, metres."""


class DoorArgs(SessionArgs, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A door of this floor: its id, or the nearest one when absent."""

    door: Annotated[Any, Argument("text", "id of a door of this floor; the nearest one when absent")] = ""


@skill(
    "OpenDoor",
    "Open a door.",
    arguments=DoorArgs,
    example='{"door": "F1/door_2"}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PRECONDITION_FAILURE),
    card=Card("open the nearest door"),
    actions=(Action(),),
)
def open_door(world: World, robot: RobotBody, arguments: DoorArgs, *, realtime: bool) -> Run:
    """Open a door of this floor."""
    return (yield from _swing(world, robot, "OpenDoor", arguments, wanted=True))


@skill(
    "CloseDoor",
    "Close a door.",
    arguments=DoorArgs,
    example='{"door": "F1/door_2"}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PRECONDITION_FAILURE),
    actions=(Action(),),
)
def close_door(world: World, robot: RobotBody, arguments: DoorArgs, *, realtime: bool) -> Run:
    """Close a door of this floor."""
    return (yield from _swing(world, robot, "CloseDoor", arguments, wanted=False))


def _swing(world: World, robot: RobotBody, name: str, arguments: DoorArgs, *, wanted: bool) -> Run:
    door = _chosen(world, robot, arguments.door)
    if isinstance(door, str):
        known = ", ".join(world.view(robot.floor).doors)
        return invalid(world, robot, name, door, f"one of {known}")
    if (refusal := _refusal(world, robot, name, door, wanted=wanted)) is not None:
        return refusal
    yield Step(DOOR_TIME, 0.5, f"moving {door.id}")
    if (refusal := _refusal(world, robot, name, door, wanted=wanted)) is not None:
        return refusal
    world.doors[door.id] = wanted
    if wanted == door.is_open:
        del world.doors[door.id]
    world.refresh(robot.floor)
    return done(
        world,
        robot,
        name,
        f"{door.id} is {'open' if wanted else 'closed'}",
        SkillChange(what=f"{door.id}.open", before=not wanted, after=wanted),
        door=door.id,
    )


def _chosen(world: World, robot: RobotBody, wanted: object) -> Door | str:
    if wanted != "":
        return door_named(world, robot, wanted)
    doors = [door for door in world.view(robot.floor).scene.doors if door.kind not in (*LEAFLESS, "sliding", "garage")]
    nearest = min(doors, key=lambda door: segment_distance(robot.place, door.segment), default=None)
    return nearest if nearest is not None else f"floor {robot.floor} has no door that moves"


def _refusal(world: World, robot: RobotBody, name: str, door: Door, *, wanted: bool) -> SkillResult | None:
    if door.kind in LEAFLESS:
        text = f"{door.id} is {with_article(door.kind)} without a leaf"
        return invalid(world, robot, name, text, "another door")
    if door.kind == "sliding":
        text = f"{door.id} is a lift's landing door"
        return invalid(world, robot, name, text, "CallElevator, which opens it")
    if door.kind == "garage":
        text = f"{door.id} is a garage door, which only its own motor opens"
        return invalid(world, robot, name, text, "another door")
    away = segment_distance(robot.place, door.segment)
    if away > DOOR_REACH or robot_room(world, robot, door) is None:
        text = f"{door.id} is {away:.2f} m away or behind a wall; the hand reaches {DOOR_REACH:g} m"
        return unmet(world, robot, name, text, f"GoNearObject {door.id}")
    is_open = world.doors.get(door.id, door.is_open)
    if is_open == wanted:
        word = "open" if wanted else "closed"
        return unmet(world, robot, name, f"{door.id} is {word} already", "nothing: it is done")
    if not wanted and (obstacle := _in_doorway(world, robot.floor, door)) is not None:
        text = f"{obstacle} is in the way of {door.id}"
        return unmet(world, robot, name, text, "clearing the doorway")
    return None


def robot_room(world: World, robot: RobotBody, door: Door) -> str | None:
    """Return the room beside the door that the robot is in, or ``None`` when it is in neither."""
    room = world.view(robot.floor).map.room_at(*robot.place)
    if room in door.rooms:
        return room
    near = segment_distance(robot.place, door.segment) < 2 * world.radius
    return str(door.rooms[0]) if near else None


def _in_doorway(world: World, floor: int, door: Door) -> str | None:
    for name, body in world.robots.items():
        if body.floor == floor and segment_distance(body.place, door.segment) < body.radius + LEAF:
            return f"the robot of session {name!r}"
    (ax, ay), (bx, by) = door.segment
    count = max(2, int(dist(*door.segment) / 0.05))
    points = [(ax + (bx - ax) * i / count, ay + (by - ay) * i / count) for i in range(count + 1)]
    for state in world.objects.on_floor(floor):
        kind = world.objects.kinds[state.id]
        if state.mount != "floor" or kind.size[2] <= FLAT or state.position is None:
            continue
        reach = dist(*door.segment) + LEAF + hypot(kind.size[0], kind.size[1]) / 2
        if dist(points[count // 2], state.position[:2]) > reach:
            continue
        if any(box_distance(point, state, kind) < LEAF for point in points):
            return state.id
    return None

"""Place: on, in or in front of something."""

from mansion_msgs_py.skills import PlaceArgs
from mansion_msgs_py.world import ObjectState, SkillChange, SkillResult
from mansion_skills.skills.handling import HAND_TIME, out_of_reach
from mansion_skills.skills.naming import object_named
from mansion_skills.skills.outcome import Run, Step, done, invalid, unmet
from mansion_skills.skills.seeing import REACH
from mansion_skills.skills.surfaces import Spot, can_contain, floor_spot, surface_spot
from mansion_skills.world.carrying import put_down
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["place"]

RELATIONS = {"on": "surface", "in": "inside", "in_front": "floor"}
FLOOR = "floor"


def place(world: World, robot: RobotBody, arguments: PlaceArgs, realtime: bool) -> Run:
    """Put what the hand holds on, in or in front of something."""
    name = "Place"
    relation = arguments.relation
    mount = RELATIONS.get(relation) if isinstance(relation, str) else None
    if mount is None:
        text = f"there is no relation {relation!r}"
        return invalid(world, robot, name, text, "on, in or in_front")
    target: ObjectState | None = None
    if arguments.target != FLOOR:
        found = object_named(world, robot, arguments.target)
        if isinstance(found, str):
            return invalid(world, robot, name, found, "an id that ListVisible gives, or floor")
        target = found
    if (refusal := _refusal(world, robot, name, target, mount)) is not None:
        return refusal
    yield Step(HAND_TIME, 0.5, "reaching")
    if target is not None:
        target = world.objects.state(target.id)
    if (refusal := _refusal(world, robot, name, target, mount)) is not None:
        return refusal
    held = world.objects.held_by(robot.session)
    assert held is not None
    spot = _spot(world, robot, held, target, mount)
    where = f"{relation} {FLOOR if target is None else target.id}"
    if spot is None:
        text = f"there is no free place for {held} {where} within {REACH:g} m"
        return unmet(world, robot, name, text, "another place, or standing nearer")
    before = world.objects.state(held)
    _put(world, robot, held, target, FLOOR if target is None else mount, spot)
    return done(
        world,
        robot,
        name,
        f"put {held} {where}",
        SkillChange(what=f"{held}.place", before=before, after=world.objects.state(held)),
        object=held,
    )


def _refusal(world: World, robot: RobotBody, name: str, target: ObjectState | None, mount: str) -> SkillResult | None:
    held = world.objects.held_by(robot.session)
    if target is not None:
        kind = world.objects.kinds[target.id]
        if mount == "surface" and not kind.receptacle:
            text = f"nothing can be put on {target.id}"
            return invalid(world, robot, name, text, "an object that is a receptacle")
        if mount == "inside" and not can_contain(world, kind):
            text = f"nothing can be put into {target.id}"
            return invalid(world, robot, name, text, "an object that holds things, or relation on")
    if held is None:
        return unmet(world, robot, name, "the hand is empty", "PickUp first")
    if target is None:
        return None
    if target.id in world.objects.carried_with(held):
        text = f"{target.id} is in the hand itself"
        return invalid(world, robot, name, text, "something else")
    if (refusal := out_of_reach(world, robot, name, target)) is not None:
        return refusal
    if mount == "inside" and target.states.get("open") is False:
        text = f"{target.id} is closed"
        return unmet(world, robot, name, text, f"OpenObject {target.id}")
    return None


def _spot(world: World, robot: RobotBody, held: str, target: ObjectState | None, mount: str) -> Spot | None:
    thing = world.objects.kinds[held]
    if target is None:
        return floor_spot(world, robot, robot.place, robot.pose.yaw, world.radius, thing)
    if mount != FLOOR:
        return surface_spot(world, robot, target, thing, mount)
    assert target.position is not None
    middle = (target.position[0], target.position[1])
    depth = world.objects.kinds[target.id].size[1] / 2
    return floor_spot(world, robot, middle, target.rotation + 90.0, depth, thing)


def _put(world: World, robot: RobotBody, held: str, target: ObjectState | None, mount: str, spot: Spot) -> None:
    grid = world.view(robot.floor).map
    on_floor = mount == FLOOR or target is None
    put_down(
        world.objects,
        held,
        floor=robot.floor,
        room=grid.room_at(*spot.position[:2]) if target is None or on_floor else target.room,
        position=spot.position,
        rotation=spot.rotation,
        parent=None if on_floor or target is None else target.id,
        mount=mount,
    )
    if on_floor:
        world.refresh(robot.floor)

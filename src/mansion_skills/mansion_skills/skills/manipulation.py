"""PickUp, Place, OpenObject, CloseObject, ToggleOn and ToggleOff."""

from typing import Annotated, Any

from mansion_msgs_py.skills import SessionArgs
from mansion_msgs_py.world import ObjectState, SkillChange, SkillResult, SkillStatus
from mansion_skills.skills.declaration import Action, Argument, Card, skill
from mansion_skills.skills.receptacles import Spot, can_contain, floor_spot, surface_spot
from mansion_skills.skills.references import object_named
from mansion_skills.skills.results import Run, Step, done, invalid, unmet
from mansion_skills.skills.visibility import REACH, TOP_REACH, closed_carrier, is_visible, reach_to
from mansion_skills.world.objects import put_down, take_up
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = [
    "HAND_TIME",
    "ObjectArgs",
    "PlaceArgs",
    "close_object",
    "open_object",
    "out_of_reach",
    "pick_up",
    "place",
    "toggle_off",
    "toggle_on",
]

HAND_TIME = 2.0
"""Duration of any manipulation, seconds."""

RELATIONS = {"on": "surface", "in": "inside", "in_front": "floor"}

FLOOR = "floor"


def out_of_reach(world: World, robot: RobotBody, name: str, state: ObjectState) -> SkillResult | None:
    """Return why the robot cannot handle an object from where it stands, or ``None`` when it can."""
    kind = world.objects.kinds[state.id]
    near = f"GoNearObject {state.id}"
    if state.held_by is not None:
        holder = "the robot itself" if state.held_by == robot.session else state.held_by
        return unmet(world, robot, name, f"{state.id} is held by {holder}", "putting it down")
    if state.floor != robot.floor:
        text = f"{state.id} is on floor {state.floor}, the robot on floor {robot.floor}"
        return unmet(world, robot, name, text, f"going to floor {state.floor}")
    away = reach_to(robot, state, kind)
    if away > REACH:
        text = f"{state.id} is {away:.2f} m away; the hand reaches {REACH:g} m"
        return unmet(world, robot, name, text, near)
    assert state.position is not None
    low = state.position[2] - kind.size[2] / 2
    if low > TOP_REACH:
        text = f"{state.id} hangs {low:.2f} m high; the hand reaches {TOP_REACH:g} m"
        return invalid(world, robot, name, text, "something lower")
    shut = closed_carrier(world, state)
    if shut is not None:
        text = f"{state.id} is in {shut}, which is closed"
        return unmet(world, robot, name, text, f"OpenObject {shut}")
    if not is_visible(world, robot, state):
        return unmet(world, robot, name, f"the robot does not see {state.id}", near)
    return None


class ObjectArgs(SessionArgs, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """An object: its id, or the end of it where that is unambiguous on this floor (``desk_1/mug_2``, ``mug_2``)."""

    object: Annotated[Any, Argument("object", "id, or the end of it where that is unambiguous on this floor")]


class PlaceArgs(SessionArgs, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Put what is held ``on``, ``in`` or ``in_front`` of `target`; ``floor`` is the floor before the robot."""

    target: Annotated[Any, Argument("object", "id of an object, or `floor` for the floor before the robot")]
    relation: Annotated[Any, Argument("text", "`on`, `in` or `in_front`")] = "on"


@skill(
    "PickUp",
    "Take an object into the hand.",
    arguments=ObjectArgs,
    example='{"object": "F1/lobby/mug_1"}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PRECONDITION_FAILURE),
    card=Card("take an object within reach; the hand must be empty", ("object",)),
    actions=(Action(indexed="object"),),
)
def pick_up(world: World, robot: RobotBody, arguments: ObjectArgs, *, realtime: bool) -> Run:
    """Take an object, with what stands on it or lies in it, into the hand."""
    name = "PickUp"
    state = object_named(world, robot, arguments.object)
    if isinstance(state, str):
        return invalid(world, robot, name, state, "an id that ListVisible gives")
    if not world.objects.kinds[state.id].pickupable:
        text = f"{state.id} cannot be picked up"
        return invalid(world, robot, name, text, "an object that is pickupable")
    held = world.objects.held_by(robot.session)
    if held is not None:
        return unmet(world, robot, name, f"the hand holds {held}", "Place it first")
    if (refusal := out_of_reach(world, robot, name, state)) is not None:
        return refusal
    yield Step(HAND_TIME, 0.5, f"reaching for {state.id}")
    state = world.objects.state(state.id)
    if (refusal := out_of_reach(world, robot, name, state)) is not None:
        return refusal
    take_up(world.objects, state.id, robot.session)
    if state.mount not in ("surface", "inside"):
        world.refresh(robot.floor)
    return done(
        world,
        robot,
        name,
        f"holds {state.id}",
        SkillChange(what=f"{state.id}.place", before=state, after=world.objects.state(state.id)),
        object=state.id,
    )


@skill(
    "OpenObject",
    "Open an object.",
    arguments=ObjectArgs,
    example='{"object": "F1/kitchen/fridge_1"}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PRECONDITION_FAILURE),
    card=Card("open an object within reach", ("object",)),
    actions=(Action(indexed="object"),),
)
def open_object(world: World, robot: RobotBody, arguments: ObjectArgs, *, realtime: bool) -> Run:
    """Open a fridge, a drawer, a laptop, ..."""
    return (yield from _set(world, robot, "OpenObject", arguments, "open", value=True))


@skill(
    "CloseObject",
    "Close an object.",
    arguments=ObjectArgs,
    example='{"object": "F1/kitchen/fridge_1"}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PRECONDITION_FAILURE),
    card=Card("close an object within reach", ("object",)),
    actions=(Action(indexed="object"),),
)
def close_object(world: World, robot: RobotBody, arguments: ObjectArgs, *, realtime: bool) -> Run:
    """Close what OpenObject opens."""
    return (yield from _set(world, robot, "CloseObject", arguments, "open", value=False))


@skill(
    "ToggleOn",
    "Switch an object on.",
    arguments=ObjectArgs,
    example='{"object": "F1/lobby/floor_lamp_1"}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PRECONDITION_FAILURE),
    actions=(Action(indexed="object"),),
)
def toggle_on(world: World, robot: RobotBody, arguments: ObjectArgs, *, realtime: bool) -> Run:
    """Switch a lamp, a screen, a tap, ... on."""
    return (yield from _set(world, robot, "ToggleOn", arguments, "on", value=True))


@skill(
    "ToggleOff",
    "Switch an object off.",
    arguments=ObjectArgs,
    example='{"object": "F1/lobby/floor_lamp_1"}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PRECONDITION_FAILURE),
    actions=(Action(indexed="object"),),
)
def toggle_off(world: World, robot: RobotBody, arguments: ObjectArgs, *, realtime: bool) -> Run:
    """Switch off what ToggleOn switches on."""
    return (yield from _set(world, robot, "ToggleOff", arguments, "on", value=False))


def _set(world: World, robot: RobotBody, name: str, arguments: ObjectArgs, key: str, *, value: bool) -> Run:
    state = object_named(world, robot, arguments.object)
    if isinstance(state, str):
        return invalid(world, robot, name, state, "an id that ListVisible gives")
    kind = world.objects.kinds[state.id]
    if not (kind.openable if key == "open" else kind.toggleable):
        able = "openable" if key == "open" else "toggleable"
        text = f"{state.id} is not {able}"
        return invalid(world, robot, name, text, f"an object that is {able}")
    if (refusal := out_of_reach(world, robot, name, state)) is not None:
        return refusal
    word = ("open" if value else "closed") if key == "open" else ("on" if value else "off")
    if state.states.get(key) is value:
        return unmet(world, robot, name, f"{state.id} is {word} already", "nothing: it is done")
    yield Step(HAND_TIME, 0.5, f"reaching for {state.id}")
    state = world.objects.state(state.id)
    if (refusal := out_of_reach(world, robot, name, state)) is not None:
        return refusal
    world.objects.set_state(state.id, key, value)
    return done(
        world,
        robot,
        name,
        f"{state.id} is {word}",
        SkillChange(what=f"{state.id}.{key}", before=state.states.get(key), after=value),
        object=state.id,
    )


@skill(
    "Place",
    "Put what is held on, in or in front of something.",
    arguments=PlaceArgs,
    example='{"target": "F1/lobby/table_1", "relation": "on"}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PRECONDITION_FAILURE),
    card=Card(
        "put what is held `on` or `in` an object within reach, or `on` the `floor` before the robot",
        ("target", "relation"),
        optional=("relation",),
    ),
    actions=(
        Action(indexed="target", fixed={"relation": "on"}),
        Action(indexed="target", fixed={"relation": "in"}),
        Action(fixed={"target": "floor", "relation": "on"}),
    ),
)
def place(world: World, robot: RobotBody, arguments: PlaceArgs, *, realtime: bool) -> Run:
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
            return invalid(world, robot, name, text, "a container, or relation on")
    if held is None:
        return unmet(world, robot, name, "the hand is empty", "PickUp first")
    if target is None:
        return None
    if target.id in world.objects.carried_with(held):
        text = f"{target.id} is what the hand holds, or lies on it"
        return invalid(world, robot, name, text, "something else")
    if (refusal := out_of_reach(world, robot, name, target)) is not None:
        return refusal
    if mount == "inside" and target.states.get("open") is False:
        text = f"{target.id} is closed"
        return unmet(world, robot, name, text, f"OpenObject {target.id}")
    return None


def _spot(world: World, robot: RobotBody, held: str, target: ObjectState | None, mount: str) -> Spot | None:
    item = world.objects.kinds[held]
    if target is None:
        return floor_spot(world, robot, robot.place, robot.pose.yaw, world.radius, item)
    if mount != FLOOR:
        return surface_spot(world, robot, target, item, mount)
    assert target.position is not None
    middle = (target.position[0], target.position[1])
    depth = world.objects.kinds[target.id].size[1] / 2
    return floor_spot(world, robot, middle, target.rotation + 90.0, depth, item)


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

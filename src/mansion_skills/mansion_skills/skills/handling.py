"""PickUp, OpenObject, CloseObject, ToggleOn and ToggleOff."""

from mansion_msgs_py.skills import ObjectArgs
from mansion_msgs_py.world import ObjectState, SkillChange, SkillResult
from mansion_skills.skills.naming import object_named
from mansion_skills.skills.outcome import Run, Step, done, invalid, unmet
from mansion_skills.skills.seeing import REACH, TOP_REACH, closed_carrier, is_visible, reach_to
from mansion_skills.world.carrying import take_up
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["HAND_TIME", "close_object", "open_object", "out_of_reach", "pick_up", "toggle_off", "toggle_on"]

HAND_TIME = 2.0
"""Seconds that the hand needs for anything it does."""


def out_of_reach(world: World, robot: RobotBody, name: str, state: ObjectState) -> SkillResult | None:
    """Return why the robot cannot handle an object from where it stands, or ``None`` when it can."""
    kind = world.objects.kinds[state.id]
    near = f"GoNearObject {state.id}"
    if state.held_by is not None:
        holder = "the robot itself" if state.held_by == robot.session else state.held_by
        return unmet(world, robot, name, f"{state.id} is in the hand of {holder}", "putting it down")
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


def pick_up(world: World, robot: RobotBody, arguments: ObjectArgs, realtime: bool) -> Run:
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


def open_object(world: World, robot: RobotBody, arguments: ObjectArgs, realtime: bool) -> Run:
    """Open a fridge, a drawer, a laptop, ..."""
    return (yield from _set(world, robot, "OpenObject", arguments, "open", True))


def close_object(world: World, robot: RobotBody, arguments: ObjectArgs, realtime: bool) -> Run:
    """Close what OpenObject opens."""
    return (yield from _set(world, robot, "CloseObject", arguments, "open", False))


def toggle_on(world: World, robot: RobotBody, arguments: ObjectArgs, realtime: bool) -> Run:
    """Switch a lamp, a screen, a tap, ... on."""
    return (yield from _set(world, robot, "ToggleOn", arguments, "on", True))


def toggle_off(world: World, robot: RobotBody, arguments: ObjectArgs, realtime: bool) -> Run:
    """Switch off what ToggleOn switches on."""
    return (yield from _set(world, robot, "ToggleOff", arguments, "on", False))


def _set(world: World, robot: RobotBody, name: str, arguments: ObjectArgs, key: str, value: bool) -> Run:
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

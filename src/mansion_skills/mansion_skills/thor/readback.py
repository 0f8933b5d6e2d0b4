"""Read back from AI2-THOR what became of the agent and the objects."""

from collections.abc import Mapping
from math import dist
from typing import Any

import msgspec

from mansion_geometry.thor.house_format import floor_heading, floor_point, floor_rotation
from mansion_msgs_py.shapes import Point3
from mansion_msgs_py.world import ObjectState, Pose2D, SkillChange
from mansion_skills.skills.receptacles import can_contain
from mansion_skills.world.objects import put_down, take_up
from mansion_skills.world.robot_body import RobotBody, turn_between
from mansion_skills.world.world import World

__all__ = ["read_back"]

SAME_PLACE, SAME_TURN = 0.01, 1.0
"""Differences that are put down to rounding, metres and degrees."""

SETTLED = 0.1
"""Greatest distance that an object may slide and keep its receptacle when AI2-THOR names none, metres."""


def read_back(world: World, robot: RobotBody, metadata: Mapping[str, Any]) -> list[SkillChange]:
    """Bring the world in line with an event's metadata.

    Parameters
    ----------
    world : World
    robot : RobotBody
        The agent.
    metadata : mapping
        ``event.metadata``: ``agent`` and ``objects`` are read.

    Returns
    -------
    list of SkillChange
        What was otherwise than the world had it, of the objects.
    """
    _read_agent(robot, metadata["agent"])
    before = dict(world.objects.changed)
    doors = world.view(robot.floor).doors
    seen = {entry["objectId"]: entry for entry in metadata["objects"]}
    door_changes = []
    for name, entry in seen.items():
        if name in doors:
            door_changes += _read_door(world, name, at_first=doors[name].is_open, is_open=bool(entry["isOpen"]))
    for name in [name for name in seen if name in world.objects]:
        _read_object(world, robot, name, seen[name])
    changed = [name for name in seen if name in world.objects and world.objects.changed.get(name) != before.get(name)]
    world.objects.commit()
    if changed or door_changes:
        world.refresh(robot.floor)
    return door_changes + [
        SkillChange(what=f"{name}.place", before=before.get(name), after=world.objects.state(name)) for name in changed
    ]


def _read_agent(robot: RobotBody, agent: Mapping[str, Any]) -> None:
    x, y, _ = floor_point(agent["position"])
    yaw = floor_heading(float(agent["rotation"]["y"]))
    moved = dist((x, y), robot.place) > SAME_PLACE
    if moved or abs(turn_between(robot.pose.yaw, yaw)) > SAME_TURN:
        robot.move(Pose2D(x=x, y=y, yaw=yaw))
    pitch = -float(agent["cameraHorizon"])
    if abs(pitch - robot.pitch) > SAME_TURN:
        robot.pitch = round(pitch, 3)


def _read_door(world: World, name: str, *, at_first: bool, is_open: bool) -> list[SkillChange]:
    was = world.doors.get(name, at_first)
    if was == is_open:
        return []
    world.doors[name] = is_open
    if is_open == at_first:
        del world.doors[name]
    return [SkillChange(what=f"{name}.open", before=was, after=is_open)]


def _read_object(world: World, robot: RobotBody, name: str, entry: Mapping[str, Any]) -> None:
    _read_states(world, name, entry)
    state = world.objects.state(name)
    if entry["isPickedUp"]:
        if state.held_by is None:
            take_up(world.objects, name, robot.session)
        return
    place, turn = _center(entry), floor_rotation(float(entry["rotation"]["y"]))
    room = world.view(robot.floor).map.room_at(place[0], place[1])
    if state.held_by is None:
        _move(world, state, entry, place, turn, room)
    elif state.parent is None:
        parent = _named_parent(world, state, entry)
        put_down(
            world.objects,
            name,
            floor=robot.floor,
            room=room,
            position=place,
            rotation=turn,
            parent=parent,
            mount=_mount(world, parent),
        )


def _move(
    world: World, state: ObjectState, entry: Mapping[str, Any], place: Point3, turn: float, room: str | None
) -> None:
    """Put an object where AI2-THOR has it, unless that is where it was."""
    assert state.position is not None
    moved = dist(place, state.position)
    if moved <= SAME_PLACE and abs(turn_between(state.rotation, turn)) <= SAME_TURN:
        return
    parent = _named_parent(world, state, entry)
    if parent is None and moved <= SETTLED:
        parent = state.parent
    world.objects.put(
        msgspec.structs.replace(
            state,
            room=room or state.room,
            position=place,
            rotation=turn,
            parent=parent,
            mount=state.mount if parent == state.parent else _mount(world, parent),
        )
    )


def _read_states(world: World, name: str, entry: Mapping[str, Any]) -> None:
    kind, states = world.objects.kinds[name], world.objects.state(name).states
    for able, key, said in (
        (kind.openable and entry["openable"], "open", bool(entry["isOpen"])),
        (kind.toggleable and entry["toggleable"], "on", bool(entry["isToggled"])),
    ):
        if able and states.get(key) is not said:
            world.objects.set_state(name, key, said)


def _center(entry: Mapping[str, Any]) -> Point3:
    """Return the middle of an object's box: its ``position`` may be its foot."""
    box = entry.get("axisAlignedBoundingBox")
    return floor_point(box["center"] if box else entry["position"])


def _named_parent(world: World, state: ObjectState, entry: Mapping[str, Any]) -> str | None:
    """Return what carries an object now: as before where AI2-THOR names it too, else the first that it names."""
    own = world.objects.carried_with(state.id)
    named = [name for name in entry.get("parentReceptacles") or [] if name in world.objects and name not in own]
    return state.parent if state.parent in named else next(iter(named), None)


def _mount(world: World, parent: str | None) -> str:
    if parent is None:
        return "floor"
    kind = world.objects.kinds[parent]
    return "inside" if kind.openable and can_contain(world, kind) else "surface"

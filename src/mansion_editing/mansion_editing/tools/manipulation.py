"""RemoveObject, MoveObject and SetState: change the objects that a scene has."""

import math

import msgspec
from shapely import STRtree

from mansion_editing.physics.engine import PhysicsEngine
from mansion_editing.state import SceneState
from mansion_editing.tools.floor_places import free_floor_places
from mansion_editing.tools.perception import contents, object_named, on_top
from mansion_editing.tools.placement import settle_on
from mansion_geometry.object_footprints import footprint, footprint_at
from mansion_msgs_py.editing import MoveObjectArgs, RemoveObjectArgs, SetStateArgs
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.wording import with_article
from mansion_scene.decor.frames import room_polygon, to_local

__all__ = ["move_object", "remove_object", "set_state"]

LOW = 0.03
OVERLAP = 1e-3
"""Square metres by which footprints may overlap through rounding."""


def remove_object(state: SceneState, args: RemoveObjectArgs) -> list[str]:
    """Remove an object with all that it carries, or all that a receptacle carries; return the ids.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` without an id, ``NOT_FOUND`` for an unknown one.
    """
    if not args.object_id and not args.receptacle_id:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "give object_id or receptacle_id", path="$.object_id")
    if args.object_id:
        floor, item = state.get(args.object_id, "$.object_id")
        roots = [item]
        if args.receptacle_id:
            _, receptacle = object_named(state, args.receptacle_id, "$.receptacle_id")
            carried = {member.id for member in state.subtree(floor, receptacle)[1:]}
            if item.id not in carried:
                raise MansionError(ErrorCode.CONFLICT, f"{item.id} is not on or in {receptacle.id}")
    else:
        floor, receptacle = object_named(state, args.receptacle_id, "$.receptacle_id")
        roots = _carried(state, floor, receptacle)
    members = [m for root in roots for m in state.subtree(floor, root)]
    unique = {member.id: member for member in members}
    for member in reversed(unique.values()):
        state.remove(floor, member)
    return list(unique)


def _carried(state: SceneState, floor: int, receptacle: SceneObject) -> list[SceneObject]:
    """Return the objects on and in a receptacle, by the scene's hierarchy and by geometry."""
    index = state.index(floor)
    asset = state.asset(receptacle)
    found = list(index.children.get(receptacle.id, []))
    for item in (*on_top(index, receptacle, asset), *contents(index, receptacle, asset)):
        loose = item.mount in ("surface", "inside") or item.pickupable
        if loose and item.parent in (None, receptacle.id):
            found.append(item)
    return list({item.id: item for item in found}.values())


def set_state(state: SceneState, args: SetStateArgs) -> SceneObject:
    """Open, close or switch an object.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` when no state is given, ``INFEASIBLE`` for what does not open or switch.
    """
    floor, item = object_named(state, args.object_id, "$.object_id")
    states = dict(item.states)
    if args.open is None and args.on is None:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "give open or on", path="$.open")
    for name, value, able in (("open", args.open, item.openable), ("on", args.on, item.toggleable)):
        if value is None:
            continue
        if not able:
            what = "open or close" if name == "open" else "switch on or off"
            raise MansionError(ErrorCode.INFEASIBLE, f"{item.id} does not {what}", path=f"$.{name}")
        states[name] = value
    after = msgspec.structs.replace(item, states=states)
    if after != item:
        state.replace(floor, item, after)
    return after


def move_object(state: SceneState, args: MoveObjectArgs, engine: PhysicsEngine) -> SceneObject:
    """Move an object, with what it carries, to a receptacle, a room or a point.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` without a target, ``INFEASIBLE`` where there is no place, ``NOT_FOUND`` for unknown ids.
    """
    floor, item = object_named(state, args.object_id, "$.object_id")
    members = state.subtree(floor, item)
    target, moved = _target(state, args, floor, item, engine)
    if target != floor:
        prefix = state.new_id(target, moved.room, item.category)
        moved = msgspec.structs.replace(moved, id=prefix)
    carried = [_with(item, moved, member) for member in members[1:]]
    if target == floor:
        for old, new in zip(members, [moved, *carried], strict=True):
            if old != new:
                state.replace(floor, old, new)
        return moved
    for old in reversed(members):
        state.remove(floor, old)
    names = {item.id: moved.id}
    state.add(target, moved)
    for old, new in zip(members[1:], carried, strict=True):
        fresh = state.new_id(target, moved.room, old.category)
        names[old.id] = fresh
        parent = names.get(old.parent or "", moved.id)
        state.add(target, msgspec.structs.replace(new, id=fresh, parent=parent))
    return moved


def _target(
    state: SceneState, args: MoveObjectArgs, floor: int, item: SceneObject, engine: PhysicsEngine
) -> tuple[int, SceneObject]:
    if not args.receptacle_id:
        if args.x is None or args.y is None:
            raise MansionError(ErrorCode.INVALID_PAYLOAD, "give receptacle_id, or x and y", path="$.receptacle_id")
        return floor, _at_point(state, args.x, args.y, args.rotation, floor, item)
    room = state.room(args.receptacle_id)
    if room is not None:
        for x, y, rotation in free_floor_places(state, *room, item):
            position = (round(x, 4), round(y, 4), item.size[2] / 2)
            return room[0], msgspec.structs.replace(
                item, room=room[1].id, position=position, rotation=rotation, parent=None, mount="floor"
            )
        raise MansionError(ErrorCode.INFEASIBLE, f"no free place for {item.id} in {room[1].id}")
    target, receptacle = object_named(state, args.receptacle_id, "$.receptacle_id")
    own = [member.id for member in state.subtree(floor, item)]
    if receptacle.id in own:
        raise MansionError(ErrorCode.INFEASIBLE, f"{receptacle.id} is carried by {item.id}", path="$.receptacle_id")
    if item.mount in ("wall", "ceiling"):
        raise MansionError(ErrorCode.INFEASIBLE, f"{item.id} hangs on {with_article(item.mount)}")
    asset = state.asset(receptacle)
    inside = asset is not None and bool(asset.volumes) and not asset.surfaces
    try:
        return target, settle_on(state, item, target, receptacle, engine, inside=inside, skip=own)
    except MansionError as error:
        if inside or asset is None or not asset.volumes or error.code != ErrorCode.INFEASIBLE:
            raise
        return target, settle_on(state, item, target, receptacle, engine, inside=True, skip=own)


def _at_point(
    state: SceneState, x: float, y: float, rotation: float | None, floor: int, item: SceneObject
) -> SceneObject:
    room = state.index(floor).room_at(x, y)
    if room is None:
        raise MansionError(ErrorCode.INFEASIBLE, f"({x:g}, {y:g}) is in no room of floor {floor}")
    turn = item.rotation if rotation is None else rotation % 360.0
    shape = footprint_at((x, y), item.size, turn)
    area = room_polygon(room.net_polygon, room.net_holes)
    if shape.difference(area.buffer(2e-3)).area > OVERLAP:
        raise MansionError(ErrorCode.INFEASIBLE, f"{item.id} would extend beyond {room.id} at ({x:g}, {y:g})")
    own = {member.id for member in state.subtree(floor, item)}
    parent, mount = item.parent, item.mount
    if parent is not None:
        _, carrier = state.get(parent)
        u, v = to_local(carrier, (x, y))
        if abs(u) > carrier.size[0] / 2 or abs(v) > carrier.size[1] / 2:
            raise MansionError(
                ErrorCode.INFEASIBLE,
                f"({x:g}, {y:g}) is outside {carrier.id}, which carries {item.id}; give a receptacle_id",
            )
    low, high = item.position[2] - item.size[2] / 2, item.position[2] + item.size[2] / 2
    others = [
        other
        for other in state.index(floor).objects
        if other.id not in own
        and other.id != parent
        and other.size[2] > LOW
        and min(high, other.position[2] + other.size[2] / 2) - max(low, other.position[2] - other.size[2] / 2) > 5e-3
        and math.dist(other.position[:2], (x, y)) < 10.0
    ]
    shapes = [footprint(other) for other in others]
    for number in sorted(STRtree(shapes).query(shape).tolist()):
        if shapes[number].intersection(shape).area > OVERLAP and item.size[2] > LOW:
            raise MansionError(ErrorCode.INFEASIBLE, f"{item.id} would overlap {others[number].id} at ({x:g}, {y:g})")
    position = (round(x, 4), round(y, 4), item.position[2])
    return msgspec.structs.replace(
        item, room=room.id, position=position, rotation=round(turn, 4), parent=parent, mount=mount
    )


def _with(before: SceneObject, after: SceneObject, member: SceneObject) -> SceneObject:
    """Return what an object carries where it goes with it."""
    u, v = to_local(before, member.position)
    angle = math.radians(after.rotation)
    c, s = math.cos(angle), math.sin(angle)
    position = (
        round(after.position[0] + c * u - s * v, 4),
        round(after.position[1] + s * u + c * v, 4),
        round(member.position[2] + after.position[2] - before.position[2], 4),
    )
    turn = round((member.rotation + after.rotation - before.rotation) % 360.0, 4)
    return msgspec.structs.replace(member, room=after.room, position=position, rotation=turn)

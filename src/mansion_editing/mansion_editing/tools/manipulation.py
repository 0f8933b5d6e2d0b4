"""RemoveObject, MoveObject and SetState: change the objects and open or close the doors that a scene has."""

import math
from collections.abc import Collection, Sequence
from dataclasses import replace

import msgspec
from shapely import Polygon, STRtree

from mansion_editing.physics.engine import PhysicsEngine
from mansion_editing.state import SceneState
from mansion_editing.tools.destinations import Accept, AtReceptacle, InRoom
from mansion_editing.tools.perception import contents, object_named, on_top
from mansion_editing.tools.placement import put_in_room
from mansion_editing.tools.placing_wishes import refusal, wish_of
from mansion_editing.tools.relations import NO_WISH, PlacingWish, looks_at
from mansion_editing.tools.resting import settle_on
from mansion_editing.tools.tops import carries_on_top
from mansion_geometry.doorways import LEAFLESS
from mansion_geometry.object_footprints import WALKABLE_HEIGHT, footprint, footprint_at
from mansion_msgs_py.editing.objects import MoveObjectArgs, RemoveObjectArgs, SetStateArgs
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene, SceneObject
from mansion_msgs_py.wording import with_article
from mansion_scene.decor.frames import room_polygon, to_local

__all__ = ["at_point", "door_swung", "move_object", "relocate", "remove_object", "scene_with", "set_state"]

OVERLAP = 1e-3
"""Square metres by which footprints may overlap through rounding."""

_NEAR = 10.0
"""Distance between middles, metres, beyond which no two objects touch."""


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
    members = [m for root in roots for m in _lifted_off(state, floor, root)]
    unique = {member.id: member for member in members}
    for member in reversed(unique.values()):
        state.remove(floor, member)
    return list(unique)


def _lifted_off(state: SceneState, floor: int, root: SceneObject) -> list[SceneObject]:
    """Return an object with what goes when it is taken away; what stands below it is left on the floor."""
    below = [item for item in state.subtree(floor, root)[1:] if item.mount == "floor"]
    for item in below:
        state.replace(floor, item, msgspec.structs.replace(item, parent=None))
    return state.subtree(floor, root)


def _carried(state: SceneState, floor: int, receptacle: SceneObject) -> list[SceneObject]:
    """Return the objects on and in a receptacle, by the scene's hierarchy and by geometry."""
    index = state.index(floor)
    asset = state.asset(receptacle)
    found = [item for item in index.children.get(receptacle.id, []) if item.mount != "floor"]
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


def move_object(
    state: SceneState, args: MoveObjectArgs, engine: PhysicsEngine, accept: Accept | None = None
) -> SceneObject:
    """Move an object, with what it carries, to a receptacle, a room or a point, or turn it where it is.

    Parameters
    ----------
    accept : callable, optional
        Judges a place in a room that a wish is about before it is taken.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` without a target, ``INFEASIBLE`` where there is no place, ``NOT_FOUND`` for unknown ids.
    """
    floor, item = object_named(state, args.object_id, "$.object_id")
    target, moved = _target(state, args, floor, item, engine, accept)
    return relocate(state, floor, item, target, moved)


def relocate(state: SceneState, floor: int, item: SceneObject, target: int, moved: SceneObject) -> SceneObject:
    """Put an object with what it carries where `moved` is; on another floor all get new ids."""
    members = state.subtree(floor, item)
    if target != floor:
        moved = msgspec.structs.replace(moved, id=state.new_id(target, moved.room, item.category))
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


def scene_with(state: SceneState, floor: int, item: SceneObject) -> FloorScene:
    """Return a floor with an object on it, new or moved there with what it carries; the state is not changed."""
    scene = state.scenes[floor]
    found = state.find(item.id)
    if found is None or found[0] != floor:
        return msgspec.structs.replace(scene, objects=[*scene.objects, item])
    before = found[1]
    moved = {m.id: _with(before, item, m) for m in state.subtree(floor, before)[1:]}
    moved[item.id] = item
    return msgspec.structs.replace(scene, objects=[moved.get(o.id, o) for o in scene.objects])


def _target(
    state: SceneState, args: MoveObjectArgs, floor: int, item: SceneObject, engine: PhysicsEngine, accept: Accept | None
) -> tuple[int, SceneObject]:
    wish = wish_of(state, args)
    if item in (wish.near, wish.other, wish.facing):
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{item.id} is to move and named as its landmark", path="$.near")
    place = args.receptacle_id or _place_of(item, wish)
    if not place:
        return floor, _on_the_spot(state, args, floor, item, wish)
    if args.turn is not None or (wish != NO_WISH and args.x is not None):
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, "give a receptacle or a wish, or a point and a turn, not both", path="$.turn"
        )
    own = [member.id for member in state.subtree(floor, item)]
    room = state.room(place)
    if room is not None:
        return room[0], _in_room(state, item, InRoom(*room, wish, accept, own))
    target, receptacle = object_named(state, place, "$.receptacle_id")
    if receptacle.id in own:
        raise refusal(f"{receptacle.id} is carried by {item.id}", path="$.receptacle_id")
    if item.mount in ("wall", "ceiling"):
        raise refusal(f"{item.id} hangs on {with_article(item.mount)}")
    asset = state.asset(receptacle)
    inside = asset is not None and bool(asset.volumes) and (args.inside or not carries_on_top(asset))
    where = AtReceptacle(target, receptacle, inside=inside, wish=wish, companions=own)
    try:
        return target, settle_on(state, item, where, engine)
    except MansionError as error:
        if inside or asset is None or not asset.volumes or error.code != ErrorCode.INFEASIBLE:
            raise
        return target, settle_on(state, item, replace(where, inside=True), engine)


def _place_of(item: SceneObject, wish: PlacingWish) -> str:
    """Return the room or the receptacle that a wish is about where none is named; empty for the object's own spot."""
    loose = item.mount in ("surface", "inside") or item.pickupable
    near = wish.near
    if near is not None:
        on_top = loose and near.parent is not None and near.mount != "floor" and wish.side != "under"
        return near.parent or "" if on_top else near.room
    return item.room if wish.spot else ""


def _in_room(state: SceneState, item: SceneObject, where: InRoom) -> SceneObject:
    floor, room = where.floor, where.room
    there = state.find(item.id)
    known = there is not None and there[0] == floor
    thing = item if known else msgspec.structs.replace(item, id=state.new_id(floor, room.id, item.category))
    placed = put_in_room(state, thing, where)
    return placed if where.wish != NO_WISH or item.mount in ("wall", "ceiling") else _unparented(placed)


def _unparented(item: SceneObject) -> SceneObject:
    """Return an object that stands on the floor as carried by nothing."""
    return msgspec.structs.replace(item, parent=None, mount="floor")


def _on_the_spot(
    state: SceneState, args: MoveObjectArgs, floor: int, item: SceneObject, wish: PlacingWish
) -> SceneObject:
    """Return an object at the point that is given, else where it is, turned as is asked for."""
    if (args.x is None) != (args.y is None):
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "give receptacle_id, or x and y", path="$.receptacle_id")
    x, y = (item.position[0], item.position[1]) if args.x is None or args.y is None else (args.x, args.y)
    if wish.facing is not None:
        return _turned_to(state, x, y, floor, item, wish.facing)
    rotation = args.rotation
    if args.turn is not None:
        rotation = (item.rotation if rotation is None else rotation) + args.turn
    if rotation is None and args.x is None:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, "give receptacle_id, x and y, rotation, turn or a wish", path="$.receptacle_id"
        )
    if args.x is None and item.mount == "wall":
        raise refusal(f"{item.id} hangs on a wall and looks away from it; it cannot be turned")
    return at_point(state, x, y, rotation, floor, item)


def _turned_to(
    state: SceneState, x: float, y: float, floor: int, item: SceneObject, target: SceneObject
) -> SceneObject:
    """Return an object turned so that it looks at another: by quarters where that will do, else straight to it."""
    if item.mount == "wall":
        raise refusal(f"{item.id} hangs on a wall and looks away from it; it cannot be turned")
    if target.room != item.room:
        raise refusal(f"{target.id} is not in {item.room}")
    there = msgspec.structs.replace(item, position=(x, y, item.position[2]))
    aim = math.degrees(math.atan2(x - target.position[0], target.position[1] - y))
    reasons: list[str] = []
    for rotation in (*(item.rotation + turn for turn in (0.0, 90.0, 270.0, 180.0)), aim):
        if not looks_at(msgspec.structs.replace(there, rotation=rotation), target):
            continue
        try:
            return at_point(state, x, y, rotation, floor, item)
        except MansionError as error:
            reasons.append(error.info.message)
    raise refusal("; ".join(dict.fromkeys(reasons)) or f"{item.id} and {target.id} are in the same place")


def at_point(
    state: SceneState,
    x: float,
    y: float,
    rotation: float | None,
    floor: int,
    item: SceneObject,
    skip: Collection[str] = (),
) -> SceneObject:
    """Return an object at a point of its floor, on what carries it already; the state is not changed.

    Parameters
    ----------
    rotation : float, optional
        Degrees; its own when absent.
    skip : collection of str
        Objects that are not in the way, besides what it carries.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with what is in the way.
    """
    room = state.index(floor).room_at(x, y)
    if room is None:
        raise refusal(f"({x:g}, {y:g}) is in no room of floor {floor}")
    turn = item.rotation if rotation is None else rotation % 360.0
    shape = footprint_at((x, y), item.size, turn)
    area = room_polygon(room.net_polygon, room.net_holes)
    if shape.difference(area.buffer(2e-3)).area > OVERLAP:
        raise refusal(f"{item.id} would extend beyond {room.id} at ({x:g}, {y:g})")
    parent = _carrier_at(state, item, x, y)
    own = {member.id for member in state.subtree(floor, item)} | {*skip, parent}
    if item.size[2] > WALKABLE_HEIGHT:
        near = [other for other in state.index(floor).objects if math.dist(other.position[:2], (x, y)) < _NEAR]
        _refuse_overlap(item, shape, [other for other in near if other.id not in own])
    position = (round(x, 4), round(y, 4), item.position[2])
    return msgspec.structs.replace(item, room=room.id, position=position, rotation=round(turn, 4), parent=parent)


def _carrier_at(state: SceneState, item: SceneObject, x: float, y: float) -> str | None:
    """Return what carries an object, or ``None`` where it would stand beside that on the floor."""
    if item.parent is None:
        return None
    _, carrier = state.get(item.parent)
    u, v = to_local(carrier, (x, y))
    if abs(u) <= carrier.size[0] / 2 and abs(v) <= carrier.size[1] / 2:
        return item.parent
    if item.mount != "floor":
        raise refusal(f"({x:g}, {y:g}) is outside {carrier.id}, which carries {item.id}; give a receptacle_id")
    return None


def _refuse_overlap(item: SceneObject, shape: Polygon, others: Sequence[SceneObject]) -> None:
    """Raise where an object would overlap one of others with its new footprint."""
    standing = [
        other
        for other in others
        if other.size[2] > WALKABLE_HEIGHT and min(item.top, other.top) - max(item.bottom, other.bottom) > 5e-3
    ]
    shapes = [footprint(other) for other in standing]
    for number in sorted(STRtree(shapes).query(shape).tolist()):
        if shapes[number].intersection(shape).area > OVERLAP:
            where = shape.centroid
            raise refusal(f"{item.id} would overlap {standing[number].id} at ({where.x:g}, {where.y:g})")


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


def door_swung(state: SceneState, args: SetStateArgs) -> tuple[int, FloorScene] | None:
    """Return the floor of a door, by its id, with its scene as it is once the door is open or closed; else None.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` without `open`, ``INFEASIBLE`` for what has no leaf and for a lift's door.
    """
    for floor in state.floors:
        scene = state.scenes[floor]
        at = next((number for number, door in enumerate(scene.doors) if door.id == args.object_id), None)
        if at is None:
            continue
        door = scene.doors[at]
        if args.open is None or args.on is not None:
            raise MansionError(ErrorCode.INVALID_PAYLOAD, "a door is open or closed: give open", path="$.open")
        if door.kind in LEAFLESS:
            raise MansionError(ErrorCode.INFEASIBLE, f"{door.id} has no leaf to open or close", path="$.open")
        if door.kind == "sliding":
            raise MansionError(ErrorCode.INFEASIBLE, f"{door.id} is a lift's door, which the lift opens", path="$.open")
        doors = [*scene.doors[:at], msgspec.structs.replace(door, is_open=args.open), *scene.doors[at + 1 :]]
        return floor, msgspec.structs.replace(scene, doors=doors)
    return None

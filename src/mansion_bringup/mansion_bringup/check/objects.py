"""Does every object stand where a thing can stand: in its room, free of others, on what carries it."""

from collections.abc import Iterator

from shapely import LineString, Polygon, STRtree

from mansion_bringup.check.fault import Fault
from mansion_bringup.check.shapes import net_area, vertical
from mansion_geometry.object_footprints import footprint
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom

__all__ = ["check_objects"]

AREA_SLACK = 1e-3
"""Square metres by which footprints may overlap or overhang through rounding."""

WALKABLE_HEIGHT = 0.03
"""A thing lower than this (a rug) is walked over."""

DOOR_DEPTH = 0.6
"""Depth of the area before a door that must stay clear, metres."""

HEIGHT_SLACK = 0.03


def check_objects(scene: FloorScene) -> Iterator[Fault]:
    """Yield faults of the objects' poses."""
    rooms = {room.id: room for room in scene.rooms}
    things = {thing.id: thing for thing in scene.objects}
    for thing in scene.objects:
        yield from _in_room(thing, rooms)
        if thing.mount in ("surface", "inside"):
            yield from _on_parent(thing, things)
        elif thing.mount == "floor" and abs(vertical(thing)[0]) > HEIGHT_SLACK:
            yield Fault("OBJECT_FLOATS", thing.id, f"its foot is at {vertical(thing)[0]:.2f} m")
    yield from _overlaps(scene)
    yield from _before_doors(scene)


def _in_room(thing: SceneObject, rooms: dict[str, SceneRoom]) -> Iterator[Fault]:
    room = rooms.get(thing.room)
    if room is None:
        yield Fault("OBJECT_ROOM", thing.id, f"is in {thing.room!r}, which is not there")
        return
    beyond = footprint(thing).difference(net_area(room).buffer(2e-3)).area
    if beyond > AREA_SLACK:
        yield Fault("OBJECT_OUTSIDE", thing.id, f"{beyond:.3f} m2 extend beyond {room.id}")
    low, high = vertical(thing)
    if low < -HEIGHT_SLACK or high > room.ceiling_height + HEIGHT_SLACK:
        yield Fault("OBJECT_OUTSIDE", thing.id, f"reaches from {low:.2f} m to {high:.2f} m")


def _on_parent(thing: SceneObject, things: dict[str, SceneObject]) -> Iterator[Fault]:
    parent = things.get(thing.parent or "")
    if parent is None:
        yield Fault("OBJECT_PARENT", thing.id, f"is on {thing.parent!r}, which is not there")
        return
    shared = footprint(thing).intersection(footprint(parent)).area
    if shared < 0.5 * footprint(thing).area:
        yield Fault("OBJECT_PARENT", thing.id, f"is not over {parent.id}")
    low, high = vertical(thing)
    parent_low, parent_high = vertical(parent)
    below = low < parent_low - HEIGHT_SLACK
    if thing.mount == "inside" and (below or high > parent_high + HEIGHT_SLACK):
        yield Fault("OBJECT_PARENT", thing.id, f"is not within the height of {parent.id}")
    if thing.mount == "surface" and (below or low > parent_high + HEIGHT_SLACK):
        yield Fault("OBJECT_FLOATS", thing.id, f"stands at {low:.2f} m, {parent.id} ends lower")


def _overlaps(scene: FloorScene) -> Iterator[Fault]:
    things = [thing for thing in scene.objects if thing.size[2] > WALKABLE_HEIGHT]
    if not things:
        return
    shapes = [footprint(thing) for thing in things]
    tree = STRtree(shapes)
    first, second = tree.query(shapes, predicate="intersects")
    known = {thing.id: thing for thing in scene.objects}
    carriers = [_carriers(thing, known) for thing in things]
    for index, other in sorted(zip(first.tolist(), second.tolist())):
        if things[index].id in carriers[other] or things[other].id in carriers[index]:
            continue
        if other > index and _collide(things[index], things[other], shapes[index], shapes[other]):
            where = f"{things[index].id} and {things[other].id}"
            yield Fault("OBJECT_OVERLAP", where, "overlap")


def _carriers(thing: SceneObject, things: dict[str, SceneObject]) -> set[str]:
    """Return the ids of what carries an object, and of what carries that (a cup on a tray on a table)."""
    found: set[str] = set()
    while thing.parent is not None and thing.parent not in found:
        found.add(thing.parent)
        if thing.parent not in things:
            break
        thing = things[thing.parent]
    return found


def _collide(one: SceneObject, other: SceneObject, shape: Polygon, second: Polygon) -> bool:
    nested = one.parent is not None and one.parent == other.parent and one.mount != other.mount
    if nested:
        return False
    (low, high), (low2, high2) = vertical(one), vertical(other)
    in_height = min(high, high2) - max(low, low2) > 5e-3
    return in_height and shape.intersection(second).area > AREA_SLACK


def _before_doors(scene: FloorScene) -> Iterator[Fault]:
    standing = [
        thing
        for thing in scene.objects
        if thing.mount in ("floor", "wall") and vertical(thing)[0] < 1.9 and thing.size[2] > WALKABLE_HEIGHT
    ]
    if not standing:
        return
    shapes = [footprint(thing) for thing in standing]
    tree = STRtree(shapes)
    for door in scene.doors:
        area = LineString(door.segment).buffer(DOOR_DEPTH, cap_style="flat")
        for index in sorted(tree.query(area)):
            thing = standing[index]
            near = thing.room in door.rooms
            if near and area.intersection(shapes[index]).area > AREA_SLACK:
                yield Fault("DOOR_BLOCKED", door.id, f"{thing.id} stands before it")

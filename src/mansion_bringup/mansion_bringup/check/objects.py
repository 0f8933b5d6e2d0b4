"""Checks that objects are in their rooms, overlap no other and rest on what carries them, and where lamps are."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Final, TypeAlias

from shapely import LineString, Point, Polygon, STRtree, prepare

from mansion_bringup.check.fault import Fault
from mansion_bringup.check.shapes import net_area, room_area, vertical
from mansion_geometry.object_footprints import WALKABLE_HEIGHT, footprints
from mansion_geometry.wall_sizes import DOOR_HEAD, doorway_depth
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom

__all__ = ["carriers", "check_lights", "check_objects"]

Placed: TypeAlias = tuple[SceneObject, Polygon]
"""An object and its footprint."""

AREA_SLACK = 1e-3
"""Square metres by which footprints may overlap or overhang from rounding."""

HEIGHT_SLACK = 0.03


def check_objects(scene: FloorScene) -> Iterator[Fault]:
    """Yield faults of the objects' poses."""
    furnished = {item.room for item in scene.objects}
    rooms = {room.id: (room, _region(room)) for room in scene.rooms if room.id in furnished}
    placed = list(zip(scene.objects, footprints(scene.objects), strict=True))
    known = {item.id: (item, shape) for item, shape in placed}
    for item, shape in placed:
        yield from _in_room(item, shape, rooms)
        if item.mount in ("surface", "inside"):
            yield from _on_parent(item, shape, known)
        elif item.mount == "floor" and abs(vertical(item)[0]) > HEIGHT_SLACK:
            yield Fault("OBJECT_FLOATS", item.id, f"its lower side is at {vertical(item)[0]:.2f} m")
    yield from _overlaps(placed)
    yield from _before_doors(scene, placed)


def _region(room: SceneRoom) -> Polygon:
    """Return where a room's objects may be, ready to be asked for many of them."""
    region = net_area(room).buffer(2e-3)
    prepare(region)
    return region


def _in_room(item: SceneObject, shape: Polygon, rooms: Mapping[str, tuple[SceneRoom, Polygon]]) -> Iterator[Fault]:
    room, region = rooms.get(item.room, (None, None))
    if room is None or region is None:
        yield Fault("OBJECT_ROOM", item.id, f"is in {item.room!r}, which does not exist")
        return
    beyond = 0.0 if region.covers(shape) else shape.difference(region).area
    if beyond > AREA_SLACK:
        yield Fault("OBJECT_OUTSIDE", item.id, f"{beyond:.3f} m2 extend beyond {room.id}")
    low, high = vertical(item)
    if low < -HEIGHT_SLACK or high > room.ceiling_height + HEIGHT_SLACK:
        yield Fault("OBJECT_OUTSIDE", item.id, f"reaches from {low:.2f} m to {high:.2f} m")


def _on_parent(item: SceneObject, shape: Polygon, known: Mapping[str, Placed]) -> Iterator[Fault]:
    if (item.parent or "") not in known:
        yield Fault("OBJECT_PARENT", item.id, f"is on {item.parent!r}, which does not exist")
        return
    parent, below_it = known[item.parent or ""]
    if shape.intersection(below_it).area < 0.5 * shape.area:
        yield Fault("OBJECT_PARENT", item.id, f"is not over {parent.id}")
    low, high = vertical(item)
    parent_low, parent_high = vertical(parent)
    below = low < parent_low - HEIGHT_SLACK
    if item.mount == "inside" and (below or high > parent_high + HEIGHT_SLACK):
        yield Fault("OBJECT_PARENT", item.id, f"is not within the height of {parent.id}")
    if item.mount == "surface" and (below or low > parent_high + HEIGHT_SLACK):
        yield Fault("OBJECT_FLOATS", item.id, f"its lower side is at {low:.2f} m, above the top of {parent.id}")


def _overlaps(placed: Sequence[Placed]) -> Iterator[Fault]:
    items = [item for item, _ in placed if item.size[2] > WALKABLE_HEIGHT]
    if not items:
        return
    shapes = [shape for item, shape in placed if item.size[2] > WALKABLE_HEIGHT]
    tree = STRtree(shapes)
    first, second = tree.query(shapes, predicate="intersects")
    known = {item.id: item for item, _ in placed}
    carried_by = [carriers(item, known) for item in items]
    for index, other in sorted(zip(first.tolist(), second.tolist())):
        if items[index].id in carried_by[other] or items[other].id in carried_by[index]:
            continue
        if other > index and _collide(items[index], items[other], shapes[index], shapes[other]):
            where = f"{items[index].id} and {items[other].id}"
            yield Fault("OBJECT_OVERLAP", where, "overlap")


def carriers(item: SceneObject, items: Mapping[str, SceneObject]) -> set[str]:
    """Return the ids of what carries an object, and of what carries that (a cup on a tray on a table)."""
    found: set[str] = set()
    while item.parent is not None and item.parent not in found:
        found.add(item.parent)
        if item.parent not in items:
            break
        item = items[item.parent]
    return found


def _collide(one: SceneObject, other: SceneObject, shape: Polygon, second: Polygon) -> bool:
    nested = one.parent is not None and one.parent == other.parent and one.mount != other.mount
    if nested:
        return False
    (low, high), (low2, high2) = vertical(one), vertical(other)
    in_height = min(high, high2) - max(low, low2) > 5e-3
    return in_height and shape.intersection(second).area > AREA_SLACK


def _before_doors(scene: FloorScene, placed: Sequence[Placed]) -> Iterator[Fault]:
    standing = [
        (item, shape)
        for item, shape in placed
        if item.mount in ("floor", "wall") and item.bottom < DOOR_HEAD and item.size[2] > WALKABLE_HEIGHT
    ]
    if not standing:
        return
    tree = STRtree([shape for _, shape in standing])
    for door in scene.doors:
        line = LineString(door.segment)
        area = line.buffer(doorway_depth(line.length, is_open=door.kind == "open"), cap_style="flat")
        for index in sorted(tree.query(area)):
            item, shape = standing[index]
            near = item.room in door.rooms
            if near and area.intersection(shape).area > AREA_SLACK:
                yield Fault("DOOR_BLOCKED", door.id, f"{item.id} stands in front of it")


BESIDE: Final = 0.3
"""Metres by which a lamp may lie off its room: on the face of a wall, say."""


def check_lights(scene: FloorScene) -> Iterator[Fault]:
    """Yield lamps that are not in their rooms; the sun is nowhere in particular."""
    rooms = {room.id: room for room in scene.rooms}
    outline = Polygon(scene.outline, scene.holes)
    for light in scene.lights:
        if light.kind == "directional":
            continue
        x, y, z = light.position
        room = rooms.get(light.room or "")
        if light.room is not None and room is None:
            yield Fault("LIGHT_ROOM", light.id, f"is in {light.room!r}, which does not exist")
            continue
        place = outline if room is None else room_area(room)
        ceiling = scene.height if room is None else room.ceiling_height
        if place.distance(Point(x, y)) > BESIDE or not -BESIDE <= z <= ceiling + BESIDE:
            yield Fault("LIGHT_OUTSIDE", light.id, f"is outside {light.room or 'the building'}")

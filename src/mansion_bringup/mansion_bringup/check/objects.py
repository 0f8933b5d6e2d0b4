"""Checks that every object is in its room, overlaps no other and rests on what carries it."""

from collections.abc import Iterator, Mapping

from shapely import LineString, Polygon, STRtree

from mansion_bringup.check.fault import Fault
from mansion_bringup.check.shapes import net_area, vertical
from mansion_geometry.object_footprints import footprint
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom

__all__ = ["carriers", "check_objects"]

AREA_SLACK = 1e-3
"""Square metres by which footprints may overlap or overhang from rounding."""

WALKABLE_HEIGHT = 0.03
"""An object lower than this (a rug) is walked over."""

DOOR_DEPTH = 0.6
"""Depth of the area before a door that must stay clear, metres."""

HEIGHT_SLACK = 0.03


def check_objects(scene: FloorScene) -> Iterator[Fault]:
    """Yield faults of the objects' poses."""
    rooms = {room.id: room for room in scene.rooms}
    items = {item.id: item for item in scene.objects}
    nets = {name: net_area(room).buffer(2e-3) for name, room in rooms.items()}
    for item in scene.objects:
        yield from _in_room(item, rooms, nets)
        if item.mount in ("surface", "inside"):
            yield from _on_parent(item, items)
        elif item.mount == "floor" and abs(vertical(item)[0]) > HEIGHT_SLACK:
            yield Fault("OBJECT_FLOATS", item.id, f"its lower side is at {vertical(item)[0]:.2f} m")
    yield from _overlaps(scene)
    yield from _before_doors(scene)


def _in_room(item: SceneObject, rooms: dict[str, SceneRoom], nets: dict[str, Polygon]) -> Iterator[Fault]:
    room = rooms.get(item.room)
    if room is None:
        yield Fault("OBJECT_ROOM", item.id, f"is in {item.room!r}, which does not exist")
        return
    beyond = footprint(item).difference(nets[room.id]).area
    if beyond > AREA_SLACK:
        yield Fault("OBJECT_OUTSIDE", item.id, f"{beyond:.3f} m2 extend beyond {room.id}")
    low, high = vertical(item)
    if low < -HEIGHT_SLACK or high > room.ceiling_height + HEIGHT_SLACK:
        yield Fault("OBJECT_OUTSIDE", item.id, f"reaches from {low:.2f} m to {high:.2f} m")


def _on_parent(item: SceneObject, items: dict[str, SceneObject]) -> Iterator[Fault]:
    parent = items.get(item.parent or "")
    if parent is None:
        yield Fault("OBJECT_PARENT", item.id, f"is on {item.parent!r}, which does not exist")
        return
    shared = footprint(item).intersection(footprint(parent)).area
    if shared < 0.5 * footprint(item).area:
        yield Fault("OBJECT_PARENT", item.id, f"is not over {parent.id}")
    low, high = vertical(item)
    parent_low, parent_high = vertical(parent)
    below = low < parent_low - HEIGHT_SLACK
    if item.mount == "inside" and (below or high > parent_high + HEIGHT_SLACK):
        yield Fault("OBJECT_PARENT", item.id, f"is not within the height of {parent.id}")
    if item.mount == "surface" and (below or low > parent_high + HEIGHT_SLACK):
        yield Fault("OBJECT_FLOATS", item.id, f"its lower side is at {low:.2f} m, above the top of {parent.id}")


def _overlaps(scene: FloorScene) -> Iterator[Fault]:
    items = [item for item in scene.objects if item.size[2] > WALKABLE_HEIGHT]
    if not items:
        return
    shapes = [footprint(item) for item in items]
    tree = STRtree(shapes)
    first, second = tree.query(shapes, predicate="intersects")
    known = {item.id: item for item in scene.objects}
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


def _before_doors(scene: FloorScene) -> Iterator[Fault]:
    standing = [
        item
        for item in scene.objects
        if item.mount in ("floor", "wall") and vertical(item)[0] < 1.9 and item.size[2] > WALKABLE_HEIGHT
    ]
    if not standing:
        return
    shapes = [footprint(item) for item in standing]
    tree = STRtree(shapes)
    for door in scene.doors:
        area = LineString(door.segment).buffer(DOOR_DEPTH, cap_style="flat")
        for index in sorted(tree.query(area)):
            item = standing[index]
            near = item.room in door.rooms
            if near and area.intersection(shapes[index]).area > AREA_SLACK:
                yield Fault("DOOR_BLOCKED", door.id, f"{item.id} stands in front of it")

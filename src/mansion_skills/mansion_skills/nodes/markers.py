"""What RViz shows of a floor: rooms, doors, objects and robots."""

from collections.abc import Iterable

from builtin_interfaces.msg import Time
from geometry_msgs.msg import Point
from std_msgs.msg import ColorRGBA
from visualization_msgs.msg import Marker, MarkerArray

from mansion_msgs_py.world import Pose2D
from mansion_skills.nodes.frames import heading, pose
from mansion_skills.world.world import World

__all__ = ["floor_markers"]

ROOM = (0.35, 0.45, 0.6, 1.0)
DOOR_OPEN, DOOR_CLOSED = (0.2, 0.7, 0.3, 1.0), (0.8, 0.2, 0.2, 1.0)
OBJECT, PICKUPABLE = (0.65, 0.55, 0.4, 0.8), (0.95, 0.7, 0.1, 1.0)
ROBOT = (0.1, 0.3, 0.9, 1.0)


def floor_markers(world: World, floor: int, frame: str, stamp: Time) -> MarkerArray:
    """Return the markers of a floor in the frame of the building; they replace those of the floor before."""
    elevation = world.building.entry(floor).elevation
    clear = Marker(action=Marker.DELETEALL)
    clear.header.frame_id, clear.header.stamp = frame, stamp
    markers = [clear]

    def add(space: str, kind: int, color: tuple[float, float, float, float]) -> Marker:
        marker = Marker(ns=space, id=len(markers), type=kind, action=Marker.ADD)
        marker.header.frame_id, marker.header.stamp = frame, stamp
        marker.color = ColorRGBA(r=color[0], g=color[1], b=color[2], a=color[3])
        marker.pose.orientation = heading(0.0)
        markers.append(marker)
        return marker

    view = world.view(floor)
    for room in view.scene.rooms:
        outline = add("rooms", Marker.LINE_STRIP, ROOM)
        outline.scale.x = 0.05
        outline.points = _points([*room.polygon, room.polygon[0]], elevation + 0.02)
        name = add("room_names", Marker.TEXT_VIEW_FACING, ROOM)
        name.scale.z, name.text = 0.4, room.name or room.id
        x, y = (sum(p[i] for p in room.polygon) / len(room.polygon) for i in (0, 1))
        name.pose = pose(Pose2D(x=x, y=y), elevation + 0.5)
    for door in view.scene.doors:
        is_open = world.doors.get(door.id, door.is_open)
        line = add("doors", Marker.LINE_STRIP, DOOR_OPEN if is_open else DOOR_CLOSED)
        line.scale.x = 0.1
        line.points = _points(door.segment, elevation + 0.05)
    for state in world.objects.on_floor(floor):
        kind = world.objects.kinds[state.id]
        if state.position is None:
            continue
        box = add("objects", Marker.CUBE, PICKUPABLE if kind.pickupable else OBJECT)
        box.scale.x, box.scale.y, box.scale.z = (float(edge) for edge in kind.size)
        x, y, z = state.position
        box.pose = pose(Pose2D(x=x, y=y, yaw=state.rotation), elevation + z)
    for robot in world.robots.values():
        if robot.floor == floor:
            body = add("robots", Marker.CYLINDER, ROBOT)
            body.scale.x = body.scale.y = 2 * robot.radius
            body.scale.z = 1.2
            body.pose = pose(robot.pose, elevation + 0.6)
    return MarkerArray(markers=markers)


def _points(line: Iterable[tuple[float, float]], z: float) -> list[Point]:
    return [Point(x=float(x), y=float(y), z=z) for x, y in line]

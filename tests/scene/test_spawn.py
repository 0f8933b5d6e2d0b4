"""Where the robot starts."""

from types import ModuleType

import msgspec
import pytest
from shapely.geometry import LineString, Point, Polygon

from mansion_geometry.object_footprints import footprint
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import SceneObject, SceneRoom
from mansion_scene.spawn import place_spawn
from mansion_scene.structure import build_structure


def block(room: SceneRoom, x: float, y: float, w: float, d: float, rotation: float = 0.0) -> SceneObject:
    return SceneObject(
        id=f"{room.id}/block_{x}_{y}",
        room=room.id,
        category="block",
        asset="block",
        position=(x, y, 0.5),
        rotation=rotation,
        size=(w, d, 1.0),
    )


def test_the_robot_stands_free_in_the_hub(sample_floors: ModuleType) -> None:
    for seed in range(20):
        structure = build_structure(sample_floors.random_floor(seed))
        hub = structure.rooms[0]
        pose = place_spawn(hub, structure.doors, [])
        assert pose.room == hub.id and pose.yaw in (0.0, 90.0, 180.0, 270.0)
        assert Polygon(hub.net_polygon).buffer(-0.2).covers(Point(pose.x, pose.y))


def test_it_keeps_off_furniture_and_on_the_side_of_the_doors(sample_floors: ModuleType) -> None:
    structure = build_structure(sample_floors.flat())
    hub = structure.rooms[0]
    # A wall of cupboards across the living room leaves the north end without entrance and kitchen.
    objects = [block(hub, 2.0, 5.0, 3.9, 0.6), block(hub, 1.0, 1.0, 0.8, 0.8, 30.0)]
    pose = place_spawn(hub, structure.doors, objects)
    here = Point(pose.x, pose.y)
    assert all(footprint(item).distance(here) >= 0.2 for item in objects)
    way = LineString([here, (5.9, 2.0)])
    assert not way.crosses(footprint(objects[0]))


def test_a_room_full_to_the_brim_is_refused(sample_floors: ModuleType) -> None:
    structure = build_structure(sample_floors.flat())
    hub = structure.rooms[0]
    with pytest.raises(MansionError, match="no free position"):
        place_spawn(hub, structure.doors, [block(hub, 4.0, 4.0, 9.0, 9.0)])


def test_what_hangs_high_is_no_obstacle(sample_floors: ModuleType) -> None:
    structure = build_structure(sample_floors.flat())
    hub = structure.rooms[0]
    lamp = msgspec.structs.replace(block(hub, 3.0, 2.0, 9.0, 9.0), mount="ceiling", position=(3.0, 2.0, 2.5))
    assert place_spawn(hub, structure.doors, [lamp]) == place_spawn(hub, structure.doors, [])

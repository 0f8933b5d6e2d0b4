"""Rooms are furnished around what stands in them already."""

import pytest
from shapely.geometry import Polygon

from mansion_assets.catalogue import load_catalogue
from mansion_geometry.object_footprints import footprint
from mansion_msgs_py.program import RequestedObject
from mansion_msgs_py.scene import Door, FloorScene, SceneObject, SceneRoom
from mansion_scene.decor.frames import scene_object
from mansion_scene.refurnishing import furnish_room
from mansion_scene.standing_objects import floor_around

RING = [(0.0, 0.0), (5.0, 0.0), (5.0, 4.0), (0.0, 4.0)]
ROOM = SceneRoom(
    id="F1/bedroom", room_type="bedroom", kind="main", polygon=RING, net_polygon=RING, area=20.0, ceiling_height=2.8
)
SCENE = FloorScene(
    building_id="b", floor=1, floors=1, label="1", elevation=0.0, height=3.0, outline=RING, rooms=[ROOM], walls=[],
    doors=[Door(id="F1/door_1", kind="single", segment=((4.0, 0.0), (4.9, 0.0)), rooms=(ROOM.id, None), width=0.9,
                height=2.1)],
)  # fmt: skip


def _piece(category: str, x: float, y: float, height: float = 0.0, turn: float = 0.0) -> SceneObject:
    asset = load_catalogue().by_category(category)[0]
    return scene_object(asset, f"{ROOM.id}/{category}_1", ROOM.id, (x, y, height or asset.size[2] / 2), turn)


@pytest.mark.parametrize(
    ("piece", "takes"),
    [
        (_piece("wardrobe", 2.5, 2.0), True),
        (_piece("radiator", 2.5, 0.05, 0.4), True),
        (_piece("exit_sign", 2.5, 0.05, 2.4), False),
        (_piece("smoke_detector", 2.5, 2.0, 2.7), False),
        (_piece("rug", 2.5, 2.0), False),
    ],
    ids=lambda value: getattr(value, "category", None),
)
def test_what_stands_and_what_hangs_low_takes_floor(piece: SceneObject, takes: bool) -> None:
    free = floor_around(ROOM, [piece])
    area = Polygon(free.net_polygon, free.net_holes).area
    assert (area < 20.0) == takes and (free == ROOM) != takes


def test_new_furniture_keeps_clear_of_what_stands_and_takes_other_ids() -> None:
    wardrobe = _piece("wardrobe", 0.8, 3.6, turn=180.0)
    lamp = _piece("smoke_detector", 2.5, 2.0, 2.775)
    new, _ = furnish_room(SCENE, ROOM, [wardrobe, lamp], [], 3, load_catalogue())
    beds = [item for item in new if item.category in ("bed", "single_bed")]
    standing = [item for item in new if item.mount == "floor" and item.size[2] > 0.03]
    assert beds and wardrobe.id not in {item.id for item in new} and lamp.id not in {item.id for item in new}
    assert all(footprint(item).intersection(footprint(wardrobe)).area < 1e-3 for item in standing)
    above = [footprint(item) for item in new if item.mount == "ceiling"]
    assert all(shape.intersection(footprint(lamp)).area == 0.0 for shape in above)
    assert not any(item.parent == wardrobe.id for item in new)


def test_what_nobody_wants_more_of_is_not_brought() -> None:
    new, _ = furnish_room(SCENE, ROOM, [], [RequestedObject(category="bed", count=0)], 3, load_catalogue())
    assert new and not any(item.category in ("bed", "single_bed") for item in new)

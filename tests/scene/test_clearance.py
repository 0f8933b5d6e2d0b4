"""What hangs on walls closes no way, and rooms are furnished around what stands in them."""

import pytest
from shapely.geometry import Polygon

from mansion_assets.catalogue import load_catalogue
from mansion_geometry.object_footprints import footprint
from mansion_geometry.robot_body import BODY_RADIUS
from mansion_msgs_py.placement import PlacementOpening
from mansion_msgs_py.program import RequestedObject
from mansion_msgs_py.scene import Door, FloorScene, SceneObject, SceneRoom
from mansion_scene.clearance import clear_of_ways, floor_around
from mansion_scene.decor.frames import scene_object
from mansion_scene.refurnishing import furnish_room

ROOM = Polygon([(0, 0), (6, 0), (6, 2), (0, 2)])
DOOR = PlacementOpening(segment=((0.0, 0.5), (0.0, 1.4)))


def thing(name: str, x: float, y: float, size: tuple[float, float, float], **more) -> SceneObject:
    z = more.pop("z", size[2] / 2)
    return SceneObject(
        id=name, room="r", category=name, asset=name, position=(x, y, z), rotation=0.0, size=size, **more
    )


STALL = thing("stall", 3.0, 1.25, (1.0, 1.5, 2.0))
BASIN = thing("basin", 5.5, 1.7, (0.6, 0.5, 0.9))
DRYER = thing("dryer", 3.0, 0.11, (0.3, 0.22, 0.3), mount="wall", z=1.2)


def left(hung: list[SceneObject]) -> list[str]:
    return [item.id for item in clear_of_ways(hung, [STALL, BASIN], ROOM, [DOOR])]


def test_a_dryer_that_narrows_the_only_way_goes_with_what_lies_on_it():
    soap = thing("soap", 3.0, 0.11, (0.1, 0.1, 0.1), mount="surface", parent="dryer", z=1.4)
    clock = thing("clock", 3.0, 0.02, (0.3, 0.03, 0.3), mount="wall", z=2.2)
    assert left([DRYER, soap, clock]) == ["clock"]


def test_it_stays_where_there_is_room():
    assert left([thing("dryer", 5.0, 0.11, (0.3, 0.22, 0.3), mount="wall", z=1.2)]) == ["dryer"]


def test_nothing_low_hangs_beside_the_door():
    low = thing("hook", 0.4, 0.6, (0.2, 0.05, 0.2), mount="wall", z=1.2)
    high = thing("sign", 0.4, 0.6, (0.2, 0.05, 0.2), mount="wall", z=2.6)
    assert left([low, high]) == ["sign"]


def test_what_leaves_less_than_the_robot_needs_goes() -> None:
    needs = 2 * BODY_RADIUS
    for gap, stays in ((needs - 0.004, []), (needs + 0.004, ["shelf"])):
        shelf = thing("shelf", 3.0, (0.5 - gap) / 2, (0.3, 0.5 - gap, 0.3), mount="wall", z=1.2)
        assert left([shelf]) == stays


def test_what_is_thin_narrows_a_way_too() -> None:
    gap = 2 * BODY_RADIUS + 0.005
    stall = thing("stall", 3.0, 1.0 + gap / 2, (1.0, 2.0 - gap, 2.0))
    board = thing("board", 3.0, 0.005, (0.3, 0.01, 0.3), mount="wall", z=1.2)
    assert [item.id for item in clear_of_ways([board], [stall, BASIN], ROOM, [DOOR])] == []


RING = [(0.0, 0.0), (5.0, 0.0), (5.0, 4.0), (0.0, 4.0)]
BEDROOM = SceneRoom(
    id="F1/bedroom", room_type="bedroom", kind="main", polygon=RING, net_polygon=RING, area=20.0, ceiling_height=2.8
)
SCENE = FloorScene(
    building_id="b", floor=1, floors=1, label="1", elevation=0.0, height=3.0, outline=RING, rooms=[BEDROOM], walls=[],
    doors=[Door(id="F1/door_1", kind="single", segment=((4.0, 0.0), (4.9, 0.0)), rooms=(BEDROOM.id, None), width=0.9,
                height=2.1)],
)  # fmt: skip


def _piece(category: str, x: float, y: float, height: float = 0.0, turn: float = 0.0) -> SceneObject:
    asset = load_catalogue().by_category(category)[0]
    return scene_object(asset, f"{BEDROOM.id}/{category}_1", BEDROOM.id, (x, y, height or asset.size[2] / 2), turn)


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
    free = floor_around(BEDROOM, [piece])
    area = Polygon(free.net_polygon, free.net_holes).area
    assert (area < 20.0) == takes and (free == BEDROOM) != takes


def test_new_furniture_keeps_clear_of_what_stands_and_takes_other_ids() -> None:
    wardrobe = _piece("wardrobe", 0.8, 3.6, turn=180.0)
    lamp = _piece("smoke_detector", 2.5, 2.0, 2.775)
    new, _ = furnish_room(SCENE, BEDROOM, [wardrobe, lamp], [], 3, load_catalogue())
    beds = [item for item in new if item.category in ("bed", "single_bed")]
    standing = [item for item in new if item.mount == "floor" and item.size[2] > 0.03]
    assert beds and wardrobe.id not in {item.id for item in new} and lamp.id not in {item.id for item in new}
    assert all(footprint(item).intersection(footprint(wardrobe)).area < 1e-3 for item in standing)
    above = [footprint(item) for item in new if item.mount == "ceiling"]
    assert all(shape.intersection(footprint(lamp)).area == 0.0 for shape in above)
    assert not any(item.parent == wardrobe.id for item in new)


def test_what_nobody_wants_more_of_is_not_brought() -> None:
    new, _ = furnish_room(SCENE, BEDROOM, [], [RequestedObject(category="bed", count=0)], 3, load_catalogue())
    assert new and not any(item.category in ("bed", "single_bed") for item in new)

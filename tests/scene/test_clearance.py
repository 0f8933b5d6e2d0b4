"""What hangs on walls is left out where it closes a way, and stays where it does not."""

from shapely.geometry import Polygon

from mansion_geometry.robot_body import BODY_RADIUS
from mansion_msgs_py.placement import PlacementOpening
from mansion_msgs_py.scene import SceneObject
from mansion_scene.clearance import clear_of_ways

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

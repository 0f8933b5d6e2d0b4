"""``mansion edit``'s independent check and the files that follow an edit."""

import msgspec

from mansion_bringup.edit_hooks import new_faults
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom


def _scene(*objects: SceneObject) -> FloorScene:
    ring = [(0.0, 0.0), (6.0, 0.0), (6.0, 6.0), (0.0, 6.0)]
    room = SceneRoom(
        id="F1/hall", room_type="hall", kind="main", polygon=ring, net_polygon=ring, area=36.0
    )
    return FloorScene(
        building_id="b", floor=1, floors=1, label="1", elevation=0.0, height=3.0,
        outline=ring, rooms=[room], walls=[], doors=[], objects=list(objects),
    )  # fmt: skip


def _box(name: str, x: float, y: float = 3.0) -> SceneObject:
    return SceneObject(
        id=name, room="F1/hall", category="box", asset="box", position=(x, y, 0.5), rotation=0.0, size=(1.0, 1.0, 1.0)
    )  # fmt: skip


def test_an_overlap_is_a_new_fault_and_an_old_one_is_not() -> None:
    one, other = _box("F1/hall/box_1", 2.0), _box("F1/hall/box_2", 4.0)
    apart = _scene(one, other)
    pushed = _scene(one, msgspec.structs.replace(other, position=(2.5, 3.0, 0.5)))
    found = new_faults({1: apart}, {1: pushed})
    assert len(found) == 1 and "stand in each other" in found[0]
    third = _scene(*pushed.objects, _box("F1/hall/box_3", 5.0, 5.0))
    assert new_faults({1: pushed}, {1: third}) == []


def test_what_leaves_its_room_is_refused() -> None:
    inside, outside = _scene(_box("F1/hall/box_1", 2.0)), _scene(_box("F1/hall/box_1", 6.2))
    assert any("stand out of F1/hall" in fault for fault in new_faults({1: inside}, {1: outside}))

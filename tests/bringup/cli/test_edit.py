"""``mansion edit``'s independent check and the files that follow an edit."""

import msgspec
import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_bringup.check.integrity import check_identity
from mansion_bringup.check.objects import check_objects
from mansion_bringup.check.reach import check_reach
from mansion_bringup.edit_hooks import new_faults
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom


def _scene(*objects: SceneObject) -> FloorScene:
    ring = [(0.0, 0.0), (6.0, 0.0), (6.0, 6.0), (0.0, 6.0)]
    room = SceneRoom(id="F1/hall", room_type="hall", kind="main", polygon=ring, net_polygon=ring, area=36.0)
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
    assert len(found) == 1 and "overlap" in found[0]
    third = _scene(*pushed.objects, _box("F1/hall/box_3", 5.0, 5.0))
    assert new_faults({1: pushed}, {1: third}) == []


def test_what_leaves_its_room_is_refused() -> None:
    inside, outside = _scene(_box("F1/hall/box_1", 2.0)), _scene(_box("F1/hall/box_1", 6.2))
    assert any("extend beyond F1/hall" in fault for fault in new_faults({1: inside}, {1: outside}))


def test_a_floor_with_other_walls_is_judged_whole() -> None:
    before = _scene(_box("F1/hall/box_1", 2.0))
    half = [(0.0, 0.0), (3.0, 0.0), (3.0, 6.0), (0.0, 6.0)]
    room = msgspec.structs.replace(before.rooms[0], polygon=half, net_polygon=half, area=18.0)
    found = new_faults({1: before}, {1: msgspec.structs.replace(before, rooms=[room])})
    assert any(fault.startswith("COVERAGE") for fault in found)
    assert new_faults({1: before}, {1: before, 2: msgspec.structs.replace(before, floor=2)})
    renamed = msgspec.structs.replace(before.rooms[0], name="Hall of mirrors", wall_material="white_marble")
    assert new_faults({1: before}, {1: msgspec.structs.replace(before, rooms=[renamed])}) == []


def test_what_lies_in_a_bowl_in_a_box_overlaps_neither() -> None:
    box = _box("F1/hall/box_1", 2.0)
    bowl = msgspec.structs.replace(_box("F1/hall/bowl_1", 2.0), size=(0.4, 0.4, 0.3), mount="inside", parent=box.id)
    apple = msgspec.structs.replace(_box("F1/hall/apple_1", 2.0), size=(0.1, 0.1, 0.1), mount="inside", parent=bowl.id)
    loose = msgspec.structs.replace(apple, parent=None, mount="floor")
    assert not any(f.endswith("overlap") for f in _whole_check(_scene(box, bowl, apple)))
    assert any(f.endswith("overlap") for f in _whole_check(_scene(box, bowl, loose)))


def _whole_check(scene: FloorScene) -> set[str]:
    faults = [*check_identity("b", [scene]), *check_objects(scene), *check_reach([scene])]
    return {str(fault) for fault in faults}


def _stacked(rng: np.random.Generator) -> list[SceneObject]:
    """Return boxes about the hall, some of them on others."""
    things: list[SceneObject] = []
    for number in range(int(rng.integers(4, 12))):
        x, y = (float(v) for v in rng.uniform(0.3, 5.7, 2))
        thing = msgspec.structs.replace(_box(f"F1/hall/box_{number}", x, y), size=(0.8, 0.8, 1.0))
        if things and rng.random() < 0.4:
            carrier = things[int(rng.integers(len(things)))]
            x, y, z = carrier.position
            thing = msgspec.structs.replace(
                thing,
                size=(0.3, 0.3, 0.2),
                position=(x, y, z + carrier.size[2] / 2 + 0.1),
                mount="surface",
                parent=carrier.id,
            )
        things.append(thing)
    return things


@settings(deadline=None, max_examples=60)
@given(st.integers(0, 10_000))
def test_judging_what_changed_finds_all_that_the_whole_check_finds(seed: int) -> None:
    rng = np.random.default_rng(seed)
    things = _stacked(rng)
    edited = list(things)
    for _ in range(int(rng.integers(1, 3))):
        at = int(rng.integers(len(edited)))
        if rng.random() < 0.3 and len(edited) > 1:
            edited.pop(at)
            continue
        x, y = (float(v) for v in rng.uniform(0.3, 5.7, 2))
        moved = msgspec.structs.replace(edited[at], position=(x, y, edited[at].position[2]))
        edited[at] = moved
    before, after = _scene(*things), _scene(*edited)
    assert set(new_faults({1: before}, {1: after})) == _whole_check(after) - _whole_check(before)

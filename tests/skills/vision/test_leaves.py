"""The camera hangs doors as the building's models do."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_export.meshes.opening_meshes import leaf_parts
from mansion_msgs_py.scene import Door
from mansion_skills.vision.articulation import leaves_of
from sample_building import scene

SCENE = scene(1, [1])
HALL, OFFICE = "F1/hall", "F1/office"


def room_at(x: float, y: float) -> str | None:
    return HALL if y < 3.0 else OFFICE


@given(
    kind=st.sampled_from(["single", "double", "glazed", "sliding", "entrance", "doorway", "frame"]),
    hinge=st.sampled_from(["start", "end", "both", "none"]),
    swing=st.sampled_from([HALL, OFFICE, None]),
    rooms=st.sampled_from([(HALL, OFFICE), (OFFICE, HALL)]),
    backwards=st.booleans(),
    is_open=st.booleans(),
)
@settings(max_examples=200, deadline=None)
def test_leaves_are_where_the_exported_model_has_them(
    kind: str, hinge: str, swing: str | None, rooms: tuple[str, str], backwards: bool, is_open: bool
) -> None:
    ends = ((2.0, 3.0), (3.5, 3.0))
    door = Door(
        id="F1/door_1",
        kind=kind,
        segment=(ends[1], ends[0]) if backwards else ends,
        rooms=rooms,
        width=1.5,
        height=2.1,
        wall="w1",
        hinge=hinge,
        swing=swing,
        is_open=is_open,
    )
    SCENE.doors[:] = [door]
    expected = [node for node, _ in leaf_parts(SCENE)]
    leaves = leaves_of(door, 1.0 if is_open else 0.0, room_at)
    assert [leaf.name for leaf in leaves] == [node.id for node in expected]
    for leaf, node in zip(leaves, expected):
        assert (leaf.x, leaf.y) == pytest.approx(node.position[:2], abs=1e-6)
        assert (leaf.yaw - node.rotation) % 360.0 == pytest.approx(0.0, abs=1e-6) or (
            leaf.yaw - node.rotation
        ) % 360.0 == pytest.approx(360.0, abs=1e-6)


def test_a_sliding_door_can_stand_half_open() -> None:
    door = next(door for door in scene(1, [1]).doors if door.kind == "sliding")
    shut, half, wide = (leaves_of(door, opening, room_at) for opening in (0.0, 0.5, 1.0))
    for a, b, c in zip(shut, half, wide):
        assert (a.x + c.x) / 2 == pytest.approx(b.x)
        assert (a.y + c.y) / 2 == pytest.approx(b.y)

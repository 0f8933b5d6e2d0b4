"""What objects cover on the floor, and which of them stop a robot."""

import pytest

from mansion_geometry.object_footprints import footprint, footprints, stops_robots
from mansion_msgs_py.scene import SceneObject


@pytest.mark.parametrize(
    ("height", "size", "mount", "expected"),
    [
        (0.4, 0.8, "floor", True),
        (0.01, 0.02, "floor", False),
        (2.2, 0.3, "ceiling", False),
        (1.4, 0.6, "wall", True),
        (0.9, 0.2, "surface", False),
        (0.4, 0.2, "inside", False),
    ],
)
def test_what_is_flat_hangs_high_or_is_carried_stops_nobody(
    height: float, size: float, mount: str, expected: bool
) -> None:
    item = SceneObject(
        id="F1/hall/thing_1", room="F1/hall", category="thing", asset="thing", mount=mount, position=(0.0, 0.0, height),
        rotation=0.0, size=(0.5, 0.5, size),
    )  # fmt: skip
    assert stops_robots(item) is expected


def test_footprints_of_many_are_those_of_each() -> None:
    items = [
        SceneObject(
            id=f"F1/hall/thing_{number}", room="F1/hall", category="thing", asset="thing", mount="floor",
            position=(number, 0.5 * number, 0.4), rotation=37.0 * number, size=(0.5, 0.3 + 0.1 * number, 0.8),
        )
        for number in range(5)
    ]  # fmt: skip
    assert list(footprints(items)) == [footprint(item) for item in items]
    assert len(footprints([])) == 0

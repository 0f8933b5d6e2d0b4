"""Which objects stop a robot."""

import pytest

from mansion_geometry.object_footprints import stops_robots
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

"""What a landmark may be called."""

import pytest

from mansion_msgs_py.world import Pose2D
from mansion_skills.world.floor_view import Landmark, landmark_named

HERE = Pose2D(x=0.0, y=0.0)
LANDMARKS = [
    Landmark("stair_1", "stair", 1, HERE),
    Landmark("F1/kitchen", "room", 1, HERE, ("The Trough", "Kitchen", "Hall")),
    Landmark("F1/room_2", "room", 1, HERE, ("Canteen",)),
    Landmark("F1/hall", "room", 1, HERE, ("Lobby", "canteen")),
]


@pytest.mark.parametrize(
    ("words", "name"),
    [
        ("F1/kitchen", "F1/kitchen"), ("kitchen", "F1/kitchen"), ("the trough", "F1/kitchen"), ("stairs", "stair_1"),
        ("hall", "F1/hall"), ("canteen", "F1/room_2"), ("CANTEEN", "F1/room_2"), ("lobby", "F1/hall"),
    ],
)  # fmt: skip
def test_a_room_goes_by_its_id_then_its_name_then_its_other_names(words: str, name: str) -> None:
    found = landmark_named(words, LANDMARKS, 1, (0.0, 0.0))
    assert found is not None and found.name == name


def test_what_nothing_is_called_is_no_landmark() -> None:
    assert landmark_named("the moon", LANDMARKS, 1, (0.0, 0.0)) is None

"""Rooms that have another type's furniture because of their building or their name."""

import pytest

from mansion_knowledge.furnished_as import furnished_as


@pytest.mark.parametrize(
    ("room_type", "building_type", "name", "expected"),
    [
        ("treatment_room", "dental_clinic", "treatment room", "dental_room"),
        ("treatment_room", "hospital", "treatment room", "treatment_room"),
        ("gym", "school", "gym", "sports_hall"),
        ("gym", "gym_building", "gym", "gym"),
        ("workshop", "car_dealership", "repair workshop", "car_workshop"),
        ("vip_room", "restaurant", "Private dining room", "private_dining_room"),
        ("vip_room", "casino", "vip room", "vip_room"),
        ("bedroom", "", "", "bedroom"),
    ],
)
def test_building_and_name_say_how_a_room_is_furnished(
    room_type: str, building_type: str, name: str, expected: str
) -> None:
    assert furnished_as(room_type, building_type, name) == expected

"""Vehicles in halls of bays."""

import pytest

from mansion_msgs_py.placement import PlacementObject, PlacementOpening, PlacementRoom
from mansion_scene.placement import place_room


def bay(doors: int) -> PlacementRoom:
    """Return a hall of 20 m with doors of 3.8 m in its south wall."""
    middles = [20.0 * (number + 0.5) / doors for number in range(doors)]
    return PlacementRoom(
        room_id="bay",
        room_type="apparatus_bay",
        polygon=[(0, 0), (20, 0), (20, 9), (0, 9)],
        doors=[PlacementOpening(segment=((x - 1.9, 0), (x + 1.9, 0))) for x in middles],
        objects=[PlacementObject(name="fire_engine", size=(2.35, 6.0, 2.95), quantity=doors)],
    )


@pytest.mark.parametrize("doors", [2, 3])
def test_each_vehicle_stands_behind_a_door_with_its_nose_to_it(doors: int) -> None:
    engines = place_room(bay(doors), seed=1).placements
    assert sorted(round(engine.center[0], 2) for engine in engines) == [
        pytest.approx(20.0 * (number + 0.5) / doors, abs=0.02) for number in range(doors)
    ]
    assert {round(engine.rotation) % 360 for engine in engines} == {180}

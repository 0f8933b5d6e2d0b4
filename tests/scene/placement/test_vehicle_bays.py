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


@pytest.mark.parametrize("doors", [1, 2, 3])
def test_each_vehicle_stands_behind_a_door_with_its_nose_to_it(doors: int) -> None:
    engines = place_room(bay(doors), seed=1).placements
    assert sorted(round(engine.center[0], 2) for engine in engines) == [
        pytest.approx(20.0 * (number + 0.5) / doors, abs=0.02) for number in range(doors)
    ]
    assert {round(engine.rotation) % 360 for engine in engines} == {180}


def garage(kind: str, width: float, depth: float, door: float, cars: int) -> PlacementRoom:
    """Return a garage with its door in the middle of its south wall and a door into the house in the north."""
    return PlacementRoom(
        room_id="garage",
        room_type=kind,
        polygon=[(0, 0), (width, 0), (width, depth), (0, depth)],
        doors=[
            PlacementOpening(segment=((width / 2 - door / 2, 0), (width / 2 + door / 2, 0))),
            PlacementOpening(segment=((0.5, depth), (1.4, depth))),
        ],
        objects=[
            PlacementObject(name="garage_car", size=(1.8, 4.4, 1.5), quantity=cars, global_="edge"),
            PlacementObject(name="metal_shelf", size=(1.0, 0.4, 1.8), quantity=2, global_="edge"),
        ],
    )


@pytest.mark.parametrize(
    ("kind", "width", "depth", "door", "cars"),
    [("garage", 3.4, 6.0, 2.5, 1), ("double_garage", 6.0, 6.2, 5.0, 2), ("double_garage", 8.6, 5.7, 5.0, 2)],
)
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_cars_stand_abreast_behind_the_door_of_a_garage(
    kind: str, width: float, depth: float, door: float, cars: int, seed: int
) -> None:
    placed = place_room(garage(kind, width, depth, door, cars), seed=seed).placements
    parked = [each for each in placed if each.name.startswith("garage_car")]
    assert len(parked) == cars
    assert {round(car.rotation) % 180 for car in parked} == {0}
    assert len({round(car.center[1], 2) for car in parked}) == 1
    assert all(abs(car.center[0] - width / 2) < door / 2 for car in parked)

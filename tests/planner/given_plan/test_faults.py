"""Every fault of a plan is named with floor, room and place, all of them at once."""

from collections.abc import Callable
from typing import Any

import pytest

Faults = Callable[[dict[str, Any]], list[str]]


def room(plan: dict[str, Any], name: str) -> dict[str, Any]:
    """Return the room of a name on the first floor listed."""
    found: dict[str, Any] = next(room for room in plan["floors"][0]["rooms"] if room["name"] == name)
    return found


def test_rooms_that_overlap(faults: Faults, flat: dict[str, Any]) -> None:
    room(flat, "Kitchen")["polygon"] = [[3.5, 5], [8, 5], [8, 8], [3.5, 8]]
    assert faults(flat) == ["floor 1, Living room and Kitchen at (3.75, 6.50): overlap by 1.50 m2"]


def test_a_gap_that_cuts_a_room_off(faults: Faults, flat: dict[str, Any]) -> None:
    room(flat, "Bath")["polygon"] = [[4.9, 0], [8, 0], [8, 2.2], [4.9, 2.2]]
    (told,) = (line for line in faults(flat) if "touches" in line)
    assert told.startswith("floor 1, Bath at (")
    assert told.endswith("touches no room: 0.80 m lie between it and Hall; a wall has 0.5 m at most")


def test_a_room_without_a_door(faults: Faults, flat: dict[str, Any]) -> None:
    del flat["floors"][0]["doors"][3]
    (told,) = faults(flat)
    assert told.startswith("floor 1, Bath at (6.00, 1.50): cannot be reached: it has no door;")
    assert "--complete doors" in told


def test_rooms_that_open_to_each_other_alone(faults: Faults, house: dict[str, Any]) -> None:
    house["floors"][0]["doors"] = [{"rooms": ["Landing", "Stairs"]}, {"rooms": ["Landing", "Bedroom"]}]
    (told,) = faults(house)
    assert told.startswith("floor 2, Bathroom at (8.00, 4.00): cannot be reached")


def test_a_door_that_is_on_no_wall_of_its_rooms(faults: Faults, flat: dict[str, Any]) -> None:
    flat["floors"][0]["doors"][3] = {"rooms": ["Bath", "Hall"], "at": [6, 1.5]}
    assert faults(flat) == ["floor 1, door at (6.00, 1.50): is on no wall of Bath and Hall: the nearest is 1.50 m away"]


def test_a_door_between_rooms_that_share_no_wall(faults: Faults, flat: dict[str, Any]) -> None:
    flat["floors"][0]["doors"].append({"rooms": ["Bath", "Living room"]})
    assert faults(flat) == ["floor 1, door between Bath and Living room at (6.00, 1.50): they share no wall"]


def test_a_wall_too_short_for_its_door(faults: Faults, flat: dict[str, Any]) -> None:
    room(flat, "Hall")["polygon"] = [[4, 3], [8, 3], [8, 5], [4, 5]]
    room(flat, "Bath")["polygon"] = [[4, 0], [8, 0], [8, 3], [7.4, 3], [7.4, 2], [4, 2]]
    flat["floors"][0]["rooms"].append({"name": "Store", "polygon": [[4, 2], [7.4, 2], [7.4, 3], [4, 3]]})
    flat["floors"][0]["doors"][3] = {"rooms": ["Bath", "Hall"], "at": [7.7, 3]}
    flat["floors"][0]["doors"].append({"rooms": ["Store", "Hall"]})
    (told,) = faults(flat)
    assert told.startswith("floor 1, door between Hall and Bath at (7.70, 3.00): their wall is 0.60 m long")


def test_a_door_too_narrow_to_get_through(faults: Faults, flat: dict[str, Any]) -> None:
    flat["floors"][0]["doors"][3] = {"at": [5, 3], "width": 0.5}
    assert [told for told in faults(flat) if "clear width" in told] == [
        "floor 1, door between Hall and Bath at (5.00, 3.00): a clear width of 0.50 m; at least 0.7 m are needed to get"
        " through"
    ]


def test_a_ring_that_crosses_itself(faults: Faults, flat: dict[str, Any]) -> None:
    room(flat, "Kitchen")["polygon"] = [[4, 5], [8, 8], [8, 5], [4, 8]]
    assert faults(flat) == ["floor 1, Kitchen at (6.00, 6.50): its boundary crosses or touches itself"]


def test_a_room_too_narrow_to_enter(faults: Faults, flat: dict[str, Any]) -> None:
    flat["floors"][0]["rooms"].append({"name": "Closet", "polygon": [[8, 5], [8.5, 5], [8.5, 8], [8, 8]]})
    flat["floors"][0]["doors"].append({"rooms": ["Closet", "Kitchen"]})
    assert faults(flat) == [
        "floor 1, Closet at (8.25, 6.50): is too narrow to enter; 0.72 m between wall centre lines are needed"
    ]


@pytest.mark.parametrize(("scale", "unit"), [(1000.0, "mm"), (100.0, "cm")])
def test_numbers_that_look_like_another_unit(faults: Faults, flat: dict[str, Any], scale: float, unit: str) -> None:
    for each in flat["floors"][0]["rooms"]:
        each["polygon"] = [[x * scale, y * scale] for x, y in each["polygon"]]
    (told,) = faults(flat)
    assert f'say "units": "{unit}"' in told


def test_degrees_of_longitude(faults: Faults, flat: dict[str, Any]) -> None:
    for each in flat["floors"][0]["rooms"]:
        each["polygon"] = [[13.4 + x * 1e-5, 52.5 + y * 1e-5] for x, y in each["polygon"]]
    (told,) = faults(flat)
    assert "metres in plan are expected" in told


def test_no_entrance(faults: Faults, flat: dict[str, Any]) -> None:
    del flat["floors"][0]["doors"][0]
    (told,) = faults(flat)
    assert told.startswith("floor 1: has no entrance")


def test_a_window_in_an_inner_wall(faults: Faults, flat: dict[str, Any]) -> None:
    flat["floors"][0]["windows"].append({"at": [4, 6.5]})
    assert faults(flat) == ["floor 1, window at (4.00, 6.50): is on no outer wall: the nearest is 1.50 m away"]


def test_names_that_no_room_has(faults: Faults, flat: dict[str, Any]) -> None:
    flat["floors"][0]["doors"].append({"rooms": ["Hall", "Kitchn"]})
    (told,) = faults(flat)
    assert told.startswith("floor 1, door: there is no room 'Kitchn' on this floor; did you mean Kitchen?")


def test_floors_that_nothing_joins(faults: Faults, house: dict[str, Any]) -> None:
    for floor in house["floors"]:
        floor["rooms"][3]["name"] = "Store"
        floor["doors"] = [*floor["doors"][:2], {"rooms": [floor["rooms"][0]["name"], "Store"]}, *floor["doors"][3:]]
    assert any(line.startswith("building: nothing joins its floors") for line in faults(house))


def test_stairs_that_do_not_lie_over_each_other(faults: Faults, house: dict[str, Any]) -> None:
    upper = house["floors"][0]["rooms"]
    upper[0]["polygon"], upper[3] = upper[3]["polygon"], {"name": "Stairs", "polygon": upper[0]["polygon"]}
    told = faults(house)
    assert any("nothing lies over it on floor 2" in line for line in told)
    assert any("nothing lies over it on floor 1" in line for line in told)


def test_a_stair_that_fits_nowhere(faults: Faults, house: dict[str, Any]) -> None:
    for floor in house["floors"]:
        floor["rooms"][0]["polygon"] = [[4, 2.5], [6, 2.5], [6, 8], [4, 8]]
        floor["rooms"][3] = {"name": "Stairs", "polygon": [[4, 0], [6, 0], [6, 2.5], [4, 2.5]]}
    told = faults(house)
    assert [line.split(":")[0] for line in told] == [f"floor {n}, Stairs at (5.00, 1.25)" for n in (1, 2)]
    assert "no stair with a turn fits into 2.00 x 2.50 m" in told[0]


def test_a_floor_that_is_left_out(faults: Faults, house: dict[str, Any]) -> None:
    house["floors"][0]["floor"] = 3
    assert any("floors [1, 3] lack 2" in line for line in faults(house))


def test_a_room_with_neither_polygon_nor_area(faults: Faults, flat: dict[str, Any]) -> None:
    del room(flat, "Bath")["polygon"]
    assert "floor 1, Bath: has neither a polygon nor an area" in faults(flat)


def test_all_faults_are_told_at_once(faults: Faults, flat: dict[str, Any]) -> None:
    room(flat, "Kitchen")["polygon"] = [[4, 5], [8, 8], [8, 5], [4, 8]]
    room(flat, "Anna's bedroom")["polygon"] = [[0, 0], [4, 0], [4, 3.4], [0, 3.4]]
    flat["floors"][0]["rooms"].append({"name": "Annexe", "polygon": [[10, 0], [13, 0], [13, 3], [10, 3]]})
    flat["floors"][0]["windows"].append({"at": [4, 1.5]})
    flat["floors"][0]["doors"][0] = {"rooms": ["Hall", "Cellar"]}
    told = "\n".join(faults(flat))
    for part in ("crosses", "overlap by", "Annexe at", "is on no outer wall", "'Cellar'", "has no entrance"):
        assert part in told

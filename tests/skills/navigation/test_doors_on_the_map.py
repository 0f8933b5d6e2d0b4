"""A door that swings changes the grids as making them anew would."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_skills import Robot
from mansion_skills.navigation.floor_map import Body, FloorMap
from sample_building import scene

DOORS = [door.id for door in scene(1, [1, 2]).doors]
BODIES = [
    Body("F1/office/box_1", (2.3, 3.4, 0.3), (0.5, 0.4, 0.6), 20.0, False, 1),
    Body("F1/office/shelf_1", (5.7, 4.4, 0.9), (0.9, 0.3, 1.8), 90.0, False, 2),
    Body("F1/kitchen/desk_1", (8.4, 3.3, 0.4), (1.2, 0.5, 0.8), 0.0, False, 3),
]


@given(st.lists(st.tuples(st.sampled_from(DOORS), st.booleans()), max_size=12))
@settings(max_examples=30, deadline=None)
def test_swinging_doors_gives_the_grids_of_an_update(swings: list[tuple[str, bool]]) -> None:
    made = scene(1, [1, 2])
    is_open = {door.id: door.is_open for door in made.doors}
    swung, anew = FloorMap(made, 0.2), FloorMap(made, 0.2)
    swung.update(BODIES, is_open)
    for name, wanted in swings:
        swung.swing(name, is_open=wanted)
        is_open[name] = wanted
    anew.update(BODIES, is_open)
    assert np.array_equal(swung.occupied, anew.occupied)
    assert np.array_equal(swung.blocked, anew.blocked)
    assert np.array_equal(swung.view, anew.view)


def test_grids_in_use_are_left_as_they_are(robot: Robot) -> None:
    grid = robot.engine.session("").world.view(1).map
    before, version = grid.blocked, grid.version
    copy = before.copy()
    robot.go_near_object("F1/door_1")
    robot.close_door("F1/door_1")
    assert np.array_equal(before, copy)
    assert grid.version > version and not np.array_equal(grid.blocked, copy)


@pytest.mark.parametrize("door", ["door_1", "door_2"])
def test_a_door_closed_and_opened_again_leaves_no_trace(building: Path, door: str) -> None:
    robot = Robot(building)
    grid = robot.engine.session("").world.view(1).map
    before = grid.blocked.copy()
    robot.go_near_object(f"F1/{door}")
    robot.close_door(f"F1/{door}")
    robot.open_door(f"F1/{door}")
    assert np.array_equal(grid.blocked, before)

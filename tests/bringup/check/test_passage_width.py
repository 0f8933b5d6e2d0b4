"""CheckPath, ``mansion check`` and the robot's navigation mean the same width of a way."""

import math
from collections import deque

import msgspec
import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_bringup.check.reach import check_reach
from mansion_editing.state import SceneState
from mansion_editing.tools.paths import check_path
from mansion_geometry.robot_body import ROBOT_RADIUS
from mansion_msgs_py.editing.questions import CheckPathArgs
from mansion_msgs_py.scene import Door, FloorScene
from mansion_skills.navigation.floor_map import Body, FloorMap
from sample_building import scene, thing

WEST, EAST = (1.0, 1.5), (9.0, 1.5)


def floor_with_gap(gap: float, turn: float, shift: float) -> FloorScene:
    """Return a floor whose hall two cabinets close but for a gap, the only way from the entrance to the kitchen."""
    whole = scene(1, [1])
    entrance = Door(
        id="F1/entrance",
        kind="entrance",
        segment=((0.0, 2.1), (0.0, 2.9)),
        rooms=("F1/hall", None),
        width=0.8,
        height=2.1,
        wall="w2",
    )
    hall = (5.0, 1.5 + shift)
    cabinets = []
    for number, side in ((1, 1.0), (2, -1.0)):
        away, angle = side * (gap / 2 + 1.0), math.radians(turn)
        x, y = hall[0] - math.sin(angle) * away, hall[1] + math.cos(angle) * away
        cabinets.append(thing(f"cabinet_{number}", "F1/hall", (x, y, 0.0), (1.4, 2.0, 1.0), rotation=turn))
    doors = [door for door in whole.doors if door.id != "F1/door_5"]
    return msgspec.structs.replace(
        whole,
        doors=[*doors, entrance],
        objects=[*[o for o in whole.objects if o.room != "F1/hall"], *cabinets],
        spawn=msgspec.structs.replace(whole.spawn, x=WEST[0], y=WEST[1]) if whole.spawn else None,
    )


def drives(floor: FloorScene) -> bool:
    """Whether the grid that the skills drive on leads from one end of the hall to the other."""
    grid = FloorMap(floor, ROBOT_RADIUS)
    bodies = [
        Body(item.id, item.position, item.size, item.rotation, False, number)
        for number, item in enumerate(floor.objects, start=1)
        if item.parent is None and item.mount == "floor"
    ]
    grid.update(bodies, {door.id: True for door in floor.doors})
    start, goal = grid.frame.cell(*WEST), grid.frame.cell(*EAST)
    assert grid.is_free(*WEST) and grid.is_free(*EAST)
    seen, queue = {start}, deque([start])
    while queue:
        row, column = queue.popleft()
        for step in ((0, 1), (1, 0), (0, -1), (-1, 0)):
            cell = (row + step[0], column + step[1])
            if cell not in seen and grid.frame.holds(*cell) and not grid.blocked[cell]:
                seen.add(cell)
                queue.append(cell)
    return goal in seen


def affirmed(floor: FloorScene) -> tuple[bool, bool]:
    """Whether CheckPath, and whether the building check, find the way to the kitchen."""
    state = SceneState([floor], load_catalogue())
    path = check_path(state, CheckPathArgs(end="kitchen")).reachable
    lost = {fault.where for fault in check_reach([floor]) if fault.kind == "ROOM_UNREACHABLE"}
    return path, "F1/kitchen" not in lost


@pytest.mark.parametrize(("gap", "turn"), [(0.40, 0.0), (0.45, 8.0), (0.45, 20.0), (0.45, 35.0)])
@pytest.mark.parametrize("shift", [0.0, 0.013, 0.031])
def test_what_the_checks_affirm_the_robot_drives(gap: float, turn: float, shift: float) -> None:
    floor = floor_with_gap(gap, turn, shift)
    assert affirmed(floor) == (True, True)
    assert drives(floor)


@pytest.mark.parametrize("turn", [0.0, 8.0, 20.0])
@pytest.mark.parametrize("gap", [0.30, 0.36, 0.39])
def test_neither_check_affirms_a_gap_narrower_than_the_robot(gap: float, turn: float) -> None:
    assert affirmed(floor_with_gap(gap, turn, 0.0)) == (False, False)

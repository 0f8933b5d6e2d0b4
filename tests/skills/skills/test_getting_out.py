"""A robot that stands in a corner gets out of it: by every skill that goes somewhere, and by MoveAhead's hints."""

from math import dist
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from mansion_msgs_py.world import Pose2D, SkillStatus
from mansion_skills import Robot

OK, FAILED = SkillStatus.SUCCESS, SkillStatus.EXECUTION_FAILURE
THINGS = ["mug_1", "fridge_1", "table_1", "shelf_1", "box_1", "F1/door_1", "F1/door_2"]

anywhere = settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])


def stand(robot: Robot, x: float, y: float, yaw: float = 0.0) -> None:
    robot.engine.session(robot.session).robot.pose = Pose2D(x=x, y=y, yaw=yaw)


def free_cells(robot: Robot) -> list[tuple[float, float]]:
    grid = robot.engine.session(robot.session).world.view(1).map
    return [grid.frame.center(int(r), int(c)) for r, c in np.argwhere(~grid.blocked)]


def corner_cells(robot: Robot) -> list[tuple[float, float]]:
    """Return the free cells with something beside them and something before or behind them."""
    grid = robot.engine.session(robot.session).world.view(1).map
    b = grid.blocked
    beside = np.roll(b, 1, 1) | np.roll(b, -1, 1)
    before = np.roll(b, 1, 0) | np.roll(b, -1, 0)
    return [grid.frame.center(int(r), int(c)) for r, c in np.argwhere(~b & beside & before)]


@anywhere
@given(data=st.data(), yaw=st.floats(0, 359))
def test_every_skill_that_goes_somewhere_gets_out_of_any_free_cell(
    robot: Robot, data: st.DataObject, yaw: float
) -> None:
    cells = free_cells(robot)
    start = data.draw(st.sampled_from(cells))
    goals = {
        "GoToLandmark": {"landmark": st.sampled_from(["hall", "office", "kitchen", "elevator"])},
        "GoNearObject": {"object": st.sampled_from(THINGS)},
    }
    for name, arguments in goals.items():
        stand(robot, *start, yaw)
        drawn = {key: data.draw(values) for key, values in arguments.items()}
        result = robot.skill(name, **drawn)
        assert result.status is OK, (name, drawn, start, result.message)
    stand(robot, *start, yaw)
    x, y = data.draw(st.sampled_from(cells))
    assert robot.move_to(x, y).status is OK


def test_every_corner_of_the_floor_is_left(robot: Robot) -> None:
    corners = corner_cells(robot)
    assert len(corners) > 40
    for x, y in corners:
        stand(robot, x, y)
        assert robot.go_to_landmark("hall").status is OK, (x, y)


def test_the_hints_of_moving_ahead_lead_out_of_every_corner(robot: Robot) -> None:
    for x, y in corner_cells(robot):
        for yaw in (0.0, 90.0, 200.0):
            stand(robot, x, y, yaw)
            for _ in range(6):
                result = robot.move_ahead(15.0)
                assert result.status is FAILED
                out = result.data["way_out"]
                assert f"Rotate {out['degrees']:g} and MoveAhead" in result.satisfied_by
                robot.rotate(out["degrees"])
                assert robot.move_ahead(out["meters"]).status is OK
                if dist((x, y), robot.engine.session("").robot.place) > 0.7:
                    break
            else:
                pytest.fail(f"six hints did not lead out of {(x, y, yaw)}")


def test_moving_by_what_is_said_to_be_free_succeeds(robot: Robot) -> None:
    stand(robot, 3.0, 6.5, 90.0)
    result = robot.move_ahead(2.0)
    first = result.satisfied_by.split(",")[0]
    assert first.startswith("MoveAhead ") or result.data["free"]["ahead"] == 0.0
    assert robot.move_ahead(result.data["free"]["ahead"]).status is OK


@pytest.mark.parametrize(
    ("pose", "distance", "thing"),
    [
        ((6.0, 1.5, 270.0), 3.0, "a wall"),
        ((3.0, 6.0, 90.0), 3.0, "F1/office/desk_1"),
        ((9.0, 7.0, 90.0), -3.0, "F1/kitchen/table_1"),
    ],
)
def test_the_answer_names_what_is_in_the_way(
    robot: Robot, pose: tuple[float, float, float], distance: float, thing: str
) -> None:
    stand(robot, *pose)
    result = robot.move_ahead(distance)
    assert result.status is FAILED
    assert result.data["blocked_by"] == thing
    assert f"{thing} is in the way" in result.message


def test_a_closed_door_and_another_robot_are_named_too(robot: Robot, building: Path) -> None:
    robot.go_near_object("F1/door_1")
    robot.close_door("F1/door_1")
    stand(robot, 2.45, 2.0, 90.0)
    assert robot.move_ahead(2.0).data["blocked_by"] == "F1/door_1"
    other = Robot(building, "second", engine=robot.engine)
    stand(other, 6.0, 1.5)
    stand(robot, 4.0, 1.5, 0.0)
    assert robot.move_ahead(5.0).data["blocked_by"] == "the robot of session 'second'"

"""The way on an episode's pictures is the one that was driven."""

from itertools import pairwise
from math import dist
from pathlib import Path

from episode_tasks import mug_task
from mansion_msgs_py.world import Pose2D
from mansion_skills.world.robot_body import RobotBody
from mansion_tasks.episodes.contact_sheet import Trajectory
from mansion_tasks.episodes.episode_folder import episode_folder
from mansion_tasks.episodes.port import LocalPort


def robot(x: float, y: float, floor: int = 1) -> RobotBody:
    return RobotBody("r", floor, Pose2D(x=x, y=y), 0.2)


def test_a_trail_has_the_corners_of_the_path() -> None:
    body, trajectory = robot(0.0, 0.0), Trajectory()
    trajectory.add(body)
    body.path = [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0)]
    body.move(Pose2D(x=3.0, y=2.0))
    trajectory.add(body)
    assert trajectory.points == [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0)]


def test_standing_still_adds_nothing() -> None:
    body, trajectory = robot(0.0, 0.0), Trajectory()
    body.path = [(1.0, 0.0), (0.0, 0.0)]
    for _ in range(3):
        trajectory.add(body)
    assert trajectory.points == [(0.0, 0.0)]


def test_another_floor_begins_anew() -> None:
    body, trajectory = robot(0.0, 0.0), Trajectory()
    trajectory.add(body)
    body.floor, body.pose, body.path = 2, Pose2D(x=5.0, y=1.0), []
    trajectory.add(body)
    assert trajectory.points == [(5.0, 1.0)]


def test_the_way_of_a_task_lies_where_a_robot_can_drive(building: Path) -> None:
    task, port, trajectory = mug_task(), LocalPort(), Trajectory()
    with episode_folder(building, task.start) as folder:
        port.load(folder)
        world, body = port.world()
        trajectory.add(body)
        for call in task.oracle:
            port.call(call)
            trajectory.add(body)
        grid = world.view(body.floor).map
        assert len(trajectory.points) > 4
        for a, b in pairwise(trajectory.points):
            steps = max(1, int(dist(a, b) / 0.05))
            for k in range(steps + 1):
                x, y = (a[i] + (b[i] - a[i]) * k / steps for i in (0, 1))
                assert grid.is_free(x, y)

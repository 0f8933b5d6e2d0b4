"""The way on an episode's pictures is the one that was driven."""

from itertools import pairwise
from math import dist
from pathlib import Path

from episode_tasks import mug_task
from mansion_msgs_py.world import Pose2D
from mansion_skills.world.robot_body import RobotBody
from mansion_tasks.episodes.port import LocalPort
from mansion_tasks.episodes.stand_in import stand_in
from mansion_tasks.episodes.trail import Trail


def robot(x: float, y: float, floor: int = 1) -> RobotBody:
    return RobotBody("r", floor, Pose2D(x=x, y=y), 0.2)


def test_a_trail_has_the_corners_of_the_path() -> None:
    body, trail = robot(0.0, 0.0), Trail()
    trail.follow(body)
    body.path = [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0)]
    body.move(Pose2D(x=3.0, y=2.0))
    trail.follow(body)
    assert trail.points == [(0.0, 0.0), (3.0, 0.0), (3.0, 2.0)]


def test_standing_still_adds_nothing() -> None:
    body, trail = robot(0.0, 0.0), Trail()
    body.path = [(1.0, 0.0), (0.0, 0.0)]
    for _ in range(3):
        trail.follow(body)
    assert trail.points == [(0.0, 0.0)]


def test_another_floor_begins_anew() -> None:
    body, trail = robot(0.0, 0.0), Trail()
    trail.follow(body)
    body.floor, body.pose, body.path = 2, Pose2D(x=5.0, y=1.0), []
    trail.follow(body)
    assert trail.points == [(5.0, 1.0)]


def test_the_way_of_a_task_lies_where_a_robot_can_drive(building: Path) -> None:
    task, port, trail = mug_task(), LocalPort(), Trail()
    with stand_in(building, task.start) as folder:
        port.load(folder)
        world, body = port.world()
        trail.follow(body)
        for call in task.oracle:
            port.call(call)
            trail.follow(body)
        grid = world.view(body.floor).map
        assert len(trail.points) > 4
        for a, b in pairwise(trail.points):
            steps = max(1, int(dist(a, b) / 0.05))
            for k in range(steps + 1):
                x, y = (a[i] + (b[i] - a[i]) * k / steps for i in (0, 1))
                assert grid.is_free(x, y)

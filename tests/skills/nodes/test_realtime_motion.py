"""With skills in real time, /odom moves evenly between their steps, at the speed that it tells."""

import threading
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from sample_building import write_building

pytest.importorskip("rclpy")

from mansion_bringup.client import MansionClient
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses, NodeProcess
from mansion_skills.skills.driving import SPEED

pytestmark = pytest.mark.graph

NODE = NodeProcess("mansion_skills", "skill_server", "load_building")


@pytest.fixture
def client(tmp_path: Path) -> Iterator[MansionClient]:
    options = GraphOptions(
        domain_id=free_domain(), parameters={"skill_server": {"motion": "realtime", "camera": "false"}}
    )
    with GraphProcesses(options, [NODE]) as running:
        running.wait_ready(60.0)
        with MansionClient(domain_id=options.domain_id, timeout=60.0) as made:
            made.call("load_building", {"path": str(write_building(tmp_path / "b", [1]))})
            yield made


def test_odometry_moves_evenly(client: MansionClient) -> None:
    from nav_msgs.msg import Odometry

    heard: list[tuple[float, float, float]] = []
    arrived = threading.Event()

    def keep(message: Any) -> None:
        stamp = message.header.stamp.sec + 1e-9 * message.header.stamp.nanosec
        place = message.pose.pose.position
        heard.append((stamp, (place.x**2 + place.y**2) ** 0.5, message.twist.twist.linear.x))
        arrived.set()

    client.subscribe(Odometry, "/odom", keep)
    assert arrived.wait(10.0)
    free = client.call("skills/go_to_landmark", {"landmark": "office"})
    assert free["status"] == "SUCCESS"
    start = len(heard)
    client.call("skills/move_ahead", {"distance": -0.8})
    moving = heard[start:]
    assert len(moving) > 8
    for (before, a, _), (after, b, _) in pairwise(moving):
        # As far as the time between two messages allows: never a step of a skill at once.
        assert abs(b - a) <= SPEED * (after - before) + 0.015
    speeds = [speed for _, _, speed in moving]
    assert min(speeds) == pytest.approx(-SPEED, abs=0.05)

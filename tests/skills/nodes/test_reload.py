"""A skill server loads one building after the other while others listen; nothing of it is destroyed under an executor.

``MANSION_TEST_LOADS=300 ./mansion test tests/skills/nodes/test_reload.py`` is the long run.
"""

import os
import shutil
import threading
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from sample_building import write_building

rclpy = pytest.importorskip("rclpy")

from mansion_bringup.client import MansionClient  # noqa: E402
from mansion_bringup.graph.domains import free_domain  # noqa: E402
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses, NodeProcess  # noqa: E402
from mansion_bringup.graph.topic_echo import message_class  # noqa: E402
from mansion_msgs_py.errors import MansionError  # noqa: E402
from mansion_msgs_py.interfaces import TOPICS  # noqa: E402
from mansion_msgs_py.nodes.shell import qos_profile  # noqa: E402
from mansion_skills.nodes.robot_names import RobotNames  # noqa: E402

pytestmark = [pytest.mark.graph, pytest.mark.timeout(900)]

LOADS = int(os.environ.get("MANSION_TEST_LOADS", "24"))
SESSIONS = ("", "r2", "r3")
NODE = NodeProcess("mansion_skills", "skill_server", "load_building")


class Listener:
    """A node with a subscription to every topic of the server, of every session, and an executor that spins it."""

    def __init__(self, executor: Any, domain: int, name: str) -> None:
        self.context = rclpy.context.Context()
        rclpy.init(context=self.context, args=[], domain_id=domain)
        self.node = rclpy.create_node(name, namespace="/mansion", context=self.context)
        self.heard: Counter[str] = Counter()
        self.fault: BaseException | None = None
        for session in SESSIONS:
            for entry in TOPICS:
                if entry.node == "skill_server":
                    self._listen(RobotNames("", "", session).interface(entry.name))
        self.executor = executor(context=self.context)
        self.executor.add_node(self.node)
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._spin, daemon=True)
        self._thread.start()

    def _listen(self, entry: Any) -> None:
        try:
            kind = message_class(entry)
        except MansionError:  # tf2_msgs is not everywhere
            return

        def count(message: Any) -> None:
            self.heard[entry.name] += 1

        self.node.create_subscription(kind, entry.name, count, qos_profile(entry.qos))

    def _spin(self) -> None:
        try:
            while not self._ended.is_set():
                self.executor.spin_once(timeout_sec=0.2)
        except BaseException as fault:
            self.fault = fault

    def close(self) -> None:
        self._ended.set()
        self._thread.join(timeout=10.0)
        self.executor.shutdown(timeout_sec=2.0)
        self.node.destroy_node()
        rclpy.try_shutdown(context=self.context)


@pytest.fixture(scope="module")
def buildings(tmp_path_factory: pytest.TempPathFactory) -> list[Path]:
    root = tmp_path_factory.mktemp("buildings")
    first = write_building(root / "first", [1, 2, 3])
    return [first, Path(shutil.copytree(first, root / "second"))]


@pytest.fixture
def server() -> Iterator[GraphProcesses]:
    options = GraphOptions(domain_id=free_domain(), parameters={"skill_server": {"durable": "false"}})
    with GraphProcesses(options, [NODE]) as running:
        running.wait_ready(60.0)
        yield running


def test_a_server_outlives_many_loads_with_listeners_on_every_topic(
    server: GraphProcesses, buildings: list[Path], capfd: pytest.CaptureFixture[str]
) -> None:
    domain = server.options.domain_id
    assert domain is not None
    executors = (rclpy.executors.SingleThreadedExecutor, rclpy.executors.MultiThreadedExecutor)
    listeners = [Listener(executor, domain, f"listener_{number}") for number, executor in enumerate(executors)]
    try:
        with MansionClient(domain_id=domain, timeout=60.0) as client:
            for number in range(LOADS):
                session = SESSIONS[number % len(SESSIONS)]
                arguments = {"path": str(buildings[number % 2]), "world": f"w{number % 4}"}
                loaded = client.call("load_building", {**arguments, "session": session})
                assert loaded["session"] == (session or "default")
                client.call("skills/rotate", {"degrees": 90, "session": session})
            assert server.ended() == {}
            assert client.call("skills/where_am_i")["floor"] == 1
    finally:
        for listener in listeners:
            listener.close()
    assert [listener.fault for listener in listeners] == [None, None]
    for listener in listeners:
        assert {"/map", "/odom", "/r2/odom", "/r3/map", "robot_state"} <= listener.heard.keys()
    assert "Traceback" not in capfd.readouterr().err

"""Two skill servers in one domain keep apart: topics, drive commands and frames."""

import time
from collections.abc import Iterator

import pytest

from sample_building import write_building

pytest.importorskip("rclpy")

from mansion_bringup.client import MansionClient
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses, NodeProcess
from mansion_skills.engine.motion import STALE

pytestmark = pytest.mark.graph

NODE = NodeProcess("mansion_skills", "skill_server", "load_building")
QUIET = {"camera": "false", "durable": "false"}


@pytest.fixture(scope="module")
def clients(tmp_path_factory: pytest.TempPathFactory) -> Iterator[list[MansionClient]]:
    """A client of each of two servers, with three robots in their buildings."""
    domain = free_domain()
    parameters = {"/mansion": QUIET, "/site_b": {**QUIET, "frame_prefix": "site_b/"}}
    graphs = [
        GraphProcesses(GraphOptions(namespace=namespace, domain_id=domain, parameters={"skill_server": given}), [NODE])
        for namespace, given in parameters.items()
    ]
    with graphs[0], graphs[1]:
        made = []
        for graph in graphs:
            graph.wait_ready(60.0)
            client = MansionClient(domain_id=domain, namespace=graph.options.namespace, timeout=30.0)
            folder = write_building(tmp_path_factory.mktemp("buildings") / "one", [1, 2])
            client.call("load_building", {"path": str(folder)})
            client.call("load_building", {"path": str(folder), "session": "r2", "world": "w2"})
            made.append(client)
        yield made
        for client in made:
            client.close()


def x_of(client: MansionClient, session: str = "") -> float:
    """Where a robot stands."""
    name = f"{session}/skills/where_am_i" if session else "skills/where_am_i"
    return float(client.call(name)["pose"]["x"])


def test_a_drive_command_moves_one_robot(clients: list[MansionClient]) -> None:
    from geometry_msgs.msg import Twist

    node = clients[0].node
    for topic, mover in (("/cmd_vel", (0, "")), ("/site_b/cmd_vel", (1, "")), ("/r2/cmd_vel", (0, "r2"))):
        robots = [(0, ""), (0, "r2"), (1, ""), (1, "r2")]
        time.sleep(2 * STALE)  # until the robot before stands
        before = {robot: x_of(clients[robot[0]], robot[1]) for robot in robots}
        publisher = node.create_publisher(Twist, topic, 10)
        command = Twist()
        command.linear.x = 0.5
        end = time.monotonic() + 15.0
        while abs(x_of(clients[mover[0]], mover[1]) - before[mover]) < 0.1:
            assert time.monotonic() < end, topic
            publisher.publish(command)
            time.sleep(0.05)
        moved = {robot for robot in robots if x_of(clients[robot[0]], robot[1]) != before[robot]}
        assert moved == {mover}


def test_no_topic_has_two_publishers_but_those_of_all_nodes(clients: list[MansionClient]) -> None:
    node = clients[0].node
    shared = {"/diagnostics", "/parameter_events", "/rosout"}
    names = {name for name, _ in node.get_topic_names_and_types()} - shared
    assert {"/map", "/site_b/map", "/r2/odom", "/site_b/r2/odom"} <= names
    assert {name for name in names if node.count_publishers(name) > 1} <= {"/tf", "/site_b/tf"}


def test_the_frames_of_the_second_building_have_its_prefix(clients: list[MansionClient]) -> None:
    from nav_msgs.msg import Odometry

    got: dict[str, tuple[str, str]] = {}

    def keep(message: Odometry) -> None:
        got["frames"] = (message.header.frame_id, message.child_frame_id)

    clients[1].subscribe(Odometry, "/site_b/odom", keep)
    end = time.monotonic() + 15.0
    while "frames" not in got and time.monotonic() < end:
        time.sleep(0.05)
    assert got["frames"] == ("site_b/odom", "site_b/base_link")


def test_the_diagnostics_of_both_say_whose_they_are(clients: list[MansionClient]) -> None:
    from diagnostic_msgs.msg import DiagnosticArray

    seen: dict[str, dict[str, str]] = {}

    def keep(message: DiagnosticArray) -> None:
        for status in message.status:
            seen[status.name] = {entry.key: entry.value for entry in status.values}

    clients[0].subscribe(DiagnosticArray, "/diagnostics", keep)
    wanted = {"mansion: /mansion/skill_server", "mansion: /site_b/skill_server"}
    end = time.monotonic() + 15.0
    while not wanted <= seen.keys() and time.monotonic() < end:
        time.sleep(0.05)
    assert wanted <= seen.keys()
    facts = seen["mansion: /site_b/skill_server"]
    assert int(facts["calls served"]) > 0
    assert facts["session r2"].endswith("floor 1") and facts["camera"] == "switched off"

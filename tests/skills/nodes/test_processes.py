"""The server as a process: killed at any moment, serving two robots, and driving a robot stack."""

import itertools
import json
import os
import random
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from invariants import check_world
from mansion_bringup.client import MansionClient
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses, NodeProcess
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.interfaces import topic
from mansion_msgs_py.nodes.shell import qos_profile
from mansion_skills import Robot
from sample_building import write_building

pytestmark = pytest.mark.graph

os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
NODE = NodeProcess("mansion_skills", "skill_server", "load_building")
worlds = itertools.count()
KILLS = int(os.environ.get("MANSION_TEST_KILLS", "4"))

CARRIER = """
import sys, mansion_skills
robot = mansion_skills.Robot(sys.argv[1])
print("ready", flush=True)
while True:
    for skill, arguments in (
        ("GoNearObject", {"object": "F1/office/mug_1"}), ("PickUp", {"object": "F1/office/mug_1"}),
        ("GoToLandmark", {"landmark": "elevator"}), ("CallElevator", {}),
        ("UseElevator", {"target_floor": 2}), ("GoNearObject", {"object": "F2/kitchen/table_1"}),
        ("Place", {"target": "F2/kitchen/table_1"}), ("PickUp", {"object": "F1/office/mug_1"}),
        ("GoToLandmark", {"landmark": "elevator"}), ("CallElevator", {}),
        ("UseElevator", {"target_floor": 1}), ("GoNearObject", {"object": "F1/office/desk_1"}),
        ("Place", {"target": "F1/office/desk_1"}),
    ):
        result = robot.skill(skill, **arguments)
        print(robot.engine.session("").world.step, flush=True)
"""


def test_a_killed_process_comes_back_to_its_last_finished_skill(building: Path) -> None:
    rng = random.Random(7)
    for _ in range(KILLS):
        process = subprocess.Popen([sys.executable, "-c", CARRIER, str(building)], stdout=subprocess.PIPE, text=True)
        assert process.stdout is not None and process.stdout.readline() == "ready\n"
        time.sleep(rng.uniform(0.02, 0.4))
        process.kill()
        told = process.stdout.read().split("\n")[:-1]
        process.wait(10)
        world = Robot(building).engine.session("").world
        check_world(world)
        if told:
            assert int(told[-1]) <= world.step <= int(told[-1]) + 1


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[GraphProcesses, Path]]:
    folder = write_building(tmp_path_factory.mktemp("sample"))
    options = GraphOptions(domain_id=free_domain())
    with GraphProcesses(options, [NODE]) as running:
        running.wait_ready(60.0)
        yield running, folder


@pytest.fixture
def client(server: tuple[GraphProcesses, Path]) -> Iterator[MansionClient]:
    running, folder = server
    with MansionClient(domain_id=running.options.domain_id, timeout=30.0) as client:
        arguments = {"path": str(folder), "reset": True, "world": f"world_{next(worlds)}"}
        client.call("load_building", arguments)
        yield client


def receive(client: MansionClient, kind: type, name: str) -> Any:
    """Return the next (or the latched) message of a topic."""
    got: list[Any] = []
    arrived = threading.Event()

    def keep(message: Any) -> None:
        got.append(message)
        arrived.set()

    stop = client.subscribe(kind, name, keep)
    assert arrived.wait(10.0), f"nothing on {name}"
    stop()
    return got[-1]


def test_a_refused_skill_answers_with_its_status_and_result(client: MansionClient) -> None:
    with pytest.raises(MansionError) as caught:
        client.call("skills/use_elevator", {"target_floor": 99})
    assert caught.value.code == "INVALID_ACTION"
    assert caught.value.info.details["satisfied_by"] == "one of [1, 2, 3]"


def test_the_robot_stack_gets_map_frames_scan_and_drives(client: MansionClient) -> None:
    from geometry_msgs.msg import PoseStamped, Twist
    from nav_msgs.msg import OccupancyGrid, Odometry
    from sensor_msgs.msg import Imu, LaserScan
    from visualization_msgs.msg import MarkerArray

    grid = receive(client, OccupancyGrid, "/map")
    assert grid.info.resolution == pytest.approx(0.05) and {-1, 0, 100} == set(grid.data)
    odometry = receive(client, Odometry, "/odom")
    assert (odometry.header.frame_id, odometry.child_frame_id) == ("odom", "base_link")
    assert all(odometry.pose.covariance[7 * axis] > 0 for axis in range(6))
    assert all(odometry.twist.covariance[7 * axis] > 0 for axis in range(6))
    imu = receive(client, Imu, "/imu")
    assert imu.linear_acceleration.z == pytest.approx(9.81)
    assert imu.angular_velocity_covariance[8] > 0
    scan = receive(client, LaserScan, "/scan")
    assert len(scan.ranges) == 360
    assert scan.ranges[270] == pytest.approx(1.44, abs=0.06)
    assert len(receive(client, MarkerArray, "markers").markers) > 10
    before = receive(client, PoseStamped, "robot_pose").pose.position.x
    publisher = client.node.create_publisher(Twist, "/cmd_vel", qos_profile(topic("/cmd_vel").qos))
    command = Twist()
    command.linear.x = 0.5
    end = time.monotonic() + 10.0
    while receive(client, PoseStamped, "robot_pose").pose.position.x < before + 0.3:
        assert time.monotonic() < end
        publisher.publish(command)


def test_the_frames_are_published_where_their_message_type_is(client: MansionClient) -> None:
    messages = pytest.importorskip("tf2_msgs.msg", reason="tf2_msgs is not installed")
    static = receive(client, messages.TFMessage, "/tf_static")
    children = {transform.child_frame_id for transform in static.transforms}
    assert children >= {"floor_1", "floor_3", "base_scan", "imu_link"}
    moving = receive(client, messages.TFMessage, "/tf")
    assert [transform.child_frame_id for transform in moving.transforms] == ["odom", "base_link"]


def test_the_map_follows_the_robot_to_another_floor(client: MansionClient) -> None:
    from nav_msgs.msg import OccupancyGrid

    client.call("skills/go_to_landmark", {"landmark": "elevator"})
    client.call("skills/call_elevator")
    client.call("skills/use_elevator", {"target_floor": 3})
    assert receive(client, OccupancyGrid, "/map").info.origin.position.z == pytest.approx(6.4)


def test_a_second_robot_has_services_and_topics_below_its_session(
    client: MansionClient, server: tuple[GraphProcesses, Path]
) -> None:
    from nav_msgs.msg import OccupancyGrid

    world = f"world_{next(worlds) - 1}"
    client.call("load_building", {"path": str(server[1]), "session": "r2", "world": world})
    assert client.call("r2/skills/where_am_i")["session"] == "r2"
    client.call("skills/go_to_landmark", {"landmark": "stairs", "session": "r2"})
    client.call("skills/take_stairs", {"direction": "Up", "session": "r2"})
    got: list[Any] = []
    client.node.create_subscription(OccupancyGrid, "/r2/map", got.append, qos_profile(topic("/map").qos))
    end = time.monotonic() + 10.0
    while not got and time.monotonic() < end:
        time.sleep(0.05)
    assert got[-1].info.origin.position.z == pytest.approx(3.2)


def test_two_clients_take_turns(client: MansionClient, server: tuple[GraphProcesses, Path]) -> None:
    counts = {"a": 0, "b": 0}
    stop = threading.Event()

    def work(name: str) -> None:
        with MansionClient(domain_id=server[0].options.domain_id) as mine:
            while not stop.is_set():
                mine.call("skills/rotate", {"degrees": 10})
                counts[name] += 1

    threads = [threading.Thread(target=work, args=(name,)) for name in counts]
    for thread in threads:
        thread.start()
    end = time.monotonic() + 20.0
    while min(counts.values()) < 10 and time.monotonic() < end:
        time.sleep(0.05)
    stop.set()
    for thread in threads:
        thread.join(20.0)
    assert min(counts.values()) >= 10


def test_a_killed_server_is_replaced_and_goes_on(client: MansionClient, server: tuple[GraphProcesses, Path]) -> None:
    running, folder = server
    client.call("skills/go_near_object", {"object": "F1/office/mug_1"})
    client.call("skills/pick_up", {"object": "F1/office/mug_1"})
    os.kill(running.running["skill_server"].pid, signal.SIGKILL)
    running.running["skill_server"].wait(10)
    running.start("skill_server")
    running.wait_ready(60.0)
    arguments = {"path": str(folder), "world": f"world_{next(worlds) - 1}"}
    # Until its lease ends, the killed server still looks alive, and what is sent to it is lost.
    for _ in range(15):
        try:
            client.call("load_building", arguments, timeout=4.0)
            break
        except MansionError as error:
            assert error.code in ("TIMEOUT", "UNAVAILABLE")
    assert client.call("skills/where_am_i")["held"] == "F1/office/mug_1"


def test_the_command_line_runs_skills_in_its_own_process(building: Path) -> None:
    def run(*arguments: str) -> tuple[int, Any]:
        done = subprocess.run(
            [sys.executable, "-m", "mansion_bringup", "skill", *arguments, "-b", str(building)],
            capture_output=True,
            text=True,
            timeout=60,
        )
        return done.returncode, json.loads(done.stdout)

    assert run("GoToLandmark", '{"landmark": "elevator"}')[0] == 0
    status, refused = run("use_elevator", '{"target_floor": 3}')
    assert (status, refused["status"]) == (1, "PRECONDITION_FAILURE")
    assert run("WhereAmI")[1]["pose"]["x"] == pytest.approx(0.66)


def test_the_example_carries_an_object_from_floor_1_to_floor_3(building: Path) -> None:
    script = Path(__file__).parents[3] / "docs" / "examples" / "carry_object.py"
    assert len(script.read_text().splitlines()) <= 20
    subprocess.run(
        [sys.executable, str(script), str(building), "F1/office/mug_1", "F3/kitchen/table_1"], check=True, timeout=60
    )
    state = Robot(building).engine.session("").world.objects.state("F1/office/mug_1")
    assert (state.floor, state.parent) == (3, "F3/kitchen/table_1")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ((), "carry_object.py BUILDING OBJECT RECEPTACLE"),
        (("F1/office/mug", "F3/kitchen/table_1"), "did you mean F1/office/mug_1?"),
        (("F1/office/mug_1", "F9/table"), "PlanRoute F9/table: "),
        (("F3/kitchen/table_1", "F1/office"), "PickUp F3/kitchen/table_1: INVALID_ACTION: "),
    ],
)
def test_the_example_ends_with_status_1_and_the_reason(building: Path, words: tuple[str, ...], said: str) -> None:
    script = Path(__file__).parents[3] / "docs" / "examples" / "carry_object.py"
    command = [sys.executable, str(script), *([str(building), *words] if words else [])]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 1 and "Traceback" not in done.stderr
    assert said in done.stderr

"""Who reaches a node of Mansion: everyone on this machine, and nobody from outside unless the user chose so.

Two network namespaces stand for two machines. A stranger on the second one knows the address of the first one, names it
as a peer and calls a service there.
"""

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from mansion_bringup.discovery import CHOICES, loopback_variables
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GRAPH_NODES

pytest.importorskip("rclpy")
pytestmark = pytest.mark.graph

HERE, THERE = "10.213.7.1", "10.213.7.2"
DOMAIN = "47"

SERVER = """
import rclpy
from std_srvs.srv import Trigger
rclpy.init()
node = rclpy.create_node("served")
node.create_service(Trigger, "/served", lambda request, response: response)
print("ready", flush=True)
rclpy.spin(node)
"""

CALLER = """
import sys, time, rclpy
from std_srvs.srv import Trigger
rclpy.init()
node = rclpy.create_node("stranger")
client = node.create_client(Trigger, "/served")
found = client.wait_for_service(timeout_sec=float(sys.argv[1]))
if found:
    future = client.call_async(Trigger.Request())
    rclpy.spin_until_future_complete(node, future, timeout_sec=10.0)
    found = future.done()
print("called" if found else "nothing there")
"""


@dataclass(frozen=True)
class Machine:
    """A network namespace; the empty name is the machine that the tests run on."""

    name: str = ""

    def command(self, *words: str) -> list[str]:
        """A command line that runs there."""
        inside = ["ip", "netns", "exec", self.name] if self.name else []
        return [*inside, sys.executable, "-c", *words]


def environment(**variables: str) -> dict[str, str]:
    """An environment without any choice of a range but the given ones."""
    kept = {name: value for name, value in os.environ.items() if name not in CHOICES}
    return {**kept, "ROS_DOMAIN_ID": DOMAIN, **variables}


DEFAULT_OF_MANSION = loopback_variables({})
PLAIN_LOCALHOST = {"ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
STRANGER = {**PLAIN_LOCALHOST, "ROS_STATIC_PEERS": HERE}


@pytest.fixture(scope="module")
def machines() -> Iterator[tuple[Machine, Machine]]:
    """Two machines on one wire."""
    if os.geteuid() != 0 or shutil.which("ip") is None:
        pytest.skip("network namespaces need root and iproute2")
    names = [f"mansion-{os.getpid()}-{number}" for number in (1, 2)]

    def ip(*words: str, check: bool = True) -> None:
        subprocess.run(["ip", *words], check=check, capture_output=True, timeout=20)

    try:
        for name in names:
            ip("netns", "add", name)
        ip("link", "add", "wire", "netns", names[0], "type", "veth", "peer", "wire", "netns", names[1])
        for name, address in zip(names, (HERE, THERE)):
            ip("-n", name, "address", "add", f"{address}/24", "dev", "wire")
            for device in ("lo", "wire"):
                ip("-n", name, "link", "set", device, "up")
    except subprocess.CalledProcessError as error:
        for name in names:
            ip("netns", "delete", name, check=False)
        pytest.skip(f"network namespaces are not to be had: {error.stderr.decode().strip()}")
    yield Machine(names[0]), Machine(names[1])
    for name in names:
        ip("netns", "delete", name, check=False)


def answers(
    server: Machine, serving: dict[str, str], caller: Machine, calling: dict[str, str], patience: float
) -> bool:
    """Whether a caller gets an answer of a node."""
    process = subprocess.Popen(server.command(SERVER), env=environment(**serving), stdout=subprocess.PIPE, text=True)
    try:
        assert process.stdout is not None and process.stdout.readline() == "ready\n"
        done = subprocess.run(
            caller.command(CALLER, str(patience)),
            env=environment(**calling),
            capture_output=True,
            text=True,
            timeout=60,
        )
        assert done.stdout in ("called\n", "nothing there\n"), done.stderr
        return done.stdout == "called\n"
    finally:
        process.kill()
        process.communicate()


def test_a_stranger_who_names_this_machine_calls_nothing_of_mansions(machines: tuple[Machine, Machine]) -> None:
    here, there = machines
    assert not answers(here, DEFAULT_OF_MANSION, there, STRANGER, patience=8.0)


def test_the_same_stranger_reaches_a_node_with_ros_2s_own_localhost(machines: tuple[Machine, Machine]) -> None:
    here, there = machines
    assert answers(here, PLAIN_LOCALHOST, there, STRANGER, patience=20.0)


@pytest.mark.parametrize("reach", ["LOCALHOST", "SUBNET"])
def test_a_plain_node_on_this_machine_finds_mansions(machines: tuple[Machine, Machine], reach: str) -> None:
    here, _ = machines
    plain = {"ROS_AUTOMATIC_DISCOVERY_RANGE": reach}
    assert answers(here, DEFAULT_OF_MANSION, here, plain, patience=20.0)
    assert answers(here, plain, here, DEFAULT_OF_MANSION, patience=20.0)


def test_no_socket_of_mansions_is_bound_to_another_address_than_loopback() -> None:
    process = subprocess.Popen(
        Machine().command(SERVER), env=environment(**DEFAULT_OF_MANSION), stdout=subprocess.PIPE, text=True
    )
    try:
        assert process.stdout is not None and process.stdout.readline() == "ready\n"
        addresses = bound_addresses(process.pid)
        assert addresses and addresses <= {"127.0.0.1", "239.255.0.1"}, addresses
    finally:
        process.kill()
        process.communicate()


@pytest.fixture
def runtime() -> Iterator[Path]:
    """A folder for sockets; its path is short, as paths of sockets must be."""
    with tempfile.TemporaryDirectory() as folder:
        yield Path(folder)


def test_no_process_of_a_graph_listens_on_another_address_than_loopback(tmp_path: Path, runtime: Path) -> None:
    variables = environment(
        PYTHONPATH=os.pathsep.join(sys.path), ROS_DOMAIN_ID=str(free_domain()), XDG_RUNTIME_DIR=str(runtime)
    )
    variables.pop("AMENT_PREFIX_PATH", None)
    command = [sys.executable, "-m", "mansion_bringup", "up", "--processes"]
    graph = subprocess.Popen(command, env=variables, cwd=tmp_path, stderr=subprocess.PIPE, text=True)
    try:
        assert graph.stderr is not None
        assert any(line.startswith("up in /mansion") for line in graph.stderr)
        processes = [graph.pid, *descendants(graph.pid)]
        names = [Path(f"/proc/{pid}/cmdline").read_bytes() for pid in processes]
        assert all(any(node.module.encode() in name for name in names) for node in GRAPH_NODES)
        addresses = set[str]().union(*map(bound_addresses, processes))
        assert "127.0.0.1" in addresses and addresses <= {"127.0.0.1", "239.255.0.1"}, addresses
        assert [path.is_socket() for path in runtime.rglob("*.*")] == [True]  # which mansion call finds
    finally:
        graph.terminate()
        graph.communicate(timeout=30)


def descendants(pid: int) -> list[int]:
    """Processes that a process has started, and theirs."""
    children = [
        int(number) for file in Path(f"/proc/{pid}/task").glob("*/children") for number in file.read_text().split()
    ]
    return [*children, *(further for child in children for further in descendants(child))]


def bound_addresses(pid: int) -> set[str]:
    """Local addresses of a process's UDP and TCP sockets (proc(5), /proc/PID/net/udp)."""
    inodes = set()
    for number in os.listdir(f"/proc/{pid}/fd"):
        target = os.readlink(f"/proc/{pid}/fd/{number}")
        if target.startswith("socket:["):
            inodes.add(target[8:-1])
    addresses = set()
    for table in ("udp", "tcp", "udp6", "tcp6"):
        with open(f"/proc/{pid}/net/{table}", encoding="ascii") as rows:
            for row in list(rows)[1:]:
                fields = row.split()
                if fields[9] in inodes:
                    hexadecimal = fields[1].partition(":")[0]
                    quads = [str(int(hexadecimal[at : at + 2], 16)) for at in (6, 4, 2, 0)]
                    addresses.add(".".join(quads) if len(hexadecimal) == 8 else hexadecimal)
    return addresses

"""``mansion call`` by way of the process that keeps a graph: as real processes, in domains of their own."""

import contextlib
import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from mansion_bringup.discovery import CHOICES, loopback_variables
from mansion_bringup.graph.domains import free_domain

pytest.importorskip("rclpy")
pytestmark = pytest.mark.graph

NODE = """
import os, time, rclpy
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.interfaces import ServiceInterface, topic
from mansion_msgs_py.nodes.node import MansionNode
from mansion_msgs_py.nodes.shell import JsonPublisher, add_json_service
from mansion_msgs_py.world import SkillProgress

def drive(arguments):
    for k in range(1, 13):
        for session, fraction in (("default", k / 12), ("other", 0.0)):
            text = f"at {k} of {session}"
            news.publish(SkillProgress(session=session, skill="Drive", message=text, fraction=fraction))
        time.sleep(0.25)
    return {"done": True}

def refuse(arguments):
    raise MansionError("NOT_FOUND", "there is no floor 9", path="$.floor")

def dawdle(arguments):
    print("called", flush=True)
    time.sleep(60)

rclpy.init()
node = MansionNode("served", namespace="/mansion")
add_json_service(node, ServiceInterface("echo", "served", "Send it back.", dict, dict), lambda arguments: arguments)
add_json_service(node, ServiceInterface("who", "served", "Say who.", None, dict), lambda _: {"pid": os.getpid()})
add_json_service(node, ServiceInterface("refuse", "served", "Refuse.", None, dict), refuse)
add_json_service(node, ServiceInterface("dawdle", "served", "Take long.", None, dict), dawdle)
news = JsonPublisher(node, topic("skill_progress"))
add_json_service(node, ServiceInterface("skills/drive", "served", "Drive.", dict, dict), drive)
print("ready", flush=True)
rclpy.spin(node)
"""

KEEPER = """
import signal, sys
from mansion_bringup.graph.resident_client import ResidentClient
with ResidentClient("/mansion") as resident:
    print(resident.path, flush=True)
    signal.sigwait({signal.SIGTERM})
"""


@pytest.fixture
def runtime() -> Iterator[Path]:
    """A folder for the sockets of a test; its path is short, as paths of sockets must be."""
    with tempfile.TemporaryDirectory() as folder:
        yield Path(folder)


def variables(runtime: Path, domain: int) -> dict[str, str]:
    """The environment of a process in a domain, with a runtime folder of the test's own."""
    kept = {name: value for name, value in os.environ.items() if name not in CHOICES}
    chosen = {"ROS_DOMAIN_ID": str(domain), "XDG_RUNTIME_DIR": str(runtime), "PYTHONPATH": os.pathsep.join(sys.path)}
    return {**kept, **loopback_variables({}), **chosen}


@contextmanager
def process(script: str, environment: dict[str, str]) -> Iterator[tuple[subprocess.Popen[str], str]]:
    """Run a script until the end of the block; gives the first line that it prints."""
    # A signal that sigwait waits for must be blocked from the start, or it ends the process.
    begin = "import signal; signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGTERM})\n" if script is KEEPER else ""
    running = subprocess.Popen(
        [sys.executable, "-c", begin + script], env=environment, stdout=subprocess.PIPE, text=True
    )
    try:
        assert running.stdout is not None
        yield running, running.stdout.readline().strip()
    finally:
        running.terminate()
        try:
            running.wait(20)
        except subprocess.TimeoutExpired:
            running.kill()
        running.communicate()


def call(environment: dict[str, str], *words: str) -> subprocess.CompletedProcess[str]:
    """Run ``mansion call``; standard error tells of each import."""
    command = [sys.executable, "-X", "importtime", "-m", "mansion_bringup", "call", *words]
    return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=120)


def has_participant(done: subprocess.CompletedProcess[str]) -> bool:
    """Whether a command has imported the middleware."""
    return any(line.endswith(" rclpy") for line in done.stderr.splitlines())


def test_a_command_asks_the_process_that_keeps_the_graph(runtime: Path) -> None:
    environment = variables(runtime, free_domain())
    with process(NODE, environment) as (node, _), process(KEEPER, environment):
        done = call(environment, "who")
        assert json.loads(done.stdout) == {"pid": node.pid}, done.stderr
        assert done.returncode == 0 and not has_participant(done)
        done = call(environment, "echo", '{"text": "ß", "numbers": [1, 2.5]}')
        assert json.loads(done.stdout) == {"text": "ß", "numbers": [1, 2.5]} and not has_participant(done)
        alone = call({**environment, "XDG_RUNTIME_DIR": str(runtime / "none")}, "who")
        assert json.loads(alone.stdout) == {"pid": node.pid} and has_participant(alone)


@pytest.mark.parametrize("lent", [True, False])
def test_a_long_call_says_how_far_it_is(runtime: Path, *, lent: bool) -> None:
    environment = variables(runtime, free_domain())
    with process(NODE, environment), process(KEEPER, environment):
        if not lent:
            environment["XDG_RUNTIME_DIR"] = str(runtime / "none")
        done = call(environment, "skills/drive", "{}")
        assert json.loads(done.stdout) == {"done": True} and has_participant(done) is not lent
        assert "% at 12 of default, " in done.stderr or "% at 11 of default, " in done.stderr
        assert "of other" not in done.stderr and "\033" not in done.stderr
        quiet = call(environment, "skills/drive", "{}", "-q")
        assert json.loads(quiet.stdout) == {"done": True} and " of default" not in quiet.stderr


def test_a_director_lends_its_client_where_it_is_told_to(runtime: Path) -> None:
    environment = variables(runtime, free_domain())
    command = [sys.executable, "-m", "mansion_bringup.nodes.building_director", "--ros-args", "-r", "__ns:=/mansion"]
    with process(NODE, environment) as (node, _):
        with subprocess.Popen([*command, "-p", "lend_client:=true"], env=environment) as director:
            found: list[Path] = []
            while not found:
                assert director.poll() is None
                found = list(runtime.rglob("*.sock"))
                time.sleep(0.05)
            done = call(environment, "who")
            director.send_signal(signal.SIGINT)
        assert json.loads(done.stdout) == {"pid": node.pid} and not has_participant(done)
        assert not found[0].exists()


def test_it_refuses_as_a_participant_of_ones_own_does(runtime: Path) -> None:
    environment = variables(runtime, free_domain())
    with process(NODE, environment), process(KEEPER, environment):
        by_socket = call(environment, "refuse")
        alone = call({**environment, "XDG_RUNTIME_DIR": str(runtime / "none")}, "refuse")
        assert by_socket.stdout == alone.stdout and by_socket.returncode == alone.returncode == 1
        assert json.loads(by_socket.stdout)["error"]["path"] == "$.floor"
        assert not has_participant(by_socket) and has_participant(alone)
        late = call(environment, "dawdle", "--timeout", "0.3")
        assert json.loads(late.stdout)["error"]["code"] == "TIMEOUT" and not has_participant(late)


def test_the_domain_chooses_the_graph(runtime: Path) -> None:
    first = free_domain()
    domains = [variables(runtime, first), variables(runtime, free_domain(first))]
    with contextlib.ExitStack() as running:
        nodes = [running.enter_context(process(NODE, each))[0] for each in domains]
        paths = {running.enter_context(process(KEEPER, each))[1] for each in domains}
        assert len(paths) == 2
        for node, each in zip(nodes, domains, strict=True):
            done = call(each, "who")
            assert json.loads(done.stdout) == {"pid": node.pid} and not has_participant(done)


def test_a_killed_graph_leaves_a_socket_that_is_in_nobodys_way(runtime: Path) -> None:
    environment = variables(runtime, free_domain())
    with process(NODE, environment) as (node, _):
        with process(KEEPER, environment) as (keeper, left):
            keeper.send_signal(signal.SIGKILL)
            keeper.wait(20)
        assert Path(left).is_socket()
        alone = call(environment, "who")
        assert json.loads(alone.stdout) == {"pid": node.pid} and has_participant(alone)
        with process(KEEPER, environment) as (_, path):
            assert Path(path).is_socket() and not Path(left).exists()
            assert not has_participant(call(environment, "who"))
        assert not Path(path).exists()


def test_a_stopped_graph_is_asked_nothing(runtime: Path) -> None:
    environment = variables(runtime, free_domain())
    with process(NODE, environment) as (node, _), process(KEEPER, environment) as (keeper, _):
        keeper.send_signal(signal.SIGSTOP)
        try:
            done = call(environment, "who")
        finally:
            keeper.send_signal(signal.SIGCONT)
        assert json.loads(done.stdout) == {"pid": node.pid} and has_participant(done)


def test_a_call_ends_with_the_graph(runtime: Path) -> None:
    environment = variables(runtime, free_domain())
    command = [sys.executable, "-m", "mansion_bringup", "call", "dawdle"]
    with process(NODE, environment) as (node, _), process(KEEPER, environment) as (keeper, _):
        with subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True) as caller:
            assert node.stdout is not None and node.stdout.readline() == "called\n"
            keeper.terminate()
            said, _ = caller.communicate(timeout=30)
        assert json.loads(said)["error"]["code"] == "UNAVAILABLE"


def test_many_commands_are_answered_at_once(runtime: Path) -> None:
    environment = variables(runtime, free_domain())
    answers: list[str] = []
    with process(NODE, environment), process(KEEPER, environment):
        threads = [
            threading.Thread(target=lambda n=n: answers.append(call(environment, "echo", f'{{"n": {n}}}').stdout))
            for n in range(4)
        ]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join(120)
    assert sorted(json.loads(answer)["n"] for answer in answers) == [0, 1, 2, 3]


@pytest.mark.skipif(os.geteuid() != 0, reason="only root becomes somebody else")
def test_another_user_reaches_no_socket(runtime: Path) -> None:
    environment = variables(runtime, free_domain())
    with process(KEEPER, environment) as (_, path):
        for folder in (runtime, *runtime.parents):
            folder.chmod(folder.stat().st_mode | 0o111)
        assert Path(path).parent.stat().st_mode & 0o777 == 0o700
        assert "PermissionError" in stranger_says("s.connect(sys.argv[1])", path)
        # Also where the folder were open, the graph does not talk to somebody else.
        Path(path).parent.chmod(0o755)
        Path(path).chmod(0o777)
        assert stranger_says("s.connect(sys.argv[1]); print(s.recv(9))", path) == "b''\n"


def stranger_says(script: str, path: str) -> str:
    """Run a script with a socket as another user, with the path as its argument, and return what it prints."""
    begin = "import os, socket, sys; os.setgroups([]); os.setgid(65534); os.setuid(65534); "
    begin += "s = socket.socket(socket.AF_UNIX); "
    command = [sys.executable, "-c", begin + script, path]
    # Nothing of this process's measuring: another user may not write where it writes.
    kept = {name: value for name, value in os.environ.items() if not name.startswith("COVERAGE")}
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60, env=kept)
    return done.stdout

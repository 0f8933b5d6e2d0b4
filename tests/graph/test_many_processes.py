"""Forty node processes in one domain: they find each other, and one that is killed is missed and found again."""

import json
import os
import select
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from mansion_bringup.discovery import CHOICES, kept_to_this_machine
from mansion_bringup.graph.domains import free_domain

pytestmark = pytest.mark.graph

COUNT = 40
PATIENCE = 90.0
"""Seconds for what takes a few on an idle machine."""

NOTICE = 20.0
"""Seconds after which a killed process must be missed."""


class Talk:
    """A process of many_nodes.py, spoken to by lines.

    Parameters
    ----------
    role : {"nodes", "client"}
    environment : dict
    prefix : sequence of str
        A command that runs it.
    """

    def __init__(self, role: str, environment: dict[str, str], prefix: Sequence[str]) -> None:
        script = Path(__file__).with_name("many_nodes.py")
        self.process = subprocess.Popen(
            [*prefix, sys.executable, str(script), role],
            env=environment,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            bufsize=0,
        )

    def ask(self, question: Any) -> Any:
        """Send a line and return the answer."""
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.process.stdin.write(json.dumps(question).encode() + b"\n")
        received = b""
        while not (received.startswith(b"@") and received.endswith(b"\n")):
            if received.endswith(b"\n"):
                received = b""  # what the middleware says
            assert select.select([self.process.stdout], [], [], PATIENCE)[0], "no answer"
            byte = os.read(self.process.stdout.fileno(), 1)
            assert byte, f"ended with status {self.process.wait(10.0)}"
            received += byte
        return json.loads(received[1:])

    def end(self) -> None:
        """End its input, which ends it; kill it if it stays."""
        assert self.process.stdin is not None
        self.process.stdin.close()
        try:
            self.process.wait(10.0)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()


class Fleet:
    """The nodes of one domain, and a client.

    Attributes
    ----------
    pids : dict
        Process id of each node's number.
    """

    def __init__(self, nodes: Talk, client: Talk) -> None:
        self.nodes, self.client = nodes, client
        self.pids: dict[int, int] = {}

    def start(self, number: int) -> None:
        """Start the node of that number."""
        self.pids[number] = self.nodes.ask(number)

    def seen_by(self, number: int) -> Any:
        """Return how many nodes a node sees, or the code of the error of asking it."""
        return self.client.ask(["call", f"ping_{number}"])

    def is_served(self, number: int) -> bool:
        """Whether the client sees the service of a node."""
        return bool(self.client.ask(["served", f"ping_{number}"]))


@contextmanager
def fleet(prefix: Sequence[str] = ()) -> Iterator[Fleet]:
    """Yield forty nodes that have been started, and a client, under Mansion's loopback profile."""
    environment = {name: value for name, value in os.environ.items() if name not in CHOICES}
    environment["ROS_DOMAIN_ID"] = str(free_domain())
    with kept_to_this_machine(environment):
        talks = [Talk(role, dict(environment), prefix) for role in ("nodes", "client")]
    try:
        running = Fleet(*talks)
        for number in range(COUNT):
            running.start(number)
        yield running
    finally:
        for talk in talks:
            talk.end()


def holds(condition: Callable[[], bool], seconds: float) -> bool:
    """Wait until a condition holds; False when it does not after `seconds`."""
    deadline = time.monotonic() + seconds
    while not condition():
        if time.monotonic() > deadline:
            return False
        time.sleep(0.1)
    return True


def all_see_each_other(running: Fleet) -> bool:
    """Whether each of the nodes, asked by the client, comes to see all of them."""
    deadline = time.monotonic() + PATIENCE
    waiting = set(range(COUNT))
    while waiting and time.monotonic() < deadline:
        waiting -= {number for number in waiting if running.seen_by(number) == COUNT}
    return not waiting


def test_forty_processes_miss_one_that_is_killed_and_find_it_again() -> None:
    with fleet() as running:
        assert all_see_each_other(running)
        os.kill(running.pids[7], signal.SIGKILL)
        assert holds(lambda: not running.is_served(7), NOTICE)
        assert holds(lambda: running.seen_by(8) == COUNT - 1, NOTICE)
        assert running.seen_by(7) == "UNAVAILABLE"
        running.start(7)
        assert holds(lambda: running.seen_by(7) == COUNT, PATIENCE)
        assert holds(lambda: running.seen_by(8) == COUNT, PATIENCE)


@pytest.mark.parametrize("options", ["size=64m", "ro"], ids=["64 MB", "none to write to"])
def test_forty_processes_work_with_little_shared_memory(options: str) -> None:
    with fleet(over_shared_memory(options)) as running:
        assert all_see_each_other(running)


def over_shared_memory(options: str) -> list[str]:
    """Return a command that runs another with a tmpfs of these options as its /dev/shm; skip where it may not."""
    script = f'mount -t tmpfs -o {options} tmpfs /dev/shm && exec "$@"'
    refusal = "there is no unshare(1)"
    for namespace in (["unshare", "--mount"], ["unshare", "--mount", "--map-root-user"]):
        prefix = [*namespace, "sh", "-c", script, "sh"]
        try:
            tried = subprocess.run([*prefix, "true"], capture_output=True, text=True, check=False)
        except FileNotFoundError:
            break
        if tried.returncode == 0:
            return prefix
        refusal = tried.stderr.strip()
    pytest.skip(f"no rights to mount anything over /dev/shm: {refusal}")

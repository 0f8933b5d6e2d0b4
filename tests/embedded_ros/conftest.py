"""Every test process gets a DDS domain of its own, on loopback."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import textwrap
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

DOMAIN = 100 + os.getpid() % 100
os.environ["ROS_AUTOMATIC_DISCOVERY_RANGE"] = "LOCALHOST"
os.environ["ROS_DOMAIN_ID"] = str(DOMAIN)
for name in ("CYCLONEDDS_URI", "ROS_STATIC_PEERS", "ROS_LOCALHOST_ONLY"):
    os.environ.pop(name, None)

DATA = Path(__file__).parent / "data"


@pytest.fixture(scope="session")
def recorded() -> Callable[[str], Any]:
    """Read a file recorded from a real Jazzy: ``vectors``, ``discovery`` or ``rclpy_api``."""

    def read(name: str) -> Any:
        return json.loads((DATA / f"{name}.json").read_text(encoding="utf-8"))

    return read


@pytest.fixture
def ros() -> Iterator[Any]:
    """rclpy, initialized and shut down."""
    import rclpy

    rclpy.init(args=[])
    yield rclpy
    rclpy.try_shutdown()


@pytest.fixture
def node(ros: Any) -> Iterator[Any]:
    """A node of the default context."""
    made = ros.create_node("tested")
    yield made
    made.destroy_node()


class Program:
    """A Python program in a process of its own, whose output is read line by line."""

    def __init__(self, source: str, *args: str, env: dict[str, str] | None = None) -> None:
        self.process = subprocess.Popen(
            [sys.executable, "-u", "-c", textwrap.dedent(source), *args],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path), **(env or {})},
        )

    def line(self) -> str:
        """The next line of standard output."""
        assert self.process.stdout is not None
        line = self.process.stdout.readline()
        if not line:
            _, errors = self.process.communicate(timeout=10)
            raise AssertionError(f"the program ended early:\n{errors}")
        return line.strip()

    def signal(self, number: int) -> None:
        self.process.send_signal(number)

    def finish(self, timeout: float = 20.0) -> tuple[str, str]:
        """What is left of both outputs, once it has ended."""
        return self.process.communicate(timeout=timeout)


@pytest.fixture
def program() -> Iterator[Callable[..., Program]]:
    """Start programs; they are killed at the end of the test."""
    started: list[Program] = []

    def start(source: str, *args: str, env: dict[str, str] | None = None) -> Program:
        started.append(Program(source, *args, env=env))
        return started[-1]

    yield start
    for each in started:
        if each.process.poll() is None:
            each.process.kill()
            each.process.communicate()

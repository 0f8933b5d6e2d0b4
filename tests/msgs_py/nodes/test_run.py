"""A node process ends quietly when it is told to, and says in one line what it cannot start with."""

import os
import signal
import subprocess
import sys
import textwrap
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

pytest.importorskip("rclpy")
pytestmark = pytest.mark.graph

PROLOGUE = """
import os, sys, time
from rcl_interfaces.msg import IntegerRange, ParameterDescriptor
from rclpy.node import Node
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.nodes.run import run_node

class Bare(Node):
    def __init__(self):
        super().__init__("bare")
"""

NOTICE = "The following exception was never retrieved: cannot use Destroyable"

Program = Callable[[str], "subprocess.Popen[str]"]


@pytest.fixture
def program() -> Iterator[Program]:
    """Start a program in a domain of its own, on loopback."""
    started: list[subprocess.Popen[str]] = []
    environment = {
        "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST",
        **os.environ,
        "ROS_DOMAIN_ID": str(150 + os.getpid() % 50),
        "PYTHONPATH": os.pathsep.join(sys.path),
    }

    def start(source: str) -> "subprocess.Popen[str]":
        process = subprocess.Popen(
            [sys.executable, "-u", "-c", PROLOGUE + textwrap.dedent(source)],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            env=environment,
        )
        started.append(process)
        return process

    yield start
    for process in started:
        if process.poll() is None:
            process.kill()
            process.communicate()


def told(process: "subprocess.Popen[str]", number: signal.Signals) -> tuple[int, str]:
    """Send a signal to a program that has said ``ready``; its exit status and what it wrote to stderr.

    A notice of rclpy's own is left out: where a callback was about to begin as the context went down, its executor says
    that nobody asked for the callback's outcome.
    """
    assert process.stdout is not None
    assert process.stdout.readline() == "ready\n"
    process.send_signal(number)
    _, errors = process.communicate(timeout=20)
    own = [line for line in errors.splitlines(keepends=True) if not line.startswith(NOTICE)]
    return process.returncode, "".join(own)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_spinning_node_ends_without_a_traceback(program: Program, number: signal.Signals) -> None:
    process = program("""
        class Busy(Bare):
            def __init__(self):
                super().__init__()
                self.create_timer(0.001, lambda: None)
                self.create_timer(0.1, lambda: print("ready"))
        run_node(Busy)
    """)
    assert told(process, number) == (0, "")


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_node_that_is_still_being_made_ends_without_a_traceback(program: Program, number: signal.Signals) -> None:
    process = program("""
        class Slow(Bare):
            def __init__(self):
                super().__init__()
                print("ready")
                time.sleep(30)
        run_node(Slow)
    """)
    assert told(process, number) == (0, "")


def test_a_node_whose_call_goes_on_ends_within_the_grace(program: Program) -> None:
    process = program("""
        class Busy(Bare):
            def __init__(self):
                super().__init__()
                self.create_timer(0.1, self.work)
            def work(self):
                print("ready")
                while True:
                    sum(range(10_000))
        run_node(Busy)
    """)
    assert told(process, signal.SIGTERM) == (0, "")


def test_two_interrupts_without_a_terminal_leave_status_0(program: Program) -> None:
    process = program("""
        class Spinning(Bare):
            def __init__(self):
                super().__init__()
                self.create_timer(0.1, lambda: print("ready"))
        run_node(Spinning)
        print("ended")
        time.sleep(0.2)
    """)
    assert process.stdout is not None
    assert process.stdout.readline() == "ready\n"
    process.send_signal(signal.SIGINT)
    while process.stdout.readline() != "ended\n":
        pass
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=20)
    assert (process.returncode, errors) == (0, "")


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_what_fails_because_the_context_is_gone_is_not_reported(program: Program, number: signal.Signals) -> None:
    process = program("""
        import rclpy
        class Late(Bare):
            def __init__(self):
                super().__init__()
                self.create_timer(0.01, self.fail)
            def fail(self):
                print("ready")
                while rclpy.ok():
                    time.sleep(0.01)
                raise RuntimeError("the publisher's context is invalid")
        run_node(Late)
    """)
    status, errors = told(process, number)
    assert status == 0
    assert "Traceback" not in errors


def test_a_refusal_at_the_start_is_one_line_and_status_1(program: Program) -> None:
    process = program("""
        class Refusing(Bare):
            def __init__(self):
                super().__init__()
                raise MansionError(ErrorCode.UNAVAILABLE, "the parameter hooks names 'nothing'")
        run_node(Refusing)
    """)
    _, errors = process.communicate(timeout=20)
    assert process.returncode == 1
    assert "the parameter hooks names 'nothing'" in errors
    assert "Traceback" not in errors


@pytest.mark.parametrize("value", ["99", "many"])
def test_a_parameter_that_is_not_accepted_is_one_line_and_status_1(program: Program, value: str) -> None:
    process = program(f"""
        class Limited(Bare):
            def __init__(self):
                super().__init__()
                limits = [IntegerRange(from_value=1, to_value=9, step=1)]
                self.declare_parameter("count", 1, ParameterDescriptor(integer_range=limits))
        run_node(Limited, ["limited", "--ros-args", "-p", "count:={value}"])
    """)
    _, errors = process.communicate(timeout=20)
    assert process.returncode == 1
    assert "count" in errors
    assert "Traceback" not in errors


def test_a_fault_in_a_callback_is_reported(program: Program) -> None:
    process = program("""
        class Faulty(Bare):
            def __init__(self):
                super().__init__()
                self.create_timer(0.01, lambda: 1 / 0)
        run_node(Faulty)
    """)
    _, errors = process.communicate(timeout=20)
    assert process.returncode == 1
    assert "ZeroDivisionError" in errors


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_a_node_whose_call_keeps_the_interpreter_ends_all_the_same(program: Program, number: signal.Signals) -> None:
    process = program("""
        import re
        class Searching(Bare):
            def __init__(self):
                super().__init__()
                self.create_timer(0.1, self.search)
            def search(self):
                print("ready")
                re.match("(a|a)*b", "a" * 60)
        run_node(Searching)
    """)
    status, errors = told(process, number)
    assert (status, errors) == (-signal.SIGKILL, "")


def test_nothing_watches_a_node_that_has_ended(program: Program) -> None:
    process = program("""
        class Spinning(Bare):
            def __init__(self):
                super().__init__()
                self.create_timer(0.1, lambda: print("ready"))
        run_node(Spinning)
    """)
    assert process.stdout is not None
    assert process.stdout.readline() == "ready\n"
    children = Path(f"/proc/{process.pid}/task/{process.pid}/children")
    watchers = [Path("/proc", pid) for pid in children.read_text().split()]
    assert len(watchers) == 1
    process.kill()
    process.communicate(timeout=20)
    deadline = time.monotonic() + 20.0
    while any(path.exists() for path in watchers) and time.monotonic() < deadline:
        time.sleep(0.05)
    assert not any(path.exists() for path in watchers)

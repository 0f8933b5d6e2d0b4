"""Stages behind services wait for a node that is loading, and name one that is not there."""

import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator

import pytest
import rclpy
from rclpy.context import Context
from rclpy.node import Node

from mansion_bringup.client import MansionClient
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.pipeline.stages import RemoteStages
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.interfaces import service
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.nodes.node import MansionNode
from mansion_msgs_py.nodes.shell import add_json_service
from spinning import spinning

os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")

PROBLEM = FloorProblem(boundary=[(0.0, 0.0), (4.0, 0.0), (4.0, 3.0)], nodes=[], floor=7)


def solved(problem: FloorProblem) -> FloorLayout:
    return FloorLayout(rooms=[], topology_satisfied=True, floor=problem.floor)


@pytest.fixture
def client() -> Iterator[MansionClient]:
    with MansionClient(domain_id=free_domain(), timeout=20.0) as client:
        yield client


@pytest.fixture
def solver(client: MansionClient) -> Iterator[Node]:
    """A ``floor_solver`` that serves nothing yet, spinning."""
    context = Context()
    rclpy.init(context=context, args=[], domain_id=client.node.context.get_domain_id())
    node = MansionNode("floor_solver", namespace="/mansion", context=context)
    with spinning(node):
        yield node


def until(condition: Callable[[], bool], seconds: float = 20.0) -> None:
    end = time.monotonic() + seconds
    while not condition() and time.monotonic() < end:
        time.sleep(0.02)
    assert condition()


def test_a_node_that_is_up_and_still_loading_is_waited_for(client: MansionClient, solver: Node) -> None:
    until(lambda: client.sees_node("floor_solver"))
    loaded = threading.Timer(1.0, add_json_service, args=(solver, service("solve_floor"), solved))
    loaded.start()
    layout = RemoteStages(client, 20.0, discovery=0.1).solve(PROBLEM)
    assert layout.floor == 7


def test_a_node_that_never_serves_is_given_up(client: MansionClient, solver: Node) -> None:
    until(lambda: client.sees_node("floor_solver"))
    with pytest.raises(MansionError, match="no node serves /mansion/solve_floor") as caught:
        RemoteStages(client, 1.0, discovery=0.1).solve(PROBLEM)
    assert caught.value.code == ErrorCode.UNAVAILABLE


def test_a_node_that_is_not_there_is_not_waited_for(client: MansionClient) -> None:
    with pytest.raises(MansionError, match="no node serves /mansion/solve_floor"):
        RemoteStages(client, 3600.0, discovery=0.1).solve(PROBLEM)


STAGES_BY_MANY_THREADS = """
import sys
import threading

from mansion_bringup.pipeline.stages import LocalStages

sys.setswitchinterval(1e-6)
stages, failed = LocalStages(), []

def attempt(stage):
    try:
        stage(None)
    except ImportError as error:
        failed.append(error)
    except Exception:
        pass  # nothing was asked for

threads = [threading.Thread(target=attempt, args=(stage,)) for stage in (stages.plan, stages.solve, stages.furnish)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
print(failed)
"""


def test_threads_of_a_new_process_may_begin_with_different_stages() -> None:
    ended = subprocess.run(
        [sys.executable, "-c", STAGES_BY_MANY_THREADS], capture_output=True, text=True, timeout=300, check=True
    )
    assert ended.stdout == "[]\n", ended.stdout

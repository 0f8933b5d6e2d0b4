"""Episodes over the services of a real skill server are those of one process."""

import os
import signal
from pathlib import Path

import msgspec
import pytest

from episode_tasks import apple_task, call, mug_task, search_task
from mansion_bringup.client import MansionClient
from mansion_bringup.graph.domains import free_domain
from mansion_bringup.graph.processes import GraphOptions, GraphProcesses
from mansion_bringup.graph.skill_port import SERVER, GraphPort
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.task import Task
from mansion_msgs_py.world import SkillStatus
from mansion_tasks.agents.baselines import OracleAgent, RandomAgent
from mansion_tasks.agents.explorer import Explorer
from mansion_tasks.agents.interface import Agent
from mansion_tasks.episodes.port import LocalPort
from mansion_tasks.episodes.replaying import replay
from mansion_tasks.episodes.running import run_episode

pytestmark = pytest.mark.graph

os.environ.setdefault("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")


def test_agents_get_the_same_result_over_services_as_in_one_process(building: Path) -> None:
    options = GraphOptions(domain_id=free_domain(), parameters={"skill_server": {"durable": "false"}})
    with GraphProcesses(options, [SERVER]) as graph:
        graph.wait_ready(60.0)
        with MansionClient(domain_id=options.domain_id, timeout=30.0) as client:
            port = GraphPort(client)
            for task in (mug_task(), apple_task(), search_task()):
                for agent in (OracleAgent(), Explorer(), RandomAgent()):
                    compare(task, agent, building, port)
            for bad in (call("FlyAway"), call("Rotate", session="x"), call("CallElevator", a=1)):
                assert port.call(bad).status is SkillStatus.INVALID_ACTION
            os.kill(graph.running["skill_server"].pid, signal.SIGKILL)
            graph.running["skill_server"].wait(10)
            with MansionClient(domain_id=options.domain_id, timeout=3.0) as late:
                with pytest.raises(MansionError) as caught:
                    GraphPort(late).call(call("Rotate", degrees=10))
                assert caught.value.code == ErrorCode.UNAVAILABLE


def compare(task: Task, agent: Agent, building: Path, port: GraphPort) -> None:
    here = run_episode(task, building, agent, LocalPort())
    there = run_episode(task, building, agent, port)
    assert there.steps == here.steps
    assert msgspec.structs.replace(there.end, seconds=0.0) == msgspec.structs.replace(here.end, seconds=0.0)
    assert replay(there, building, LocalPort()) == []

"""A replica of the world that another process drives is the same world, after every skill."""

from pathlib import Path

import pytest

from episode_tasks import apple_task, call, mug_task
from mansion_msgs_py.task import Task
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World
from mansion_tasks.agents.baselines import RandomAgent
from mansion_tasks.agents.interface import Briefing
from mansion_tasks.episodes.episode_folder import WorldReplica, episode_folder
from mansion_tasks.episodes.observations import Observer
from mansion_tasks.episodes.port import LocalPort
from mansion_tasks.episodes.running import world_digest


def facts(world: World, robot: RobotBody) -> list[object]:
    lifts = [(lift.name, lift.position, round(lift.opening, 9), lift.session) for lift in world.lifts.values()]
    return [world_digest(world, robot), world.time, lifts, robot.call]


@pytest.mark.parametrize("task", [mug_task(), apple_task()], ids=lambda task: task.id)
def test_a_replica_follows_the_oracle(building: Path, task: Task) -> None:
    with episode_folder(building, task.start) as folder:
        port = LocalPort()
        port.load(folder)
        replica = WorldReplica(folder)
        for skill in task.oracle:
            for step in (skill, call("Rotate", degrees=40), call("Rotate", degrees=-40)):
                if port.call(step).changed:
                    replica.follow()
                    assert facts(replica.world, replica.robot) == facts(*port.world()), step


@pytest.mark.parametrize("seed", range(4))
def test_a_replica_follows_chance(building: Path, seed: int) -> None:
    with episode_folder(building) as folder:
        port, agent = LocalPort(), RandomAgent()
        port.load(folder)
        agent.reset(Briefing("", (1, 2, 3), ("G", "2", "3"), 80, seed=seed))
        watcher, replica = Observer(port, mug_task(), agent.access), WorldReplica(folder)
        for step in range(80):
            seen = watcher.observation(watcher.snapshot(), step, None, None, None)
            if port.call(agent.act(seen)).changed:
                replica.follow()
                world, robot = port.world()
                assert world_digest(replica.world, replica.robot) == world_digest(world, robot)
                assert replica.world.lift_states() == world.lift_states()

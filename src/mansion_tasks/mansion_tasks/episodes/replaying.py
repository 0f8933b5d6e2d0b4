"""Run the skills of a logged episode again, and compare what comes of them."""

from collections.abc import Callable
from pathlib import Path

from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World
from mansion_tasks.episodes.episode_folder import episode_folder
from mansion_tasks.episodes.log import EpisodeLog
from mansion_tasks.episodes.port import SkillPort
from mansion_tasks.episodes.running import world_digest
from mansion_tasks.tasks.progress import ProgressTracker

__all__ = ["OnStep", "replay"]

OnStep = Callable[[int, World, RobotBody], None]
"""Takes the number of a step, 0 before the first, and the world and robot as they are then."""


def replay(
    log: EpisodeLog, building: Path, port: SkillPort, on_step: OnStep = lambda step, world, robot: None
) -> list[str]:
    """Call a log's skills in a fresh episode folder of the building.

    Parameters
    ----------
    log : EpisodeLog
    building : Path
    port : SkillPort
    on_step : callable
        Called before the first skill (step 0) and after each, while the world is there.

    Returns
    -------
    list of str
        Where the repetition differs from the log; empty when it is the same.
    """
    differences: list[str] = []
    with episode_folder(building, log.start.task.start) as folder:
        port.load(folder)
        world, robot = port.world()
        tracker = ProgressTracker(log.start.task, world, robot.session)
        score = tracker.observe()
        on_step(0, world, robot)
        for step in log.steps:
            status = step.status if step.refused else port.call(step.call).status
            world, robot = port.world()
            score = tracker.observe()
            again = (status, robot.floor, robot.pose)
            if again != (step.status, step.floor, step.pose):
                differences.append(
                    f"step {step.step}, {step.call.skill}: {again[0]} on floor {again[1]} at {again[2]}, "
                    f"logged {step.status} on floor {step.floor} at {step.pose}"
                )
            on_step(step.step, world, robot)
        if score.success != log.end.success:
            differences.append(f"success is {score.success}, logged {log.end.success}")
        progress = (round(score.retrieval, 6), round(score.navigation, 6))
        if progress != (log.end.retrieval, log.end.navigation):
            logged = (log.end.retrieval, log.end.navigation)
            differences.append(f"retrieval and navigation are {progress}, logged {logged}")
        if world_digest(world, robot) != log.end.digest:
            differences.append("the world differs at the end")
    return differences

"""Prove that a task can be done: let the oracle do it in a sandbox."""

from dataclasses import dataclass
from typing import Final

from mansion_msgs_py.task import ProgressScore, SkillCall, Task
from mansion_msgs_py.world import SkillStatus
from mansion_tasks.tasks.oracle import Oracle
from mansion_tasks.tasks.progress import ProgressTracker
from mansion_tasks.tasks.sandbox import SESSION, Sandbox

__all__ = ["Solution", "replay", "solve"]

MAX_SKILLS: Final = 200
"""Skills after which the oracle gives up."""


@dataclass(frozen=True)
class Solution:
    """How the oracle did a task.

    Attributes
    ----------
    plan : list of SkillCall
        The skills that succeeded; run from the start they do the task again.
    floors : tuple of int
        Where the robot was, in the order of the first visits.
    tries : int
        Skills called, failed ones included.
    seconds : float
        On the world's clock.
    """

    plan: list[SkillCall]
    floors: tuple[int, ...]
    tries: int
    seconds: float

    @property
    def floors_spanned(self) -> int:
        """Floors from the lowest to the highest that the way touches."""
        return max(self.floors) - min(self.floors) + 1


def solve(task: Task, sandbox: Sandbox) -> Solution | None:
    """Let the oracle do a task from its start; ``None`` when it cannot."""
    sandbox.reset(task.start)
    world = sandbox.world
    oracle = Oracle(task, world, SESSION)
    tracker = ProgressTracker(task, world, SESSION)
    plan: list[SkillCall] = []
    floors = [sandbox.robot.floor]
    for tries in range(MAX_SKILLS):
        if tracker.observe().success:
            return Solution(plan, tuple(dict.fromkeys(floors)), tries, world.time)
        call = oracle.next_call(tracker.seen)
        if call is None:
            return None
        result = sandbox.run(call)
        oracle.note(call, result)
        if result.status is SkillStatus.SUCCESS:
            plan.append(call)
        floors.append(sandbox.robot.floor)
    return None


def replay(task: Task, plan: list[SkillCall], sandbox: Sandbox) -> ProgressScore:
    """Run a plan from a task's start and return the score at its end."""
    sandbox.reset(task.start)
    tracker = ProgressTracker(task, sandbox.world, SESSION)
    score = tracker.observe()
    for call in plan:
        sandbox.run(call)
        score = tracker.observe()
    return score

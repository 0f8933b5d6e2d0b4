"""How hard a task is, and how many skills an agent may call for it."""

from typing import Final

from mansion_msgs_py.task import Difficulty, Task
from mansion_skills.world.world import World
from mansion_tasks.tasks.solving import Solution

__all__ = ["difficulty_of", "steps_for"]

LONG_PLAN: Final = 9
"""Skills from which a plan counts as long."""

MANY_ALIKE: Final = 8
"""Things of the target's kind that are not meant, from which they count as many."""

LEAST_STEPS, MOST_STEPS, STEPS_PER_SKILL = 30, 200, 5


def difficulty_of(task: Task, solution: Solution, world: World) -> Difficulty:
    """Judge a task by the floors it spans, the length of its plan, and the things that look like its target.

    One point each for two floors, for four floors, for a long plan and for many things alike: none is easy, three hard.
    """
    targets = {name for goal in task.goals for name in goal.objects}
    kinds = {world.objects.kinds[name].category for name in targets if name in world.objects}
    alike = sum(world.objects.kinds[name].category in kinds for name in world.objects)
    points = (
        (solution.floors_spanned >= 2)
        + (solution.floors_spanned >= 4)
        + (len(solution.plan) >= LONG_PLAN)
        + (alike - len(targets) >= MANY_ALIKE)
    )
    if points == 0:
        return Difficulty.EASY
    return Difficulty.HARD if points >= 3 else Difficulty.MEDIUM


def steps_for(solution: Solution) -> int:
    """Return how many skills an agent may call: several for each of the oracle's."""
    return max(LEAST_STEPS, min(MOST_STEPS, STEPS_PER_SKILL * len(solution.plan)))

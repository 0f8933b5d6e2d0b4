"""The steps of making a world that other packages do: building, checking, making and trying tasks, starting workers."""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor
from contextlib import AbstractContextManager, contextmanager
from multiprocessing import active_children
from pathlib import Path
from typing import TYPE_CHECKING

from mansion_bringup.check import Fault
from mansion_msgs_py.building_folder import TASKS
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.task import Task, read_task_set
from mansion_world.records import DoneTask, MadeTasks, Trial

if TYPE_CHECKING:
    from mansion_tasks.episodes.results import BenchResult
    from mansion_tasks.tasks.sandbox import Sandbox

__all__ = ["build_for_world", "check_for_world", "redo_tasks", "tasks_for_world", "trials_of", "world_workers"]


def build_for_world(request: BuildRequest, folder: Path, *, formats: Sequence[str] = ()) -> None:
    """Build one request into a folder, in this process (`mansion_world.attempts.Build`)."""
    with importing:
        from mansion_bringup.pipeline.build import build_building

    build_building(request, folder, jobs=1, formats=formats)


def check_for_world(folder: Path) -> list[Fault]:
    """Return the faults of a building folder (`mansion_world.attempts.Check`)."""
    with importing:
        from mansion_bringup.verify import verify_building

    return verify_building(folder)


def tasks_for_world(folder: Path, count: int, seed: int, first: int) -> MadeTasks:
    """Make tasks in a building, each done twice: by the oracle, and by its plan (`mansion_world.attempts.TaskStep`)."""
    with importing:
        from mansion_tasks.tasks.generate import generate
        from mansion_tasks.tasks.sandbox import Sandbox

    sandbox = Sandbox(folder)
    wanted = count
    while True:
        undone: list[Task] = []
        try:
            made = generate(sandbox, wanted, seed, first=first, unsolved=undone.append)
        except MansionError as error:
            if error.code != ErrorCode.INFEASIBLE:
                raise
            return MadeTasks(undone=len(undone), why_none=error.info.message)
        tries = [_run_plan(task, sandbox) for task in made]
        done = [entry for entry in tries if entry.success]
        if len(done) >= count or len(made) < wanted:
            why = "" if done else "no plan completes its task when it is run again"
            return MadeTasks(tasks=done[:count], undone=len(undone) + len(tries) - len(done), why_none=why)
        wanted += count - len(done)


def redo_tasks(folder: Path) -> list[DoneTask]:
    """Run the plan of each task of a building (`mansion_world.verification.RedoTasks`)."""
    with importing:
        from mansion_tasks.tasks.sandbox import Sandbox

    tasks = read_task_set(folder / TASKS).tasks
    sandbox = Sandbox(folder)
    return [_run_plan(task, sandbox) for task in tasks]


def _run_plan(task: Task, sandbox: "Sandbox") -> DoneTask:
    with importing:
        from mansion_tasks.tasks.solving import replay

    score = replay(task, task.oracle, sandbox)
    return DoneTask(task=task, success=score.success, metres=sandbox.robot.driven, seconds=sandbox.world.time)


def trials_of(result: "BenchResult") -> list[Trial]:
    """Return the episodes of a bench as trials of a world."""
    return [
        Trial(
            building=row.building,
            task=row.task,
            agent=row.agent,
            success=row.success,
            retrieval=row.retrieval,
            navigation=row.navigation,
            steps=row.steps,
            seconds=row.time,
        )
        for row in result.episodes
    ]


def world_workers(jobs: int) -> Callable[[], AbstractContextManager[Executor]]:
    """Return what makes `jobs` processes that end with this one (`mansion_world.making.Workers`).

    They are ended at once when what uses them fails or is interrupted.
    """

    @contextmanager
    def workers() -> Iterator[Executor]:
        with importing:
            from mansion_bringup.pipeline.executors import stage_pool

        earlier = set(active_children())
        pool = stage_pool(jobs)
        try:
            yield pool
        except BaseException:
            for child in set(active_children()) - earlier:
                child.terminate()
            raise
        finally:
            pool.shutdown(wait=True, cancel_futures=True)

    return workers

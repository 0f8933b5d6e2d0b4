"""Executors of a build: processes that run the stages, or threads that wait for services beside an export pool.

A process that runs nodes has threads, so it must not fork: its exports go to a pool that a fork server made.
"""

import gc
from collections.abc import Callable
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from dataclasses import dataclass
from importlib import import_module
from multiprocessing import active_children
from types import TracebackType
from typing import Any, Final, TypeVar

from mansion_bringup.pipeline.stages import LocalStages, Stages
from mansion_export.formats import Outputs, outputs_of_build
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.workers import worker_pool

__all__ = ["BuildExecutors", "export_pool", "local_executors", "service_executors", "stage_pool"]

T = TypeVar("T")

_PILLOW: Final = ("PIL.ImageDraw", "PIL.ImageFont", "PIL.PngImagePlugin")
"""What plans and pictures are drawn with."""


@dataclass(frozen=True)
class BuildExecutors:
    """Executors of one build.

    Attributes
    ----------
    pool : Executor
        Runs the floors.
    exporter : Executor
        Runs what turns scenes into files.
    remote : Stages, optional
        Where the stages run; in the pool's own processes when absent.
    """

    pool: Executor
    exporter: Executor
    remote: Stages | None = None

    @property
    def stages(self) -> Stages:
        """The stages, for a task that is not sent to another process."""
        return self.remote or LocalStages()

    def __enter__(self) -> "BuildExecutors":
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if isinstance(error, KeyboardInterrupt) and self.remote is None:
            for child in active_children():
                child.terminate()
        self.pool.shutdown(wait=True, cancel_futures=error is not None)

    def furnish(self, task: Callable[..., T], *arguments: Any) -> "Future[T]":
        """Run a floor's task, which gets the remote stages first and the exporter second."""
        inside = isinstance(self.pool, ProcessPoolExecutor)
        exporter = None if inside else self.exporter
        return self.pool.submit(task, self.remote, exporter, *arguments)


def local_executors(jobs: int, outputs: Outputs) -> BuildExecutors:
    """Return `jobs` forked processes (or this thread's helper thread for one) that run stages and make `outputs`."""
    if jobs > 1:
        _import_stages(outputs)
        # What a worker inherits stays: to look through it for garbage would copy its pages.
        pool = worker_pool(jobs, "fork", gc.freeze)
        return BuildExecutors(pool, pool)
    thread = ThreadPoolExecutor(1)
    return BuildExecutors(thread, thread)


def service_executors(stages: Stages, jobs: int, exporter: Executor | None) -> BuildExecutors:
    """Return `jobs` threads that ask `stages`, with `exporter` for the files."""
    pool = ThreadPoolExecutor(max(1, jobs))
    return BuildExecutors(pool, exporter or pool, stages)


def export_pool(workers: int) -> ProcessPoolExecutor:
    """Return processes for exports that end with this one, made without forking it; what all builds write is loaded."""
    return worker_pool(workers, "forkserver", preload=tuple(_export_modules(outputs_of_build())))


def stage_pool(workers: int) -> ProcessPoolExecutor:
    """Return processes for whole builds that end with this one, however it ends."""
    return worker_pool(workers, "spawn")


def _export_modules(outputs: Outputs) -> list[str]:
    return [output.module for output in (*outputs.floor, *outputs.building)]


def _import_stages(outputs: Outputs) -> None:
    """Import what the workers need before they are forked, and load the kernels that all of them use."""
    for module in _export_modules(outputs):
        import_module(module)
    with importing:
        for module in ("mansion_planner.solver", "mansion_scene.assembly", "mansion_scene.room_contents", *_PILLOW):
            import_module(module)
        from mansion_scene.placement import warm
    warm()

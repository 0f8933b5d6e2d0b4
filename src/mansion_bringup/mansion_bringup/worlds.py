"""What a world needs of the pipeline: one request built, one folder checked, and processes that do both."""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor
from contextlib import AbstractContextManager, contextmanager
from multiprocessing import active_children
from pathlib import Path

from mansion_bringup.check import Fault
from mansion_msgs_py.request import BuildRequest

__all__ = ["build_for_world", "check_for_world", "world_workers"]


def build_for_world(request: BuildRequest, folder: Path, *, formats: Sequence[str] = ()) -> None:
    """Build one request into a folder, in this process (`mansion_world.attempts.Build`)."""
    from mansion_bringup.pipeline.build import build_building

    build_building(request, folder, jobs=1, formats=formats)


def check_for_world(folder: Path) -> list[Fault]:
    """Return the faults of a building folder (`mansion_world.attempts.Check`)."""
    from mansion_bringup.verify import verify_building

    return verify_building(folder)


def world_workers(jobs: int) -> Callable[[], AbstractContextManager[Executor]]:
    """Return what makes `jobs` processes that end with this one (`mansion_world.making.Workers`).

    They are ended at once when what uses them fails or is interrupted.
    """

    @contextmanager
    def workers() -> Iterator[Executor]:
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

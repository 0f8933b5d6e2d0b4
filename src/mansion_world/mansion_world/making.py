"""A world made: requests built by workers in any order, and given their places in the order of their indices.

An attempt depends on its request alone. Whether it is a near-duplicate depends on the buildings before it, so attempts
that finish early wait until all before them have their places: the world does not depend on the number of workers.
"""

from collections.abc import Callable
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from mansion_msgs_py import __version__
from mansion_msgs_py.codec import encode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_world.attempts import NO_TASKS, Build, Check, Outcome, TaskStep, attempt_building
from mansion_world.likeness import nearly_the_same
from mansion_world.measures import folder_digest
from mansion_world.mixture import Mixture
from mansion_world.records import Record, SetAside, WorldIndex
from mansion_world.sampling import WorldRequest, sample
from mansion_world.world_folder import WorldFolder

__all__ = ["MOST_ATTEMPTS", "Workers", "WorldProgress", "make_world"]

MOST_ATTEMPTS: Final = 10
"""Requests for one place of the world before it is left empty."""

_MOST_CRASHES: Final = 5
"""Ends of workers while one attempt was in work before it is set aside."""

_AHEAD: Final = 8
"""Attempts for each worker that may wait for their places."""

Workers = Callable[[], AbstractContextManager[Executor]]
"""Makes the processes that build; asked again when one of them was killed."""


@dataclass(frozen=True)
class WorldProgress:
    """How far a world is.

    Attributes
    ----------
    done, total : int
        Buildings in their places, and asked.
    kept : int
        Of those done, which an earlier run had made.
    set_aside : int
        Attempts that this run set aside.
    missing : int
        Places left empty after `MOST_ATTEMPTS`.
    """

    done: int
    total: int
    kept: int
    set_aside: int
    missing: int


@dataclass
class _Run:
    """The state of a run."""

    world: WorldFolder
    count: int
    seed: int
    mix: Mixture
    tasks: TaskStep = NO_TASKS
    next_new: int = 0
    next_place: int = 0
    kept: int = 0
    asides: int = 0
    missing: int = 0
    again: list[WorldRequest] = field(default_factory=list)
    waiting: dict[int, Record | None] = field(default_factory=dict)
    crashes: dict[tuple[int, int], int] = field(default_factory=dict)
    graphs: dict[str, list[int]] = field(default_factory=dict)
    working: dict[Future[Outcome], WorldRequest] = field(default_factory=dict)

    def progress(self) -> WorldProgress:
        done = self.next_place - self.missing
        return WorldProgress(done, self.count, self.kept, self.asides, self.missing)


def make_world(
    folder: Path,
    count: int,
    *,
    seed: int,
    mix: Mixture,
    build: Build,
    check: Check,
    workers: Workers,
    jobs: int = 1,
    tasks: TaskStep = NO_TASKS,
    report: Callable[[WorldProgress], None] = lambda progress: None,
) -> WorldProgress:
    """Make a world of `count` buildings, or go on with one.

    Parameters
    ----------
    folder : Path
        Finished buildings that are as they were written are kept; a larger `count` adds to them.
    build, check : callable
        One request into a folder, and the faults of a folder; both run in the workers.
    workers : callable
        Makes an executor of `jobs` workers.
    tasks : TaskStep
        What makes the tasks of each building; it runs in the workers.
    report : callable
        Gets the progress after each change.

    Raises
    ------
    MansionError
        ``CONFLICT`` for a folder that holds something else or that another command is making, ``UNAVAILABLE`` for a
        full disk. What is done stays.
    """
    run = _Run(WorldFolder(folder), count, seed, mix, tasks)
    with run.world.locked():
        index = WorldIndex(seed=seed, mix=encode(mix), versions={"mansion": __version__}, tasks=tasks.count)
        run.world.adopt(index)
        try:
            while run.next_place < count:
                _work(run, workers, jobs, build, check, report)
            run.world.write_manifest()
        except OSError as error:
            raise _cannot_write(run, error.strerror or str(error)) from None
        return run.progress()


def _cannot_write(run: _Run, why: str) -> MansionError:
    return MansionError(
        ErrorCode.UNAVAILABLE,
        f"cannot write to {run.world.path}: {why}; {run.next_place - run.missing} of {run.count} buildings are done, "
        "and the same command goes on from there",
    )


def _work(
    run: _Run, workers: Workers, jobs: int, build: Build, check: Check, report: Callable[[WorldProgress], None]
) -> None:
    """Work until all is done or a worker ends."""
    with workers() as executor:
        while run.next_place < run.count:
            while len(run.working) < jobs and (request := _next_request(run, jobs)) is not None:
                try:
                    future = executor.submit(attempt_building, run.world, run.seed, request, build, check, run.tasks)
                except BrokenProcessPool:
                    run.again.append(request)
                    _after_crash(run)
                    return
                run.working[future] = request
            _settle(run)
            report(run.progress())
            if run.working:
                finished, _ = wait(run.working, return_when=FIRST_COMPLETED)
                for future in finished:
                    try:
                        outcome = future.result()
                    except BrokenProcessPool:
                        _after_crash(run)
                        return
                    _take(run, run.working.pop(future), outcome)


def _next_request(run: _Run, jobs: int) -> WorldRequest | None:
    """Return the next request to build; what is done already waits for its place at once."""
    while run.again:
        run.again.sort(key=lambda request: request.index, reverse=True)
        request = run.again.pop()
        if not _is_done(run, request):
            return request
    while run.next_new < min(run.count, run.next_place + _AHEAD * jobs):
        request = sample(run.next_new, run.seed, run.mix)
        run.next_new += 1
        if not _found_finished(run, request.index) and not _is_done(run, request):
            return request
    return None


def _found_finished(run: _Run, index: int) -> bool:
    record = run.world.record(index)
    if record is None:
        return False
    if folder_digest(run.world.building(index))[0] != record.building.sha256:
        run.world.forget(index)
        return False
    run.waiting[index] = record
    run.kept += 1
    return True


def _is_done(run: _Run, request: WorldRequest) -> bool:
    """Whether an earlier run built the attempt or set it aside; its successor then waits its turn."""
    if run.world.was_set_aside(request.index, request.attempt):
        _try_again(run, request)
        return True
    record = run.world.built(request.index, request.attempt)
    if record is None:
        return False
    if folder_digest(run.world.work(request.index, request.attempt))[0] != record.building.sha256:
        run.world.discard(request.index, request.attempt)
        return False
    run.waiting[request.index] = record
    return True


def _try_again(run: _Run, request: WorldRequest) -> None:
    if request.attempt + 1 < MOST_ATTEMPTS:
        run.again.append(sample(request.index, run.seed, run.mix, attempt=request.attempt + 1))
    else:
        run.waiting[request.index] = None


def _take(run: _Run, request: WorldRequest, outcome: Outcome) -> None:
    if outcome.full:
        raise _cannot_write(run, outcome.full)
    if outcome.aside is not None:
        _set_aside(run, outcome.aside)
    else:
        run.waiting[request.index] = outcome.record


def _set_aside(run: _Run, entry: SetAside) -> None:
    run.world.set_aside(entry)
    run.asides += 1
    _try_again(run, entry.request)


def _after_crash(run: _Run) -> None:
    """Give back what was in work when a worker ended, and set aside what workers end at again and again."""
    for request in run.working.values():
        key = (request.index, request.attempt)
        run.crashes[key] = run.crashes.get(key, 0) + 1
        if run.crashes[key] < _MOST_CRASHES:
            run.again.append(request)
        else:
            details = [f"a worker ended {_MOST_CRASHES} times while it was in work"]
            _set_aside(run, SetAside(request=request, reason="worker ended", details=details))
    run.working.clear()


def _settle(run: _Run) -> None:
    """Give places to what waits, in the order of the indices."""
    while run.next_place in run.waiting:
        record = run.waiting.pop(run.next_place)
        if record is None:
            run.missing += 1
        elif not _place(run, record):
            return
        run.next_place += 1


def _place(run: _Run, record: Record) -> bool:
    """Give a building its place, or set it aside where an earlier one is nearly the same."""
    row = record.building
    placed = run.world.record(row.index) is not None
    twin = None if placed else _twin(run, record)
    if twin is not None:
        request = sample(row.index, run.seed, run.mix, attempt=row.attempt)
        _set_aside(run, SetAside(request=request, reason="near-duplicate", details=[f"of {twin:06d}"]))
        return False
    if not placed:
        run.world.settle(record)
    run.graphs.setdefault(record.graph, []).append(row.index)
    return True


def _twin(run: _Run, record: Record) -> int | None:
    for index in run.graphs.get(record.graph, []):
        other = run.world.record(index)
        if other is not None and nearly_the_same(record.likeness, other.likeness):
            return index
    return None

"""The making of a world: workers build requests in any order, and buildings get their places in the order of indices.

An attempt depends on its request alone. Whether it is a near-duplicate depends on the buildings before it, so attempts
that finish early wait until all before them have their places: the world does not depend on the number of workers.
"""

from collections.abc import Callable, Sequence
from concurrent.futures import FIRST_COMPLETED, Executor, Future, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import AbstractContextManager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Final

from mansion_msgs_py import __version__
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.request import building_id_of
from mansion_world.attempts import (
    NO_TASKS,
    Assignment,
    Build,
    Check,
    Outcome,
    TaskStep,
    WorkerLost,
    WorkersGone,
    attempt_building,
)
from mansion_world.building_measures import folder_digest
from mansion_world.near_duplicates import likeness_cells, nearly_the_same
from mansion_world.records import Record, SetAside, WorldIndex
from mansion_world.requests import Requests
from mansion_world.sampling import WorldRequest
from mansion_world.world_folder import WorldFolder, building_path

__all__ = ["Jobs", "Workers", "WorldProgress", "make_world"]

_MOST_CRASHES: Final = 5
"""Number of times that workers may crash at one attempt before it is set aside."""

_AHEAD: Final = 8
"""Attempts for each worker that may wait for their places."""

_LOOK_AGAIN: Final = 5.0
"""Seconds after which the number of workers is asked for again."""

Workers = Callable[[], AbstractContextManager[Executor]]
"""Makes the processes that build; asked again when one of them was killed."""

Jobs = Callable[[], int]
"""Returns how many attempts may run at once, at least one; machines come and go."""


@dataclass(frozen=True)
class WorldProgress:
    """How far a world is.

    Attributes
    ----------
    done, total : int
        Buildings in their places, and asked.
    kept : int
        How many of the finished ones an earlier run had made.
    set_aside : int
        Attempts that this run set aside.
    missing : int
        Places left empty, because no attempt filled them.
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
    requests: Requests
    next_new: int = 0
    next_place: int = 0
    kept: int = 0
    asides: int = 0
    missing: int = 0
    again: list[WorldRequest] = field(default_factory=list)
    waiting: dict[int, Record | None] = field(default_factory=dict)
    crashes: dict[tuple[int, int], int] = field(default_factory=dict)
    alike: dict[tuple[str, tuple[int, int]], list[int]] = field(default_factory=dict)
    working: dict[Future[Outcome], WorldRequest] = field(default_factory=dict)

    def progress(self) -> WorldProgress:
        done = self.next_place - self.missing
        return WorldProgress(done, self.count, self.kept, self.asides, self.missing)


def make_world(
    folder: Path,
    count: int,
    *,
    requests: Requests,
    build: Build,
    check: Check,
    workers: Workers,
    jobs: int | Jobs = 1,
    tasks: TaskStep = NO_TASKS,
    report: Callable[[WorldProgress], None] = lambda progress: None,
) -> WorldProgress:
    """Make a world of `count` buildings, or continue one.

    Parameters
    ----------
    folder : Path
        Finished buildings that are as they were written are kept; a larger `count` adds to them.
    requests : Requests
        Drawn from a mixture, or listed.
    build, check : callable
        One request into a folder, and the faults of a folder; both run in the workers.
    workers : callable
        Makes an executor of `jobs` workers. Its futures raise `WorkerLost` or `WorkersGone` where such things happen.
    jobs : int or callable
        Attempts running at once; a callable is asked again and again.
    tasks : TaskStep
        What makes the tasks of each building; it runs in the workers.
    report : callable
        Gets the progress after each change.

    Raises
    ------
    MansionError
        ``CONFLICT`` for a folder that holds something else or that another command is making, ``UNAVAILABLE`` for a
        full disk and where all workers are gone for good. What is done stays.
    """
    run = _Run(WorldFolder(folder.absolute()), count, requests)
    assignment = Assignment(run.world, requests.seed, requests.terms.floor_area, build, check, tasks)
    with run.world.locked():
        try:
            versions = {"mansion": __version__}
            run.world.adopt(WorldIndex(seed=requests.seed, mix=requests.origin, versions=versions, tasks=tasks.count))
            requests.prepare(run.world)
            while run.next_place < count:
                _work(run, workers, jobs if callable(jobs) else lambda: jobs, assignment, report)
            run.world.write_manifest()
        except OSError as error:
            raise _cannot_write(run, error.strerror or str(error)) from None
        except WorkersGone as error:
            raise _stopped(run, str(error)) from None
        return run.progress()


def _cannot_write(run: _Run, why: str) -> MansionError:
    return _stopped(run, f"cannot write to {run.world.path}: {why}")


def _stopped(run: _Run, why: str) -> MansionError:
    done = f"{run.next_place - run.missing} of {run.count} buildings are done"
    return MansionError(ErrorCode.UNAVAILABLE, f"{why}; {done}; run the same command again to continue")


def _work(
    run: _Run, workers: Workers, jobs: Jobs, assignment: Assignment, report: Callable[[WorldProgress], None]
) -> None:
    """Work until all is done or the processes must be restarted."""
    with workers() as executor:
        while run.next_place < run.count:
            if not _hand_out(run, executor, jobs(), assignment):
                return
            _settle(run)
            report(run.progress())
            if run.working and not _collect(run):
                return


def _hand_out(run: _Run, executor: Executor, jobs: int, assignment: Assignment) -> bool:
    """Give each free worker an attempt; return whether the executor still works."""
    while len(run.working) < jobs and (request := _next_request(run, jobs)) is not None:
        try:
            future = executor.submit(attempt_building, assignment, request)
        except BrokenProcessPool:
            run.again.append(request)
            _after_crash(run, list(run.working))
            return False
        run.working[future] = request
    return True


def _collect(run: _Run) -> bool:
    """Wait for an attempt and take what became of it; return whether the executor still works."""
    finished, _ = wait(run.working, timeout=_LOOK_AGAIN, return_when=FIRST_COMPLETED)
    for future in finished:
        try:
            outcome = future.result()
        except BrokenProcessPool:
            _after_crash(run, list(run.working))
            return False
        except WorkerLost:
            _after_crash(run, [future])
        else:
            _take(run, run.working.pop(future), outcome)
    return True


def _next_request(run: _Run, jobs: int) -> WorldRequest | None:
    """Return the next request to build; what is done already waits for its place at once."""
    while run.again:
        run.again.sort(key=lambda request: request.index, reverse=True)
        request = run.again.pop()
        if not _is_done(run, request):
            return request
    while run.next_new < min(run.count, run.next_place + _AHEAD * jobs):
        request = run.requests.at(run.next_new)
        run.next_new += 1
        if not _found_finished(run, request) and not _is_done(run, request):
            return request
    return None


def _found_finished(run: _Run, request: WorldRequest) -> bool:
    record = run.world.record(request.index)
    if record is None:
        return False
    asked = run.requests.at(request.index, record.building.attempt)
    if not _is_of(record, asked) or folder_digest(run.world.path / record.building.path)[0] != record.building.sha256:
        run.world.forget(record)
        return False
    run.waiting[request.index] = record
    run.kept += 1
    return True


def _is_of(record: Record, request: WorldRequest) -> bool:
    """Whether a record is of the building that a request asks for; a line of a list may have changed."""
    row = record.building
    return (row.path, row.id) == (building_path(request.index, request.name), building_id_of(request.request))


def _is_done(run: _Run, request: WorldRequest) -> bool:
    """Whether an earlier run built the attempt or set it aside; its successor then waits its turn."""
    aside = run.world.set_aside_at(request.index, request.attempt)
    if aside is not None and aside.request == request:
        _try_again(run, request)
        return True
    record = run.world.built(request.index, request.attempt)
    if record is None:
        return False
    folder = run.world.work(request.index, request.attempt)
    if not _is_of(record, request) or folder_digest(folder)[0] != record.building.sha256:
        run.world.discard(request.index, request.attempt)
        return False
    run.waiting[request.index] = record
    return True


def _try_again(run: _Run, request: WorldRequest) -> None:
    if request.attempt + 1 < run.requests.terms.attempts:
        run.again.append(run.requests.at(request.index, request.attempt + 1))
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


def _after_crash(run: _Run, ended: Sequence[Future[Outcome]]) -> None:
    """Return to the queue what ran when a worker crashed, and set aside what workers crash at repeatedly."""
    for request in [run.working.pop(future) for future in ended]:
        key = (request.index, request.attempt)
        run.crashes[key] = run.crashes.get(key, 0) + 1
        if run.crashes[key] < _MOST_CRASHES:
            run.again.append(request)
        else:
            details = [f"a worker ended {_MOST_CRASHES} times while working on it"]
            _set_aside(run, SetAside(request=request, reason="worker ended", details=details))


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
    twin = _twin(run, record) if run.requests.terms.distinct and not placed else None
    if twin is not None:
        request = run.requests.at(row.index, row.attempt)
        _set_aside(run, SetAside(request=request, reason="near-duplicate", details=[f"of {twin:06d}"]))
        return False
    if not placed:
        run.world.settle(record)
    run.alike.setdefault((record.graph, likeness_cells(record.likeness)[0]), []).append(row.index)
    return True


def _twin(run: _Run, record: Record) -> int | None:
    cells = likeness_cells(record.likeness)
    for index in sorted(index for cell in cells for index in run.alike.get((record.graph, cell), [])):
        other = run.world.record(index)
        if other is not None and nearly_the_same(record.likeness, other.likeness):
            return index
    return None

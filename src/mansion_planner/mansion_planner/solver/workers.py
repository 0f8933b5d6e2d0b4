"""Processes that solve floors: forked from one that has the kernels loaded, so that they begin at once.

Loading the kernels takes about as long as twenty floors do, so it happens once, before the fork. A process with threads
must not fork (a lock that another thread holds stays locked in the child), so there each worker starts anew and loads
the kernels itself.
"""

import multiprocessing
import signal
import sys
import threading
import time
from collections.abc import Generator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed

from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.layout import FloorLayout, FloorProblem, UnmetEdge
from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.solve import solve_floor
from mansion_planner.solver.warming import warm

__all__ = ["largest_first", "refusal", "solutions", "solve_timed"]


def refusal(problem: FloorProblem, error: MansionError) -> FloorLayout:
    """Return the layout that stands for a refused problem: no room, every edge unmet, and why."""
    reason = f"{error.info.path}: {error.info.message}"
    return FloorLayout(
        rooms=[],
        topology_satisfied=False,
        unmet_edges=[UnmetEdge(source=e.source, target=e.target, kind=e.kind, reason=reason) for e in problem.edges],
        plan_id=problem.plan_id,
        messages=[f"refused, {error.code} at {reason}"],
        building_id=problem.building_id,
        floor=problem.floor,
    )


def solve_timed(problem: FloorProblem, options: SolverOptions | None = None) -> FloorLayout:
    """Solve one problem and note the seconds; a refused problem gives `refusal`."""
    begin = time.perf_counter()
    try:
        layout = solve_floor(problem, options=options)
    except MansionError as error:
        layout = refusal(problem, error)
    layout.seconds = round(time.perf_counter() - begin, 4)
    return layout


def solutions(problems: Sequence[FloorProblem], jobs: int) -> Generator[tuple[int, FloorLayout], None, None]:
    """Yield each problem's index and layout as they are done: in order for one job, else the largest first.

    Parameters
    ----------
    problems : sequence of FloorProblem
    jobs : int
        Processes. Workers take the next problem when they are free, so that none waits for another.

    Yields
    ------
    index : int
    layout : FloorLayout
        The same for any number of jobs, apart from ``seconds``.

    Notes
    -----
    Closing the generator early, or Ctrl-C in it, ends the workers at once.
    """
    workers = min(jobs, len(problems))
    if workers < 2:
        warm()
        for index, problem in enumerate(problems):
            yield index, solve_timed(problem)
        return
    others = multiprocessing.active_children()
    with _pool(workers) as pool:
        waiting = {
            pool.submit(_solve_encoded, encode_bytes(problems[index])): index for index in largest_first(problems)
        }
        try:
            for future in as_completed(waiting):
                yield waiting[future], decode(FloorLayout, future.result())
        except BaseException:
            # Without the workers, nothing of what still waits is solved before the pool closes.
            for child in multiprocessing.active_children():
                if child not in others:
                    child.terminate()
            pool.shutdown(wait=True, cancel_futures=True)
            raise


def largest_first(problems: Sequence[FloorProblem]) -> list[int]:
    """Return the indices by falling number of rooms, so that no large floor is left for the end."""
    return sorted(range(len(problems)), key=lambda index: -len(problems[index].nodes))


def _pool(workers: int) -> ProcessPoolExecutor:
    """Return the worker processes, ready to solve."""
    if sys.platform == "linux" and threading.active_count() == 1:
        warm()
        forking = multiprocessing.get_context("fork")
        return ProcessPoolExecutor(workers, forking, initializer=_leave_interrupts)
    spawning = multiprocessing.get_context("spawn")
    return ProcessPoolExecutor(workers, spawning, initializer=_start_cold)


def _leave_interrupts() -> None:
    """Let Ctrl-C, which reaches the whole group of processes, be the parent's to answer."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def _start_cold() -> None:
    _leave_interrupts()
    warm()


def _solve_encoded(data: bytes) -> bytes:
    """Solve one encoded problem in a worker process."""
    return encode_bytes(solve_timed(decode(FloorProblem, data)))

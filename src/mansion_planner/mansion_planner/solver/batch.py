"""Many floors at once: files of problems (``mansion solve``) and the worker processes that solve them.

Loading the kernels takes about as long as solving twenty floors, so it happens once, before the workers are forked. A
process with threads must not fork (a lock that another thread holds stays locked in the child), so there each worker
starts anew and loads the kernels itself.
"""

import multiprocessing
import sys
import threading
import time
from collections.abc import Callable, Generator, Sequence
from concurrent.futures import ProcessPoolExecutor, as_completed
from contextlib import closing
from pathlib import Path

import msgspec

from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.files import read_payload, write_atomic
from mansion_msgs_py.layout import FloorLayout, FloorProblem, UnmetEdge
from mansion_msgs_py.workers import worker_pool
from mansion_msgs_py.world import Progress
from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.solve import solve_floor, warm

__all__ = ["largest_first", "solve_file", "solve_timed"]


def refused_layout(problem: FloorProblem, error: MansionError) -> FloorLayout:
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
    """Solve one problem and fill in ``seconds``; a refused problem gives `refused_layout`."""
    begin = time.perf_counter()
    try:
        layout = solve_floor(problem, options=options)
    except MansionError as error:
        layout = refused_layout(problem, error)
    return msgspec.structs.replace(layout, seconds=round(time.perf_counter() - begin, 4))


def solve_many(problems: Sequence[FloorProblem], jobs: int) -> Generator[tuple[int, FloorLayout], None, None]:
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
        return worker_pool(workers, "fork")
    return worker_pool(workers, "spawn", warm)


def _solve_encoded(data: bytes) -> bytes:
    """Solve one encoded problem in a worker process."""
    return encode_bytes(solve_timed(decode(FloorProblem, data)))


def load_problems(path: Path) -> list[FloorProblem]:
    """Read a JSON list of problems.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` or ``INVALID_PAYLOAD`` with the JSON path.
    """
    return read_payload(list[FloorProblem], path, "a JSON list of floor problems")


def solve_file(
    problems: Path, output: Path, *, seed: int = 0, jobs: int = 1, progress: Callable[[Progress], None] | None = None
) -> list[FloorLayout]:
    """Solve every problem of a file and write the layouts.

    Parameters
    ----------
    problems, output : Path
        JSON lists of `FloorProblem` and `FloorLayout`; the output appears whole or not at all.
    seed : int
        Added to each problem's own seed.
    jobs : int
        Processes; the layouts are the same for any number, apart from ``seconds``.
    progress : callable, optional
        Called after each problem, first when the worker processes exist.

    Returns
    -------
    list of FloorLayout
        In the order of the problems.

    Raises
    ------
    MansionError
        When the problems cannot be read.
    """
    seeded = [msgspec.structs.replace(problem, seed=problem.seed + seed) for problem in load_problems(problems)]
    done: dict[int, FloorLayout] = {}
    with closing(solve_many(seeded, jobs)) as arriving:
        for index, layout in arriving:
            done[index] = layout
            if progress is not None:
                met = "every edge met" if layout.topology_satisfied else "edges unmet"
                message = f"plan {layout.plan_id}: {met}"
                progress(Progress(stage="solve", message=message, done=len(done), total=len(seeded)))
    layouts = [done[index] for index in range(len(seeded))]
    lines = b",\n".join(encode_bytes(layout) for layout in layouts)
    write_atomic(output, b"[" + lines + b"]\n")
    return layouts

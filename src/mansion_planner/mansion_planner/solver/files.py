"""``mansion solve``: a JSON list of problems to a JSON list of layouts, in one process or several."""

import multiprocessing
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import msgspec

from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import write_atomic
from mansion_msgs_py.layout import FloorLayout, FloorProblem, UnmetEdge
from mansion_msgs_py.world import Progress
from mansion_planner.solver.options import SolverOptions

__all__ = ["load_problems", "refusal", "solve_file", "solve_timed"]


def load_problems(path: Path) -> list[FloorProblem]:
    """Read a JSON list of problems.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` or ``INVALID_PAYLOAD`` with the JSON path.
    """
    try:
        data = path.read_bytes()
    except OSError as error:
        raise MansionError(
            ErrorCode.NOT_FOUND, f"cannot read {path}: {error.strerror or error}"
        ) from None
    return decode(list[FloorProblem], data)


def refusal(problem: FloorProblem, error: MansionError) -> FloorLayout:
    """Return the layout that stands for a refused problem: no room, every edge unmet, and why."""
    reason = f"{error.info.path}: {error.info.message}"
    return FloorLayout(
        rooms=[],
        topology_satisfied=False,
        unmet_edges=[
            UnmetEdge(source=e.source, target=e.target, kind=e.kind, reason=reason)
            for e in problem.edges
        ],
        plan_id=problem.plan_id,
        messages=[f"refused, {error.code} at {reason}"],
        building_id=problem.building_id,
        floor=problem.floor,
    )


def solve_timed(problem: FloorProblem, options: SolverOptions | None = None) -> FloorLayout:
    """Solve one problem and note the seconds; a refused problem gives `refusal`."""
    from mansion_planner.solver.solve import solve_floor

    begin = time.perf_counter()
    try:
        layout = solve_floor(problem, options=options)
    except MansionError as error:
        layout = refusal(problem, error)
    layout.seconds = round(time.perf_counter() - begin, 4)
    return layout


def _solve_encoded(data: bytes) -> bytes:
    """Solve one encoded problem in a worker process."""
    return encode_bytes(solve_timed(decode(FloorProblem, data)))


def _prepare_worker() -> None:
    from mansion_planner.solver import warm

    warm()


def _solutions(problems: list[FloorProblem], jobs: int) -> Iterator[FloorLayout]:
    """Yield the layouts in order."""
    if jobs == 1 or len(problems) < 2:
        _prepare_worker()
        for problem in problems:
            yield solve_timed(problem)
        return
    context = multiprocessing.get_context("spawn")
    workers = min(jobs, len(problems))
    with ProcessPoolExecutor(workers, mp_context=context, initializer=_prepare_worker) as pool:
        for data in pool.map(_solve_encoded, [encode_bytes(p) for p in problems]):
            yield decode(FloorLayout, data)


def solve_file(
    problems: Path,
    output: Path,
    *,
    seed: int = 0,
    jobs: int = 1,
    progress: Callable[[Progress], None] | None = None,
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
        Called after each problem.

    Returns
    -------
    list of FloorLayout
        In the order of the problems.

    Raises
    ------
    MansionError
        When the problems cannot be read.
    """
    asked = [
        msgspec.structs.replace(problem, seed=problem.seed + seed)
        for problem in load_problems(problems)
    ]
    layouts: list[FloorLayout] = []
    for layout in _solutions(asked, jobs):
        layouts.append(layout)
        if progress is not None:
            met = "every edge met" if layout.topology_satisfied else "edges unmet"
            message = f"plan {layout.plan_id}: {met}"
            progress(Progress(stage="solve", message=message, done=len(layouts), total=len(asked)))
    lines = b",\n".join(encode_bytes(layout) for layout in layouts)
    write_atomic(output, b"[" + lines + b"]\n")
    return layouts

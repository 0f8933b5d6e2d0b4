"""``mansion solve``: a JSON list of problems to a JSON list of layouts, in one process or several."""

from collections.abc import Callable
from contextlib import closing
from pathlib import Path

import msgspec

from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.files import write_atomic
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.reading import read_payload
from mansion_msgs_py.world import Progress
from mansion_planner.solver.workers import solutions

__all__ = ["load_problems", "solve_file"]


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
    asked = [msgspec.structs.replace(problem, seed=problem.seed + seed) for problem in load_problems(problems)]
    done: dict[int, FloorLayout] = {}
    with closing(solutions(asked, jobs)) as arriving:
        for index, layout in arriving:
            done[index] = layout
            if progress is not None:
                met = "every edge met" if layout.topology_satisfied else "edges unmet"
                message = f"plan {layout.plan_id}: {met}"
                progress(Progress(stage="solve", message=message, done=len(done), total=len(asked)))
    layouts = [done[index] for index in range(len(asked))]
    lines = b",\n".join(encode_bytes(layout) for layout in layouts)
    write_atomic(output, b"[" + lines + b"]\n")
    return layouts

"""Build every brief of a corpus up to its layouts and count the facts that the result meets.

``score_briefs.py tests/briefs/briefs.json [--seed 0] [--plan-only]``
"""

import argparse
import json
import time
from pathlib import Path

from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.layout import FloorLayout, LayoutRoom
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import PlanReply
from mansion_planner.fact_score import FactResult, score_building
from mansion_planner.plan import plan_building
from mansion_planner.solver import solve_floor


def layouts_of(reply: PlanReply, plan_only: bool) -> tuple[list[FloorLayout], int]:
    """Solve each floor (once for floors that repeat another); count those with an unmet edge."""
    solved: dict[int, FloorLayout] = {}
    layouts, unmet = [], 0
    for floor, problem in zip(reply.program.floors, reply.problems):
        if plan_only:
            layouts.append(_boxes(problem))
            continue
        if floor.copy is not None and floor.copy in solved:
            layouts.append(solved[floor.copy])
            continue
        layout = solve_floor(problem)
        unmet += not layout.topology_satisfied
        solved[floor.index] = layout
        layouts.append(layout)
    return layouts, unmet


def _boxes(problem: object) -> FloorLayout:
    """Stand-in rooms of the planned areas, for a fast check of the reading alone."""
    rooms = []
    for node in problem.nodes:  # type: ignore[attr-defined]
        if node.type not in ("stair", "elevator"):
            side = (node.area or 1.0) ** 0.5
            rooms.append(LayoutRoom(id=node.id, polygon=[(0, 0), (side, 0), (side, side), (0, side)]))
    return FloorLayout(rooms=rooms, topology_satisfied=True)


def main() -> None:
    """Score the corpus and print what is missed."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("corpus", type=Path)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--plan-only", action="store_true", help="skip the solver")
    options = parser.parse_args()
    results: list[FactResult] = []
    planning: list[float] = []
    floors = unmet = 0
    for entry in json.loads(options.corpus.read_text()):
        begin = time.process_time()
        try:
            reply = plan_building(BuildRequest(description=entry["brief"], seed=options.seed))
        except MansionError as error:
            found = [FactResult(f, f == f"error={error.code}", str(error)) for f in entry["facts"]]
        else:
            planning.append(time.process_time() - begin)
            layouts, missed = layouts_of(reply, options.plan_only)
            floors, unmet = floors + len(layouts), unmet + missed
            found = score_building(entry["facts"], reply, layouts)
        results += found
        for result in found:
            if not result.met:
                print(f"MISSED {result.fact!r} of {entry['brief']!r}: {result.found}")
    met = sum(result.met for result in results)
    hard = [r for r in results if r.fact.startswith("floors=") or "@" in r.fact]
    print(f"facts met: {met} of {len(results)} ({met / len(results):.1%})")
    print(f"floor counts and pinned rooms: {sum(r.met for r in hard)} of {len(hard)}")
    print(f"floors with an unmet edge: {unmet} of {floors}")
    slow = sorted(planning)[int(0.95 * len(planning))]
    print(
        f"planning: median {1e3 * sorted(planning)[len(planning) // 2]:.1f} ms, "
        f"95th percentile {1e3 * slow:.1f} ms, most {1e3 * max(planning):.1f} ms of processor time"
    )


if __name__ == "__main__":
    main()

"""Solve and score real floor plans: the table of docs/floor_solver.md.

    python benchmarks/floorplans/run.py PROBLEMS.json [--no-seeds] [--paper] [-o LAYOUTS.json] [--seed S]

PROBLEMS.json is a list of floor problems, each with its true rooms as "truth".
"""

import argparse
from pathlib import Path

import msgspec

from mansion_msgs_py.codec import decode, encode_bytes
from mansion_planner.solver import SolverOptions
from mansion_planner.solver.evaluation import TrueProblem, run_protocol, table

PAPER = SolverOptions(wall_search=False)


def without_seeds(problem: TrueProblem) -> TrueProblem:
    """Return the problem with no hint where its rooms lie."""
    nodes = [msgspec.structs.replace(n, seed=None, seed_box=None) for n in problem.nodes]
    return msgspec.structs.replace(problem, nodes=nodes, seeds=None)


def main() -> None:
    """Run the benchmark."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("problems", type=Path)
    parser.add_argument("--no-seeds", action="store_true", help="leave all seeds out")
    parser.add_argument("--paper", action="store_true", help="cut rounds only, no wall search")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("-o", "--output", type=Path)
    args = parser.parse_args()
    problems = decode(list[TrueProblem], args.problems.read_bytes())
    if args.no_seeds:
        problems = [without_seeds(problem) for problem in problems]
    options = PAPER if args.paper else SolverOptions()
    scores, layouts = run_protocol(problems, options=options, seed=args.seed)
    print(table(scores))
    if args.output:
        args.output.write_bytes(encode_bytes(layouts))


if __name__ == "__main__":
    main()

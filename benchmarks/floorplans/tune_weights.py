"""Random search for the weights of the energy of section C.2, on real plans.

    python benchmarks/floorplans/tune_weights.py PROBLEMS.json [--samples 24] [--folds 4] [-o weights.json]

Weight vectors are drawn from the simplex; each is tried with the cut rounds alone (no wall search), because only there
the energy decides. The plans are split into folds: the best vector of all folds but one is scored on the one left out,
which shows how much of the gain carries over to unseen plans.
"""

import argparse
from pathlib import Path
from typing import Any

import numpy as np

from mansion_msgs_py.codec import decode, encode_bytes
from mansion_planner.solver import EnergyWeights, SolverOptions
from mansion_planner.solver.batch import solve_timed
from mansion_planner.solver.evaluation import TrueProblem, score_plan

NAMES = ("ratio", "seed", "corner", "wall")


def merit(problem: TrueProblem, weights: EnergyWeights) -> float:
    """Return a plan's merit: IoU, less the area error, less the share of unmet edges."""
    options = SolverOptions(wall_search=False, retries=3, energy=weights)
    score = score_plan(problem, solve_timed(problem, options))
    asked = score.access[1] + score.adjacent[1]
    unmet = asked - score.access[0] - score.adjacent[0]
    return score.macro - score.area_error / score.rooms - unmet / max(1, asked)


def main() -> None:
    """Run the search."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("problems", type=Path)
    parser.add_argument("--samples", type=int, default=24)
    parser.add_argument("--folds", type=int, default=4)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("-o", "--output", type=Path)
    args = parser.parse_args()
    problems = decode(list[TrueProblem], args.problems.read_bytes())
    rng = np.random.default_rng(args.seed)
    vectors = np.round(rng.dirichlet(np.ones(4), args.samples), 3)
    merits = np.array(
        [[merit(problem, EnergyWeights(**dict(zip(NAMES, v.tolist())))) for problem in problems] for v in vectors]
    )
    fold = np.arange(len(problems)) % args.folds
    held_out = [merits[int(np.argmax(merits[:, fold != f].mean(axis=1))), fold == f].mean() for f in range(args.folds)]
    order = np.argsort(-merits.mean(axis=1), kind="stable")
    record: dict[str, Any] = {
        "plans": len(problems),
        "samples": args.samples,
        "seed": args.seed,
        "merit_of_the_mean_vector": round(float(merits.mean()), 4),
        "merit_cross_validated": round(float(np.mean(held_out)), 4),
        "ranking": [
            {**dict(zip(NAMES, vectors[k].tolist())), "merit": round(float(merits[k].mean()), 4)} for k in order
        ],
    }
    print(f"chosen: {record['ranking'][0]}, cross-validated {record['merit_cross_validated']}")
    if args.output:
        args.output.write_bytes(encode_bytes(record, indent=2) + b"\n")


if __name__ == "__main__":
    main()

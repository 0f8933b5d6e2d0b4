"""Synthetic floors of 10 to 60 rooms and 200 to 2,000 m2 with cores, holes and structural walls.

    python benchmarks/floorplans/synthetic.py [--floors 200] [--seed 0] [--jobs 1] [-o PROBLEMS.json]

Solves them and prints how many have every edge met, each miss with its reason, how many have a narrow room, and the
cost by number of rooms.
"""

import argparse
import tempfile
from pathlib import Path

import numpy as np

from mansion_geometry.randomness import item_generator
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.layout import FloorLayout, FloorProblem, ProblemCore, ProblemNode
from mansion_msgs_py.topology import Edge
from mansion_planner.solver.batch import solve_file

Ring = list[tuple[float, float]]


def box(x0: float, y0: float, x1: float, y1: float) -> Ring:
    """Return a rectangle's ring, in centimetres."""
    x0, y0, x1, y1 = (round(v, 2) for v in (x0, y0, x1, y1))
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def outline(rng: np.random.Generator, area: float) -> tuple[Ring, float, float]:
    """Return a box, an L or a U, with the width and height of its full lower part."""
    kind = int(rng.integers(3))
    fill = (1.0, 0.82, 0.85)[kind]
    wide = round(float(np.sqrt(area / fill * rng.uniform(1.0, 2.0))), 2)
    high = round(area / fill / wide, 2)
    if kind == 0:
        return box(0, 0, wide, high), wide, high
    if kind == 1:
        x, y = round(0.6 * wide, 2), round(0.55 * high, 2)
        return [(0, 0), (wide, 0), (wide, y), (x, y), (x, high), (0, high)], wide, y
    x0, x1, y = round(0.35 * wide, 2), round(0.65 * wide, 2), round(0.5 * high, 2)
    ring = [(0, 0), (wide, 0), (wide, high), (x1, high), (x1, y), (x0, y), (x0, high), (0, high)]
    return ring, wide, y


def floor(index: int, seed: int, rooms: int | None = None) -> FloorProblem:
    """Return one synthetic floor, of 10 to 60 rooms where `rooms` is not given."""
    rng = item_generator(seed, "synthetic", index)
    drawn = int(rng.integers(10, 61))
    rooms = drawn if rooms is None else rooms
    area = float(np.clip(rooms * rng.uniform(18.0, 40.0), 200.0, 2000.0))
    ring, wide, high = outline(rng, area)
    x, y = wide * rng.uniform(0.15, 0.45), high * rng.uniform(0.2, 0.35)
    cores = [
        ProblemCore(id="stair", type="stair", polygon=box(x, y, x + 5, y + 3)),
        ProblemCore(id="lift", type="elevator", polygon=box(x + 5, y, x + 7, y + 2)),
    ]
    holes, walls = [], []
    if rng.random() < 0.4 and wide > 22 and high > 9:
        hx, hy = wide * rng.uniform(0.68, 0.8), high * rng.uniform(0.3, 0.4)
        holes = [box(hx, hy, hx + 2.5, hy + 2.5)]
    if rng.random() < 0.5:
        wx = round(wide * rng.uniform(0.05, 0.12) + 3, 2)
        walls = [((wx, 0.0), (wx, round(high * 0.3, 2)))]
    free = area - 19.0 - 6.25 * len(holes)
    share = rng.uniform(0.15, 0.25)
    sizes = rng.lognormal(0.0, 0.4, rooms - 1)
    sizes *= free * (1.0 - share) / sizes.sum()
    nodes = [ProblemNode(id="corridor", type="main", area=float(free * share))]
    edges = [Edge(source="corridor", target="stair"), Edge(source="corridor", target="lift")]
    for k in range(rooms - 1):
        name = f"room_{k}"
        nodes.append(ProblemNode(id=name, type="Entities", area=float(sizes[k])))
        inner = k > 5 and rng.random() < 0.12
        source = f"room_{int(rng.integers(5))}" if inner else "corridor"
        edges.append(Edge(source=source, target=name))
    return FloorProblem(
        plan_id=f"synthetic-{index}",
        boundary=ring,
        holes=holes,
        cores=cores,
        structural_walls=walls,
        nodes=nodes,
        edges=edges,
        min_access_wall=1.2,
    )


def summary(problems: list[FloorProblem], layouts: list[FloorLayout]) -> str:
    """Return the result as text."""
    lines = []
    for problem, layout in zip(problems, layouts):
        lines += [f"{problem.plan_id}: {edge.source} - {edge.target}: {edge.reason}" for edge in layout.unmet_edges]
    met = sum(layout.topology_satisfied for layout in layouts)
    lines.append(f"{met} of {len(layouts)} floors with every edge met")
    narrow = sum(layout.checks.get("usable", 0.0) < len(problem.nodes) for problem, layout in zip(problems, layouts))
    lines.append(f"{narrow} floors with a narrow room")
    seconds = [layout.seconds for layout in layouts]
    median, high, most = np.percentile(seconds, [50, 95, 100])
    lines.append(f"elapsed: median {median:.2f} s, 95th percentile {high:.2f} s, largest {most:.2f} s")
    lines.append("| rooms | floors | median s | largest s | candidates | area error | corners |")
    lines.append("| --- | --- | --- | --- | --- | --- | --- |")
    for low in range(10, 61, 10):
        chosen = [
            layout
            for problem, layout in zip(problems, layouts)
            if low <= len(problem.nodes) < low + 10 and layout.rooms
        ]
        if chosen:
            seconds = [layout.seconds for layout in chosen]
            mean = {
                key: float(np.mean([layout.checks[key] for layout in chosen]))
                for key in ("candidates", "area_error", "corners")
            }
            lines.append(
                f"| {low}-{low + 9} | {len(chosen)} | {np.median(seconds):.2f} | {max(seconds):.2f} | "
                f"{mean['candidates']:.0f} | {mean['area_error']:.3f} | {mean['corners']:.2f} |"
            )
    return "\n".join(lines)


def main() -> None:
    """Run the benchmark."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--floors", type=int, default=200)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("-o", "--output", type=Path, help="write the problems here and stop")
    args = parser.parse_args()
    problems = [floor(k, args.seed) for k in range(args.floors)]
    if args.output:
        args.output.write_bytes(encode_bytes(problems))
        return
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "problems.json"
        source.write_bytes(encode_bytes(problems))
        layouts = solve_file(source, Path(folder) / "layouts.json", jobs=args.jobs)
    print(summary(problems, layouts))


if __name__ == "__main__":
    main()

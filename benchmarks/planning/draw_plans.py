"""Draw the solved floors of a brief side by side: ``draw_plans.py "a small flat" -o flat.png``."""

import argparse
from pathlib import Path

from shapely.geometry import Polygon
from shapely.ops import polylabel

from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import PlanReply
from mansion_planner.plan import plan_building
from mansion_planner.solver import solve_floor

COLOURS = {"circulation": "#f2e6c9", "public": "#cfe3f5", "private": "#d8efd3", "service": "#ead7ea"}


def draw(axis: object, reply: PlanReply, number: int, layout: FloorLayout) -> None:
    """Draw one floor into a matplotlib axis."""
    from mansion_knowledge import default_knowledge

    base = default_knowledge()
    topology, problem = reply.topologies[number], reply.problems[number]
    kinds = {node.id: base.room(node.room_type).zone for node in topology.nodes}
    ax = axis
    for room in layout.rooms:
        shape = Polygon(room.polygon, room.holes)
        xs, ys = zip(*room.polygon, room.polygon[0])
        ax.fill(xs, ys, color=COLOURS.get(kinds.get(room.id, "service"), "w"))  # type: ignore[attr-defined]
        ax.plot(xs, ys, color="k", lw=1.0)  # type: ignore[attr-defined]
        spot = polylabel(shape, tolerance=0.1).coords[0]
        ax.text(*spot, f"{room.id}\n{shape.area:.0f}", ha="center", va="center", fontsize=5)  # type: ignore[attr-defined]
    for core in problem.cores:
        xs, ys = zip(*core.polygon, core.polygon[0])
        ax.fill(xs, ys, color="#888")  # type: ignore[attr-defined]
        centre = Polygon(core.polygon).centroid
        ax.text(centre.x, centre.y, core.id, ha="center", va="center", fontsize=5, color="w")  # type: ignore[attr-defined]
    for edge in layout.edges:
        if edge.kind == "access" and edge.wall is not None:
            (ax0, ay0), (bx0, by0) = edge.wall
            mx, my = (ax0 + bx0) / 2, (ay0 + by0) / 2
            ax.plot([mx], [my], "r.", ms=3)  # type: ignore[attr-defined]
    for (x0, y0), (x1, y1) in problem.structural_walls:
        ax.plot([x0, x1], [y0, y1], color="b", lw=1.5)  # type: ignore[attr-defined]
    ok = "" if layout.topology_satisfied else " UNMET"
    floor = reply.program.floors[number]
    ax.set_title(f"{floor.label}: {floor.gross_floor_area:.0f} m2{ok}", fontsize=7)  # type: ignore[attr-defined]
    ax.set_aspect("equal")  # type: ignore[attr-defined]
    ax.axis("off")  # type: ignore[attr-defined]


def main() -> None:
    """Plan, solve and draw."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("briefs", nargs="+")
    parser.add_argument("-o", "--output", type=Path, required=True)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--most", type=int, default=4, help="floors drawn of each building")
    options = parser.parse_args()
    rows = [plan_building(BuildRequest(description=b, seed=options.seed)) for b in options.briefs]
    columns = max(min(len(reply.problems), options.most) for reply in rows)
    figure, axes = plt.subplots(len(rows), columns, figsize=(4.2 * columns, 3.4 * len(rows)), squeeze=False)
    for row, (brief, reply) in enumerate(zip(options.briefs, rows)):
        for column in range(columns):
            if column < len(reply.problems):
                draw(axes[row][column], reply, column, solve_floor(reply.problems[column]))
            else:
                axes[row][column].axis("off")
        axes[row][0].text(0, 1.12, brief, transform=axes[row][0].transAxes, fontsize=8)
    figure.tight_layout()
    figure.savefig(options.output, dpi=110)


if __name__ == "__main__":
    main()

"""Check the cores that a model chooses (Fig. 23's placement preferences), and read them as the program's."""

from typing import Literal

import shapely
from shapely.geometry import Polygon

from mansion_llm import Fault
from mansion_msgs_py.program import CorePlan, VerticalConnectivity
from mansion_planner.llm.answers import CoreAnswer, CoresAnswer
from mansion_planner.program.building import PlannedBuilding

__all__ = ["core_faults", "core_sizes", "cores_of", "same_cores"]

_PASSAGE = 0.6
"""Half the width of the free strip that must join all parts of a floor, metres."""


def core_sizes(given: VerticalConnectivity) -> dict[str, list[tuple[float, float]]]:
    """Return the accepted sizes of each type of core: those of the rules' cores, either way round."""
    sizes: dict[str, list[tuple[float, float]]] = {"stair": [(3.0, 6.0)], "elevator": [(2.0, 2.0)]}
    for core in given.cores:
        size = (core.x[1] - core.x[0], core.y[1] - core.y[0])
        if size not in sizes[core.type]:
            sizes[core.type].append(size)
    return {kind: sorted({s for w, d in all_ for s in ((w, d), (d, w))}) for kind, all_ in sizes.items()}


def _common_outline(planned: PlannedBuilding) -> Polygon:
    shapes = [Polygon(e.outline, e.holes) for e in planned.envelopes.values()]
    common = shapes[0]
    for shape in shapes[1:]:
        common = common.intersection(shape)
    return common


def core_faults(answer: CoresAnswer, planned: PlannedBuilding) -> list[Fault]:
    """Return what is wrong with the cores of an answer."""
    given = planned.program.vertical_connectivity
    wanted = {kind: sum(c.type == kind for c in given.cores) for kind in ("stair", "elevator")}
    got = {kind: sum(c.type == kind for c in answer.cores) for kind in wanted}
    out = [
        f"the core type {core.type[:30]!r} is neither stair nor elevator"
        for core in answer.cores
        if core.type not in wanted
    ]
    for kind, count in wanted.items():
        if got[kind] != count:
            out.append(f"{count} {kind} cores are needed, not {got[kind]} ({given.justification})")
    if answer.method != given.method:
        out.append(f"method must be {given.method!r} ({given.justification})")
    if not out:
        out = _place_faults(answer.cores, planned)
    return [Fault(f"vertical_connectivity: {text}", "cores") for text in out]


def _place_faults(cores: list[CoreAnswer], planned: PlannedBuilding) -> list[str]:
    if same_cores(cores, planned.program.vertical_connectivity.cores):
        return []
    out = []
    sizes = core_sizes(planned.program.vertical_connectivity)
    outline = _common_outline(planned)
    boxes: list[Polygon] = []
    for core in cores:
        name = f"the {core.type} at x={list(core.x)}, y={list(core.y)}"
        values = (*core.x, *core.y)
        box = shapely.box(core.x[0], core.y[0], core.x[1], core.y[1])
        if not all(0 <= v <= 1000 and v == round(v) for v in values):
            out.append(f"{name} needs non-negative integer coordinates")
            continue
        size = (core.x[1] - core.x[0], core.y[1] - core.y[0])
        if size not in sizes[core.type]:
            accepted = " or ".join(f"{w:g} x {d:g}" for w, d in sizes[core.type])
            out.append(f"{name} must measure {accepted}")
        elif not outline.buffer(1e-6).covers(box):
            out.append(f"{name} is not inside the outline of every floor")
        elif any(box.intersection(other).area > 1e-6 for other in boxes):
            out.append(f"{name} overlaps another core")
        boxes.append(box)
    if out:
        return out
    for core, box in zip(cores, boxes):
        others = shapely.union_all([other for other in boxes if other is not box])
        if not _in_corner(box, outline, others):
            out.append(f"the {core.type} at x={list(core.x)}, y={list(core.y)} is in no corner of two exterior walls")
    free = outline.difference(shapely.union_all(boxes)).buffer(-_PASSAGE, join_style="mitre")
    if not isinstance(free, Polygon):
        out.append("the cores cut the floor apart")
    return out


def _in_corner(box: Polygon, outline: Polygon, others: Polygon) -> bool:
    """Whether two sides at right angles lie on exterior walls, one of them perhaps on another core."""
    x0, y0, x1, y1 = box.bounds
    sides = [((x0, y0), (x1, y0)), ((x1, y0), (x1, y1)), ((x0, y1), (x1, y1)), ((x0, y0), (x0, y1))]
    lines = [shapely.LineString(side) for side in sides]
    outer = [_covered(line, outline.boundary) for line in lines]
    backed = [o or _covered(line, others.boundary) for o, line in zip(outer, lines)]
    return any((outer[a] and backed[b]) or (backed[a] and outer[b]) for a in (0, 2) for b in (1, 3))


def _covered(line: shapely.LineString, boundary: shapely.Geometry | None) -> bool:
    return boundary is not None and bool(line.intersection(boundary.buffer(1e-6)).length >= 0.95 * line.length)


def same_cores(cores: list[CoreAnswer], given: list[CorePlan]) -> bool:
    """Whether an answer repeats the given cores."""

    def key(core: CoreAnswer | CorePlan) -> tuple[str, float, float, float, float]:
        return core.type, core.x[0], core.y[0], core.x[1], core.y[1]

    return sorted(map(key, cores)) == sorted(map(key, given))


def cores_of(answer: CoresAnswer) -> list[CorePlan]:
    """Return the program's cores of a faultless answer."""
    counts: dict[str, int] = {}
    out = []
    for core in answer.cores:
        counts[core.type] = counts.get(core.type, 0) + 1
        kind: Literal["stair", "elevator"] = "stair" if core.type == "stair" else "elevator"
        out.append(CorePlan(id=f"{kind}_{counts[kind]}", type=kind, x=core.x, y=core.y))
    return sorted(out, key=lambda core: (core.type != "stair", core.id))

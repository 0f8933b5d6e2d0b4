"""From the best partition to the FloorLayout payload."""

from mansion_geometry.rings import polygon_parts
from mansion_msgs_py.layout import FloorLayout, LayoutRoom, RealisedEdge, UnmetEdge
from mansion_planner.solver.cutting import RoundsResult
from mansion_planner.solver.feasibility import Relaxed
from mansion_planner.solver.measured import Measured
from mansion_planner.solver.model import FloorModel
from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.polygons import layout_room, turned_back
from mansion_planner.solver.verify import MOST_STRADDLED, Verdict, figures_of

__all__ = ["finish"]


def _turned_edge(edge: RealisedEdge, angle: float) -> RealisedEdge:
    """Return the edge with its wall in the problem's frame."""
    edge.length = round(edge.length, 4)
    if edge.wall is not None:
        a, b = (turned_back([p], angle)[0] for p in edge.wall)
        edge.wall = (a, b)
    return edge


def _reason(model: FloorModel, edge: RealisedEdge, relaxed: list[Relaxed], options: SolverOptions, used: int) -> str:
    for entry in relaxed:
        if {entry.link.source, entry.link.target} == {edge.source, edge.target}:
            return entry.reason
    need = model.problem.min_access_wall if edge.kind == "access" else options.adjacent_wall
    what = "they do not touch"
    if edge.length > 0.0:
        what = f"they share {edge.length:.2f} m of wall"
    return f"{what}, {need:g} m are needed; {used} candidate layouts were looked at"


def _messages(verdict: Verdict) -> list[str]:
    """Return what is wrong with shapes and structural walls, in words."""
    lines = [f"{name}: {reason}" for name, reason in verdict.shape_faults.items()]
    lines += [
        f"structural wall {k} lies inside rooms for {length:.2f} m"
        for k, length in enumerate(verdict.straddled)
        if length > MOST_STRADDLED
    ]
    return lines


def finish(
    model: FloorModel,
    measured: Measured,
    options: SolverOptions,
    rounds: RoundsResult,
    relaxed: list[Relaxed],
    used: int,
) -> FloorLayout:
    """Return the layout of the best partition, measured on its final polygons."""
    shapes, verdict = measured.shapes, measured.verdict
    rooms = [
        layout_room(room.id, max(polygon_parts(shape), key=lambda p: p.area), model.angle)
        for room, shape in zip(model.rooms, shapes)
    ]
    rooms += [LayoutRoom(id=r.id, polygon=r.polygon) for r in model.problem.fixed_rooms]
    edges = [_turned_edge(edge, model.angle) for edge in verdict.edges]
    unmet = [
        UnmetEdge(source=e.source, target=e.target, kind=e.kind, reason=_reason(model, e, relaxed, options, used))
        for e in edges
        if not e.satisfied
    ]
    return FloorLayout(
        rooms=rooms,
        topology_satisfied=not unmet,
        unmet_edges=unmet,
        plan_id=model.problem.plan_id,
        edges=edges,
        rounds=rounds.records,
        hub=model.hub,
        area_scale=round(model.area_scale, 6),
        scores={"energy": round(measured.partition.energy, 6), "rounds": round(rounds.energy, 6)},
        checks={name: round(value, 9) for name, value in figures_of(model, shapes, verdict).items()}
        | {"candidates": float(used)},
        messages=[*model.messages, *_messages(verdict)],
        building_id=model.problem.building_id,
        floor=model.problem.floor,
    )

"""The floor solver's problem: outline, cores, room graph, and the sketch's seeds."""

from mansion_msgs_py.layout import FloorProblem, ProblemCore, ProblemNode, SeedRange
from mansion_msgs_py.topology import FloorTopology
from mansion_planner.program.building import PlannedBuilding
from mansion_planner.program.model import Box, Storey, box_area

__all__ = ["ACCESS_WALL", "floor_problem"]

ACCESS_WALL = 1.20
"""Least shared wall of an access edge in a building, metres."""


def floor_problem(planned: PlannedBuilding, storey: Storey, topology: FloorTopology, seed: int) -> FloorProblem:
    """Return what the floor solver is asked for a floor."""
    sketch = planned.sketches[storey.index]
    boxes: dict[str, list[Box]] = {corridor.id: corridor.boxes for corridor in sketch.corridors}
    boxes |= {placement.room.id: placement.boxes for placement in sketch.rooms}
    floor = next(f for f in planned.program.floors if f.index == storey.index)
    nodes = []
    for node in topology.nodes:
        shape = [planned.frame.area_box(box) for box in boxes.get(node.id, [])]
        nodes.append(
            ProblemNode(
                id=node.id, type=node.type, area=node.area, room_type=node.room_type,
                open_relation=node.open_relation, seed=_centroid(shape), seed_box=_bounds(shape),
            )
        )  # fmt: skip
    cores = [
        ProblemCore(
            id=core.id,
            type=core.type,
            polygon=[(core.x[0], core.y[0]), (core.x[1], core.y[0]), (core.x[1], core.y[1]), (core.x[0], core.y[1])],
            door_side=core.door_side,
        )
        for core in planned.program.vertical_connectivity.cores
    ]
    return FloorProblem(
        boundary=floor.outline, holes=floor.holes, cores=cores, nodes=nodes, edges=topology.edges,
        structural_walls=floor.structural_walls, plan_id=f"{planned.program.building_id}/F{storey.index}",
        min_access_wall=ACCESS_WALL, building_id=planned.program.building_id, floor=storey.index, seed=seed,
    )  # fmt: skip


def _centroid(boxes: list[Box]) -> tuple[float, float] | None:
    total = sum(box_area(box) for box in boxes)
    if total <= 0:
        return None
    x = sum(box_area(b) * (b[0] + b[2]) / 2 for b in boxes) / total
    y = sum(box_area(b) * (b[1] + b[3]) / 2 for b in boxes) / total
    return round(x, 4), round(y, 4)


def _bounds(boxes: list[Box]) -> SeedRange | None:
    if not boxes:
        return None
    return SeedRange(
        x=(round(min(b[0] for b in boxes), 4), round(max(b[2] for b in boxes), 4)),
        y=(round(min(b[1] for b in boxes), 4), round(max(b[3] for b in boxes), 4)),
    )

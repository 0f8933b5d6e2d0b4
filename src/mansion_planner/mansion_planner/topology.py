"""From the program of a floor to its room graph (schema of Fig. 24) and its solver problem."""

import msgspec

from mansion_geometry.wall_sizes import ACCESS_WALL
from mansion_knowledge import KnowledgeBase
from mansion_msgs_py.layout import FloorProblem, ProblemCore, ProblemNode, SeedRange
from mansion_msgs_py.topology import Edge, FloorTopology, TopologyNode
from mansion_planner.program.building import PlannedBuilding, materials_of
from mansion_planner.program.model import Box, Storey, box_area

__all__ = ["fallback_problem", "floor_problem", "floor_topology"]


def floor_topology(planned: PlannedBuilding, storey: Storey, knowledge: KnowledgeBase) -> FloorTopology:
    """Return the nodes and edges of a floor: hub, corridors, rooms and cores.

    Every room is reached through ``access`` edges; the areas of all nodes but the cores add up to the free area.
    """
    sketch = planned.sketches[storey.index]
    style = planned.decisions.style
    nodes: list[TopologyNode] = []
    edges: list[Edge] = []
    for number, corridor in enumerate(sketch.corridors):
        kind = storey.hub if number == 0 else knowledge.room(_passage(storey))
        floor, wall = materials_of(kind, style, knowledge, planned.decisions.facts.materials)
        nodes.append(
            TopologyNode(
                id=corridor.id, type="main" if number == 0 else "Entities", area=round(corridor.area, 3),
                floor_material=floor, wall_material=wall, open_relation="open", room_type=kind.name,
            )
        )  # fmt: skip
        if corridor.parent:
            edges.append(Edge(source=corridor.parent, target=corridor.id, kind="access"))
    names = {placement.room.id: placement for placement in sketch.rooms}
    floor_program = next(f for f in planned.program.floors if f.index == storey.index)
    materials = {room.id: (room.floor_material, room.wall_material) for room in floor_program.rooms}
    for name, placement in names.items():
        floor, wall = materials[name]
        nodes.append(
            TopologyNode(
                id=name, type="Entities", area=round(placement.area, 3), floor_material=floor,
                wall_material=wall, open_relation="open" if placement.room.kind.open else "door",
                room_type=placement.room.kind.name,
            )
        )  # fmt: skip
        edges.append(Edge(source=placement.parent, target=name, kind="access"))
    for core in planned.massing.cores:
        floor, wall = materials_of(knowledge.room("corridor"), style, knowledge)
        nodes.append(
            TopologyNode(
                id=core.id, type=core.type, area=round(box_area(core.box), 3), floor_material=floor,
                wall_material=wall, open_relation="door", room_type=core.type,
            )
        )  # fmt: skip
        edges.append(Edge(source=sketch.core_parent.get(core.id, storey.hub.name), target=core.id, kind="access"))
    linked = {frozenset((edge.source, edge.target)) for edge in edges}
    edges += [
        Edge(source=room.id, target=other, kind="adjacent")
        for room in floor_program.rooms
        for other in room.adjacent_to
        if frozenset((room.id, other)) not in linked
    ]
    return FloorTopology(nodes=nodes, edges=edges, building_id=planned.program.building_id, floor=storey.index)


def _passage(storey: Storey) -> str:
    return "hallway" if storey.use.family == "home" else "corridor"


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


def fallback_problem(problem: FloorProblem, planned: PlannedBuilding, storey: Storey) -> FloorProblem | None:
    """Return the problem of a loose sketch with the places that it was made from; none where the sketch has places.

    It misses stated areas or wished neighbours, but its access edges are known to hold.
    """
    sketch = planned.sketches[storey.index].placed
    if sketch is None:
        return None
    boxes: dict[str, list[Box]] = {corridor.id: corridor.boxes for corridor in sketch.corridors}
    boxes |= {placement.room.id: placement.boxes for placement in sketch.rooms}
    areas = {corridor.id: corridor.area for corridor in sketch.corridors}
    areas |= {placement.room.id: placement.area for placement in sketch.rooms}
    nodes = []
    for node in problem.nodes:
        shape = [planned.frame.area_box(box) for box in boxes.get(node.id, [])]
        area = round(areas.get(node.id, node.area or 1.0), 3)
        nodes.append(msgspec.structs.replace(node, area=area, seed=_centroid(shape), seed_box=_bounds(shape)))
    edges = [edge for edge in problem.edges if edge.kind == "access"]
    return msgspec.structs.replace(problem, nodes=nodes, edges=edges)


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

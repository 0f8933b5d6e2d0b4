"""The room graph of a floor (schema of Fig. 24) from its sketch."""

from mansion_knowledge import KnowledgeBase
from mansion_msgs_py.topology import Edge, FloorTopology, TopologyNode
from mansion_planner.program.building import PlannedBuilding
from mansion_planner.program.materials import materials_of
from mansion_planner.program.model import Storey, box_area

__all__ = ["floor_topology"]


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

"""Ask a model for the room graph of a floor (Fig. 24), and check it."""

import msgspec
import shapely
from shapely.geometry import Polygon

from mansion_llm import Fault, Prompt, quoted_data
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.layout import FloorProblem, ProblemCore, ProblemNode
from mansion_msgs_py.program import FloorProgram
from mansion_msgs_py.topology import Edge, EdgeKind, FloorTopology, NodeKind, TopologyNode
from mansion_planner.llm.answers import NodeAnswer, TopologyAnswer
from mansion_planner.llm.cleaning import clean_id, clean_text, room_kind
from mansion_planner.llm.context import ARCHITECT, CLOSING, Context, as_json, number
from mansion_planner.llm.graph_rules import MOST_CHILDREN, access_promoted, graph_faults
from mansion_planner.llm.palette import Palette
from mansion_planner.program.building import PlannedBuilding
from mansion_planner.solver.room_graph import resolve_zones

__all__ = ["free_region", "plan_model_topology"]


_RULES = f"""\
Rules:
1. Give the abstract connections of this floor, no geometry. Every room of the list is a node with the same id; every
   stair and elevator is a node with its id. Beyond them you may add only corridors, and area zones.
2. Node types: main (exactly one: the hub that is suggested, unless another space clearly dominates the floor),
   Entities (a room or corridor), area (a zone that will be divided completely among the rooms hanging on it), stair,
   elevator.
3. Edge kinds: access (one walks from the one into the other) and adjacent (they only share a wall). Every room is
   reached from the hub through access edges, never through a stair, an elevator, a toilet or another bedroom.
4. No toilet opens into a kitchen. Stairs and elevators open to the hub or a corridor.
5. At most {MOST_CHILDREN} access edges at one space, about ten are better: use a corridor or an area zone for more.
   Rooms that belong together hang on the same corridor. The graph must be drawable without crossings.
6. open_relation is "open" for main and for spaces that flow into their neighbour, "door" for all others and for stairs
   and elevators.
7. Areas are in square metres and together fill the floor polygon without the cores; keep those of the list where you
   can and give the rest to hub and corridors.
8. Each node has a floor_material and a wall_material in a few plain words."""


_SCHEMA = """\
{"nodes": [{"id": "<id>", "type": "main|Entities|area|stair|elevator", "area": <float>, "floor_material": "<words>",
            "wall_material": "<words>", "open_relation": "open|door"}],
 "edges": [{"source": "<id>", "target": "<id>", "kind": "access|adjacent"}]}"""


_KINDS: dict[str, NodeKind] = {
    "main": "main", "entities": "Entities", "entity": "Entities", "room": "Entities", "area": "area",
    "stair": "stair", "elevator": "elevator",
}  # fmt: skip


def plan_model_topology(
    context: Context, planned: PlannedBuilding, offline: FloorTopology, palette: Palette
) -> FloorTopology | None:
    """Return the model's room graph of a floor, or ``None`` where the offline one is to stay.

    Parameters
    ----------
    offline : FloorTopology
        The graph of the sketch of the same rooms.
    """
    piece = f"topology/F{offline.floor}"
    if not context.client.wants("topology"):
        context.from_rules(piece)
        return None
    floor = next(f for f in planned.program.floors if f.index == offline.floor)
    reader = _Reader(context, planned, floor, offline, palette)
    prompt = _topology_prompt(context, planned, floor, palette)
    answer = context.client.ask(prompt, TopologyAnswer, reader.faults)
    if answer.value is None or not answer.good:
        context.from_rules(piece, answer.reason)
        return None
    context.from_model(piece)
    topology, _ = reader.topology(answer.value)
    return topology


def free_region(floor: FloorProgram, planned: PlannedBuilding) -> Polygon:
    """Return a floor's outline without holes and cores."""
    cores = [shapely.box(c.x[0], c.y[0], c.x[1], c.y[1]) for c in planned.program.vertical_connectivity.cores]
    return Polygon(floor.outline, floor.holes).difference(shapely.union_all(cores))


def _topology_prompt(context: Context, planned: PlannedBuilding, floor: FloorProgram, palette: Palette) -> Prompt:
    """Return the question for one floor's room graph."""
    free = free_region(floor, planned)
    rings = [
        [(round(x, 2), round(y, 2)) for x, y in ring.coords[:-1]]
        for part in (free.geoms if hasattr(free, "geoms") else [free])
        for ring in (part.exterior, *part.interiors)
    ]
    cores = [{"id": c.id, "type": c.type, "x": c.x, "y": c.y} for c in planned.program.vertical_connectivity.cores]
    rooms = [
        {"id": r.id, "area": r.area_estimate, "floor_material": r.floor_material, "wall_material": r.wall_material}
        | ({"beside": r.adjacent_to} if r.adjacent_to else {})
        for r in floor.rooms
    ]
    lines = [
        quoted_data("brief", context.description),
        f"Building: {planned.program.reasoning}",
        f"Floor {floor.index}, {number(floor.gross_floor_area)} m2 gross, {number(free.area)} m2 without cores: "
        f"{floor.requirement}",
        f"Floor polygon without cores (first ring the outline): {as_json(rings)}",
        f"Stairs and elevators: {as_json(cores)}",
        f"Rooms of the program, the suggested hub first: {as_json(rooms)}",
        "Palette of the building:\n" + palette.hints(),
        _RULES,
        CLOSING,
        _SCHEMA,
    ]
    return Prompt("floor_topology", ARCHITECT, "\n".join(lines))


class _Reader:
    """Reads answers for one floor."""

    def __init__(
        self, context: Context, planned: PlannedBuilding, floor: FloorProgram, offline: FloorTopology, palette: Palette
    ) -> None:
        self.context, self.planned, self.floor, self.palette = context, planned, floor, palette
        self.cores = {n.id: n for n in offline.nodes if n.type in ("stair", "elevator")}
        self.building_id = offline.building_id
        self.free = float(free_region(floor, planned).area)
        self.rooms = {room.id: room for room in floor.rooms}

    def faults(self, answer: TopologyAnswer) -> list[Fault]:
        """Return what is wrong with an answer."""
        topology, out = self.topology(answer)
        ids = {node.id for node in topology.nodes}
        out += [f"the {core.type} {name} is missing" for name, core in self.cores.items() if name not in ids]
        out += [f"the room {name} is missing" for name in self.rooms if name not in ids]
        out += graph_faults(topology, self.context.knowledge) + self._hub_faults(topology)
        if not out:
            out += self._zone_faults(topology) + self._wish_faults(topology)
        return [Fault(text) for text in out]

    def topology(self, answer: TopologyAnswer) -> tuple[FloorTopology, list[str]]:
        """Return an answer as a room graph, and what is wrong with its nodes and edges."""
        read = [self._node(entry) for entry in answer.nodes]
        nodes = [node for node, _ in read if node is not None]
        faults = [fault for _, wrong in read for fault in wrong]
        edges: list[Edge] = []
        seen: dict[frozenset[str], int] = {}
        for edge in answer.edges:
            source, target = clean_id(edge.source), clean_id(edge.target)
            kind: EdgeKind | None = {"access": "access", "adjacent": "adjacent"}.get(edge.kind)  # type: ignore[assignment]
            if not source or not target or kind is None:
                faults.append(
                    f"an edge needs two node ids and a kind of access or adjacent, not {clean_text(edge.kind, 20)!r}"
                )
                continue
            pair = frozenset((source, target))
            if pair not in seen:
                seen[pair] = len(edges)
                edges.append(Edge(source=source, target=target, kind=kind))
            elif kind == "access":
                edges[seen[pair]] = Edge(source=source, target=target, kind=kind)
        topology = FloorTopology(
            nodes=nodes or [self._hub_alone()], edges=edges, building_id=self.building_id, floor=self.floor.index
        )
        return self._with_areas(access_promoted(topology)), faults

    def _hub_alone(self) -> TopologyNode:
        hub = self.floor.rooms[0]
        return TopologyNode(id=hub.id, type="main", area=self.free, room_type=hub.room_type)

    def _node(self, entry: NodeAnswer) -> tuple[TopologyNode | None, list[str]]:
        """Return a node, none where it is unreadable, and what is wrong with it."""
        name, kind = clean_id(entry.id), _KINDS.get(entry.type.lower())
        if not name:
            return None, [f"{clean_text(entry.id, 40)!r} is no id of the rooms, stairs and elevators"]
        if kind is None:
            known = "main, Entities, area, stair, elevator"
            return None, [f"{name}: the type {clean_text(entry.type, 20)!r} is none of {known}"]
        if name in self.cores:
            own = self.cores[name]
            return own, [] if kind == own.type else [f"{name} is of type {own.type}"]
        if kind in ("stair", "elevator"):
            return None, [f"there is no {kind} {name}"]
        if not 0.0 < entry.area < 1e5:
            return None, [f"{name}: area is {entry.area:g}; a positive number of square metres is needed"]
        faults: list[str] = []
        room = self.rooms.get(name)
        room_type = room.room_type if room else room_kind(name, self.context.knowledge, {}).name
        if room is None and kind != "area" and self.context.knowledge.room(room_type).zone != "circulation":
            faults.append(f"{name} is not in the list of rooms; only corridors and area zones may be added")
        if room is not None and not 0.6 * room.area_estimate <= entry.area and name != self.floor.rooms[0].id:
            faults.append(f"{name} has {entry.area:g} m2 and should have about {room.area_estimate:g}")
        floor, wall = entry.floor_material, entry.wall_material
        if not floor and room is not None:
            floor, wall = room.floor_material, room.wall_material
        floor, wall = self.palette.materials(room_type, floor, wall)
        opens = "open" if kind == "main" or entry.open_relation == "open" else "door"
        node = TopologyNode(
            id=name, type=kind, area=float(entry.area), floor_material=floor, wall_material=wall,
            open_relation="open" if opens == "open" else "door", room_type=room_type,
        )  # fmt: skip
        return node, faults

    def _with_areas(self, topology: FloorTopology) -> FloorTopology:
        """Let the areas add up to the free area: rooms as in the program, the rest to hub and corridors."""
        zones = self._zones(topology)
        rooms = [n for n in topology.nodes if n.id not in self.cores and n.id not in zones]
        around = [
            n for n in rooms if self.context.knowledge.room(n.room_type).zone == "circulation" or n.type == "main"
        ]
        inner = [n for n in rooms if n not in around]
        areas = {n.id: self.rooms[n.id].area_estimate if n.id in self.rooms else n.area for n in inner}
        left = self.free - sum(areas.values())
        least = 0.08 * self.free if around else 0.0
        if inner and left < least:
            scale = (self.free - least) / sum(areas.values())
            areas = {name: area * scale for name, area in areas.items()}
            left = least
        share = left / sum(n.area for n in around) if around else 0.0
        areas |= {n.id: max(n.area * share, 0.5) for n in around}
        nodes = []
        for node in topology.nodes:
            area = areas.get(node.id, node.area)
            nodes.append(msgspec.structs.replace(node, area=round(area, 3)))
        return msgspec.structs.replace(topology, nodes=nodes)

    def _problem(self, topology: FloorTopology) -> FloorProblem:
        cores = [
            ProblemCore(id=c.id, type=c.type, polygon=[(c.x[0], c.y[0]), (c.x[1], c.y[0]), (c.x[1], c.y[1])])
            for c in self.planned.program.vertical_connectivity.cores
        ]
        nodes = [ProblemNode(id=n.id, type=n.type, area=n.area) for n in topology.nodes]
        return FloorProblem(boundary=self.floor.outline, nodes=nodes, edges=topology.edges, cores=cores)

    def _zones(self, topology: FloorTopology) -> set[str]:
        """Return the area zones, which are divided completely and vanish."""
        if not any(node.type == "area" for node in topology.nodes):
            return set()
        try:
            return set(resolve_zones(self._problem(topology), set(self.cores))[1])
        except MansionError:
            return set()

    def _hub_faults(self, topology: FloorTopology) -> list[str]:
        """Another space than the program's hub may be main only where it dominates the floor."""
        hub = self.floor.rooms[0]
        main = next((node for node in topology.nodes if node.type == "main"), None)
        if main is None or main.id == hub.id:
            return []
        if main.id in self.rooms and self.rooms[main.id].area_estimate > 1.5 * hub.area_estimate:
            return []
        return [f"main must be {hub.id}: {main.id} does not dominate the floor"]

    def _zone_faults(self, topology: FloorTopology) -> list[str]:
        zones = self._zones(topology)
        return [
            f"{name} is a room of the program; as an area zone with rooms hanging on it, it would vanish"
            for name in self.rooms
            if name in zones
        ]

    def _wish_faults(self, topology: FloorTopology) -> list[str]:
        """Return the wished neighbours without an edge."""
        pairs = {frozenset((edge.source, edge.target)) for edge in topology.edges}
        return [
            f"the brief wants {room.id} beside {other}: they need an edge"
            for room in self.floor.rooms
            for other in room.adjacent_to
            if frozenset((room.id, other)) not in pairs
        ]

"""The prompt for a floor's room graph: the inputs, rules and output of Fig. 24 in our words."""

import shapely
from shapely.geometry import Polygon

from mansion_llm import Prompt, quoted_data
from mansion_msgs_py.program import FloorProgram
from mansion_planner.llm.context import Context
from mansion_planner.llm.graph_rules import MOST_CHILDREN
from mansion_planner.llm.palette import Palette
from mansion_planner.llm.wording import ARCHITECT, CLOSING, as_json, number
from mansion_planner.program.building import PlannedBuilding

__all__ = ["free_region", "topology_prompt"]

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


def free_region(floor: FloorProgram, planned: PlannedBuilding) -> Polygon:
    """Return a floor's outline without holes and cores."""
    cores = [shapely.box(c.x[0], c.y[0], c.x[1], c.y[1]) for c in planned.program.vertical_connectivity.cores]
    return Polygon(floor.outline, floor.holes).difference(shapely.union_all(cores))


def topology_prompt(context: Context, planned: PlannedBuilding, floor: FloorProgram, palette: Palette) -> Prompt:
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

"""A plan in the payloads that the planner writes: program, room graphs, problems and wishes."""

from collections import Counter
from collections.abc import Sequence

import msgspec
from shapely.geometry import Polygon

from mansion_geometry.rings import ring_of
from mansion_geometry.stair_landings import with_landings
from mansion_geometry.wall_sizes import ACCESS_WALL
from mansion_knowledge import KnowledgeBase
from mansion_msgs_py.layout import FixedRoom, FloorProblem, ProblemCore, ProblemNode
from mansion_msgs_py.program import (
    AreaSummary,
    BuildingProgram,
    CorePlan,
    Downgrade,
    FloorProgram,
    RoomProgram,
    TraceEntry,
    VerticalConnectivity,
)
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.shapes import Ring
from mansion_msgs_py.topology import Edge, FloorTopology, NodeKind, TopologyNode
from mansion_msgs_py.wishes import MOST_WORDS, Scope, Wish, WishValue
from mansion_msgs_py.wording import counted, with_article
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.given_plan.door_places import LEAST_WALL
from mansion_planner.given_plan.faults import Findings
from mansion_planner.given_plan.floors import GivenFloor
from mansion_planner.given_plan.planned_storey import planned_storey
from mansion_planner.given_plan.storeys import StoreyRoom
from mansion_planner.program.building import clutter_of, materials_of, with_elevations
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.outside import outside_of
from mansion_planner.program.wish_ledger import requested_objects, wishes_of

__all__ = ["problem_of", "program_of", "topology_of"]

_CENT = 0.01
"""Square metres by which rounded areas may differ from their sum, for each room."""


def program_of(
    request: BuildRequest,
    floors: Sequence[GivenFloor],
    heights: Sequence[float],
    cores: Sequence[CorePlan],
    decisions: Decisions,
    findings: Findings,
    knowledge: KnowledgeBase,
    building_id: str,
) -> BuildingProgram:
    """Return the program of a building whose floors are given; notes of reading its plan become downgrades."""
    kinds = {core.type for core in cores}
    name = decisions.facts.building_name or decisions.building.name
    spoken = with_article(name.replace("_", " ")).capitalize()
    written = [
        _floor_program(floor, height, len(floors), decisions, knowledge) for floor, height in zip(floors, heights)
    ]
    notes = [
        Downgrade(wish=wish, got=got, reason=reason, stage="program", floor=floor)
        for floor, wish, got, reason in findings.notes
    ]
    program = BuildingProgram(
        building_id=building_id,
        reasoning=f"{spoken} of {counted(len(floors), 'storey')}, as its plan has it.",
        vertical_connectivity=VerticalConnectivity(
            method="stair_and_elevator" if len(kinds) == 2 else next(iter(kinds), "none"),
            cores=list(cores),
            justification="as the plan has it",
        ),
        floors=with_elevations(written),
        description=request.description,
        building_type=name,
        planned_like=decisions.building.name if decisions.facts.building_name else "",
        style=decisions.style,
        outside=outside_of(decisions.facts.outside, decisions.building.name, decisions.style),
        seed=request.seed,
        trace=[*decisions.trace, TraceEntry(words="", effect="rooms, doors and windows as the plan has them")],
        downgrades=[*decisions.downgrades, *notes],
        wishes=_wishes(floors, decisions, knowledge),
    )
    return with_landings(program)


def _floor_program(
    floor: GivenFloor, height: float, count: int, decisions: Decisions, knowledge: KnowledgeBase
) -> FloorProgram:
    storey = floor.storey
    planned = planned_storey(floor, decisions.building)
    names = Counter(room.name.casefold() for room in storey.rooms)
    rooms = []
    for room in sorted((r for r in storey.rooms if not r.core), key=lambda room: room.id != floor.main.id):
        floor_text, wall_text = materials_of(room.type, decisions.style, knowledge, decisions.facts.materials)
        aliases = [room.name] if names[room.name.casefold()] > 1 else []
        kind = room.type.name.replace("_", " ")
        rooms.append(
            RoomProgram(
                id=room.id, area_estimate=round(room.area, 2), room_type=room.type.name, floor_material=floor_text,
                wall_material=wall_text, name=room.name, objects=requested_objects(decisions, room.id, planned),
                aliases=[*aliases, *([kind] if room.known and kind != room.name.casefold() else [])],
                clutter=clutter_of(room.type.name, decisions),
            )
        )  # fmt: skip
    total = sum(room.area_estimate for room in rooms)
    gross = round(float(floor.outline.area), 2)
    if total > gross:
        gross = round(gross + _CENT * len(rooms), 2)
    return FloorProgram(
        index=storey.index,
        requirement=f"{counted(len(rooms), 'room')} of the plan",
        gross_floor_area=gross,
        rooms=rooms,
        area_summary=AreaSummary(
            sum_rooms=round(total, 2), reserve_ratio=round(max(1.0 - total / gross, 0.0), 4), fits_within_gfa=True,
            notes="as the plan has it",
        ),
        label=storey.label or _label(storey.index, count),
        height=height,
        outline=ring_of(floor.outline.exterior),
        holes=[ring_of(hole, ccw=False) for hole in floor.outline.interiors],
        openings=floor.openings,
    )  # fmt: skip


def _label(index: int, count: int) -> str:
    if index == 1:
        return "G" if count > 1 else "1"
    return str(index) if index > 1 else f"B{1 - index}"


def topology_of(floor: GivenFloor, program: FloorProgram, building_id: str) -> FloorTopology:
    """Return the room graph of a floor: its main room first, its cores last, an access edge for each door."""
    materials = {room.id: (room.floor_material, room.wall_material) for room in program.rooms}
    nodes = []
    for room in sorted(floor.storey.rooms, key=lambda room: (room.id != floor.main.id, bool(room.core))):
        floor_text, wall_text = materials.get(room.id, ("", ""))
        nodes.append(
            TopologyNode(
                id=room.id, type=_node_kind(room, floor), area=round(room.area, 3), floor_material=floor_text,
                wall_material=wall_text,
                room_type=room.core or room.type.name,
            )
        )  # fmt: skip
    pairs = dict.fromkeys(door.rooms for door in floor.doors if door.rooms[1] is not None)
    edges = [Edge(source=a, target=b) for a, b in pairs if b is not None]
    return FloorTopology(nodes=nodes, edges=edges, building_id=building_id, floor=floor.storey.index)


def _node_kind(room: StoreyRoom, floor: GivenFloor) -> NodeKind:
    if room.core == "stair":
        return "stair"
    if room.core == "elevator":
        return "elevator"
    return "main" if room.id == floor.main.id else "Entities"


def problem_of(floor: GivenFloor, topology: FloorTopology, seed: int, cores: Sequence[CorePlan]) -> FloorProblem:
    """Return what the solver is asked: to keep the rooms that are given, and to draw the others."""
    nodes = [
        ProblemNode(id=node.id, type=node.type, area=node.area, room_type=node.room_type) for node in topology.nodes
    ]
    return FloorProblem(
        boundary=ring_of(floor.outline.exterior),
        holes=[ring_of(hole, ccw=False) for hole in floor.outline.interiors],
        nodes=nodes,
        edges=topology.edges,
        cores=[ProblemCore(id=core.id, type=core.type, polygon=_box(core)) for core in cores],
        fixed_rooms=[
            _fixed(room.id, room.shape) for room in floor.storey.rooms if room.shape is not None and not room.core
        ],
        plan_id=f"{topology.building_id}/F{topology.floor}",
        min_access_wall=ACCESS_WALL if not floor.storey.drawn else LEAST_WALL,
        building_id=topology.building_id,
        floor=topology.floor,
        seed=seed,
    )


def _box(core: CorePlan) -> Ring:
    (x0, x1), (y0, y1) = core.x, core.y
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def _fixed(name: str, shape: Polygon) -> FixedRoom:
    holes = [ring_of(hole, ccw=False) for hole in shape.interiors]
    return FixedRoom(id=name, polygon=ring_of(shape.exterior), holes=holes)


def _wishes(floors: Sequence[GivenFloor], decisions: Decisions, knowledge: KnowledgeBase) -> list[Wish]:
    """Return the rooms of the plan as wishes, then those of the description."""
    found = []
    for floor in floors:
        counts = Counter((room.name, room.type.name, room.known) for room in floor.storey.rooms if not room.core)
        for (name, kind, known), count in counts.items():
            reason = "" if known else f"no such room is known; furnished like {with_article(kind.replace('_', ' '))}"
            found.append(
                Wish(
                    id="wish", text=" ".join(name.split()[:MOST_WORDS]), span=(0, 0), kind="room", reason=reason,
                    value=WishValue(name=name.lower().replace(" ", "_"), type=kind, count=count),
                    scope=Scope(floors=[floor.storey.index]),
                )
            )  # fmt: skip
    found += wishes_of(decisions, knowledge) if decisions.facts != BriefFacts() else []
    return [msgspec.structs.replace(wish, id=f"wish_{number}") for number, wish in enumerate(found, 1)]

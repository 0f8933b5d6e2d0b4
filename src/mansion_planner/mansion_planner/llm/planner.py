"""Lines 1 to 7 of Algorithm 1 with a language model: each piece by the model where its answer holds, else by rules."""

import dataclasses
from collections.abc import Callable

import msgspec

from mansion_geometry.stair_landings import with_landings
from mansion_knowledge import KnowledgeBase
from mansion_llm import LlmClient
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorLayout, FloorProblem, SeedRange
from mansion_msgs_py.program import BuildingProgram
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import PlanReply
from mansion_msgs_py.topology import FloorTopology, SeedBox, SeedPlan
from mansion_planner.brief import BriefFacts
from mansion_planner.llm.context import Context
from mansion_planner.llm.numbers import plan_reference, planned_from
from mansion_planner.llm.palette import Palette, choose_palette
from mansion_planner.llm.program import plan_model_program
from mansion_planner.llm.reading import read_with_model, signed
from mansion_planner.llm.refit import chosen_of_storey, refit
from mansion_planner.llm.seeds import collect_seeds
from mansion_planner.llm.topology import plan_model_topology
from mansion_planner.program.building import PlannedBuilding
from mansion_planner.program.footprint import check_footprint
from mansion_planner.program.model import Storey
from mansion_planner.solver import solve_floor
from mansion_planner.topology import floor_problem, floor_topology

__all__ = ["plan_with_model"]

WORST_AREAS = 0.3
"""Mean relative area error beyond which a layout from the model's graph or seeds is not taken."""


def plan_with_model(
    request: BuildRequest,
    knowledge: KnowledgeBase,
    building_id: str,
    client: LlmClient | None = None,
    cancelled: Callable[[], bool] = lambda: False,
) -> PlanReply:
    """Plan a building with a language model.

    The model reads the brief, and the rules what it leaves out. The rules then plan the building from that reading,
    which gives the outline, the cores and a complete plan to fall back to, and the model plans it within these. Every
    graph with its seeds is solved; what the floor solver cannot realise is replaced by the rules' own.

    Parameters
    ----------
    client : LlmClient, optional
        The configured one when absent.
    cancelled : callable
        Asked by the configured client before each request whether the plan is not wanted any more.

    Returns
    -------
    PlanReply
        With `sources` and `llm` filled in.

    Raises
    ------
    MansionError
        As `mansion_planner.plan.plan_building`, and ``UNAVAILABLE`` when no model is configured or it refuses its key.
    """
    client = client or LlmClient.from_environment(cancelled=cancelled)
    context = Context(client, knowledge, request.description)
    try:
        if request.footprint is not None:
            check_footprint(request.footprint)
        reading = read_with_model(context, lambda facts: _refusal(context, request, facts))
        reference = signed(plan_reference(context, request, reading.facts, building_id), reading)
    except MansionError as error:
        raise error.at_stage("program") from None
    palette = choose_palette(context, reference)
    planned, moved = plan_model_program(context, reference, palette)
    if moved:
        planned, moved = _kept_cores(context, reference, planned, palette, request.seed)
    topologies: dict[int, FloorTopology] = {}
    problems: dict[int, FloorProblem] = {}
    for storey in planned.storeys:
        source = storey.index if storey.copy is None else storey.copy
        if storey.copy is None:
            topology, problem = _floor(context, planned, storey, palette, request.seed, moved=moved)
        else:
            topology = msgspec.structs.replace(topologies[source], floor=storey.index)
            plan_id = f"{building_id}/F{storey.index}"
            problem = msgspec.structs.replace(problems[source], floor=storey.index, plan_id=plan_id)
        topologies[storey.index], problems[storey.index] = topology, problem
    return PlanReply(
        program=with_landings(_with_hubs_first(planned.program, topologies)),
        topologies=[topologies[s.index] for s in planned.storeys],
        problems=[problems[s.index] for s in planned.storeys],
        sources=context.sources,
        llm=client.usage,
    )


def _refusal(context: Context, request: BuildRequest, facts: BriefFacts) -> str:
    """Return why no building of such facts can be planned, or an empty string."""
    try:
        planned_from(facts, request, context, "trial")
    except MansionError as error:
        return error.info.message
    return ""


def _with_hubs_first(program: BuildingProgram, topologies: dict[int, FloorTopology]) -> BuildingProgram:
    """Return the program with each floor's rooms begun by the hub of its graph, which a model may have chosen anew."""
    floors = []
    for floor in program.floors:
        hub = next(node.id for node in topologies[floor.index].nodes if node.type == "main")
        first, others = ([r for r in floor.rooms if (r.id == hub) is is_hub] for is_hub in (True, False))
        floors.append(msgspec.structs.replace(floor, rooms=first + others))
    return msgspec.structs.replace(program, floors=floors)


def _kept_cores(
    context: Context, reference: PlannedBuilding, moved: PlannedBuilding, palette: Palette, seed: int
) -> tuple[PlannedBuilding, bool]:
    """Return the plan with the model's cores if every floor can be laid out around them, else with the rules' cores.

    The second value tells whether the cores are the model's.
    """
    for storey in moved.storeys:
        if storey.copy is not None:
            continue
        topology = floor_topology(moved, storey, context.knowledge)
        problem = floor_problem(moved, storey, topology, seed)
        why = _shortcoming(problem, _solved(problem))
        if why:
            context.from_rules("cores", f"floor {storey.index} cannot be laid out around the model's: {why}")
            floors = [
                chosen_of_storey(s, f.rooms[0].area_estimate) for s, f in zip(moved.storeys, moved.program.floors)
            ]
            return refit(reference, floors, palette), False
    return moved, True


def _regrouped(
    planned: PlannedBuilding, storey: Storey, graph: FloorTopology, palette: Palette, *, moved: bool
) -> PlannedBuilding:
    """Return the plan with the storey sketched anew as the graph groups its rooms: suites behind their room."""
    rooms = {room.id for top in storey.rooms for room in top.each()}
    parents = _parents(graph)
    floors = []
    for other, program in zip(planned.storeys, planned.program.floors):
        floor = chosen_of_storey(other, program.rooms[0].area_estimate)
        if other.index == storey.index:
            grouped = (
                dataclasses.replace(r, suite_of=parents[r.id] if parents.get(r.id) in rooms else "")
                for r in floor.rooms
            )
            floor = dataclasses.replace(floor, rooms=tuple(grouped))
        floors.append(floor)
    return refit(planned, floors, palette, placed=not moved)


def _parents(graph: FloorTopology) -> dict[str, str]:
    """Return the node that each is reached from, breadth first from the hub along access edges."""
    hub = next(node.id for node in graph.nodes if node.type == "main")
    parents: dict[str, str] = {}
    queue = [hub]
    while queue:
        current = queue.pop(0)
        for edge in graph.edges:
            if edge.kind == "access" and current in (edge.source, edge.target):
                other = edge.target if edge.source == current else edge.source
                if other != hub and other not in parents:
                    parents[other] = current
                    queue.append(other)
    return parents


def _floor(
    context: Context, planned: PlannedBuilding, storey: Storey, palette: Palette, seed: int, *, moved: bool
) -> tuple[FloorTopology, FloorProblem]:
    """Return a floor's graph and problem: the model's where the solver can realise them."""
    offline = floor_topology(planned, storey, context.knowledge)
    own = plan_model_topology(context, planned, offline, palette)
    topology = own or offline
    sketched = planned if own is None else _regrouped(planned, storey, own, palette, moved=moved)
    plain = floor_problem(sketched, storey, topology, seed)
    requirement = next(f.requirement for f in planned.program.floors if f.index == storey.index)
    boxes = collect_seeds(context, plain, requirement)
    attempts = [(topology, _with_seeds(plain, boxes), True)] if boxes else []
    attempts.append((topology, plain, False))
    if own is not None:
        attempts.append((offline, floor_problem(planned, storey, offline, seed), False))
    best: tuple[tuple[int, float], FloorTopology, FloorProblem, bool] | None = None
    first_why = ""
    for graph, problem, seeded in attempts:
        layout = _solved(problem)
        why = _shortcoming(problem, layout)
        rank = (0, 0.0) if not why else (_open_links(layout), _area_error(problem, layout))
        first_why = first_why or why
        if best is None or rank < best[0]:
            best = (rank, graph, problem, seeded)
        if not why:
            break
    assert best is not None
    _, graph, problem, seeded = best
    if own is not None and graph is offline:
        context.from_rules(f"topology/F{storey.index}", f"the solver cannot realise the model's: {first_why}")
    if boxes and not seeded:
        context.from_rules(f"seeds/F{storey.index}", f"the solver cannot use the model's: {first_why}")
    return graph, problem


def _solved(problem: FloorProblem) -> FloorLayout | None:
    """Return the layout that the floor solver will make of a problem, or ``None`` where it finds none."""
    try:
        return solve_floor(problem)
    except MansionError as error:
        if error.code != ErrorCode.INFEASIBLE:
            raise
        return None


def _open_links(layout: FloorLayout | None) -> int:
    return sum(edge.kind == "access" for edge in layout.unmet_edges) if layout is not None else 10_000


def _area_error(problem: FloorProblem, layout: FloorLayout | None) -> float:
    from shapely.geometry import Polygon

    if layout is None:
        return 1e6
    got: dict[str, float] = {room.id: float(Polygon(room.polygon, room.holes).area) for room in layout.rooms}
    errors: list[float] = [
        abs(got.get(node.id, 0.0) - node.area) / node.area
        for node in problem.nodes
        if node.area and node.type == "Entities"
    ]
    return sum(errors) / max(1, len(errors))


def _shortcoming(problem: FloorProblem, layout: FloorLayout | None) -> str:
    """Return why a layout is not good enough, or an empty string."""
    if layout is None:
        return "no layout exists"
    unmet = [edge for edge in layout.unmet_edges if edge.kind == "access"]
    if unmet:
        return f"no door between {unmet[0].source} and {unmet[0].target}"
    error = _area_error(problem, layout)
    return f"areas are {error:.0%} off" if error > WORST_AREAS else ""


def _with_seeds(problem: FloorProblem, boxes: list[SeedBox]) -> FloorProblem:
    """Return the problem with the model's boxes; rooms without one keep the sketch's."""
    found = {box.room_id: box for box in boxes}
    nodes = []
    for node in problem.nodes:
        box = found.get(node.id)
        if box is not None:
            centre = (round((box.x[0] + box.x[1]) / 2, 4), round((box.y[0] + box.y[1]) / 2, 4))
            node = msgspec.structs.replace(node, seed=centre, seed_box=SeedRange(x=box.x, y=box.y))
        nodes.append(node)
    seeds = SeedPlan(boxes=boxes, building_id=problem.building_id, floor=problem.floor)
    return msgspec.structs.replace(problem, nodes=nodes, seeds=seeds)

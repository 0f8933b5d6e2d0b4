"""Seed boxes of each cut round by a model (Fig. 25), asked through the solver's callback with a picture."""

from shapely.geometry import Polygon, box

from mansion_llm import Fault, Prompt, quoted_data
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorProblem
from mansion_msgs_py.topology import SeedBox, SeedPlan
from mansion_planner.llm.answers import SeedAnswer, SeedsAnswer
from mansion_planner.llm.cleaning import clean_text
from mansion_planner.llm.context import ARCHITECT, CLOSING, Context, as_json, number
from mansion_planner.solver import SolverOptions, solve_floor
from mansion_planner.solver.cut_rounds import SeedRequest

__all__ = ["collect_seeds", "seed_faults"]

ROUNDS_ONLY = SolverOptions(wall_search=False, retries=2, batch=25)
"""The cut rounds alone: enough to show the model where each round's parent lies."""

LEAST_SIDE = 0.5
MOST_OVERLAP = 0.35
LEAST_INSIDE = 0.5

_RULES = """\
Rules: one box for each room of the list and for no other; x_min < x_max and y_min < y_max; inside the parent's outline
as far as possible; boxes hardly overlap; their areas follow the wished shares; rooms that are to be connected lie
beside each other, and rooms with an edge to something that is placed already lie towards it; leave the way to stairs
and elevators free."""


def _seed_prompt(context: Context, problem: FloorProblem, request: SeedRequest, requirement: str) -> Prompt:
    """Return the question for one cut round."""
    nodes = {node.id: node for node in problem.nodes}
    parent = nodes[request.parent]
    involved = {request.parent, *request.children, *request.neighbours}
    edges = [e for e in problem.edges if e.source in involved and e.target in involved]
    targets = [
        {"id": name, "area": round(nodes[name].area or 0.0, 1), "share_of_parent": round(request.fractions[name], 3)}
        for name in request.children
    ]
    outlines = {room.id: [(round(x, 2), round(y, 2)) for x, y in room.polygon] for room in request.layout}
    cores = {c.id: [(round(x, 2), round(y, 2)) for x, y in c.polygon] for c in problem.cores}
    (x0, x1), (y0, y1) = request.x_range, request.y_range
    lines = [
        "Place rooms within their parent region by axis-aligned boxes. The picture shows the floor from above, y up: "
        "the parent in yellow, stairs and elevators dark, what is placed already in blue-grey.",
        quoted_data("brief", context.description),
        f"Floor: {requirement}",
        f"Rooms to place: {as_json(targets)}",
        f"Parent: {parent.id}, type {parent.type}. Its coordinates lie within x from {number(x0)} to {number(x1)} and "
        f"y from {number(y0)} to {number(y1)}; use values of this range.",
        f"Outlines so far: {as_json(outlines)}",
        f"Stairs and elevators: {as_json(cores)}",
        f"Placed neighbours of the parent: {', '.join(request.neighbours) or 'none'}",
        f"Edges: {as_json(edges)}",
        _RULES,
        CLOSING,
        '{"boxes": [{"room_id": "<id>", "x": [<min>, <max>], "y": [<min>, <max>], "area": <share of the parent>, '
        '"reason": "<one sentence>"}]}',
    ]
    return Prompt("seed_boxes", ARCHITECT, "\n".join(lines), (request.preview,))


def seed_faults(answer: SeedsAnswer, request: SeedRequest) -> list[Fault]:
    """Return what is wrong with the boxes of a round; the piece of each fault is the room."""
    faults: list[Fault] = []
    named = [entry.room_id for entry in answer.boxes]
    for name in request.children:
        if named.count(name) != 1:
            count = named.count(name)
            faults.append(Fault(f"{name} has {count} boxes; one is needed" if count else f"{name} is missing", name))
    parts = [Polygon(r.polygon, r.holes) for r in request.layout if r.id == request.parent]
    kept: list[tuple[str, Polygon]] = []
    for entry in answer.boxes:
        name = entry.room_id
        if name not in request.children:
            faults.append(Fault(f"{clean_text(name, 40)!r} is not to be placed in this round", "extra"))
            continue
        text = _box_fault(entry, parts)
        shape = box(entry.x[0], entry.y[0], entry.x[1], entry.y[1])
        for other, placed in kept:
            shared = shape.intersection(placed).area if other != name and not text else 0.0
            if shared > MOST_OVERLAP * min(shape.area, placed.area):
                text = f"the boxes of {name} and {other} overlap too much"
        if text:
            faults.append(Fault(text, name))
        else:
            kept.append((name, shape))
    return faults


def _box_fault(entry: SeedAnswer, parts: list[Polygon]) -> str:
    """Return what is wrong with one box by itself."""
    name = entry.room_id
    if not all(abs(v) < 1e6 for v in (*entry.x, *entry.y)):
        return f"{name}: coordinates must be finite"
    if entry.x[1] - entry.x[0] < LEAST_SIDE or entry.y[1] - entry.y[0] < LEAST_SIDE:
        return f"{name}: x and y are [min, max], at least {LEAST_SIDE} m apart"
    if entry.area is not None and not 0.0 <= entry.area <= 1.0:
        return f"{name}: area is a share of the parent between 0 and 1, not {entry.area:g}"
    shape = box(entry.x[0], entry.y[0], entry.x[1], entry.y[1])
    inside = sum(shape.intersection(part).area for part in parts)
    if parts and inside < LEAST_INSIDE * shape.area:
        return f"{name}: only {inside / shape.area:.0%} of the box lies in the parent"
    return ""


def collect_seeds(context: Context, problem: FloorProblem, requirement: str) -> list[SeedBox]:
    """Run a floor's cut rounds and return the model's box for each room that got a good one."""
    piece = f"seeds/F{problem.floor}"
    if not context.client.wants("seeds"):
        context.from_rules(piece)
        return []
    found: list[SeedBox] = []
    reasons: list[str] = []
    asked: list[str] = []

    def plan(request: SeedRequest) -> SeedPlan | None:
        asked.extend(request.children)
        prompt = _seed_prompt(context, problem, request, requirement)
        answer = context.client.ask(prompt, SeedsAnswer, lambda value: seed_faults(value, request), array_field="boxes")
        if not answer.good:
            reasons.append(answer.reason)
        if answer.value is None:
            return None
        faulty = answer.faulty_pieces()
        boxes = [
            SeedBox(room_id=b.room_id, x=b.x, y=b.y, area=b.area, reason=clean_text(b.reason, 200))
            for b in answer.value.boxes
            if b.room_id in request.children and b.room_id not in faulty
        ]
        found.extend(boxes)
        return SeedPlan(boxes=boxes, building_id=problem.building_id, floor=problem.floor)

    try:
        solve_floor(problem, options=ROUNDS_ONLY, seed_callback=plan)
    except MansionError as error:
        if error.code != ErrorCode.INFEASIBLE:
            raise
        reasons.append(error.info.message)
    if not asked:
        context.from_rules(piece, reasons[0] if reasons else "no room is to be placed")
    elif len(found) == len(asked):
        context.from_model(piece)
    elif found:
        context.partly_from_model(piece, f"{len(found)} of {len(asked)} rooms: {reasons[0]}")
    else:
        context.from_rules(piece, reasons[0] if reasons else "")
    return found

"""A plan as rows of text: what the command line prints as a table, and the trace of words to decisions."""

from dataclasses import dataclass

from mansion_msgs_py.stages import PlanReply

__all__ = ["PlanRow", "PlanTable", "plan_table", "trace_lines"]


@dataclass(frozen=True)
class PlanRow:
    """A room of the plan.

    Attributes
    ----------
    floor : str
        The floor's label.
    reached_from : str
        The node whose access edge leads to it.
    """

    floor: str
    room: str
    room_type: str
    area: float
    reached_from: str
    floor_material: str
    wall_material: str


@dataclass(frozen=True)
class PlanTable:
    """Title, one line for each floor, a row for each room, and what the brief could not be given."""

    title: str
    floors: list[str]
    rows: list[PlanRow]
    trace: list[str]
    downgrades: list[str]


def trace_lines(reply: PlanReply) -> list[str]:
    """Return the trace as lines: the words in quotation marks, or the rule, and what they led to."""
    return [
        f'"{entry.words}" -> {entry.effect}' if entry.words else f"(rule) {entry.effect}"
        for entry in reply.program.trace
    ]


def plan_table(reply: PlanReply) -> PlanTable:
    """Return a plan as structured rows, rooms in the order of the room graph.

    Examples
    --------
    >>> from mansion_msgs_py.request import BuildRequest
    >>> from mansion_planner.plan import plan_building
    >>> table = plan_table(plan_building(BuildRequest(description="a small flat")))
    >>> table.rows[0].room
    'living_room'
    """
    program = reply.program
    rows: list[PlanRow] = []
    lines: list[str] = []
    for floor, topology in zip(program.floors, reply.topologies):
        repeats = f", repeats floor {floor.copy}" if floor.copy is not None else ""
        lines.append(
            f"{floor.label}: {floor.gross_floor_area:.0f} m2, {floor.height:g} m high, "
            f"{len(floor.rooms)} rooms, reserve {floor.area_summary.reserve_ratio:.0%}{repeats}"
        )
        parents = {edge.target: edge.source for edge in topology.edges if edge.kind == "access"}
        rows += [
            PlanRow(
                floor=floor.label,
                room=node.id,
                room_type=node.room_type,
                area=round(node.area, 1),
                reached_from=parents.get(node.id, ""),
                floor_material=node.floor_material,
                wall_material=node.wall_material,
            )
            for node in topology.nodes
        ]
    total = sum(floor.gross_floor_area for floor in program.floors)
    cores = ", ".join(core.id for core in program.vertical_connectivity.cores) or "no cores"
    kind = program.building_type.replace("_", " ")
    return PlanTable(
        title=f"{kind}, {program.style}: {len(program.floors)} floors, {total:.0f} m2, {cores}",
        floors=lines,
        rows=rows,
        trace=trace_lines(reply),
        downgrades=[f"{wish.wish}: {wish.got} ({wish.reason})" for wish in program.downgrades],
    )

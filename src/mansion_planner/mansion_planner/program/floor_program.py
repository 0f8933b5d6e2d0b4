"""A storey's part of the building program of Fig. 23: rooms with areas and materials, and the sum of areas."""

from mansion_knowledge import KnowledgeBase
from mansion_msgs_py.program import AreaSummary, FloorProgram, RoomProgram
from mansion_msgs_py.wording import with_article
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.envelope import Envelope
from mansion_planner.program.furniture import requested_objects
from mansion_planner.program.materials import materials_of
from mansion_planner.program.model import Storey
from mansion_planner.program.names import aliases_of
from mansion_planner.program.neighbours import neighbours
from mansion_planner.program.placement import Sketch

__all__ = ["floor_program"]


def floor_program(
    decisions: Decisions, storey: Storey, sketch: Sketch, envelope: Envelope, knowledge: KnowledgeBase
) -> FloorProgram:
    """Return a storey's rooms, hub first, with the areas that its sketch gives them, square metres."""
    gross = envelope.area
    placed = sum(placement.area for placement in sketch.rooms)
    circulation = gross - placed
    hub_least = min(storey.hub.least, 0.5 * circulation)
    reserve = min(max(0.12 * gross, min(0.25 * gross, circulation - hub_least)), circulation - 1.0)
    hub_area = max(circulation - reserve, 1.0)
    floor, wall = materials_of(storey.hub, decisions.style, knowledge, decisions.facts.materials)
    rooms = [
        RoomProgram(
            id=storey.hub.name, area_estimate=round(hub_area, 2), room_type=storey.hub.name,
            floor_material=floor, wall_material=wall, open_relation="open", notes="circulation hub",
        )
    ]  # fmt: skip
    beside = neighbours(decisions, storey, sketch)
    for placement in sketch.rooms:
        room = placement.room
        floor, wall = materials_of(room.kind, decisions.style, knowledge, decisions.facts.materials)
        rooms.append(
            RoomProgram(
                id=room.id, area_estimate=round(placement.area, 2), room_type=room.kind.name,
                floor_material=floor, wall_material=wall,
                open_relation="open" if room.kind.open else "door", notes=room.notes,
                adjacent_to=beside.get(room.id, []), name=room.label, aliases=aliases_of(room),
                objects=requested_objects(decisions, room, storey),
            )
        )  # fmt: skip
    total = sum(room.area_estimate for room in rooms)
    summary = AreaSummary(
        sum_rooms=round(total, 2),
        reserve_ratio=round(1.0 - total / gross, 4),
        fits_within_gfa=total <= gross,
        notes=_reserve_notes(1.0 - total / gross),
    )
    return FloorProgram(
        index=storey.index,
        requirement=_requirement(storey),
        gross_floor_area=round(gross, 2),
        rooms=rooms,
        area_summary=summary,
        label="G" if storey.index == 1 and decisions.floors > 1 else _label(storey.index),
        height=min(max(storey.use.height, 3.0), 4.2),
        outline=envelope.outline,
        holes=envelope.holes,
        copy=storey.copy,
    )


def _reserve_notes(ratio: float) -> str:
    if ratio < 0.119:
        return "less than 12% in reserve: no cores, and a large room at the end of a short corridor"
    return "the reserve holds cores, corridors and the rest of the hub"


def _label(index: int) -> str:
    return str(index) if index >= 1 else f"B{1 - index}"


def _requirement(storey: Storey) -> str:
    kinds: list[str] = []
    for room in storey.rooms:
        name = room.kind.name.replace("_", " ")
        if name not in kinds:
            kinds.append(name)
    use = storey.use.name.replace("_", " ")
    return (
        f"{storey.role} storey of {with_article(use)}: {', '.join(kinds[:8])}"
        if kinds
        else f"{storey.role} storey of {with_article(use)}"
    )

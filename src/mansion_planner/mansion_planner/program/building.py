"""Assemble the building program of Fig. 23 from decisions, massing and sketches."""

from dataclasses import dataclass, field

import numpy as np

from mansion_knowledge import KnowledgeBase
from mansion_msgs_py.program import BuildingProgram, CorePlan, VerticalConnectivity
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.wording import with_article
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.program.allocation import allocate
from mansion_planner.program.arrangement import best_arrangement
from mansion_planner.program.bearing import bearing_walls
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.envelope import Envelope
from mansion_planner.program.floor_program import floor_program
from mansion_planner.program.frame import Frame
from mansion_planner.program.furniture import assign_furniture
from mansion_planner.program.inference import note
from mansion_planner.program.massing import MassingWish, choose_shape
from mansion_planner.program.model import Massing, Storey
from mansion_planner.program.placement import Sketch
from mansion_planner.program.resolve import decide
from mansion_planner.program.sizes import storey_area, typical_room
from mansion_planner.program.storeys import make_storeys
from mansion_planner.program.vertical import vertical_method
from mansion_planner.program.wishes import wishes_of

__all__ = ["PlannedBuilding", "plan_program"]


@dataclass
class PlannedBuilding:
    """The program and what it was made from, for the topology stage."""

    program: BuildingProgram
    decisions: Decisions
    massing: Massing
    frame: Frame
    storeys: list[Storey]
    sketches: dict[int, Sketch] = field(default_factory=dict)
    envelopes: dict[int, Envelope] = field(default_factory=dict)


def plan_program(
    request: BuildRequest, facts: BriefFacts, knowledge: KnowledgeBase, building_id: str, generator: np.random.Generator
) -> PlannedBuilding:
    """Decide, distribute the rooms, choose the massing, and sketch every storey.

    Raises
    ------
    MansionError
        See `mansion_planner.plan.plan_building`.
    """
    decisions = decide(request, facts, knowledge, generator)
    storeys = make_storeys(decisions, knowledge)
    allocation = allocate(decisions, knowledge, storeys)
    method, stairs, lifts, why = vertical_method(decisions, storeys, allocation, knowledge)
    area = storey_area(decisions, storeys, allocation, knowledge, stairs, lifts)
    wish = MassingWish(
        area, decisions.building, stairs, lifts, exact=decisions.area_stated,
        room=typical_room(storeys, allocation, knowledge), shape=choose_shape(decisions, area, generator),
    )  # fmt: skip
    massing, frame, sketches, envelopes = best_arrangement(decisions, wish, storeys, allocation, knowledge)
    assign_furniture(decisions, storeys)
    walls = bearing_walls([sketches[storey.index] for storey in storeys], frame)
    program = BuildingProgram(
        building_id=building_id,
        reasoning=_reasoning(decisions, area),
        vertical_connectivity=VerticalConnectivity(method=method, cores=_cores(massing, frame), justification=why),
        floors=[
            floor_program(decisions, storey, sketches[storey.index], envelopes[storey.index], knowledge)
            for storey in storeys
        ],
        description=request.description,
        building_type=decisions.building.name,
        style=decisions.style,
        seed=request.seed,
        trace=decisions.trace,
        downgrades=decisions.downgrades,
        wishes=wishes_of(decisions, knowledge),
    )
    for floor in program.floors:
        floor.structural_walls = list(walls)
    _set_elevations(program)
    note(decisions.trace, None, f"{why}")
    return PlannedBuilding(program, decisions, massing, frame, storeys, sketches, envelopes)


def _reasoning(decisions: Decisions, area: float) -> str:
    levels = f"{decisions.floors} storeys" if decisions.floors > 1 else "one storey"
    each = " each" if decisions.floors + decisions.basements > 1 else ""
    below = f" and {decisions.basements} below ground" if decisions.basements else ""
    kind = with_article(decisions.building.name.replace("_", " ")).capitalize()
    return (
        f"{kind} of {levels}{below}, about {area:.0f} m2{each}; rooms follow "
        f"the brief first, then what such a building usually holds; circulation and cores stay at the same place on "
        f"every floor."
    )


def _cores(massing: Massing, frame: Frame) -> list[CorePlan]:
    cores = []
    for core in massing.cores:
        x0, y0, x1, y1 = frame.area_box(core.box)
        cores.append(CorePlan(id=core.id, type=core.type, x=(x0, x1), y=(y0, y1), door_side=frame.side(core.side)))
    return cores


def _set_elevations(program: BuildingProgram) -> None:
    level = 0.0
    for floor in program.floors:
        if floor.index >= 1:
            floor.elevation = round(level, 3)
            level += floor.height
    level = 0.0
    for floor in reversed(program.floors):
        if floor.index < 1:
            level -= floor.height
            floor.elevation = round(level, 3)

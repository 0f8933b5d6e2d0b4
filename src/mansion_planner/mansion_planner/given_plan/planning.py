"""Turn a plan that the user gives into program, room graphs and problems, as if the planner had drawn it."""

from collections.abc import Sequence
from dataclasses import replace

import msgspec

from mansion_geometry.randomness import item_generator
from mansion_knowledge import KnowledgeBase
from mansion_msgs_py.building_plan import BuildingPlan
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import CorePlan
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import PlanReply
from mansion_planner.brief import read_brief
from mansion_planner.brief.facts import BriefFacts
from mansion_planner.brief_checks import check_length, check_size, check_understood
from mansion_planner.given_plan.cores import core_boxes, landing_of, stair_height, with_cores
from mansion_planner.given_plan.faults import Findings
from mansion_planner.given_plan.floors import GivenFloor, core_doors, given_floor, with_stair_doors
from mansion_planner.given_plan.planned_storey import planned_storey
from mansion_planner.given_plan.room_gaps import joined_rooms
from mansion_planner.given_plan.storeys import PlanStorey, read_storeys, suggested_building
from mansion_planner.given_plan.writing import problem_of, program_of, topology_of
from mansion_planner.program.decisions import Decisions, decide
from mansion_planner.program.wish_ledger import furniture_of

__all__ = ["plan_given"]

_HEIGHTS = (3.0, 4.2)
"""Least and greatest height of a storey of which the plan states none, metres."""


def plan_given(request: BuildRequest, knowledge: KnowledgeBase, building_id: str) -> PlanReply:
    """Return the program, the room graphs and the problems of a request that has a plan.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with every fault of the plan in ``details["faults"]``; ``CONTRADICTION`` for a request that
        states sizes beside its plan.
    """
    plan = request.plan
    if plan is None:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "the request has no plan", path="$.plan")
    _refuse_beside_a_plan(request)
    findings = Findings()
    storeys = read_storeys(plan, knowledge, findings)
    if not storeys or any(all(room.core for room in storey.rooms) for storey in storeys):
        findings.refuse()
    joined = [joined_rooms(storey, findings) if storey.drawn else storey for storey in storeys]
    stacked = with_cores(joined, knowledge, findings)
    floors = [given_floor(storey, plan, findings) for storey in stacked]
    decisions = _decided(request, plan, floors, knowledge)
    cores = [landing_of(core, core_doors(core, floors)) for core in core_boxes(stacked[0])]
    heights = [_height(storey, cores, decisions, findings) for storey in stacked]
    findings.refuse()
    floors = [with_stair_doors(floor, cores, findings) for floor in floors]
    program = program_of(request, floors, heights, cores, decisions, findings, knowledge, building_id)
    check_size(program)
    topologies = [topology_of(floor, entry, building_id) for floor, entry in zip(floors, program.floors)]
    problems = [problem_of(floor, topology, request.seed, cores) for floor, topology in zip(floors, topologies)]
    return PlanReply(program=program, topologies=topologies, problems=problems)


def _refuse_beside_a_plan(request: BuildRequest) -> None:
    stated = ("floors", "area", "floor_area", "footprint")
    for name in stated:
        if getattr(request, name) is not None:
            raise MansionError(
                ErrorCode.CONTRADICTION,
                f"the plan already gives what {name} would; leave one of them out",
                path=f"$.{name}",
            )
    if request.planner == "llm":
        raise MansionError(
            ErrorCode.CONTRADICTION, "a plan is read by rules; leave the planner at rules", path="$.planner"
        )


def _height(storey: PlanStorey, cores: Sequence[CorePlan], decisions: Decisions, findings: Findings) -> float:
    """Return the height of a storey, such that its stairs fit."""
    usual = min(max(decisions.building.height, _HEIGHTS[0]), _HEIGHTS[1])
    height = storey.height if storey.height is not None else usual
    for core in cores:
        if core.type != "stair" or not any(room.id == core.id for room in storey.rooms):
            continue
        fitting = stair_height(core, usual, storey.height)
        if fitting is None:
            size = f"{core.x[1] - core.x[0]:.2f} x {core.y[1] - core.y[0]:.2f} m"
            message = f"no stair with a turn fits into {size} for a storey of {height:.2f} m"
            room = storey.room(core.id)
            findings.fault(storey.index, room.name, f"{message}; 2 x 4 m climbs 3.0 m, 3 x 6 m 4.2 m", room.place)
        else:
            height = min(height, fitting)
    return round(height, 3)


def _decided(
    request: BuildRequest, plan: BuildingPlan, floors: Sequence[GivenFloor], knowledge: KnowledgeBase
) -> Decisions:
    """Return what the building is, by the description and the words of the plan, else by its rooms."""
    facts = BriefFacts()
    if request.description.strip():
        check_length(request.description)
        facts = read_brief(request.description, knowledge)
        check_understood(facts, request.description)
    words = f"{plan.style} {plan.building_type}".strip()
    said = read_brief(words, knowledge) if words else None
    if said is not None:
        facts = replace(
            facts,
            building=facts.building or [(name, replace(span, words="")) for name, span in said.building],
            styles=facts.styles or [(name, replace(span, start=0, end=0)) for name, span in said.styles],
        )
    if not facts.building and not facts.building_like:
        like = suggested_building([floor.storey for floor in floors])
        facts = replace(facts, building_like="flat" if like == "house" and len(floors) == 1 else like)
    area = sum(floor.outline.area for floor in floors) / len(floors)
    above = sum(floor.storey.index >= 1 for floor in floors)
    sized = msgspec.structs.replace(request, floors=above, floor_area=round(max(area, 15.0), 2), plan=None)
    decisions = decide(sized, facts, knowledge, item_generator(request.seed, "program"))
    decisions.furniture = furniture_of(decisions, [planned_storey(floor, decisions.building) for floor in floors])
    return decisions

"""The planner: from a request to the program, the room graph of each floor and its solver problem.

Lines 1 to 7 of Algorithm 1 (section C.1): by rules, or with a language model where the request says so.
"""

import hashlib

from mansion_geometry.randomness import item_generator
from mansion_knowledge import KnowledgeBase, default_knowledge
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import BuildingProgram, Downgrade
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.stages import PlanReply
from mansion_msgs_py.wording import with_article
from mansion_planner.brief import BriefFacts, read_brief
from mansion_planner.program.building import plan_program
from mansion_planner.topology.graph import floor_topology
from mansion_planner.topology.problem import floor_problem

__all__ = ["building_id_of", "plan_building"]


def building_id_of(request: BuildRequest) -> str:
    """Return the request's building id, or one made of a hash of the request."""
    if request.building_id is not None:
        return request.building_id
    return "b" + hashlib.sha256(encode_bytes(request)).hexdigest()[:12]


def _report_unread(facts: BriefFacts, program: BuildingProgram) -> None:
    """Record that no word of the brief says what to build."""
    if any(vars(facts).values()):
        return
    kind = program.building_type.replace("_", " ")
    program.downgrades.append(
        Downgrade(
            wish=program.description.strip()[:80],
            got=with_article(kind),
            reason="not understood: no building type, room, number of storeys or area is named",
            stage="program",
        )
    )


def plan_building(request: BuildRequest, *, knowledge: KnowledgeBase | None = None) -> PlanReply:
    """Plan a building from its brief.

    Parameters
    ----------
    request : BuildRequest
    knowledge : KnowledgeBase, optional
        The shipped one when absent.

    Returns
    -------
    PlanReply
        The program, and for each floor its room graph and the problem for the floor solver.

    Raises
    ------
    MansionError
        ``CONTRADICTION`` for statements that exclude each other (``details`` names both), ``INFEASIBLE`` for what no
        building can meet, ``INVALID_PAYLOAD`` for an empty brief
        or a footprint that is no polygon, ``UNAVAILABLE`` when the request
        wants a language model and none is configured.

    Examples
    --------
    >>> reply = plan_building(BuildRequest(description="a two-storey library"))
    >>> [floor.index for floor in reply.program.floors]
    [1, 2]
    """
    if not request.description.strip():
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            'the description is empty; write what to build, such as "a two-storey house with three bedrooms"',
            path="$.description",
        ).at_stage("program")
    base = knowledge or default_knowledge()
    building_id = building_id_of(request)
    if request.planner == "llm":
        from mansion_planner.llm.planner import plan_with_model

        return plan_with_model(request, base, building_id)
    try:
        facts = read_brief(request.description, base)
        planned = plan_program(request, facts, base, building_id, item_generator(request.seed, "program"))
    except MansionError as error:
        raise error.at_stage("program") from None
    _report_unread(facts, planned.program)
    topologies = [floor_topology(planned, storey, base) for storey in planned.storeys]
    problems = [
        floor_problem(planned, storey, topology, request.seed) for storey, topology in zip(planned.storeys, topologies)
    ]
    return PlanReply(program=planned.program, topologies=topologies, problems=problems)

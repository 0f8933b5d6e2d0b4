"""The planner: from a request to the program, the room graph of each floor and its solver problem.

Lines 1 to 7 of Algorithm 1 (section C.1): by rules, or with a language model where the request says so.
"""

from collections.abc import Callable

from mansion_geometry.randomness import item_generator
from mansion_geometry.stair_landings import with_landings
from mansion_knowledge import KnowledgeBase, default_knowledge
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.layout import FloorProblem
from mansion_msgs_py.request import BuildRequest, building_id_of
from mansion_msgs_py.stages import PlanReply
from mansion_msgs_py.topology import FloorTopology
from mansion_planner.brief import read_brief
from mansion_planner.brief_checks import check_length, check_size, check_there, check_understood
from mansion_planner.program.building import plan_program
from mansion_planner.topology import fallback_problem, floor_problem, floor_topology

__all__ = ["plan_building"]


def plan_building(
    request: BuildRequest, *, knowledge: KnowledgeBase | None = None, cancelled: Callable[[], bool] = lambda: False
) -> PlanReply:
    """Plan a building from its brief.

    Parameters
    ----------
    request : BuildRequest
    knowledge : KnowledgeBase, optional
        The shipped one when absent.
    cancelled : callable
        Asked between the steps of a long reading, before each storey and before each question to a model, whether the
        plan is not wanted any more.

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
        wants a language model and none is configured, ``NOT_FOUND`` for a library of own assets that is not there,
        ``CANCELED``.

    Examples
    --------
    >>> reply = plan_building(BuildRequest(description="a two-storey library"))
    >>> [floor.index for floor in reply.program.floors]
    [1, 2]
    """
    base = knowledge or default_knowledge()
    if not request.libraries:
        return _planned(request, base, cancelled)
    # Words of briefs name own assets as they do the catalogue's.
    with importing:
        from mansion_assets.catalogue.preferred_folders import preferring
        from mansion_assets.library.folders import library_folders

    with preferring(library_folders(request.libraries)):
        return _planned(request, base, cancelled)


def _planned(request: BuildRequest, base: KnowledgeBase, cancelled: Callable[[], bool]) -> PlanReply:
    building_id = building_id_of(request)
    if request.plan is not None:
        return _given(request, base, building_id)
    try:
        check_there(request.description)
    except MansionError as error:
        raise error.at_stage("program") from None
    if request.planner == "llm":
        with importing:
            from mansion_planner.llm.planner import plan_with_model

        return plan_with_model(request, base, building_id, cancelled=cancelled)
    check_length(request.description)
    try:
        facts = read_brief(request.description, base, cancelled=cancelled)
        check_understood(facts, request.description)
        planned = plan_program(request, facts, base, building_id, item_generator(request.seed, "program"))
        check_size(planned.program)
    except MansionError as error:
        raise error.at_stage("program") from None
    topologies: list[FloorTopology] = []
    problems: list[FloorProblem] = []
    fallbacks: list[FloorProblem | None] = []
    for storey in planned.storeys:
        if cancelled():
            raise MansionError(ErrorCode.CANCELED, "the plan was cancelled").at_stage("topology")
        topologies.append(floor_topology(planned, storey, base))
        problems.append(floor_problem(planned, storey, topologies[-1], request.seed))
        fallbacks.append(fallback_problem(problems[-1], planned, storey))
    return PlanReply(
        program=with_landings(planned.program),
        topologies=topologies,
        problems=problems,
        fallbacks=fallbacks if any(fallbacks) else [],
    )


def _given(request: BuildRequest, knowledge: KnowledgeBase, building_id: str) -> PlanReply:
    """Return the plan that a request brings."""
    with importing:
        from mansion_planner.given_plan.planning import plan_given

    try:
        return plan_given(request, knowledge, building_id)
    except MansionError as error:
        raise error.at_stage("program") from None

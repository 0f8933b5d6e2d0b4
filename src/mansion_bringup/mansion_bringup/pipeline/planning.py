"""The plan of a request in this process, once its planner is known to work."""

from mansion_bringup.extras import ensure_extra
from mansion_bringup.pipeline.stages import LocalStages
from mansion_llm import load_settings
from mansion_msgs_py.request import BuildRequest, identified
from mansion_msgs_py.stages import PlanReply

__all__ = ["plan_request", "prepare_planner"]


def plan_request(request: BuildRequest) -> PlanReply:
    """Return program, room graphs and solver problems of a request.

    Raises
    ------
    MansionError
        As `prepare_planner`, and what the planner refuses.
    """
    prepare_planner(request)
    return LocalStages().plan(identified(request))


def prepare_planner(request: BuildRequest) -> None:
    """See that the planner of a request can work in this process, before anything is begun.

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` when no language model is configured, or its package is missing and cannot be installed.
    """
    if request.planner != "llm":
        return
    settings = load_settings()
    settings.require_endpoint()
    if settings.replay is None:
        ensure_extra("llm")

"""Arguments and replies of the services that plan, furnish and build, and of those that cancel a plan or a build."""

from collections.abc import Sequence
from typing import Annotated, Literal, TypeAlias

import msgspec

from mansion_msgs_py.building import Building
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.outside import Outside
from mansion_msgs_py.program import BuildingProgram, FloorProgram, VerticalConnectivity
from mansion_msgs_py.request import BuildRequest, Libraries
from mansion_msgs_py.shapes import BuildingId, PathText
from mansion_msgs_py.topology import FloorTopology
from mansion_msgs_py.usage import LlmUsage

__all__ = [
    "BuildInWork",
    "BuildJob",
    "BuildReply",
    "CancelBuild",
    "CancelPlan",
    "CanceledBuilds",
    "CanceledPlans",
    "FurnishRequest",
    "PlanReply",
]

FormatName: TypeAlias = Annotated[str, msgspec.Meta(max_length=100)]


class PlanReply(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of ``plan_program``: the program, and for each floor its room graph and solver problem.

    Attributes
    ----------
    sources : dict of str to str
        Piece (``numbers``, ``program/F1``, ``topology/F1``, ``seeds/F1``) to ``llm``, ``rules`` or ``rules: REASON``;
        empty for the offline planner.
    llm : LlmUsage, optional
        What the language model took.
    fallbacks : list of FloorProblem or None
        By floor, a problem that is known to be solvable, for a floor whose own one keeps rooms from being reached;
        empty where no floor has one.
    """

    program: BuildingProgram
    topologies: list[FloorTopology]
    problems: list[FloorProblem]
    sources: dict[str, str] = {}
    llm: LlmUsage | None = None
    fallbacks: list[FloorProblem | None] = []


class FurnishRequest(msgspec.Struct, frozen=True, kw_only=True):
    """Arguments of ``furnish_floor``: all that a floor's scene is made from.

    Attributes
    ----------
    floors : list of int
        All floor numbers of the building, ascending; the cores serve them.
    called : str, optional
        What the brief calls the building, where that is no type of the knowledge base.
    outside : Outside, optional
        Walls, roof and grounds as far as the brief decides them.
    planner : {"rules", "llm"}
        Who chooses the furniture; a model is told the building's `description`.
    assets : tuple of str, optional
        Libraries of own assets that come before the catalogue's.
    """

    building_id: BuildingId
    floor: FloorProgram
    floors: list[int]
    labels: list[str]
    connectivity: VerticalConnectivity
    topology: FloorTopology
    layout: FloorLayout
    building_type: str = ""
    called: str | msgspec.UnsetType = msgspec.UNSET
    style: str = ""
    outside: Outside | msgspec.UnsetType = msgspec.UNSET
    seed: int = 0
    planner: Literal["rules", "llm"] = "rules"
    description: str = ""
    assets: Libraries | msgspec.UnsetType = msgspec.UNSET

    @property
    def libraries(self) -> tuple[str, ...]:
        """Libraries of own assets; none where the request does not say."""
        return () if isinstance(self.assets, msgspec.UnsetType) else self.assets


class BuildJob(BuildRequest, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Arguments of ``build_building``: a request, and where its folder is to go.

    Attributes
    ----------
    output : str, optional
        Folder on the director's machine; below its ``output_root`` when absent.
    force : bool
        Replace a building there even if running worlds have state in it.
    formats : tuple of str
        Export formats to write beside plans and pictures, as ``mansion export --to`` names them, or ``all``.
    """

    output: PathText | None = None
    force: bool = False
    formats: Annotated[tuple[FormatName, ...], msgspec.Meta(max_length=100)] = ()

    @classmethod
    def of(
        cls, request: BuildRequest, *, output: str | None = None, force: bool = False, formats: Sequence[str] = ()
    ) -> "BuildJob":
        """Return the job of a request."""
        return cls(**msgspec.structs.asdict(request), output=output, force=force, formats=tuple(formats))

    def request(self) -> BuildRequest:
        """Return the request alone."""
        fields = {name: getattr(self, name) for name in BuildRequest.__struct_fields__}
        return BuildRequest(**fields)


class BuildReply(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of ``build_building``: the index of the finished building, and its folder when one was asked for."""

    building: Building
    path: str


class CancelPlan(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Arguments of ``cancel_plan``: the plan of which building to give up; the running one when absent."""

    building_id: BuildingId | None = None


class CanceledPlans(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of ``cancel_plan``: the building ids of the plans that were asked to end; empty where none was running."""

    plans: list[str]


class CancelBuild(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Arguments of ``cancel_build``: which builds to end; all running ones where neither is given.

    Attributes
    ----------
    building_id : str, optional
        As ``progress`` tells it.
    output : str, optional
        Folder that the building was to go to, as its ``build_building`` named it.
    """

    building_id: BuildingId | None = None
    output: PathText | None = None


class BuildInWork(msgspec.Struct, frozen=True, kw_only=True):
    """A build, and the folder that it was to write."""

    building_id: str
    path: str


class CanceledBuilds(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of ``cancel_build``: the builds that were asked to end; empty where none of them was running."""

    builds: list[BuildInWork]

"""The payload types by name, as ``mansion schema NAME`` lists them."""

from typing import Any

from mansion_msgs_py.building import Building, BuildingReport, LoadBuilding
from mansion_msgs_py.editing import (
    AgentReport,
    AssetHits,
    CheckPathArgs,
    CheckSurfaceArgs,
    DiffReport,
    EditorInfo,
    EditResult,
    InstructArgs,
    ListObjectsArgs,
    MoveObjectArgs,
    ObjectList,
    OpenEditorArgs,
    PathReport,
    PlaceInContainerArgs,
    PlaceOnSurfaceArgs,
    ReceptacleReport,
    RemoveObjectArgs,
    SearchAssetsArgs,
    SearchContentsArgs,
    SetStateArgs,
    ToolArgs,
    Transaction,
)
from mansion_msgs_py.errors import ErrorCode, ErrorReply, MansionError
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.placement import PlacementResult, PlacementRoom
from mansion_msgs_py.program import BuildingProgram
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.skills import (
    Control,
    ControlArgs,
    DoorArgs,
    GoToLandmarkArgs,
    Landmarks,
    Loaded,
    LookArgs,
    MoveAheadArgs,
    MoveToArgs,
    NearObjectArgs,
    ObjectArgs,
    PlaceArgs,
    RotateArgs,
    Route,
    RouteArgs,
    SessionArgs,
    TakeStairsArgs,
    UseElevatorArgs,
    VisibleArgs,
    VisibleObjects,
    WhereAmI,
)
from mansion_msgs_py.stages import BuildJob, BuildReply, FurnishRequest, PlanReply
from mansion_msgs_py.topology import FloorTopology, SeedPlan
from mansion_msgs_py.world import (
    LiftRequest,
    LiftState,
    Progress,
    RobotState,
    SkillProgress,
    SkillResult,
    WorldEvent,
    WorldState,
)

__all__ = ["PAYLOADS", "payload_type"]

PAYLOADS: dict[str, type[Any]] = {
    kind.__name__: kind
    for kind in (
        BuildRequest,
        BuildingProgram,
        FloorTopology,
        SeedPlan,
        FloorProblem,
        FloorLayout,
        FloorScene,
        PlacementRoom,
        PlacementResult,
        PlanReply,
        FurnishRequest,
        BuildJob,
        BuildReply,
        Building,
        BuildingReport,
        LoadBuilding,
        Loaded,
        Control,
        ControlArgs,
        DoorArgs,
        GoToLandmarkArgs,
        Landmarks,
        LookArgs,
        MoveAheadArgs,
        MoveToArgs,
        NearObjectArgs,
        ObjectArgs,
        PlaceArgs,
        RotateArgs,
        Route,
        RouteArgs,
        SessionArgs,
        TakeStairsArgs,
        UseElevatorArgs,
        VisibleArgs,
        VisibleObjects,
        WhereAmI,
        RobotState,
        LiftRequest,
        LiftState,
        WorldState,
        WorldEvent,
        SkillResult,
        SkillProgress,
        Progress,
        AgentReport,
        AssetHits,
        CheckPathArgs,
        CheckSurfaceArgs,
        DiffReport,
        EditResult,
        EditorInfo,
        InstructArgs,
        ListObjectsArgs,
        MoveObjectArgs,
        ObjectList,
        OpenEditorArgs,
        PathReport,
        PlaceInContainerArgs,
        PlaceOnSurfaceArgs,
        ReceptacleReport,
        RemoveObjectArgs,
        SearchAssetsArgs,
        SearchContentsArgs,
        SetStateArgs,
        ToolArgs,
        Transaction,
        ErrorReply,
    )
}


def payload_type(name: str) -> type[Any]:
    """Return the payload type of that name.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` with the names that exist.
    """
    try:
        return PAYLOADS[name]
    except KeyError:
        known = ", ".join(sorted(PAYLOADS))
        raise MansionError(
            ErrorCode.NOT_FOUND, f"there is no payload {name!r}; known are {known}"
        ) from None

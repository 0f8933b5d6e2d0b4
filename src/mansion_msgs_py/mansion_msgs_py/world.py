"""The robot in the building: poses, lifts, skill results and progress."""

from enum import IntEnum, StrEnum
from typing import Any, Literal

import msgspec

from mansion_msgs_py.shapes import Coordinate, Degrees, Point3

__all__ = [
    "LiftCall",
    "LiftDoor",
    "LiftMode",
    "LiftMotion",
    "LiftRequest",
    "LiftRequestType",
    "LiftState",
    "ObjectState",
    "Pose2D",
    "Progress",
    "RobotState",
    "SkillChange",
    "SkillProgress",
    "SkillResult",
    "SkillStatus",
    "WorldEvent",
    "WorldState",
]


class Pose2D(msgspec.Struct, frozen=True, kw_only=True):
    """Planar pose in the floor's frame: metres, yaw in degrees counter-clockwise from +x."""

    x: Coordinate
    y: Coordinate
    yaw: Degrees = 0.0


class RobotState(msgspec.Struct, frozen=True, kw_only=True):
    """Where a robot is and what it holds."""

    session: str
    floor: int
    label: str
    pose: Pose2D
    room: str | None = None
    held: str | None = None
    pitch: float = 0.0
    building_id: str = ""
    schema_version: Literal[1] = 1


class LiftDoor(IntEnum):
    """Door states as numbered by Open-RMF's ``rmf_lift_msgs/LiftState``."""

    CLOSED = 0
    MOVING = 1
    OPEN = 2


class LiftMotion(IntEnum):
    """Motion states as numbered by Open-RMF's ``rmf_lift_msgs/LiftState``."""

    STOPPED = 0
    UP = 1
    DOWN = 2
    UNKNOWN = 3


class LiftMode(IntEnum):
    """Modes as numbered by Open-RMF's ``rmf_lift_msgs/LiftState``."""

    UNKNOWN = 0
    HUMAN = 1
    AGV = 2
    FIRE = 3
    OFFLINE = 4
    EMERGENCY = 5


class LiftRequestType(IntEnum):
    """Request types as numbered by Open-RMF's ``rmf_lift_msgs/LiftRequest``."""

    END_SESSION = 0
    AGV_MODE = 1
    HUMAN_MODE = 2


class LiftRequest(msgspec.Struct, frozen=True, kw_only=True):
    """Ask for a lift, or let it go; field names and numbers are those of ``rmf_lift_msgs/LiftRequest``.

    Attributes
    ----------
    destination_floor : str
        Floor label, or number where no label says the same.
    door_state : LiftDoor
        State of the doors on arrival; only ``OPEN`` and ``CLOSED`` can be asked.
    """

    lift_name: str
    session_id: str
    request_type: LiftRequestType = LiftRequestType.AGV_MODE
    destination_floor: str = ""
    door_state: LiftDoor = LiftDoor.OPEN
    request_time: float = 0.0


class LiftCall(msgspec.Struct, kw_only=True, frozen=True):
    """A call that waits for its turn."""

    session: str
    floor: int
    door: LiftDoor = LiftDoor.OPEN
    mode: LiftMode = LiftMode.AGV


class LiftState(msgspec.Struct, frozen=True, kw_only=True):
    """One lift; field names and numbers are those of ``rmf_lift_msgs/LiftState``.

    Attributes
    ----------
    lift_time : float
        Seconds on the world's clock.
    available_floors : list of str
        Floor labels.
    position : float
        Height of the cabin floor above the ground, metres.
    session_id : str
        Whose call holds the lift; empty when it is free.
    """

    lift_name: str
    available_floors: list[str]
    current_floor: str
    destination_floor: str
    door_state: LiftDoor
    motion_state: LiftMotion
    lift_time: float = 0.0
    position: float = 0.0
    available_modes: list[int] = msgspec.field(default_factory=lambda: [2])
    current_mode: int = 2
    session_id: str = ""
    building_id: str = ""
    schema_version: Literal[1] = 1


class SkillStatus(StrEnum):
    """Outcome of a skill."""

    SUCCESS = "SUCCESS"
    INVALID_ACTION = "INVALID_ACTION"
    PRECONDITION_FAILURE = "PRECONDITION_FAILURE"
    PLANNING_FAILURE = "PLANNING_FAILURE"
    EXECUTION_FAILURE = "EXECUTION_FAILURE"
    POSTCONDITION_FAILURE = "POSTCONDITION_FAILURE"
    CANCELED = "CANCELED"


class SkillChange(msgspec.Struct, frozen=True, kw_only=True):
    """One fact of the world that a skill changed."""

    what: str
    before: Any = None
    after: Any = None


class SkillResult(msgspec.Struct, frozen=True, kw_only=True):
    """What a skill did, or why it did not and what would satisfy it."""

    skill: str
    status: SkillStatus
    message: str
    changed: list[SkillChange] = []
    satisfied_by: str = ""
    data: dict[str, Any] = {}
    state: RobotState | None = None
    session: str = ""
    schema_version: Literal[1] = 1


class ObjectState(msgspec.Struct, frozen=True, kw_only=True):
    """Where an object is now: on a floor, or held (`floor` is then ``None``).

    Attributes
    ----------
    position : Point3, optional
        Centre of its box in the floor's frame; of what a held object carries, in the frame of its `parent`.
    mount : str, optional
        What carries it (see `SceneObject.mount`); as in the scene when absent.
    """

    id: str
    floor: int | None = None
    room: str | None = None
    position: Point3 | None = None
    rotation: float = 0.0
    parent: str | None = None
    held_by: str | None = None
    mount: str | None = None
    states: dict[str, bool | float | str] = {}


class WorldState(msgspec.Struct, frozen=True, kw_only=True):
    """The overlay of a running session: everything that differs from the scenes on disk.

    Sessions that share a building write the whole of what they share, each after its own skills: of several overlays
    of one world, that with the highest `step` counts for all but `robot`.

    Attributes
    ----------
    world : str
        Name of the world that the session shares.
    queues : dict
        Lift id to the calls that wait behind the session that holds it.
    revisions : dict
        Scene revision of each floor (as a decimal string) that the overlay rests on.
    objects : list of ObjectState
        Objects that moved or changed state.
    doors : dict
        Door id to whether it stands open, for doors that changed.
    calls : dict
        Lift id to the floor that the session called it to.
    """

    building_id: str
    session: str
    robot: RobotState
    lifts: list[LiftState] = []
    objects: list[ObjectState] = []
    doors: dict[str, bool] = {}
    calls: dict[str, int] = {}
    revisions: dict[str, int] = {}
    queues: dict[str, list[LiftCall]] = {}
    world: str = "shared"
    time: float = 0.0
    step: int = 0
    schema_version: Literal[1] = 1


class SkillProgress(msgspec.Struct, frozen=True, kw_only=True):
    """How far a running skill is.

    Attributes
    ----------
    fraction : float
        Share of the way that is done, 0 to 1.
    time : float
        Seconds on the world's clock.
    """

    session: str
    skill: str
    message: str
    fraction: float
    pose: Pose2D | None = None
    floor: int | None = None
    time: float = 0.0
    building_id: str = ""
    schema_version: Literal[1] = 1


class WorldEvent(msgspec.Struct, frozen=True, kw_only=True):
    """What one finished skill changed."""

    step: int
    time: float
    session: str
    skill: str
    changed: list[SkillChange]
    building_id: str = ""
    world: str = ""
    schema_version: Literal[1] = 1


class Progress(msgspec.Struct, frozen=True, kw_only=True):
    """How far a long job is: `done` of `total` steps."""

    stage: str
    message: str
    done: int
    total: int
    floor: int | None = None
    building_id: str = ""
    session: str = ""
    schema_version: Literal[1] = 1

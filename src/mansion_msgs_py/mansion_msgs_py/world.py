"""The robot in the building: poses, lifts, skill results and progress."""

from enum import IntEnum, StrEnum
from typing import Any, Literal

import msgspec

from mansion_msgs_py.shapes import Point3

__all__ = [
    "LiftDoor",
    "LiftMotion",
    "LiftState",
    "ObjectState",
    "Pose2D",
    "Progress",
    "RobotState",
    "SkillChange",
    "SkillResult",
    "SkillStatus",
    "WorldState",
]


class Pose2D(msgspec.Struct, kw_only=True):
    """Planar pose in the floor's frame: metres, yaw in degrees counter-clockwise from +x."""

    x: float
    y: float
    yaw: float = 0.0


class RobotState(msgspec.Struct, kw_only=True):
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


class LiftState(msgspec.Struct, kw_only=True):
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


class SkillChange(msgspec.Struct, kw_only=True):
    """One fact of the world that a skill changed."""

    what: str
    before: Any = None
    after: Any = None


class SkillResult(msgspec.Struct, kw_only=True):
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


class ObjectState(msgspec.Struct, kw_only=True):
    """Where an object is now: on a floor, or held (``floor`` and ``position`` are then ``None``)."""

    id: str
    floor: int | None = None
    room: str | None = None
    position: Point3 | None = None
    rotation: float = 0.0
    parent: str | None = None
    held_by: str | None = None
    states: dict[str, bool | float | str] = {}


class WorldState(msgspec.Struct, kw_only=True):
    """The overlay of a running session: everything that differs from the scenes on disk.

    Attributes
    ----------
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
    time: float = 0.0
    step: int = 0
    schema_version: Literal[1] = 1


class Progress(msgspec.Struct, kw_only=True):
    """How far a long job is: `done` of `total` steps."""

    stage: str
    message: str
    done: int
    total: int
    floor: int | None = None
    building_id: str = ""
    session: str = ""
    schema_version: Literal[1] = 1

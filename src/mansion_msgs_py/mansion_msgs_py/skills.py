"""Arguments and replies of the skills: one type for each, all with an optional session.

Values that a skill judges itself (a floor that is not there, a direction that does not exist) are decoded as they come,
so that the answer is the skill's ``INVALID_ACTION`` and not a payload error.
"""

from typing import Any, Literal

import msgspec

from mansion_msgs_py.world import Pose2D, RobotState

__all__ = [
    "CameraNames",
    "Control",
    "ControlArgs",
    "DoorArgs",
    "GoToLandmarkArgs",
    "LandmarkInfo",
    "Landmarks",
    "Loaded",
    "LookArgs",
    "MoveAheadArgs",
    "MoveToArgs",
    "NearObjectArgs",
    "ObjectArgs",
    "PlaceArgs",
    "Route",
    "RouteArgs",
    "RouteLeg",
    "RotateArgs",
    "SessionArgs",
    "TakeStairsArgs",
    "UseElevatorArgs",
    "VisibleArgs",
    "VisibleObject",
    "VisibleObjects",
    "WhereAmI",
]


class SessionArgs(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Which robot a call is for (the default one when absent), and the token of who drives it, if someone does."""

    session: str = ""
    token: str = ""


class ControlArgs(SessionArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Ask to be the only driver of a session; `client` says who asks."""

    client: str = ""
    force: bool = False


class UseElevatorArgs(SessionArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Skill card UseElevator: a floor number, or a label where it is unambiguous."""

    target_floor: Any


class TakeStairsArgs(SessionArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Skill card TakeStairs: ``Up`` or ``Down``."""

    direction: Any


class GoToLandmarkArgs(SessionArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """A room, a core, or ``elevator`` or ``stairs`` for the nearest of its kind on this floor."""

    landmark: Any


class MoveToArgs(SessionArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """A point of this floor in metres; the robot ends with `yaw` (degrees), or as it arrives."""

    x: Any
    y: Any
    yaw: Any = None


class MoveAheadArgs(SessionArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Metres straight ahead; negative ones go backwards."""

    distance: Any = 0.25


class RotateArgs(SessionArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Degrees to turn on the spot, counter-clockwise."""

    degrees: Any = 90.0


class LookArgs(SessionArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Degrees to tilt the camera."""

    degrees: Any = 30.0


class ObjectArgs(SessionArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """An object: its id, or the end of it where that is unambiguous on this floor (``desk_1/mug_2``, ``mug_2``)."""

    object: Any


class NearObjectArgs(ObjectArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """An object or a door of this floor."""


class DoorArgs(SessionArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """A door of this floor: its id, or the nearest one when absent."""

    door: Any = ""


class PlaceArgs(SessionArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Put what is held ``on``, ``in`` or ``in_front`` of `target`; ``floor`` is the floor before the robot."""

    target: Any
    relation: Any = "on"


class VisibleArgs(SessionArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """How far to look, metres."""

    distance: Any = None


class RouteArgs(SessionArgs, kw_only=True, forbid_unknown_fields=True, frozen=True):
    """Where a route shall lead: a room or core of any floor (``F3/office_1``), or an object, by its id."""

    target: Any


class LandmarkInfo(msgspec.Struct, frozen=True, kw_only=True):
    """A place that a robot can be sent to."""

    name: str
    kind: str
    floor: int
    pose: Pose2D


class Landmarks(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of ``skills/list_landmarks``."""

    floor: int
    label: str
    landmarks: list[LandmarkInfo]
    session: str = ""


class VisibleObject(msgspec.Struct, frozen=True, kw_only=True):
    """Something the robot sees; `distance` (metres) and `bearing` (degrees, left is positive) from the robot."""

    id: str
    category: str
    distance: float
    bearing: float
    room: str | None = None
    parent: str | None = None
    within_reach: bool = False
    pickupable: bool = False
    receptacle: bool = False
    openable: bool = False
    toggleable: bool = False
    states: dict[str, bool | float | str] = {}


class VisibleObjects(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of ``skills/list_visible``, nearest first."""

    floor: int
    pose: Pose2D
    objects: list[VisibleObject]
    session: str = ""


class RouteLeg(msgspec.Struct, kw_only=True):
    """One part of a route: ``walk`` on a floor, ``elevator`` or ``stair`` between two; world's `seconds`."""

    kind: str
    floor: int
    to_floor: int
    via: str
    seconds: float
    meters: float = 0.0
    points: list[tuple[float, float]] = []


class Route(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of ``skills/plan_route``."""

    legs: list[RouteLeg]
    seconds: float
    meters: float
    skills: list[str] = []
    session: str = ""


class WhereAmI(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of ``skills/where_am_i``."""

    floor: int
    label: str
    room: str | None
    pose: Pose2D
    held: str | None
    session: str = ""


class Control(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of ``skills/take_control``: the token that every call of the session now needs."""

    session: str
    token: str
    client: str = ""


class Loaded(msgspec.Struct, frozen=True, kw_only=True):
    """Reply of ``load_building``."""

    building_id: str
    floors: list[int]
    labels: list[str]
    state: RobotState
    landmarks: list[LandmarkInfo]
    session: str = ""
    world: str = "shared"
    notes: list[str] = []


class CameraNames(msgspec.Struct, frozen=True, kw_only=True):
    """What the labels of segmentation images mean.

    Attributes
    ----------
    names : list of str
        Id of the room, wall, door, window, core, object or robot at each label's index; -1 is the sky.
    """

    names: list[str]
    session: str = ""
    building_id: str = ""
    schema_version: Literal[1] = 1

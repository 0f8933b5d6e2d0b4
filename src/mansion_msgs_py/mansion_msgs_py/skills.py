"""Replies of the skills, and the arguments that every call of a session has.

The further arguments of a skill are declared beside it, in `mansion_skills.skills`.
"""

from typing import Literal

import msgspec

from mansion_msgs_py.world import Pose2D, RobotState

__all__ = [
    "CameraNames",
    "Control",
    "ControlArgs",
    "LandmarkInfo",
    "Landmarks",
    "Loaded",
    "Route",
    "RouteLeg",
    "SessionArgs",
    "VisibleObject",
    "VisibleObjects",
    "WhereAmI",
]


class SessionArgs(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Which robot a call is for (the default one when absent), and the token of who drives it, if someone does."""

    session: str = ""
    token: str = ""


class ControlArgs(SessionArgs, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Ask to be the only driver of a session; `client` says who asks."""

    client: str = ""
    force: bool = False


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


class RouteLeg(msgspec.Struct, frozen=True, kw_only=True):
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

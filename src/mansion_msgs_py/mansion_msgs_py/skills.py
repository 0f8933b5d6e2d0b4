"""Arguments and replies of the skills: one type for each, all with an optional session.

Values that a skill judges itself (a floor that is not there, a direction that does not exist) are decoded as they come,
so that the answer is the skill's ``INVALID_ACTION`` and not a payload error.
"""

import msgspec

from mansion_msgs_py.world import Pose2D, RobotState

__all__ = [
    "GoToLandmarkArgs",
    "LandmarkInfo",
    "Loaded",
    "SessionArgs",
    "TakeStairsArgs",
    "UseElevatorArgs",
    "WhereAmI",
]


class SessionArgs(msgspec.Struct, kw_only=True, forbid_unknown_fields=True):
    """Which robot a call is for; the one default robot when absent."""

    session: str = ""


class UseElevatorArgs(SessionArgs, kw_only=True, forbid_unknown_fields=True):
    """Skill card UseElevator: a floor number, or a label where it is unambiguous."""

    target_floor: int | str


class TakeStairsArgs(SessionArgs, kw_only=True, forbid_unknown_fields=True):
    """Skill card TakeStairs: ``Up`` or ``Down``."""

    direction: str


class GoToLandmarkArgs(SessionArgs, kw_only=True, forbid_unknown_fields=True):
    """A room, a core, or ``elevator`` or ``stairs`` for the nearest of its kind on this floor."""

    landmark: str


class LandmarkInfo(msgspec.Struct, kw_only=True):
    """A place that a robot can be sent to."""

    name: str
    kind: str
    floor: int
    pose: Pose2D


class WhereAmI(msgspec.Struct, kw_only=True):
    """Reply of ``skills/where_am_i``."""

    floor: int
    label: str
    room: str | None
    pose: Pose2D
    held: str | None
    session: str = ""


class Loaded(msgspec.Struct, kw_only=True):
    """Reply of ``load_building``."""

    building_id: str
    floors: list[int]
    labels: list[str]
    state: RobotState
    landmarks: list[LandmarkInfo]
    session: str = ""

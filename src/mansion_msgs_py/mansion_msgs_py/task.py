"""Tasks for a robot: the request, what must be there, and when it is done (supplement, E and F.2 to F.4)."""

from enum import StrEnum
from pathlib import Path
from typing import Annotated, Any, Literal, TypeAlias

import msgspec

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import decode_from, read_bytes
from mansion_msgs_py.world import Pose2D

__all__ = [
    "Difficulty",
    "Goal",
    "GoalKind",
    "Need",
    "ProgressScore",
    "SkillCall",
    "Task",
    "TaskKind",
    "TaskSet",
    "TaskStart",
    "read_task_set",
    "read_tasks",
]


class TaskKind(StrEnum):
    """What kind of work a task is."""

    DELIVER = "deliver"
    SEARCH = "search"
    OPEN_AND_PUT = "open_and_put"
    COLLECT = "collect"


class GoalKind(StrEnum):
    """What a goal states of the world.

    ``object_in_room``: one of `objects` lies in one of `rooms`, out of the hand. ``object_on``, ``object_in``: one of
    `objects` rests on, or is within, one of `receptacles`. ``object_near``: one of `objects` lies, or is held, within
    `distance` of one of `receptacles`. ``robot_near``: the robot stands within `distance` of one of `receptacles` on
    its floor. ``robot_in_room``: the robot stands in one of `rooms`. ``holding``: it holds one of `objects`.
    ``open``, ``closed``: one of `receptacles` is. ``seen``: one of `objects` has been in view.
    """

    OBJECT_IN_ROOM = "object_in_room"
    OBJECT_ON = "object_on"
    OBJECT_IN = "object_in"
    OBJECT_NEAR = "object_near"
    ROBOT_NEAR = "robot_near"
    ROBOT_IN_ROOM = "robot_in_room"
    HOLDING = "holding"
    OPEN = "open"
    CLOSED = "closed"
    SEEN = "seen"


class Difficulty(StrEnum):
    """How hard a task is, from the floors it spans, the way and the objects alike."""

    EASY = "easy"
    MEDIUM = "medium"
    HARD = "hard"


class Goal(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A statement that must hold at the end, of any one of the objects named.

    Attributes
    ----------
    objects, receptacles, rooms : list of str
        Ids that serve equally well (every box on that bed, not one box).
    distance : float
        Metres, for the near goals.
    """

    kind: GoalKind
    objects: list[str] = []
    receptacles: list[str] = []
    rooms: list[str] = []
    distance: float = 1.5


class Need(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Something that the building must hold for the task to make sense, in words.

    Attributes
    ----------
    noun, color : str
        The object ("toolbox", "orange"); no noun where the room or the floor itself is meant.
    relation : str
        How it lies with its `receptacle`; ``room`` when only the room or the floor counts.
    receptacle, receptacle_color, room : str
        Words for where it is ("couch", "blue", "meeting room"); empty for any.
    floor : int, optional
        Index of the floor.
    role : str
        ``target`` is what is carried or sought, ``destination`` where it goes, ``other`` the rest.
    """

    noun: str = ""
    color: str = ""
    relation: Literal["on", "in", "room"] = "room"
    receptacle: str = ""
    receptacle_color: str = ""
    room: str = ""
    floor: int | None = None
    role: Literal["target", "destination", "other"] = "other"


class SkillCall(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A skill and its arguments, as ``mansion skill`` takes them."""

    skill: str
    arguments: dict[str, Any] = {}


class TaskStart(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Where the robot stands when the task begins."""

    floor: int
    pose: Pose2D


class Task(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A task in a building.

    Attributes
    ----------
    instruction : str
        What the agent is told.
    start : TaskStart, optional
        Where the building's robot starts when absent.
    needs : list of Need
        What must be there; what `mansion edit --task` provides.
    goals : list of Goal
        All must hold; without ids while the task is not grounded in a building.
    oracle : list of SkillCall
        A plan that was run and reached the goals; the proof that it can be done.
    floors_spanned : int
        Floors from the lowest to the highest that the oracle's way touches.
    max_steps : int
        Skills that an agent may call.
    """

    id: Annotated[str, msgspec.Meta(pattern=r"^[A-Za-z0-9][A-Za-z0-9_.-]{0,95}$")]
    kind: TaskKind
    instruction: str
    building_id: str = ""
    seed: int = 0
    start: TaskStart | None = None
    needs: list[Need] = []
    goals: list[Goal] = []
    oracle: list[SkillCall] = []
    difficulty: Difficulty = Difficulty.EASY
    floors_spanned: int = 1
    max_steps: Annotated[int, msgspec.Meta(ge=1, le=10_000)] = 50
    schema_version: Literal[1] = 1


class ProgressScore(msgspec.Struct, kw_only=True, frozen=True, forbid_unknown_fields=True):
    """Progress of a task: retrieval and navigation, each for itself (supplement, F.2).

    Attributes
    ----------
    retrieval, navigation : float
        0 to 1: the right object found and taken; the places of the task reached. Success makes both 1.
    """

    retrieval: float = 0.0
    navigation: float = 0.0
    success: bool = False


_BuildingId: TypeAlias = Annotated[str, msgspec.Meta(pattern=r"^([A-Za-z0-9][A-Za-z0-9_-]{0,63})?$")]
"""A `BuildingId`, or nothing where the tasks are of any building."""


class TaskSet(msgspec.Struct, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """Tasks of one building, as ``mansion task generate`` writes them.

    Attributes
    ----------
    building : str
        Folder of the building, relative to the file.
    """

    building: str
    building_id: _BuildingId
    tasks: list[Task]
    schema_version: Literal[1] = 1


def read_task_set(file: Path) -> TaskSet:
    """Read a task set.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a file that cannot be read, ``INVALID_PAYLOAD`` for one that is no task set; both name it.
    """
    if file.is_dir():
        raise MansionError(ErrorCode.NOT_FOUND, f"{file} is a folder; name a file of `mansion task generate`")
    data = read_bytes(file, "a file of `mansion task generate`")
    head = decode_from(dict[str, Any], data, file)
    if "instruction" in head and "tasks" not in head:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"{file} is a task in words; `mansion task ground {file} BUILDING -o FILE` makes a task set of it",
        )
    return decode_from(TaskSet, data, file)


def read_tasks(file: Path, task_id: str = "") -> list[Task]:
    """Return the tasks of a file, a `Task` or a `TaskSet`: the one of an id, or all.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a file that cannot be read or an id that it lacks, ``INVALID_PAYLOAD`` for what is no task.
    """
    data = read_bytes(file, "the JSON of a task, or of a set of tasks")
    if "tasks" in decode_from(dict[str, Any], data, file):
        tasks = decode_from(TaskSet, data, file).tasks
    else:
        tasks = [decode_from(Task, data, file)]
    wanted = [task for task in tasks if task_id in ("", task.id)]
    if not wanted:
        known = ", ".join(task.id for task in tasks[:20])
        raise MansionError(ErrorCode.NOT_FOUND, f"{file} has no task {task_id!r}; it has {known}")
    return wanted

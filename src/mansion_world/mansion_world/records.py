"""Records of a world: rows of its manifest, and the attempts that were rejected."""

from typing import Literal, TypeAlias

import msgspec

from mansion_msgs_py.task import Task
from mansion_world.sampling import WorldRequest

__all__ = [
    "SPLITS",
    "BuildingRow",
    "Difficulty",
    "DoneTask",
    "MadeTasks",
    "Record",
    "RoomLikeness",
    "RoomRow",
    "SetAside",
    "Split",
    "TaskRow",
    "Trial",
    "WorldIndex",
    "WorldSource",
]

Split: TypeAlias = Literal["train", "val", "test"]
Difficulty: TypeAlias = Literal["easy", "medium", "hard", "expert"]

SPLITS: tuple[Split, ...] = ("train", "val", "test")


class WorldSource(msgspec.Struct, frozen=True, kw_only=True):
    """A world that became part of another, as its own ``world.json`` had it, and how many buildings it had."""

    seed: int
    mix: str
    versions: dict[str, str]
    tasks: int
    buildings: int


class WorldIndex(msgspec.Struct, frozen=True, kw_only=True):
    """The content of ``world.json``: what all buildings of a world follow from.

    Attributes
    ----------
    mix : str
        The mixture as JSON; empty where the buildings are those of a list.
    tasks : int
        Tasks that were asked for each building.
    sources : list of WorldSource
        The worlds that this one was joined from; all else is then that of the first. None for a world that was made.
    """

    seed: int
    mix: str
    versions: dict[str, str]
    tasks: int = 0
    sources: list[WorldSource] = []
    schema_version: Literal[1] = 1


class BuildingRow(msgspec.Struct, frozen=True, kw_only=True):
    """A building in the manifest.

    Attributes
    ----------
    path : str
        Folder of the building, relative to the world's.
    floor_areas : list of float
        Area of each floor from below, m2; `area` is their sum.
    wishes, wishes_met : int
        What its sentence asks for, and how much of that the building meets.
    landmarks : int
        Rooms, stairs and lifts of the floor that has most.
    tasks : int
        Tasks in its ``tasks.json``.
    task_metres : float
        Mean of what the robot drives for them when their plans are run; 0 without tasks.
    tasks_undone : int
        Drafts that the oracle could not do, and that are therefore not tasks.
    no_tasks : str
        Why tasks that were asked for are missing altogether; empty otherwise.
    clutter : {"", "sparse", "dense"}
        Whether few or many small objects were asked for.
    bytes, sha256 : int, str
        Size and hash of all files but ``report.json``, which holds times.
    licence : str
        SPDX identifier.
    """

    index: int
    id: str
    path: str
    split: Split
    difficulty: Difficulty
    kind: str
    sub_kind: str
    outline: str
    style: str
    description: str
    wording: str
    seed: int
    attempt: int
    floors: int
    rooms: int
    landmarks: int
    objects: int
    area: float
    floor_areas: list[float]
    wishes: int
    wishes_met: int
    files: int
    bytes: int
    sha256: str
    versions: dict[str, str]
    licence: str
    tasks: int = 0
    task_metres: float = 0.0
    tasks_undone: int = 0
    no_tasks: str = ""
    clutter: str = ""


class RoomRow(msgspec.Struct, frozen=True, kw_only=True):
    """A room in the manifest."""

    index: int
    building: str
    split: Split
    floor: int
    id: str
    type: str
    area: float
    objects: int


class TaskRow(msgspec.Struct, frozen=True, kw_only=True):
    """A task in the manifest; the whole of it is in the building's ``tasks.json``.

    Attributes
    ----------
    difficulty : str
        Difficulty of the task: easy, medium or hard.
    floors : int
        From the lowest to the highest that the oracle's way touches.
    metres, seconds : float
        That the robot drives when the oracle's plan is run, without rides and stairs; the time that it takes.
    steps, max_steps : int
        Skills of the plan, and that an agent may call.
    things : int
        Goals that name an object to bring or to find.
    """

    index: int
    building: str
    split: Split
    id: str
    kind: str
    instruction: str
    difficulty: str
    floors: int
    metres: float
    seconds: float
    steps: int
    max_steps: int
    things: int


class Trial(msgspec.Struct, frozen=True, kw_only=True):
    """What came of an agent at a task.

    Attributes
    ----------
    building, task : str
        Their ids.
    retrieval, navigation : float
        Scores of the paper's supplement (F.2), from 0 to 1.
    steps : int
        Skills that the agent called.
    seconds : float
        On the clock of the world.
    """

    building: str
    task: str
    agent: str
    success: bool
    retrieval: float
    navigation: float
    steps: int
    seconds: float


class DoneTask(msgspec.Struct, frozen=True, kw_only=True):
    """What came of running a task's plan."""

    task: Task
    success: bool
    metres: float
    seconds: float


class MadeTasks(msgspec.Struct, frozen=True, kw_only=True):
    """The tasks made in a building, each done once.

    Attributes
    ----------
    undone : int
        Drafts that the oracle could not do.
    why_none : str
        Why there is none; empty where there are some or none was asked for.
    """

    tasks: list[DoneTask] = []
    undone: int = 0
    why_none: str = ""


class RoomLikeness(msgspec.Struct, frozen=True, kw_only=True, array_like=True):
    """Where a room is, for comparison: type, floor, centre and area in metres."""

    floor: int
    type: str
    x: float
    y: float
    area: float


class Record(msgspec.Struct, frozen=True, kw_only=True):
    """All that is kept of a finished building.

    Attributes
    ----------
    graph : str
        Hash of its room graphs (see `mansion_world.near_duplicates`).
    likeness : list of RoomLikeness
    """

    building: BuildingRow
    rooms: list[RoomRow]
    graph: str
    likeness: list[RoomLikeness]
    tasks: list[TaskRow] = []


class SetAside(msgspec.Struct, frozen=True, kw_only=True):
    """A request that was given up, with the reason."""

    request: WorldRequest
    reason: Literal["refused", "faults", "floor too large", "near-duplicate", "worker ended"]
    details: list[str]

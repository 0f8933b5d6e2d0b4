"""The log of an episode: one JSON line for its start, each step and its end, with all that a repetition needs."""

from pathlib import Path
from typing import Any, Literal

import msgspec

from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import decode_from, read_bytes, write_atomic
from mansion_msgs_py.shapes import BuildingId, FileName
from mansion_msgs_py.task import SkillCall, Task
from mansion_msgs_py.world import Pose2D, SkillStatus

__all__ = ["EpisodeEnd", "EpisodeLog", "EpisodeStart", "EpisodeStep", "StopReason", "read_log", "write_log"]

StopReason = Literal["success", "agent_stopped", "step_limit", "agent_failed"]


class EpisodeStart(msgspec.Struct, frozen=True, kw_only=True, tag="start", tag_field="line"):
    """What was to be done, where and by whom."""

    task: Task
    building: str
    building_id: BuildingId
    agent: FileName
    seed: int
    lessons: list[str] = []
    schema_version: Literal[1] = 1


class EpisodeStep(msgspec.Struct, frozen=True, kw_only=True, tag="step", tag_field="line"):
    """One skill and what came of it.

    Attributes
    ----------
    call : SkillCall
        With the objects' ids, whatever the agent called them.
    refused : bool
        The call named what its agent could not know, and never reached the skills.
    time : float
        Seconds on the world's clock after it.
    notes : dict
        What the agent said about its choice.
    """

    step: int
    call: SkillCall
    status: SkillStatus
    message: str
    floor: int
    pose: Pose2D
    room: str | None
    held: str | None
    time: float
    retrieval: float
    navigation: float
    refused: bool = False
    notes: dict[str, Any] = {}


class EpisodeEnd(msgspec.Struct, frozen=True, kw_only=True, tag="end", tag_field="line"):
    """How it ended.

    Attributes
    ----------
    retrieval, navigation : float
        The two progress scores of section F.2, 0 to 1.
    claimed : bool
        Whether the agent said that the task is done.
    time : float
        Seconds on the world's clock.
    seconds : float
        Seconds on the wall, the one figure that differs between runs.
    digest : str
        Digest of the world at the end.
    """

    success: bool
    retrieval: float
    navigation: float
    steps: int
    stop: StopReason
    reason: str
    time: float
    digest: str
    claimed: bool = False
    lessons: list[str] = []
    seconds: float = 0.0


class EpisodeLog(msgspec.Struct, frozen=True, kw_only=True):
    """A whole episode."""

    start: EpisodeStart
    steps: list[EpisodeStep]
    end: EpisodeEnd


def write_log(path: Path, log: EpisodeLog) -> None:
    """Write a log, whole or not at all."""
    lines = [encode_bytes(line) for line in (log.start, *log.steps, log.end)]
    write_atomic(path, b"\n".join(lines) + b"\n")


def read_log(path: Path) -> EpisodeLog:
    """Read a log.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a missing file; ``INVALID_PAYLOAD`` for a file that is not a log, or lacks its end.
    """
    data = read_bytes(path, "a log that `mansion bench agents` wrote")
    kind: Any = EpisodeStart | EpisodeStep | EpisodeEnd
    lines = [decode_from(kind, line, path) for line in data.splitlines() if line.strip()]
    steps = [line for line in lines if isinstance(line, EpisodeStep)]
    if len(lines) != len(steps) + 2 or not isinstance(lines[0], EpisodeStart) or not isinstance(lines[-1], EpisodeEnd):
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{path} is not a complete log: a start, its steps and an end")
    return EpisodeLog(start=lines[0], steps=steps, end=lines[-1])

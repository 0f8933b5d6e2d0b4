"""Steps of a running skill, and the results with which it ends."""

from collections.abc import Generator
from dataclasses import dataclass
from math import isfinite
from typing import Any, TypeAlias

from msgspec.structs import replace

from mansion_msgs_py.errors import MOST_CHARACTERS
from mansion_msgs_py.wording import shortened
from mansion_msgs_py.world import SkillChange, SkillResult, SkillStatus
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["Run", "Step", "done", "invalid", "number", "refused", "unmet", "with_changes"]


@dataclass(frozen=True)
class Step:
    """A stretch of time in a running skill, which continues once the world's clock has advanced by `seconds`."""

    seconds: float
    fraction: float
    message: str


Run: TypeAlias = Generator[Step, None, SkillResult]
"""A running skill; it can be cancelled at each step, where the world is consistent."""


def done(world: World, robot: RobotBody, skill: str, message: str, *changes: SkillChange, **data: Any) -> SkillResult:
    """Return a success with what changed."""
    return SkillResult(
        skill=skill,
        status=SkillStatus.SUCCESS,
        message=message,
        changed=list(changes),
        data=data,
        state=world.robot_state(robot),
        session=robot.session,
    )


def refused(
    world: World, robot: RobotBody, skill: str, status: SkillStatus, message: str, satisfied_by: str, **data: Any
) -> SkillResult:
    """Return a refusal with what would satisfy the skill; the world is as it was."""
    return SkillResult(
        skill=skill,
        status=status,
        message=shortened(message, MOST_CHARACTERS),
        satisfied_by=satisfied_by,
        data=data,
        state=world.robot_state(robot),
        session=robot.session,
    )


def invalid(world: World, robot: RobotBody, skill: str, message: str, satisfied_by: str) -> SkillResult:
    """Return ``INVALID_ACTION``: what was asked can never be done."""
    return refused(world, robot, skill, SkillStatus.INVALID_ACTION, message, satisfied_by)


def unmet(world: World, robot: RobotBody, skill: str, message: str, satisfied_by: str) -> SkillResult:
    """Return ``PRECONDITION_FAILURE``: it could be done in another situation."""
    return refused(world, robot, skill, SkillStatus.PRECONDITION_FAILURE, message, satisfied_by)


def with_changes(result: SkillResult, *changes: SkillChange) -> SkillResult:
    """Return a result with further changes."""
    return replace(result, changed=[*result.changed, *changes])


def number(value: object, limit: float = 1e6) -> float | None:
    """Return a JSON value as a number between -limit and limit, or ``None``."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    if not isfinite(value) or abs(value) > limit:
        return None
    return float(value)

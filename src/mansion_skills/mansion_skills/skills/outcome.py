"""Results of skills."""

from typing import Any

from mansion_msgs_py.world import SkillChange, SkillResult, SkillStatus
from mansion_skills.world.world import World

__all__ = ["done", "refused"]


def done(world: World, skill: str, message: str, *changes: SkillChange, **data: Any) -> SkillResult:
    """Return a success with what changed."""
    return SkillResult(
        skill=skill,
        status=SkillStatus.SUCCESS,
        message=message,
        changed=list(changes),
        data=data,
        state=world.robot,
        session=world.session,
    )


def refused(
    world: World, skill: str, status: SkillStatus, message: str, satisfied_by: str
) -> SkillResult:
    """Return a refusal with what would satisfy the skill; the world is as it was."""
    return SkillResult(
        skill=skill,
        status=status,
        message=message,
        satisfied_by=satisfied_by,
        state=world.robot,
        session=world.session,
    )

"""Ports through which an episode calls the robot's skills: in this process, or over the services of a graph."""

from pathlib import Path
from typing import Any, Protocol

from mansion_msgs_py.codec import convert, to_builtins
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.skills import Landmarks, VisibleObjects
from mansion_msgs_py.task import SkillCall
from mansion_msgs_py.world import SkillResult, SkillStatus
from mansion_skills.engine import Engine
from mansion_skills.robot import Robot
from mansion_skills.skills.declaration import Skill
from mansion_skills.skills.registry import SKILLS, skill_named
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World
from mansion_tasks.episodes.episode_folder import SESSION, WORLD

__all__ = ["LocalPort", "SkillPort", "as_result", "called_skill", "invalid_call"]

RESERVED = ("session", "token")
"""Arguments that say who is driven by whom; an agent drives its own robot only."""


class SkillPort(Protocol):
    """The robot of one episode at a time."""

    def load(self, folder: Path) -> None:
        """Load an episode folder and put the robot into it."""

    def call(self, call: SkillCall) -> SkillResult:
        """Run a skill; whatever is called, the answer is a result."""

    def visible(self) -> VisibleObjects:
        """Ask what the camera sees."""

    def landmarks(self) -> Landmarks:
        """Ask for this floor's landmarks."""

    def world(self) -> tuple[World, RobotBody]:
        """Return the world as the skills left it, to judge and draw it."""


class LocalPort:
    """The skills in this process."""

    def __init__(self) -> None:
        self._robot: Robot | None = None

    def load(self, folder: Path) -> None:
        """See `SkillPort.load`."""
        engine = Engine(durable=False)
        self._robot = Robot(folder, SESSION, world=WORLD, engine=engine)

    @property
    def robot(self) -> Robot:
        """The robot; nothing works before `load`."""
        if self._robot is None:
            raise MansionError(ErrorCode.NOT_LOADED, "the port has no building; load one first")
        return self._robot

    def call(self, call: SkillCall) -> SkillResult:
        """See `SkillPort.call`."""
        skill = called_skill(call)
        if isinstance(skill, SkillResult):
            return skill
        try:
            arguments = convert(skill.arguments, {**call.arguments, "session": SESSION})
            return as_result(skill, self.robot.engine.run(skill.name, arguments))
        except MansionError as error:
            return invalid_call(skill.name, str(error))

    def visible(self) -> VisibleObjects:
        """See `SkillPort.visible`."""
        return self.robot.list_visible()

    def landmarks(self) -> Landmarks:
        """See `SkillPort.landmarks`."""
        return self.robot.list_landmarks()

    def world(self) -> tuple[World, RobotBody]:
        """See `SkillPort.world`."""
        session = self.robot.engine.session(SESSION)
        return session.world, session.robot


def called_skill(call: SkillCall) -> Skill | SkillResult:
    """Return the skill that is called, or the refusal of a call that is invalid or meant for another robot."""
    skill = skill_named(call.skill)
    if skill is None:
        known = ", ".join(entry.name for entry in SKILLS.values())
        return invalid_call(call.skill, f"there is no skill {call.skill!r}", f"one of {known}")
    for name in RESERVED:
        if name in call.arguments:
            return invalid_call(skill.name, f"{name} is not the agent's to set")
    return skill


def as_result(skill: Skill, answer: Any) -> SkillResult:
    """Return a skill's answer as a result; what a question was answered is its data."""
    if isinstance(answer, SkillResult):
        return answer
    return SkillResult(
        skill=skill.name, status=SkillStatus.SUCCESS, message="answered", data=to_builtins(answer), session=SESSION
    )


def invalid_call(name: str, message: str, wish: str = "arguments of the skill") -> SkillResult:
    """Return the result of a call that never reached a skill."""
    return SkillResult(
        skill=name[:80], status=SkillStatus.INVALID_ACTION, message=message[:500], satisfied_by=wish, session=SESSION
    )

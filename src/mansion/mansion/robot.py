"""A robot in a building: every declared skill is a method, run in this process or over a node graph."""

import inspect
from collections.abc import Callable, Mapping
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.wording import choices
from mansion_msgs_py.world import SkillResult, SkillStatus
from mansion_skills.skills.declaration import Skill
from mansion_skills.skills.registry import SKILLS, skill_named

__all__ = ["Robot", "RobotPort"]


class RobotPort(Protocol):
    """One session's robot, wherever its world is."""

    def run(self, skill: Skill, arguments: Mapping[str, Any]) -> Any:
        """Run a skill and return its result, refused or not, or the answer of a query."""

    def look(self, width: int | None, height: int | None, fov: float | None) -> npt.NDArray[np.uint8]:
        """Return what the robot's camera sees, as large and as wide as usual where that is left open."""


class Robot:
    """The skills of one robot as methods: ``robot.pick_up("F1/kitchen/mug_1")``.

    The methods follow from the skills that `mansion_skills` declares; `skills` has them by name, and ``help`` says what
    each takes. A skill returns a `SkillResult`, whose ``status`` says whether it succeeded and whose ``message`` why
    not; a query returns its answer.

    Parameters
    ----------
    port : RobotPort
    home : object
        What must live as long as the robot.

    Examples
    --------
    >>> robot = b.robot()
    >>> robot.go_to("kitchen").message
    'at F1/kitchen'
    >>> robot.where_am_i().room
    'F1/kitchen'
    >>> robot.pick_up("moon").status.value
    'INVALID_ACTION'
    >>> sorted(robot.skills)[:3]
    ['call_elevator', 'close_door', 'close_object']
    """

    def __init__(self, port: RobotPort, home: object = None) -> None:
        self._port = port
        self._home = home

    @property
    def skills(self) -> dict[str, Callable[..., Any]]:
        """Every skill by its name."""
        return {name: _method(skill, self._port) for name, skill in SKILLS.items()}

    def __getattr__(self, name: str) -> Callable[..., Any]:
        if name.startswith("_") or name not in SKILLS:
            raise AttributeError(f"a robot has no skill {name!r}; {choices(name, SKILLS, 'skills')}")
        return _method(SKILLS[name], self._port)

    def __dir__(self) -> list[str]:
        return sorted([*object.__dir__(self), *SKILLS])

    def do(self, skill: str, **arguments: Any) -> Any:
        """Run a skill by its name, ``PickUp`` or ``pick_up``.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` for a skill that does not exist, ``INVALID_PAYLOAD`` for arguments that it does not have.

        Examples
        --------
        >>> b.robot().do("Rotate", degrees=90).status.value
        'SUCCESS'
        """
        return self._port.run(_known(skill), arguments)

    def go_to(self, target: str) -> SkillResult:
        """Go to a room, a stair, a lift or an object of any floor, by lifts and stairs.

        Returns
        -------
        SkillResult
            Result of the last skill that was run, or of the one that failed.
        """
        route = self.plan_route(target)
        if isinstance(route, SkillResult):
            return route
        result = SkillResult(skill="PlanRoute", status=SkillStatus.SUCCESS, message=f"at {target}")
        for step in route.skills:
            name, _, argument = step.partition(" ")
            skill = _known(name)
            result = self._port.run(skill, dict(zip(skill.parameters, [argument] if argument else [])))
            if result.status is not SkillStatus.SUCCESS:
                break
        return result

    def look(
        self, *, width: int | None = None, height: int | None = None, fov: float | None = None
    ) -> npt.NDArray[np.uint8]:
        """Return what the robot sees, ``(height, width, 3)``.

        Parameters
        ----------
        width, height : int, optional
            Pixels; 640 and 480, or what a graph's parameters say, when absent.
        fov : float, optional
            Across, degrees; 90, or what a graph's parameters say, when absent.

        Raises
        ------
        MansionError
            ``UNAVAILABLE`` naming the extra, where it is missing.
        """
        return self._port.look(width, height, fov)


def _known(name: str) -> Skill:
    found = skill_named(name)
    if found is None:
        known = choices(name, (entry.name for entry in SKILLS.values()), "skills")
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no skill {name!r}; {known}")
    return found


def _method(skill: Skill, port: RobotPort) -> Callable[..., Any]:
    """Return a skill as a function with its arguments, in the order of their declaration."""
    names = list(skill.parameters)

    def call(*given: Any, **named: Any) -> Any:
        if len(given) > len(names):
            takes = f"it takes {', '.join(names)}" if names else "it takes none"
            raise MansionError(ErrorCode.INVALID_PAYLOAD, f"{skill.name}: {len(given)} positional arguments; {takes}")
        return port.run(skill, {**dict(zip(names, given)), **named})

    arguments = [f"{name} : {entry.description}" for name, entry in skill.parameters.items()]
    call.__name__ = call.__qualname__ = skill.service
    call.__doc__ = "\n".join([skill.description, *([""] if arguments else []), *arguments])
    call.__signature__ = inspect.Signature(_parameters(skill))  # type: ignore[attr-defined]
    return call


def _parameters(skill: Skill) -> list[inspect.Parameter]:
    fields = inspect.signature(skill.arguments).parameters
    kind = inspect.Parameter.POSITIONAL_OR_KEYWORD
    needed = [inspect.Parameter(name, kind) for name in skill.parameters if fields[name].default is inspect._empty]
    given = [
        inspect.Parameter(name, kind, default=fields[name].default)
        for name in skill.parameters
        if fields[name].default is not inspect._empty
    ]
    return [*needed, *given]

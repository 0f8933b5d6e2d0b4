"""A building's world in memory for one robot: skills run at once, nothing is saved, a reset takes milliseconds."""

from dataclasses import replace
from pathlib import Path
from typing import Any, Final

from mansion_geometry.robot_body import ROBOT_RADIUS
from mansion_msgs_py.codec import convert
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.task import SkillCall, TaskStart
from mansion_msgs_py.world import Pose2D, SkillProgress, SkillResult, SkillStatus
from mansion_skills.engine.executor import WorldClock, perform
from mansion_skills.engine.session import Session, SharedWorld
from mansion_skills.skills.registry import skill_named
from mansion_skills.skills.results import invalid
from mansion_skills.world.building import LoadedBuilding
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["SESSION", "Sandbox"]

SESSION: Final = "episode"
"""Name of the sandbox's one session."""


class Sandbox:
    """The scenes as they are on disk, and a robot among them.

    Parameters
    ----------
    building : path or LoadedBuilding
        What sessions left in its folder is not read, and nothing is written to it.
    radius : float
        Radius of the robot, metres.

    Attributes
    ----------
    world : World
    steps : int
        Skills run since the last reset.
    """

    def __init__(self, building: str | Path | LoadedBuilding, *, radius: float = ROBOT_RADIUS) -> None:
        if not isinstance(building, LoadedBuilding):
            building = LoadedBuilding(Path(building).expanduser().resolve())
        self.world = World(building, SESSION, radius)
        self.steps = 0
        self._clock = WorldClock()
        self._first = {name: self.world.objects.state(name) for name in self.world.objects}
        self._lifts = {name: replace(lift, queue=[]) for name, lift in self.world.lifts.items()}
        self._by_floor: dict[int, list[str]] = {}
        for name, state in self._first.items():
            if state.floor is not None:
                self._by_floor.setdefault(state.floor, []).append(name)
        self._session = Session(SESSION, SharedWorld(self.world), self.world.add_robot(SESSION), durable=False)

    @property
    def building(self) -> LoadedBuilding:
        """The building."""
        return self.world.building

    @property
    def session(self) -> Session:
        """The robot's session, for a camera."""
        return self._session

    @property
    def robot(self) -> RobotBody:
        """The robot."""
        return self._session.robot

    def reset(self, start: TaskStart | None = None) -> None:
        """Put everything back to where the scenes have it, and the robot to `start` (its spawn pose when absent).

        Raises
        ------
        MansionError
            ``NOT_FOUND`` when the building lacks the floor or the robot cannot stand there.
        """
        self._restore_objects_and_doors()
        world = self.world
        for name, lift in self._lifts.items():
            world.lifts[name] = replace(lift, queue=[])
        world.lift_changes.clear()
        world.time, world.step, self.steps = 0.0, 0, 0
        world.robots.clear()
        world.absent.clear()
        self._session.robot = world.add_robot(SESSION)
        if start is not None:
            self._put_robot(start)

    def _restore_objects_and_doors(self) -> None:
        """Index the objects of every floor that changed again, in the order of the scene, as if it were just loaded."""
        world = self.world
        floors = {self._first[name].floor for name in world.objects.changed}
        floors |= {state.floor for state in world.objects.changed.values()}
        floors |= {
            floor
            for floor in world.building.floors
            if world.doors and any(name in world.doors for name in world.view(floor).doors)
        }
        world.doors.clear()
        for floor in sorted(floor for floor in floors if floor is not None):
            for name in self._by_floor.get(floor, []):
                world.objects.put(self._first[name])
        world.objects.commit()
        for floor in sorted(floor for floor in floors if floor is not None):
            world.refresh(floor)

    def _put_robot(self, start: TaskStart) -> None:
        x, y = start.pose.x, start.pose.y
        if start.floor not in self.building.floors:
            raise MansionError(
                ErrorCode.NOT_FOUND,
                f"the building has no floor {start.floor}; floors are {self.building.floors}",
                path="$.start.floor",
            )
        if self.world.view(start.floor).map.room_at(x, y) is None:
            raise MansionError(
                ErrorCode.NOT_FOUND, f"({x:g}, {y:g}) is in no room of floor {start.floor}", path="$.start.pose"
            )
        self.robot.floor = start.floor
        self.robot.pose = Pose2D(x=x, y=y, yaw=start.pose.yaw)

    def run(self, call: SkillCall) -> SkillResult:
        """Run a skill to its end; an unknown skill or argument is an ``INVALID_ACTION``."""
        self.steps += 1
        skill = skill_named(call.skill)
        if skill is None or skill.query:
            text = f"{call.skill!r} is not a skill that acts"
            return invalid(self.world, self.robot, call.skill, text, "a skill of docs/skills.md")
        try:
            arguments = convert(skill.arguments, {**call.arguments, "session": SESSION})
        except MansionError as error:
            wish = "the arguments of docs/skills.md"
            return invalid(self.world, self.robot, skill.name, error.info.message, wish)
        result = perform(self._session, skill, arguments, self._clock, _ignore)
        self.world.lift_changes.clear()
        return result

    def skill(self, name: str, **arguments: Any) -> SkillResult:
        """Run a skill by its name; see `run`."""
        return self.run(SkillCall(skill=name, arguments=arguments))

    def succeeds(self, call: SkillCall) -> bool:
        """Run a skill and say whether it succeeded."""
        return self.run(call).status is SkillStatus.SUCCESS


def _ignore(progress: SkillProgress) -> None:
    """Nobody watches a sandbox."""

"""Skills whose robot is AI2-THOR's agent: done in the world, acted out by the controller, and read back."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Final

from msgspec.structs import replace

from mansion_geometry.thor.controller import Controller, act, failure, first_line, start_controller
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.skills import SessionArgs
from mansion_msgs_py.world import ObjectState, Pose2D, SkillChange, SkillResult, SkillStatus
from mansion_skills.engine import Engine
from mansion_skills.engine.executor import WorldClock
from mansion_skills.engine.session import Session
from mansion_skills.skills.declaration import Skill
from mansion_skills.skills.manipulation import ObjectArgs, PlaceArgs
from mansion_skills.skills.references import object_named
from mansion_skills.skills.results import invalid, refused, with_changes
from mansion_skills.thor.actions import Action, actions_for, teleport
from mansion_skills.thor.houses import Houses
from mansion_skills.thor.readback import read_back

__all__ = ["SETTINGS", "Snapshot", "ThorEngine", "load_house", "open_controller"]

SETTINGS: Final[Mapping[str, Any]] = {
    "agentMode": "default",
    "gridSize": 0.25,
    "snapToGrid": False,
    "visibilityDistance": 2.0,
    "fieldOfView": 90,
}
"""Parameters of each ``reset``: poses are not on a grid, and the hand reaches 1.5 m to the edge of a item."""


def open_controller(**parameters: Any) -> Controller:
    """Start AI2-THOR with an empty procedural scene.

    Parameters
    ----------
    **parameters
        Parameters of ``ai2thor.controller.Controller``: ``width``, ``height``, ``platform=CloudRendering``, ...

    Raises
    ------
    MansionError
        ``UNAVAILABLE`` when the extra ``thor`` is not installed or the simulator does not start.
    """
    return start_controller(**{"scene": "Procedural", **SETTINGS, **parameters})


def load_house(controller: Controller, house: Mapping[str, Any]) -> str:
    """Reset the controller to a house; return AI2-THOR's error message, empty when the house is there."""
    try:
        event = controller.reset(scene=house, **SETTINGS)
    except (RuntimeError, ValueError) as error:
        return f"CreateHouse: {first_line(str(error))}"
    return failure(event, "CreateHouse")


@dataclass(frozen=True)
class Snapshot:
    """A robot, the objects and the doors at one moment; lifts and the clock go on."""

    floor: int
    pose: Pose2D
    pitch: float
    objects: dict[str, ObjectState]
    doors: dict[str, bool]

    @staticmethod
    def of(session: Session) -> "Snapshot":
        """Take one."""
        robot, world = session.robot, session.world
        return Snapshot(robot.floor, robot.pose, robot.pitch, dict(world.objects.changed), dict(world.doors))

    def restore(self, session: Session) -> None:
        """Put the world back."""
        robot, world = session.robot, session.world
        floors = {robot.floor, self.floor}
        if robot.floor == self.floor:
            robot.move(self.pose)
        else:
            robot.floor, robot.pose, robot.path = self.floor, self.pose, []
        robot.pitch = self.pitch
        now = world.objects.changed
        for name in sorted({*now, *self.objects}):
            if now.get(name) != self.objects.get(name):
                world.objects.put(self.objects.get(name) or world.objects.first(name))
        world.objects.commit()
        world.doors = dict(self.doors)
        for floor in sorted(floors):
            world.refresh(floor)


class ThorEngine(Engine):
    """An engine with one robot, whose body is the agent of a controller.

    Parameters
    ----------
    controller : Controller
    entered : callable
        Told of the session whose floor AI2-THOR shows from now on.
    force : bool
        Pass ``forceAction`` to what hands do: AI2-THOR then asks neither for sight nor for reach.
    durable : bool
        See `Engine`.
    """

    def __init__(
        self, controller: Controller, entered: Callable[[Session], None], *, force: bool = False, durable: bool = True
    ) -> None:
        super().__init__(WorldClock(), durable=durable)
        self.controller = controller
        self._entered = entered
        self.force = force
        self._houses: Houses | None = None

    def houses(self, session: Session) -> Houses:
        """Return the houses of a session's building, read when they are first needed."""
        if self._houses is None:
            self._houses = Houses(session.world.building)
        return self._houses

    def _perform(self, session: Session, skill: Skill, arguments: SessionArgs) -> SkillResult:
        before = Snapshot.of(session)
        if (lacking := self._lacking(session, skill, arguments)) is not None:
            return lacking
        result = super()._perform(session, skill, arguments)
        if not result.changed:
            return result
        error = self._act_out(session, before, arguments, result)
        if error:
            self._undo(session, before)
            text = f"AI2-THOR refused: {error}"
            wish = "standing elsewhere, or another object; the message names what was in the way"
            status = SkillStatus.EXECUTION_FAILURE
            result = refused(session.world, session.robot, skill.name, status, text, wish)
        changes = self.read_back(session)
        if error and session.robot.pose != before.pose:
            changes.append(SkillChange(what="pose", before=before.pose, after=session.robot.pose))
        return replace(with_changes(result, *changes), state=session.world.robot_state(session.robot))

    def read_back(self, session: Session) -> list[SkillChange]:
        """Take over the state of the controller's last event; return what the world had otherwise."""
        return read_back(session.world, session.robot, self.controller.last_event.metadata)

    def _undo(self, session: Session, before: Snapshot) -> None:
        left = session.robot.floor != before.floor
        before.restore(session)
        if left and (error := self.enter(session)):
            raise MansionError(
                ErrorCode.UNAVAILABLE, f"AI2-THOR shows neither the other floor nor floor {before.floor} again: {error}"
            )

    def _lacking(self, session: Session, skill: Skill, arguments: SessionArgs) -> SkillResult | None:
        """Refuse hands' work on what AI2-THOR has no asset for: it is not in its scene."""
        name = arguments.object if isinstance(arguments, ObjectArgs) else None
        name = arguments.target if isinstance(arguments, PlaceArgs) else name
        if skill.name == "GoNearObject" or name in (None, "floor"):
            return None
        state = object_named(session.world, session.robot, name)
        if isinstance(state, str) or state.id in self.houses(session):
            return None
        text = f"AI2-THOR has no asset for {state.id}; it is not in its scene"
        wish = "an object of house.json; metadata.mansion.omitted lists the others"
        return invalid(session.world, session.robot, skill.name, text, wish)

    def _act_out(self, session: Session, before: Snapshot, arguments: SessionArgs, result: SkillResult) -> str:
        """Do what the world did with the controller; return AI2-THOR's error message, empty when all succeeded."""
        if session.robot.floor != before.floor:
            return self.enter(session)
        robot, actions = session.robot, list[Action]()
        if result.status is SkillStatus.SUCCESS:
            actions = actions_for(session.world, robot, before.pose, before.pitch, arguments, result, force=self.force)
        elif robot.pose != before.pose:
            actions = [teleport(robot.pose, robot.pitch)]
        for action in actions:
            if error := act(self.controller, **action):
                return error
        return ""

    def enter(self, session: Session) -> str:
        """Show AI2-THOR the robot's floor (the four steps of ``update_floor``); return its error message.

        What the robot holds enters the floor's house and is picked up again there.
        """
        world, robot = session.world, session.robot
        houses = self.houses(session)
        held = world.objects.held_by(robot.session)
        carried = held if held is not None and held in houses else None
        scene = houses.arranged(world, robot.floor, robot.pose, carried)
        if error := load_house(self.controller, scene):
            return error
        self._entered(session)
        there = teleport(robot.pose, robot.pitch, forceAction=True)
        if error := act(self.controller, **there):
            return error
        if carried is None:
            return ""
        return act(self.controller, "PickupObject", objectId=carried, forceAction=True)

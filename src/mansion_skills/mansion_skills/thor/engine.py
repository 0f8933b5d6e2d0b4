"""Skills whose robot is AI2-THOR's agent: done in the world, acted out by the controller, and read back."""

from collections.abc import Callable

from mansion_geometry.thor.controller import Controller, act
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.skills import ObjectArgs, PlaceArgs, SessionArgs
from mansion_msgs_py.world import SkillChange, SkillResult, SkillStatus
from mansion_skills.engine import Engine
from mansion_skills.engine.pace import Pace
from mansion_skills.engine.seat import Seat
from mansion_skills.skills.naming import object_named
from mansion_skills.skills.outcome import invalid, refused
from mansion_skills.skills.registry import Skill
from mansion_skills.thor.actions import Action, actions_for, teleport
from mansion_skills.thor.controller import load_house
from mansion_skills.thor.houses import Houses
from mansion_skills.thor.readback import read_back
from mansion_skills.thor.snapshot import Snapshot

__all__ = ["ThorEngine"]


class ThorEngine(Engine):
    """An engine with one robot, whose body is the agent of a controller.

    Parameters
    ----------
    controller : Controller
    entered : callable
        Told of the seat whose floor AI2-THOR shows from now on.
    force : bool
        Pass ``forceAction`` to what hands do: AI2-THOR then asks neither for sight nor for reach.
    durable : bool
        See `Engine`.
    """

    def __init__(
        self, controller: Controller, entered: Callable[[Seat], None], *, force: bool = False, durable: bool = True
    ) -> None:
        super().__init__(Pace(), durable=durable)
        self.controller = controller
        self._entered = entered
        self.force = force
        self._houses: Houses | None = None

    def houses(self, seat: Seat) -> Houses:
        """Return the houses of a seat's building, read when they are first needed."""
        if self._houses is None:
            self._houses = Houses(seat.world.building)
        return self._houses

    def _perform(self, seat: Seat, skill: Skill, arguments: SessionArgs) -> SkillResult:
        before = Snapshot.of(seat)
        if (lacking := self._lacking(seat, skill, arguments)) is not None:
            return lacking
        result = super()._perform(seat, skill, arguments)
        if not result.changed:
            return result
        error = self._act_out(seat, before, arguments, result)
        if error:
            self._undo(seat, before)
            text = f"AI2-THOR refused: {error}"
            wish = "standing elsewhere, or another object; the message names what was in the way"
            status = SkillStatus.EXECUTION_FAILURE
            result = refused(seat.world, seat.robot, skill.name, status, text, wish)
        result.changed += self.read_back(seat)
        if error and seat.robot.pose != before.pose:
            result.changed.append(SkillChange(what="pose", before=before.pose, after=seat.robot.pose))
        result.state = seat.world.robot_state(seat.robot)
        return result

    def read_back(self, seat: Seat) -> list[SkillChange]:
        """Take over the state of the controller's last event; return what the world had otherwise."""
        return read_back(seat.world, seat.robot, self.controller.last_event.metadata)

    def _undo(self, seat: Seat, before: Snapshot) -> None:
        left = seat.robot.floor != before.floor
        before.restore(seat)
        if left and (error := self.enter(seat)):
            raise MansionError(
                ErrorCode.UNAVAILABLE, f"AI2-THOR shows neither the other floor nor floor {before.floor} again: {error}"
            )

    def _lacking(self, seat: Seat, skill: Skill, arguments: SessionArgs) -> SkillResult | None:
        """Refuse hands' work on what AI2-THOR has no asset for: it is not in its scene."""
        name = arguments.object if isinstance(arguments, ObjectArgs) else None
        name = arguments.target if isinstance(arguments, PlaceArgs) else name
        if skill.name == "GoNearObject" or name in (None, "floor"):
            return None
        state = object_named(seat.world, seat.robot, name)
        if isinstance(state, str) or state.id in self.houses(seat):
            return None
        text = f"AI2-THOR has no asset for {state.id}; it is not in its scene"
        wish = "an object of house.json; metadata.mansion.omitted lists the others"
        return invalid(seat.world, seat.robot, skill.name, text, wish)

    def _act_out(self, seat: Seat, before: Snapshot, arguments: SessionArgs, result: SkillResult) -> str:
        """Do what the world did with the controller; return AI2-THOR's error message, empty when all succeeded."""
        if seat.robot.floor != before.floor:
            return self.enter(seat)
        robot, actions = seat.robot, list[Action]()
        if result.status is SkillStatus.SUCCESS:
            actions = actions_for(seat.world, robot, before.pose, before.pitch, arguments, result, force=self.force)
        elif robot.pose != before.pose:
            actions = [teleport(robot.pose, robot.pitch)]
        for action in actions:
            if error := act(self.controller, **action):
                return error
        return ""

    def enter(self, seat: Seat) -> str:
        """Show AI2-THOR the robot's floor (the four steps of ``update_floor``); return its error message.

        What the robot holds enters the floor's house and is picked up again there.
        """
        world, robot = seat.world, seat.robot
        houses = self.houses(seat)
        held = world.objects.held_by(robot.session)
        carried = held if held is not None and held in houses else None
        scene = houses.arranged(world, robot.floor, robot.pose, carried)
        if error := load_house(self.controller, scene):
            return error
        self._entered(seat)
        there = teleport(robot.pose, robot.pitch, forceAction=True)
        if error := act(self.controller, **there):
            return error
        if carried is None:
            return ""
        return act(self.controller, "PickupObject", objectId=carried, forceAction=True)

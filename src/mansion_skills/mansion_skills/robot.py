"""A robot in a building from a script, without a node graph."""

from pathlib import Path
from typing import Any

from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.codec import convert
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.skills import Landmarks, Route, VisibleObjects, WhereAmI
from mansion_msgs_py.wording import choices
from mansion_msgs_py.world import SkillResult
from mansion_skills.engine import Engine
from mansion_skills.skills.registry import SKILLS, skill_named

__all__ = ["Robot"]


class Robot:
    """The skills of one session, by name or as methods; they return what the services answer.

    Parameters
    ----------
    building : path
        Folder that ``mansion build`` wrote.
    session, world : str
        See `LoadBuilding`.
    reset : bool
        Start over instead of continuing where the session was left.
    engine : Engine, optional
        Share it between robots that are in one building.

    Examples
    --------
    ::

        robot = Robot("out/office")
        robot.go_to_landmark("elevator")
        robot.call_elevator()
        print(robot.use_elevator(3).message)
    """

    def __init__(
        self,
        building: str | Path,
        session: str = "",
        *,
        world: str = "shared",
        reset: bool = False,
        engine: Engine | None = None,
    ) -> None:
        self.engine = engine or Engine()
        self.loaded = self.engine.load(LoadBuilding(path=str(building), session=session, world=world, reset=reset))
        self.session = self.loaded.session

    def skill(self, name: str, **arguments: Any) -> Any:
        """Run a skill by its name, ``PickUp`` or ``pick_up``.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` for a skill that does not exist, ``INVALID_PAYLOAD`` for arguments that it does not have.
        """
        found = skill_named(name)
        if found is None:
            known = choices(name, (skill.name for skill in SKILLS.values()), "skills")
            raise MansionError(ErrorCode.NOT_FOUND, f"there is no skill {name!r}; {known}")
        try:
            payload = convert(found.arguments, {"session": self.session, **arguments})
        except MansionError as error:
            raise error.with_message(f"{found.name}: {error.info.message}") from None
        return self.engine.run(name, payload)

    def _do(self, name: str, **arguments: Any) -> SkillResult:
        result: SkillResult = self.skill(name, **arguments)
        return result

    def call_elevator(self) -> SkillResult:
        """Bring the lift to the robot's floor and open its doors."""
        return self._do("CallElevator")

    def use_elevator(self, target_floor: int | str) -> SkillResult:
        """Ride the called lift."""
        return self._do("UseElevator", target_floor=target_floor)

    def take_stairs(self, direction: str) -> SkillResult:
        """Walk one floor ``Up`` or ``Down``."""
        return self._do("TakeStairs", direction=direction)

    def go_to_landmark(self, landmark: str) -> SkillResult:
        """Go to a room or a core of this floor."""
        return self._do("GoToLandmark", landmark=landmark)

    def move_to(self, x: float, y: float, yaw: float | None = None) -> SkillResult:
        """Go to a point of this floor."""
        return self._do("MoveTo", x=x, y=y, yaw=yaw)

    def go_near_object(self, name: str) -> SkillResult:
        """Go to where an object or a door can be reached."""
        return self._do("GoNearObject", object=name)

    def move_ahead(self, distance: float = 0.25) -> SkillResult:
        """Go straight ahead, or back."""
        return self._do("MoveAhead", distance=distance)

    def rotate(self, degrees: float = 90.0) -> SkillResult:
        """Turn on the spot, counter-clockwise."""
        return self._do("Rotate", degrees=degrees)

    def look_up(self, degrees: float = 30.0) -> SkillResult:
        """Tilt the camera up."""
        return self._do("LookUp", degrees=degrees)

    def look_down(self, degrees: float = 30.0) -> SkillResult:
        """Tilt the camera down."""
        return self._do("LookDown", degrees=degrees)

    def open_door(self, door: str = "") -> SkillResult:
        """Open a door; the nearest one when none is named."""
        return self._do("OpenDoor", door=door)

    def close_door(self, door: str = "") -> SkillResult:
        """Close a door; the nearest one when none is named."""
        return self._do("CloseDoor", door=door)

    def open_object(self, name: str) -> SkillResult:
        """Open an object."""
        return self._do("OpenObject", object=name)

    def close_object(self, name: str) -> SkillResult:
        """Close an object."""
        return self._do("CloseObject", object=name)

    def pick_up(self, name: str) -> SkillResult:
        """Take an object into the hand."""
        return self._do("PickUp", object=name)

    def place(self, target: str, relation: str = "on") -> SkillResult:
        """Put what is held ``on``, ``in`` or ``in_front`` of something; ``floor`` is the floor before the robot."""
        return self._do("Place", target=target, relation=relation)

    def toggle_on(self, name: str) -> SkillResult:
        """Switch an object on."""
        return self._do("ToggleOn", object=name)

    def toggle_off(self, name: str) -> SkillResult:
        """Switch an object off."""
        return self._do("ToggleOff", object=name)

    def where_am_i(self) -> WhereAmI:
        """Say where the robot is and what it holds."""
        answer: WhereAmI = self.skill("WhereAmI")
        return answer

    def list_landmarks(self) -> Landmarks:
        """List the rooms and cores of this floor."""
        answer: Landmarks = self.skill("ListLandmarks")
        return answer

    def list_visible(self, distance: float | None = None) -> VisibleObjects:
        """List what the camera sees, the nearest first."""
        answer: VisibleObjects = self.skill("ListVisible", distance=distance)
        return answer

    def plan_route(self, target: str) -> Route | SkillResult:
        """Plan the way to a room, a core or an object of any floor."""
        answer: Route | SkillResult = self.skill("PlanRoute", target=target)
        return answer

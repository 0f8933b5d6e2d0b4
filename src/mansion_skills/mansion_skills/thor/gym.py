"""`ThorGym`: a robot of a building whose body is AI2-THOR's agent."""

from pathlib import Path
from typing import Any

from mansion_geometry.thor.controller import Controller
from mansion_msgs_py.closing import Closing
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneCore
from mansion_skills.engine.session import Session
from mansion_skills.robot import Robot
from mansion_skills.thor.engine import ThorEngine, open_controller
from mansion_skills.thor.houses import Houses
from mansion_skills.world.floor_view import Landmark

__all__ = ["ThorGym"]


class ThorGym(Robot, Closing):
    """The skills of `Robot`, acted out in AI2-THOR (sections F.1 and E).

    The world checks what a skill needs and plans the way; the controller does it with ``Teleport``, ``MoveAhead``,
    ``PickupObject`` and so on; the pose and the objects' states are read back from ``event.metadata``. What AI2-THOR
    refuses ends with ``EXECUTION_FAILURE`` and its message, and the world is as AI2-THOR has it.

    Parameters
    ----------
    building_dir : path
        Folder that ``mansion build`` wrote; a ``house.json`` that it does not have is made in memory.
    controller : Controller, optional
        One that runs; without it AI2-THOR is started (extra ``thor``) with `parameters`.
    session : str
    reset : bool
        Start over instead of continuing where the session was left.
    force : bool
        Pass ``forceAction`` to what hands do.
    durable : bool
        Sync each save to the disk.
    **parameters
        Parameters of ``ai2thor.controller.Controller``.

    Attributes
    ----------
    landmarks : list of Landmark
        Landmarks of this floor.
    room_graph : dict
        Room or core of this floor to those that a door leads to from it.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` without a building or its houses, ``UNAVAILABLE`` without AI2-THOR.

    Examples
    --------
    ::

        with ThorGym("out/office", width=600, height=600) as robot:
            robot.go_to_landmark("elevator")
            robot.call_elevator()
            print(robot.use_elevator(3).message, robot.last_event.frame.shape)
    """

    landmarks: list[Landmark]
    room_graph: dict[str, list[str]]

    def __init__(
        self,
        building_dir: str | Path,
        controller: Controller | None = None,
        session: str = "",
        *,
        reset: bool = False,
        force: bool = False,
        durable: bool = True,
        **parameters: Any,
    ) -> None:
        own = controller is None
        self.controller = controller if controller is not None else open_controller(**parameters)
        self._thor = ThorEngine(self.controller, self._entered, force=force, durable=durable)
        try:
            super().__init__(building_dir, session, world="thor", reset=reset, engine=self._thor)
            with self._session.turn, self._session.shared.lock:
                self._enter(self._session)
        except BaseException:
            if own:
                self.controller.stop()
            raise

    @property
    def _session(self) -> Session:
        return self._thor.session(self.session)

    @property
    def houses(self) -> Houses:
        """What AI2-THOR has assets for (``id in houses``), and each floor's house as it is now (``arranged``)."""
        return self._thor.houses(self._session)

    @property
    def last_event(self) -> Any:
        """The controller's last event: ``frame``, ``metadata``, ..."""
        return self.controller.last_event

    def update_floor(self, floor_delta: int) -> Any:
        """Take the agent to another floor: the four steps of the UseElevator card.

        1. What is held leaves the house of this floor and enters that of the other.
        2. ``controller.reset(scene=...)`` loads that house.
        3. Landmarks and room graph are made again.
        4. The agent is teleported to the standard pose before the core, facing outward.

        Unlike the skills UseElevator and TakeStairs it asks for no lift and no way to it.

        Parameters
        ----------
        floor_delta : int

        Returns
        -------
        Event
            The controller's last event.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` when no core leads to that floor, ``UNAVAILABLE`` when AI2-THOR cannot show it.
        """
        session = self._session
        with session.turn, session.shared.lock:
            if floor_delta:
                target = session.robot.floor + floor_delta
                core = _core_to(session, target)
                session.world.update_floor(session.robot, floor_delta, core.id)
                self._enter(session)
                session.save()
        return self.last_event

    def _enter(self, session: Session) -> None:
        if error := self._thor.enter(session):
            raise MansionError(
                ErrorCode.UNAVAILABLE,
                f"AI2-THOR does not show floor {session.robot.floor}: {error}",
                details={"floor": session.robot.floor},
            )
        self._thor.read_back(session)

    def _entered(self, session: Session) -> None:
        """Step 3: make the landmarks and the room graph of the robot's floor."""
        view = session.world.view(session.robot.floor)
        self.landmarks = list(view.landmarks)
        names = [room.id for room in view.scene.rooms] + [core.id for core in view.scene.cores]
        graph: dict[str, list[str]] = {name: [] for name in names}
        for door in view.scene.doors:
            ends = [str(name) for name in door.rooms if name in graph]
            if len(ends) == 2 and ends[1] not in graph[ends[0]]:
                graph[ends[0]].append(ends[1])
                graph[ends[1]].append(ends[0])
        self.room_graph = graph

    def close(self) -> None:
        """End the simulator."""
        self.controller.stop()


def _core_to(session: Session, target: int) -> SceneCore:
    """Return the core that leads to a floor: a lift before stairs, then the first by name."""
    floors = session.world.building.floors
    cores = [core for core in session.world.view(session.robot.floor).scene.cores if target in core.floors]
    if not cores or target not in floors:
        raise MansionError(
            ErrorCode.NOT_FOUND,
            f"no core leads from floor {session.robot.floor} to floor {target}; floors are {floors}",
            path="$.floor_delta",
        )
    return min(cores, key=lambda core: (core.type != "elevator", core.id))

"""Sessions, their worlds, and the skills that run in them; safe to call from several threads."""

import secrets
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

from mansion_geometry.robot_body import ROBOT_RADIUS
from mansion_msgs_py.building import LoadBuilding
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.skills import Control, ControlArgs, Loaded, SessionArgs
from mansion_msgs_py.wording import choices
from mansion_msgs_py.world import (
    LiftCall,
    LiftDoor,
    LiftMode,
    LiftRequest,
    LiftRequestType,
    SkillProgress,
    SkillResult,
    SkillStatus,
    WorldEvent,
)
from mansion_skills.engine.loading import forget_world, open_world, seat_robot
from mansion_skills.engine.pace import Pace
from mansion_skills.engine.performing import catch_up, perform
from mansion_skills.engine.seat import Seat, SharedWorld
from mansion_skills.skills.asking import landmark_infos
from mansion_skills.skills.registry import SKILLS, Skill, skill_named
from mansion_skills.world.overlay import check_session, overlay_path

__all__ = ["Engine"]

MOST_WAITING = 8
"""Calls of one session that may wait for their turn."""

Listener = Callable[[Seat, WorldEvent], None]


class Engine:
    """All sessions of a process.

    Parameters
    ----------
    pace : Pace
    radius : float
        Of the robots, metres.
    durable : bool
        Whether each save is synced to the disk.
    changed : callable, optional
        Told of every change, with the session's seat, while the world is locked.
    progress : callable, optional
        Gets `SkillProgress` of running skills.
    """

    def __init__(
        self,
        pace: Pace | None = None,
        *,
        radius: float = ROBOT_RADIUS,
        durable: bool = True,
        changed: Listener | None = None,
        progress: Callable[[SkillProgress], None] | None = None,
    ) -> None:
        self.pace = pace or Pace()
        self._radius = radius
        self._durable = durable
        self._changed = changed or (lambda seat, event: None)
        self._progress = progress or (lambda payload: None)
        self._worlds: dict[tuple[Path, str], SharedWorld] = {}
        self._seats: dict[str, Seat] = {}
        # Taken before a world's lock and never while one is held: looking up a session takes none.
        self._guard = threading.RLock()

    @property
    def seats(self) -> list[Seat]:
        """The sessions that have a building."""
        return list(self._seats.values())

    @property
    def worlds(self) -> list[SharedWorld]:
        """The worlds that are open."""
        return list(self._worlds.values())

    def load(self, arguments: LoadBuilding) -> Loaded:
        """Put a session's robot into a building, where a former run of the session left it.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` when there is no building, ``CONFLICT`` when what was left does not fit it, or when others
            are in a world that is to be reset.
        """
        session = check_session(arguments.session)
        key = (Path(arguments.path).expanduser().resolve(), arguments.world)
        with self._guard:
            others = self._others(session, key)
            if arguments.reset:
                forget_world(key[0], key[1], session, others)
            shared, notes = self._worlds.get(key), list[str]()
            if shared is None or not others:
                shared, notes = open_world(key[0], key[1], self._radius)
                shared.seen = self.pace.now()
            with shared.lock:
                robot = seat_robot(shared.world, session)
            self._leave(session)
            self._worlds[key] = shared
            self._seats[session] = seat = Seat(session, shared, robot, self._durable)
            with shared.lock:
                if others:
                    self._keep_apart(shared)
                return self._loaded(seat, notes)

    def _keep_apart(self, shared: SharedWorld) -> None:
        """Save robots that share a world and have done nothing yet, so that each comes back to its own place."""
        for name, seat in sorted(self._seats.items()):
            if seat.shared is shared and not overlay_path(shared.world.building.path, name).exists():
                seat.save()

    def _others(self, session: str, key: tuple[Path, str]) -> list[str]:
        shared = self._worlds.get(key)
        return [
            name
            for name, seat in sorted(self._seats.items())
            if name != session and shared is not None and seat.shared is shared
        ]

    def _leave(self, session: str) -> None:
        """Take a session out of the world that it was in."""
        seat = self._seats.pop(session, None)
        if seat is None:
            return
        seat.stop.set()
        world = seat.world
        if not any(other.shared is seat.shared for other in self._seats.values()):
            self._worlds = {k: s for k, s in self._worlds.items() if s is not seat.shared}
        elif world.robots.get(session) is seat.robot:
            del world.robots[session]
            world.absent.add(session)

    def _loaded(self, seat: Seat, notes: list[str]) -> Loaded:
        world, building = seat.world, seat.world.building
        return Loaded(
            building_id=building.building_id,
            floors=building.floors,
            labels=[building.label(floor) for floor in building.floors],
            state=world.robot_state(seat.robot),
            landmarks=landmark_infos(world, seat.robot.floor),
            session=seat.session,
            world=world.name,
            notes=notes,
        )

    def seat(self, session: str) -> Seat:
        """Return a session's seat.

        Raises
        ------
        MansionError
            ``NOT_LOADED`` when it has no building.
        """
        name = check_session(session)
        seat = self._seats.get(name)
        if seat is None:
            raise MansionError(ErrorCode.NOT_LOADED, f"session {name!r} has no building; call load_building first")
        return seat

    def run(self, name: str, arguments: SessionArgs) -> Any:
        """Run a skill when its turn comes.

        Parameters
        ----------
        name : str
            ``CallElevator`` or ``call_elevator``.
        arguments : payload
            Of the skill's argument type.

        Returns
        -------
        SkillResult or payload
            The answer itself for a question.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` for a skill that does not exist, ``NOT_LOADED``, or ``CONFLICT`` when someone else drives or
            too many calls wait.
        """
        skill = skill_named(name)
        if skill is None:
            known = choices(name, (entry.name for entry in SKILLS.values()), "skills")
            raise MansionError(ErrorCode.NOT_FOUND, f"there is no skill {name!r}; {known}")
        seat = self.seat(arguments.session)
        if skill.question:
            with seat.shared.lock:
                return skill.call(seat.world, seat.robot, arguments)
        seat.check(arguments.token)
        if seat.turn.waiting >= MOST_WAITING:
            raise MansionError(
                ErrorCode.CONFLICT, f"{MOST_WAITING} calls of session {seat.session!r} wait already; try again later"
            )
        with seat.turn, seat.shared.lock:
            seat.check(arguments.token)
            return self._run(seat, skill, arguments)

    def _run(self, seat: Seat, skill: Skill, arguments: SessionArgs) -> SkillResult:
        result = self._perform(seat, skill, arguments)
        if result.changed:
            seat.save()
            self._changed(seat, self._event(seat, result))
        return result

    def _perform(self, seat: Seat, skill: Skill, arguments: SessionArgs) -> SkillResult:
        """Run a skill in the world; an engine whose robots have a body elsewhere moves that too."""
        return perform(seat, skill, arguments, self.pace, self._progress)

    @staticmethod
    def _event(seat: Seat, result: SkillResult) -> WorldEvent:
        world = seat.world
        return WorldEvent(
            step=world.step,
            time=world.time,
            session=seat.session,
            skill=result.skill,
            changed=result.changed,
            building_id=world.building.building_id,
            world=world.name,
        )

    def cancel(self, arguments: SessionArgs) -> SkillResult:
        """End a session's running skill and let go of its lifts."""
        seat = self.seat(arguments.session)
        seat.check(arguments.token)
        running = seat.turn.held
        seat.stop.set()
        with seat.shared.lock:
            released = [lift.name for lift in seat.world.lifts.values() if lift.release(seat.session)]
            seat.robot.call = None
            state = seat.world.robot_state(seat.robot)
        text = "the running skill is told to end" if running else "no skill is running"
        return SkillResult(
            skill="Cancel",
            status=SkillStatus.SUCCESS,
            message=text,
            data={"running": running, "lifts": released},
            state=state,
            session=seat.session,
        )

    def take_control(self, arguments: ControlArgs) -> Control:
        """Make the caller the only driver of a session."""
        seat = self.seat(arguments.session)
        with self._guard:
            if not arguments.force:
                seat.check(arguments.token)
            seat.token, seat.driver = secrets.token_hex(8), arguments.client
            return Control(session=seat.session, token=seat.token, client=seat.driver)

    def release_control(self, arguments: ControlArgs) -> Control:
        """Let every client drive the session again."""
        seat = self.seat(arguments.session)
        with self._guard:
            if not arguments.force:
                seat.check(arguments.token)
            seat.token, seat.driver = "", ""
            return Control(session=seat.session, token="")

    def request_lift(self, request: LiftRequest) -> None:
        """Do what a lift request of Open-RMF asks.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` for a lift or a floor that no open world has.
        """
        found = False
        for shared in self.worlds:
            with shared.lock:
                world = shared.world
                lift = world.lifts.get(request.lift_name)
                if lift is None:
                    continue
                found = True
                if request.request_type is LiftRequestType.END_SESSION:
                    lift.release(request.session_id)
                else:
                    floor = world.building.floor_number(request.destination_floor)
                    if floor not in lift.elevations:
                        raise MansionError(
                            ErrorCode.NOT_FOUND,
                            f"{lift.name} does not serve floor {request.destination_floor!r}",
                            path="$.destination_floor",
                        )
                    human = request.request_type is LiftRequestType.HUMAN_MODE
                    mode = LiftMode.HUMAN if human else LiftMode.AGV
                    door = LiftDoor(request.door_state)
                    lift.call(LiftCall(session=request.session_id, floor=floor, door=door, mode=mode))
                if not self.pace.realtime:
                    world.advance(lift.seconds_to_rest())
        if not found:
            raise MansionError(
                ErrorCode.NOT_FOUND, f"no open building has a lift {request.lift_name!r}", path="$.lift_name"
            )

    def tick(self) -> None:
        """Bring the worlds' clocks up to the pace's, when motion takes its time."""
        for shared in self.worlds:
            with shared.lock:
                catch_up(shared, self.pace)

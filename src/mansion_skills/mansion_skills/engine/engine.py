"""Sessions, their worlds, and the skills that run in them; safe to call from several threads."""

import secrets
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

from mansion_geometry.robot_body import ROBOT_RADIUS
from mansion_msgs_py.allowed_folders import EVERYWHERE, AllowedFolders
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
from mansion_skills.engine.executor import WorldClock, catch_up, perform
from mansion_skills.engine.session import Session, SharedWorld
from mansion_skills.skills.declaration import Skill
from mansion_skills.skills.queries import landmark_infos
from mansion_skills.skills.registry import SKILLS, skill_named
from mansion_skills.world.building import LoadedBuilding
from mansion_skills.world.overlay import (
    check_session,
    forget_overlay,
    load_overlay,
    overlay_path,
    remove_overlay_remains,
    restore_robot,
    restore_shared,
    world_overlays,
)
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["Engine"]

MOST_SESSIONS = 64
"""Robots of one process."""

MOST_WAITING = 8
"""Most calls of one session that may wait."""

Listener = Callable[[Session, WorldEvent], None]


def _open_world(path: Path, name: str, radius: float) -> tuple[SharedWorld, list[str]]:
    """Read a building and restore its world; also return what could not be restored."""
    world = World(LoadedBuilding(path), name, radius)
    notes = restore_shared(world)
    return SharedWorld(world), notes


def _restored_robot(world: World, session: str) -> RobotBody:
    """Put a session's robot into a world, where its overlay says."""
    robot = world.add_robot(session)
    saved = load_overlay(overlay_path(world.building.path, session))
    if saved is not None and saved.world == world.name:
        restore_robot(world, saved, robot)
    return robot


def _forget_world(path: Path, name: str, session: str, others: list[str]) -> None:
    """Remove the overlays of all sessions of a world.

    Raises
    ------
    MansionError
        ``CONFLICT`` while other sessions are in it.
    """
    if others:
        raise MansionError(
            ErrorCode.CONFLICT,
            f"sessions {', '.join(others)} are in the world {name!r} too; load a world of another name",
            path="$.reset",
        )
    for file in sorted((path / "state").glob("*/world.json")):
        try:
            shared = any(state.session == file.parent.name for state in world_overlays(path, name))
        except MansionError:
            shared = file.parent.name == session
        if shared or file.parent.name == session:
            forget_overlay(file)


class Engine:
    """All sessions of a process.

    Parameters
    ----------
    clock : WorldClock
    radius : float
        Robots' radius, metres.
    durable : bool
        Whether each save is synced to the disk.
    allowed : AllowedFolders
        Where this process may write; in a building elsewhere robots stay where they are, and questions are answered.
    changed : callable, optional
        Told of every change, with the session, while the world is locked.
    progress : callable, optional
        Gets `SkillProgress` of running skills.
    """

    def __init__(
        self,
        clock: WorldClock | None = None,
        *,
        radius: float = ROBOT_RADIUS,
        durable: bool = True,
        allowed: AllowedFolders = EVERYWHERE,
        changed: Listener | None = None,
        progress: Callable[[SkillProgress], None] | None = None,
    ) -> None:
        self.clock = clock or WorldClock()
        self._radius = radius
        self._durable = durable
        self._allowed = allowed
        self._changed = changed or (lambda session, event: None)
        self._progress = progress or (lambda payload: None)
        self._worlds: dict[tuple[Path, str], SharedWorld] = {}
        self._sessions: dict[str, Session] = {}
        # Taken before a world's lock and never while one is held: looking up a session takes none.
        self._guard = threading.RLock()

    @property
    def sessions(self) -> list[Session]:
        """The sessions that have a building."""
        return list(self._sessions.values())

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
            are in a world that is to be reset, ``FORBIDDEN`` to reset one that this process may not write.
        """
        name = check_session(arguments.session)
        key = (Path(arguments.path).expanduser().resolve(), arguments.world)
        with self._guard:
            self._refuse_one_more(name)
            others = self._others(name, key)
            if arguments.reset:
                self._allowed.check(key[0], "$.path")
                _forget_world(key[0], key[1], name, others)
            shared, notes = self._worlds.get(key), list[str]()
            if shared is None or not others:
                shared, notes = _open_world(key[0], key[1], self._radius)
                shared.synced = self.clock.now()
                shared.writable = self._allowed.allows(key[0])
            with shared.lock:
                robot = _restored_robot(shared.world, name)
            if shared.writable:
                remove_overlay_remains(key[0], name)
            self._leave(name)
            self._worlds[key] = shared
            self._sessions[name] = session = Session(name, shared, robot, self._durable)
            with shared.lock:
                if others:
                    self._keep_apart(shared)
                return self._loaded(session, notes)

    def _refuse_one_more(self, name: str) -> None:
        if name not in self._sessions and len(self._sessions) >= MOST_SESSIONS:
            raise MansionError(
                ErrorCode.CONFLICT,
                f"{MOST_SESSIONS} sessions are open; load a building in one of them, or start another skill server",
                path="$.session",
            )

    def _keep_apart(self, shared: SharedWorld) -> None:
        """Save the robots of a shared world that were never saved, so that each is restored to its own pose."""
        if not shared.writable:
            return
        for name, session in sorted(self._sessions.items()):
            if session.shared is shared and not overlay_path(shared.world.building.path, name).exists():
                session.save()

    def _others(self, own: str, key: tuple[Path, str]) -> list[str]:
        shared = self._worlds.get(key)
        return [
            name
            for name, session in sorted(self._sessions.items())
            if name != own and shared is not None and session.shared is shared
        ]

    def _leave(self, name: str) -> None:
        """Take a session out of the world that it was in."""
        session = self._sessions.pop(name, None)
        if session is None:
            return
        session.stop.set()
        world = session.world
        if not any(other.shared is session.shared for other in self._sessions.values()):
            self._worlds = {k: s for k, s in self._worlds.items() if s is not session.shared}
        elif world.robots.get(name) is session.robot:
            del world.robots[name]
            world.absent.add(name)

    def _loaded(self, session: Session, notes: list[str]) -> Loaded:
        world, building = session.world, session.world.building
        return Loaded(
            building_id=building.building_id,
            floors=building.floors,
            labels=[building.label(floor) for floor in building.floors],
            state=world.robot_state(session.robot),
            landmarks=landmark_infos(world, session.robot.floor),
            session=session.name,
            world=world.name,
            notes=notes,
        )

    def session(self, name: str) -> Session:
        """Return a session by its name, the default one for an empty name.

        Raises
        ------
        MansionError
            ``NOT_LOADED`` when it has no building.
        """
        name = check_session(name)
        session = self._sessions.get(name)
        if session is None:
            raise MansionError(ErrorCode.NOT_LOADED, f"session {name!r} has no building; call load_building first")
        return session

    def run(self, name: str, arguments: SessionArgs) -> Any:
        """Run a skill once the calls before it have ended.

        Parameters
        ----------
        name : str
            ``CallElevator`` or ``call_elevator``.
        arguments : payload
            Arguments of the skill's type.

        Returns
        -------
        SkillResult or payload
            The answer itself for a query.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` for a skill that does not exist, ``NOT_LOADED``, ``CONFLICT`` when someone else drives or
            too many calls wait, or ``FORBIDDEN`` where what a skill changes may not be saved.
        """
        skill = skill_named(name)
        if skill is None:
            known = choices(name, (entry.name for entry in SKILLS.values()), "skills")
            raise MansionError(ErrorCode.NOT_FOUND, f"there is no skill {name!r}; {known}")
        session = self.session(arguments.session)
        if skill.query:
            with session.shared.lock:
                return skill.call(session.world, session.robot, arguments)
        if not session.shared.writable:
            self._allowed.check(session.world.building.path)
        session.check(arguments.token)
        if session.turn.waiting >= MOST_WAITING:
            raise MansionError(
                ErrorCode.CONFLICT,
                f"{MOST_WAITING} calls of session {session.name!r} are already waiting; try again later",
            )
        with session.turn, session.shared.lock:
            session.check(arguments.token)
            return self._run(session, skill, arguments)

    def _run(self, session: Session, skill: Skill, arguments: SessionArgs) -> SkillResult:
        result = self._perform(session, skill, arguments)
        if result.changed:
            session.save()
            self._changed(session, self._event(session, result))
        return result

    def _perform(self, session: Session, skill: Skill, arguments: SessionArgs) -> SkillResult:
        """Run a skill in the world; subclasses with a robot elsewhere move that too."""
        return perform(session, skill, arguments, self.clock, self._progress)

    @staticmethod
    def _event(session: Session, result: SkillResult) -> WorldEvent:
        world = session.world
        return WorldEvent(
            step=world.step,
            time=world.time,
            session=session.name,
            skill=result.skill,
            changed=result.changed,
            building_id=world.building.building_id,
            world=world.name,
        )

    def cancel(self, arguments: SessionArgs) -> SkillResult:
        """End a session's running skill and let go of its lifts."""
        session = self.session(arguments.session)
        session.check(arguments.token)
        running = session.turn.held
        session.stop.set()
        with session.shared.lock:
            released = [lift.name for lift in session.world.lifts.values() if lift.release(session.name)]
            session.robot.call = None
            state = session.world.robot_state(session.robot)
        text = "the running skill was asked to stop" if running else "no skill is running"
        return SkillResult(
            skill="Cancel",
            status=SkillStatus.SUCCESS,
            message=text,
            data={"running": running, "lifts": released},
            state=state,
            session=session.name,
        )

    def take_control(self, arguments: ControlArgs) -> Control:
        """Make the caller the only driver of a session."""
        session = self.session(arguments.session)
        with self._guard:
            if not arguments.force:
                session.check(arguments.token)
            session.token, session.driver = secrets.token_hex(8), arguments.client
            return Control(session=session.name, token=session.token, client=session.driver)

    def release_control(self, arguments: ControlArgs) -> Control:
        """Let every client drive the session again."""
        session = self.session(arguments.session)
        with self._guard:
            if not arguments.force:
                session.check(arguments.token)
            session.token, session.driver = "", ""
            return Control(session=session.name, token="")

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
                if not self.clock.realtime:
                    world.advance(lift.seconds_to_rest())
        if not found:
            raise MansionError(
                ErrorCode.NOT_FOUND, f"no open building has a lift {request.lift_name!r}", path="$.lift_name"
            )

    def tick(self) -> None:
        """Bring the worlds' clocks up to the clock's, when motion takes its time."""
        for shared in self.worlds:
            with shared.lock:
                catch_up(shared, self.clock)

"""A session: its robot, the world that it shares, who controls it, and the fair lock of the world."""

import threading
from collections import deque
from dataclasses import dataclass, field
from types import TracebackType

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_skills.engine.motion import MotionSegment, MotionState
from mansion_skills.world.overlay import overlay_path, save_overlay
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["FairLock", "Session", "SharedWorld"]


class FairLock:
    """A lock that serves waiting threads first come, first served; a context manager.

    Attributes
    ----------
    waiting : int
        Number of threads that wait.
    """

    def __init__(self) -> None:
        self._guard = threading.Lock()
        self._queue: deque[threading.Event] = deque()
        self._held = False

    @property
    def waiting(self) -> int:
        """Number of threads that wait."""
        return len(self._queue)

    @property
    def held(self) -> bool:
        """Whether a thread has it."""
        return self._held

    def acquire(self) -> None:
        """Wait for all who came before, then take the lock."""
        with self._guard:
            if not self._held:
                self._held = True
                return
            turn = threading.Event()
            self._queue.append(turn)
        turn.wait()

    def release(self) -> None:
        """Hand the lock to the next in the queue."""
        with self._guard:
            if self._queue:
                self._queue.popleft().set()
            else:
                self._held = False

    def __enter__(self) -> "FairLock":
        self.acquire()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self.release()


@dataclass
class SharedWorld:
    """A world and the lock under which it is read and changed.

    Attributes
    ----------
    synced : float
        Reading of the clock to which the world's time was last brought, seconds.
    writable : bool
        Whether what happens may be saved; if not, robots stay where they are.
    """

    world: World
    lock: FairLock = field(default_factory=FairLock)
    synced: float = 0.0
    writable: bool = True


@dataclass
class Session:
    """One session.

    Attributes
    ----------
    turn : FairLock
        Held by the call whose skill runs.
    stop : threading.Event
        Set to end the running skill.
    segment : MotionSegment, optional
        What the robot drives now, in real time.
    token : str
        What calls need while someone has taken control; empty when all may drive.
    """

    name: str
    shared: SharedWorld
    robot: RobotBody
    durable: bool
    turn: FairLock = field(default_factory=FairLock)
    stop: threading.Event = field(default_factory=threading.Event)
    segment: MotionSegment | None = None
    token: str = ""
    driver: str = ""

    @property
    def world(self) -> World:
        """The world that the session shares."""
        return self.shared.world

    def motion(self, now: float) -> MotionState:
        """Return where the robot is at a time of the wall clock, between two steps of its skill too."""
        if self.segment is not None:
            return self.segment.at(now)
        return MotionState(self.robot.pose, self.robot.odometry)

    def check(self, token: str) -> None:
        """Refuse a call that does not come from the driver.

        Raises
        ------
        MansionError
            ``CONFLICT``.
        """
        if self.token and token != self.token:
            raise MansionError(
                ErrorCode.CONFLICT,
                f"session {self.name!r} is driven by {self.driver or 'another client'}; pass its token, wait for "
                "skills/release_control, or skills/take_control with force",
                path="$.token",
                details={"session": self.name, "driver": self.driver},
            )

    def save(self) -> None:
        """Count a step and write the session's overlay."""
        self.world.step += 1
        path = overlay_path(self.world.building.path, self.name)
        save_overlay(path, self.world.state(self.robot), durable=self.durable)

"""A session at work: its robot, the world that it shares, and who drives."""

import threading
from dataclasses import dataclass, field

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_skills.engine.fair_lock import FairLock
from mansion_skills.engine.motion_segment import MotionSegment, MotionState
from mansion_skills.world.overlay import overlay_path, save_overlay
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["Seat", "SharedWorld"]


@dataclass
class SharedWorld:
    """A world and the lock that whoever reads or changes it holds.

    Attributes
    ----------
    seen : float
        The pace's clock when the world's clock was last brought up to it.
    """

    world: World
    lock: FairLock = field(default_factory=FairLock)
    seen: float = 0.0


@dataclass
class Seat:
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

    session: str
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
        """Return where the robot is at a time of the wall's clock, between two steps of its skill too."""
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
                f"session {self.session!r} is driven by {self.driver or 'another client'}; pass its token, wait for "
                "skills/release_control, or skills/take_control with force",
                path="$.token",
                details={"session": self.session, "driver": self.driver},
            )

    def save(self) -> None:
        """Count a step and write the session's overlay."""
        self.world.step += 1
        path = overlay_path(self.world.building.path, self.session)
        save_overlay(path, self.world.state(self.robot), durable=self.durable)

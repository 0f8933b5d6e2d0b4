"""A robot's motion between the steps of a skill and under velocity commands."""

import threading
from dataclasses import dataclass, field
from math import cos, degrees, hypot, isfinite, radians, sin
from typing import TYPE_CHECKING

from mansion_msgs_py.world import Pose2D
from mansion_skills.world.robot_body import turn_between

if TYPE_CHECKING:
    from mansion_skills.engine.session import Session

__all__ = ["VelocityCommand", "MotionSegment", "MotionState", "drive_for"]

STALE = 0.5
"""Age at which a command expires, seconds."""

TOP_SPEED = 1.0

TOP_TURN = 2.0
"""Limits of the base, metres and radians a second."""

STRIDE = 0.02
"""Distance in metres, or angle in radians, between two collision checks."""


@dataclass(frozen=True)
class MotionState:
    """Where a robot is and how fast it moves.

    Attributes
    ----------
    pose, odometry : Pose2D
        Pose in the floor's frame and by the wheels.
    forward, turning : float
        Speeds, metres and radians a second.
    """

    pose: Pose2D
    odometry: Pose2D
    forward: float = 0.0
    turning: float = 0.0


@dataclass(frozen=True)
class MotionSegment:
    """Motion at constant velocity between two steps of a skill.

    Attributes
    ----------
    begin, seconds : float
        Begin on the wall clock, and duration; seconds.
    """

    start: MotionState
    end: MotionState
    begin: float
    seconds: float

    def at(self, now: float) -> MotionState:
        """Return the state at a time of the wall clock; the end from then on.

        Examples
        --------
        >>> start = MotionState(Pose2D(x=0.0, y=0.0), Pose2D(x=0.0, y=0.0))
        >>> end = MotionState(Pose2D(x=1.0, y=0.0), Pose2D(x=1.0, y=0.0))
        >>> half = MotionSegment(start, end, 10.0, 2.0).at(11.0)
        >>> half.pose.x, half.forward
        (0.5, 0.5)
        """
        if self.seconds <= 0.0 or now >= self.begin + self.seconds:
            return self.end
        part = max(0.0, now - self.begin) / self.seconds
        a, b = self.start.odometry, self.end.odometry
        heading = radians(a.yaw)
        ahead = (b.x - a.x) * cos(heading) + (b.y - a.y) * sin(heading)
        length = hypot(b.x - a.x, b.y - a.y)
        return MotionState(
            pose=_between(self.start.pose, self.end.pose, part),
            odometry=_between(a, b, part),
            forward=(length if ahead >= 0 else -length) / self.seconds,
            turning=radians(turn_between(a.yaw, b.yaw)) / self.seconds,
        )


def _between(a: Pose2D, b: Pose2D, part: float) -> Pose2D:
    return Pose2D(
        x=a.x + part * (b.x - a.x), y=a.y + part * (b.y - a.y), yaw=(a.yaw + part * turn_between(a.yaw, b.yaw)) % 360.0
    )


@dataclass
class VelocityCommand:
    """The last velocity command and what the base does now.

    Attributes
    ----------
    forward, turning : float
        Speeds of the last stretch, metres and radians a second; 0 when the robot stands or is blocked.
    moved : bool
        Whether the robot has moved since it was last saved.
    """

    forward: float = 0.0
    turning: float = 0.0
    moved: bool = False
    _wanted: tuple[float, float] = (0.0, 0.0)
    _until: float = 0.0
    _guard: threading.Lock = field(default_factory=threading.Lock)

    def command(self, forward: float, turning: float, now: float) -> None:
        """Take a command; speeds are clipped to the base's limits, and a speed that is not finite stops it."""
        finite = isfinite(forward) and isfinite(turning)
        with self._guard:
            self._wanted = (
                (max(-TOP_SPEED, min(TOP_SPEED, forward)), max(-TOP_TURN, min(TOP_TURN, turning)))
                if finite
                else (0.0, 0.0)
            )
            self._until = now + STALE

    def stop(self) -> None:
        """Drop the last command and stop."""
        with self._guard:
            self._wanted, self._until = (0.0, 0.0), 0.0
        self.forward = self.turning = 0.0
        self.moved = False

    def wanted(self, now: float) -> tuple[float, float]:
        """Return the speeds that are commanded now."""
        with self._guard:
            return self._wanted if now < self._until else (0.0, 0.0)


def drive_for(session: "Session", drive: VelocityCommand, seconds: float, now: float) -> bool:
    """Move a robot as commanded; an obstacle stops it, but not its turning.

    Returns
    -------
    bool
        Whether it moved.
    """
    forward, turning = drive.wanted(now)
    robot = session.robot
    drive.forward, drive.turning = 0.0, turning
    if (forward == 0.0 and turning == 0.0) or session.turn.held or not session.shared.writable:
        drive.turning = 0.0
        return False
    count = max(1, int(max(abs(forward), abs(turning)) * seconds / STRIDE) + 1)
    part = seconds / count
    blocked = session.world.blocked_for(robot.session, robot.floor) if forward else None
    frame = session.world.view(robot.floor).map.frame
    for _ in range(count):
        yaw = radians(robot.pose.yaw) + turning * part / 2
        x, y = robot.pose.x, robot.pose.y
        if blocked is not None:
            there = (x + forward * part * cos(yaw), y + forward * part * sin(yaw))
            here, after = frame.cell(x, y), frame.cell(*there)
            if not blocked[after] or blocked[here]:
                (x, y), drive.forward = there, forward
        yaw_after = (robot.pose.yaw + degrees(turning * part)) % 360.0
        robot.move(Pose2D(x=x, y=y, yaw=yaw_after))
    drive.moved = True
    return True

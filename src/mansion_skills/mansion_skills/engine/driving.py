"""Drive commands: a forward and a turning speed, kept up until they are old, with real collisions."""

import threading
from dataclasses import dataclass, field
from math import cos, degrees, isfinite, radians, sin

from mansion_msgs_py.world import Pose2D
from mansion_skills.engine.seat import Seat

__all__ = ["Drive", "drive_for"]

STALE = 0.5
"""Seconds after which a command no longer counts."""

TOP_SPEED = 1.0
TOP_TURN = 2.0
"""Limits of the base, metres and radians a second."""

STRIDE = 0.02
"""Metres, or a fiftieth of a radian, between two looks at the map."""


@dataclass
class Drive:
    """The last command and what the base does now.

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
        """Take a command; speeds are cut to what the base can do, and what is no number stops it."""
        finite = isfinite(forward) and isfinite(turning)
        with self._guard:
            self._wanted = (
                (max(-TOP_SPEED, min(TOP_SPEED, forward)), max(-TOP_TURN, min(TOP_TURN, turning)))
                if finite
                else (0.0, 0.0)
            )
            self._until = now + STALE

    def stop(self) -> None:
        """Forget the last command, and stand still."""
        with self._guard:
            self._wanted, self._until = (0.0, 0.0), 0.0
        self.forward = self.turning = 0.0
        self.moved = False

    def wanted(self, now: float) -> tuple[float, float]:
        """Return the speeds that count now."""
        with self._guard:
            return self._wanted if now < self._until else (0.0, 0.0)


def drive_for(seat: Seat, drive: Drive, seconds: float, now: float) -> bool:
    """Move a robot as it is commanded; it stops at what is in its way, and still turns.

    Returns
    -------
    bool
        Whether it moved.
    """
    forward, turning = drive.wanted(now)
    robot = seat.robot
    drive.forward, drive.turning = 0.0, turning
    if (forward == 0.0 and turning == 0.0) or seat.turn.held:
        drive.turning = 0.0
        return False
    count = max(1, int(max(abs(forward), abs(turning)) * seconds / STRIDE) + 1)
    part = seconds / count
    blocked = seat.world.blocked_for(robot.session, robot.floor) if forward else None
    frame = seat.world.view(robot.floor).map.frame
    for _ in range(count):
        yaw = radians(robot.pose.yaw) + turning * part / 2
        x, y = robot.pose.x, robot.pose.y
        if blocked is not None:
            there = (x + forward * part * cos(yaw), y + forward * part * sin(yaw))
            here, after = frame.cell(x, y), frame.cell(*there)
            if not blocked[after] or blocked[here]:
                (x, y), drive.forward = there, forward
        turned = (robot.pose.yaw + degrees(turning * part)) % 360.0
        robot.move(Pose2D(x=x, y=y, yaw=turned))
    drive.moved = True
    return True

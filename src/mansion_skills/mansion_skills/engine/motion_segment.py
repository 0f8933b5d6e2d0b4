"""The robot's motion between two steps of a skill, interpolated for publishers that run faster than skills step."""

from dataclasses import dataclass
from math import cos, hypot, radians, sin

from mansion_msgs_py.world import Pose2D
from mansion_skills.world.robot_body import turn_between

__all__ = ["MotionState", "MotionSegment"]


@dataclass(frozen=True)
class MotionState:
    """Where a robot is and how fast it moves.

    Attributes
    ----------
    pose, odometry : Pose2D
        In the floor's frame, and as the wheels count it.
    forward, turning : float
        Metres and radians a second.
    """

    pose: Pose2D
    odometry: Pose2D
    forward: float = 0.0
    turning: float = 0.0


@dataclass(frozen=True)
class MotionSegment:
    """Motion at even speed between two steps of a skill.

    Attributes
    ----------
    begin, seconds : float
        On the wall's clock.
    """

    start: MotionState
    end: MotionState
    begin: float
    seconds: float

    def at(self, now: float) -> MotionState:
        """Return where the robot is at a time; at its end from then on, where it stands.

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

"""A robot's body: where it stands, how it looks, and its odometry."""

from dataclasses import dataclass, field
from math import atan2, cos, degrees, hypot, radians, sin

from mansion_msgs_py.shapes import Point
from mansion_msgs_py.world import Pose2D

__all__ = ["RobotBody", "turn_between"]


def turn_between(start: float, end: float) -> float:
    """Return the shorter turn between two directions, degrees in (-180, 180]."""
    turn = (end - start) % 360.0
    return turn - 360.0 if turn > 180.0 else turn


@dataclass
class RobotBody:
    """One session's robot.

    Attributes
    ----------
    pose : Pose2D
        Pose in the floor's frame.
    pitch : float
        Pitch of the camera, degrees, up is positive.
    odometry : Pose2D
        Pose by the wheels, from (0, 0, 0), without rides and stairs.
    driven : float
        Metres driven so far, without rides and stairs.
    path : list of Point
        Path of its last motion.
    call : str, optional
        The lift that it called and has not used yet.
    """

    session: str
    floor: int
    pose: Pose2D
    radius: float
    pitch: float = 0.0
    odometry: Pose2D = field(default_factory=lambda: Pose2D(x=0.0, y=0.0))
    driven: float = 0.0
    path: list[Point] = field(default_factory=list)
    call: str | None = None

    @property
    def place(self) -> Point:
        """Where it stands."""
        return self.pose.x, self.pose.y

    def move(self, pose: Pose2D) -> None:
        """Move to another pose of the floor and update the odometry."""
        turn = radians(self.odometry.yaw - self.pose.yaw)
        dx, dy = pose.x - self.pose.x, pose.y - self.pose.y
        self.odometry = Pose2D(
            x=self.odometry.x + cos(turn) * dx - sin(turn) * dy,
            y=self.odometry.y + sin(turn) * dx + cos(turn) * dy,
            yaw=(self.odometry.yaw + pose.yaw - self.pose.yaw) % 360.0,
        )
        self.driven += hypot(dx, dy)
        self.pose = pose

    def bearing(self, point: Point) -> float:
        """Return the direction of a point from the robot's front, degrees in (-180, 180], left is positive."""
        toward = degrees(atan2(point[1] - self.pose.y, point[0] - self.pose.x))
        return turn_between(self.pose.yaw, toward)

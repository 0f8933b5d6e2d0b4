"""The way that a robot went on the floor where it is, from place to place along what its navigation planned."""

from mansion_msgs_py.shapes import Point
from mansion_skills.world.robot_body import RobotBody

__all__ = ["Trail"]


class Trail:
    """The corners of a robot's way on its present floor, extended after each skill.

    Attributes
    ----------
    points : list of Point
        The present place last; another floor begins anew.
    """

    def __init__(self) -> None:
        self.points: list[Point] = []
        self._floor: int | None = None
        self._path: list[Point] = []

    def follow(self, robot: RobotBody) -> None:
        """Add what a skill drove since the last call; the robot keeps the path of its last motion."""
        if robot.floor != self._floor:
            self._floor, self.points = robot.floor, []
        elif robot.path is not self._path and robot.path[-1:] == [robot.place]:
            begin = 1 if robot.path[0] == self.points[-1] else 0
            self.points += robot.path[begin:-1]
        self._path = robot.path
        if not self.points or self.points[-1] != robot.place:
            self.points.append(robot.place)

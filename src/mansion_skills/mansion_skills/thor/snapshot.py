"""The world before a skill, for one that AI2-THOR refuses afterwards."""

from dataclasses import dataclass

from mansion_msgs_py.world import ObjectState, Pose2D
from mansion_skills.engine.seat import Seat

__all__ = ["Snapshot"]


@dataclass(frozen=True)
class Snapshot:
    """A robot, the objects and the doors at one moment; lifts and the clock go on."""

    floor: int
    pose: Pose2D
    pitch: float
    objects: dict[str, ObjectState]
    doors: dict[str, bool]

    @staticmethod
    def of(seat: Seat) -> "Snapshot":
        """Take one."""
        robot, world = seat.robot, seat.world
        return Snapshot(robot.floor, robot.pose, robot.pitch, dict(world.objects.changed), dict(world.doors))

    def restore(self, seat: Seat) -> None:
        """Put the world back."""
        robot, world = seat.robot, seat.world
        floors = {robot.floor, self.floor}
        if robot.floor == self.floor:
            robot.move(self.pose)
        else:
            robot.floor, robot.pose, robot.path = self.floor, self.pose, []
        robot.pitch = self.pitch
        now = world.objects.changed
        for name in sorted({*now, *self.objects}):
            if now.get(name) != self.objects.get(name):
                world.objects.put(self.objects.get(name) or world.objects.first(name))
        world.objects.commit()
        world.doors = dict(self.doors)
        for floor in sorted(floors):
            world.refresh(floor)

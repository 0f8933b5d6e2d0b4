"""A world kept like one in another process, from the overlay that is saved there after each skill."""

from pathlib import Path

from mansion_msgs_py.codec import decode
from mansion_msgs_py.world import LiftDoor, LiftState, WorldState
from mansion_skills.world.building import LoadedBuilding
from mansion_skills.world.overlay import overlay_path, restore_robot
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World
from mansion_tasks.episodes.stand_in import SESSION, WORLD

__all__ = ["Mirror"]


class Mirror:
    """The world of a stand-in folder whose robot somebody else drives.

    Parameters
    ----------
    folder : Path

    Attributes
    ----------
    world : World
    robot : RobotBody
        Both the same objects for as long as the mirror lives.
    """

    def __init__(self, folder: Path) -> None:
        self._file = overlay_path(folder, SESSION)
        self.world = World(LoadedBuilding(folder), WORLD)
        self.robot: RobotBody = self.world.add_robot(SESSION)
        self._first = {name: self.world.objects.state(name) for name in self.world.objects}
        self._last = b""
        self._closing: dict[str, float] = {}
        self.follow()

    def follow(self) -> None:
        """Bring the world up to what was saved last."""
        try:
            data = self._file.read_bytes()
        except FileNotFoundError:
            return
        if data == self._last:
            return
        self._last, world = data, self.world
        saved = decode(WorldState, data)
        moved = {state.id: state for state in saved.objects}
        if moved != world.objects.changed or saved.doors != world.doors:
            for name in [name for name in world.objects.changed if name not in moved]:
                world.objects.put(self._first[name])
            for state in saved.objects:
                world.objects.put(state)
            world.objects.commit()
            world.doors.clear()
            world.doors.update(saved.doors)
            world.reload()
        for entry in saved.lifts:
            self._follow_lift(entry, saved)
        world.time, world.step = saved.time, saved.step
        self.robot.call = None
        restore_robot(world, saved, self.robot)

    def _follow_lift(self, entry: LiftState, saved: WorldState) -> None:
        """Restore a lift; doors that were let go are as far closed as their time allows, which no overlay says."""
        name, lift = entry.lift_name, self.world.lifts[entry.lift_name]
        lift.restore(entry, saved.queues.get(name, []))
        if entry.door_state is not LiftDoor.MOVING:
            self._closing.pop(name, None)
            return
        lift.opening = 1.0
        since = self._closing.setdefault(name, saved.time)
        for _ in lift.advance(saved.time - since, since, saved.building_id):
            continue

"""The temporary building folder of an episode, and a replica of the world that another process saves in it."""

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from mansion_msgs_py.codec import decode
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.task import TaskStart
from mansion_msgs_py.world import LiftDoor, LiftState, RobotState, WorldState
from mansion_skills.world.building import LoadedBuilding
from mansion_skills.world.overlay import overlay_path, restore_robot, save_overlay
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["SESSION", "WORLD", "WorldReplica", "episode_folder"]

SESSION = "episode"
WORLD = "episode"


@contextmanager
def episode_folder(building: Path, start: TaskStart | None = None) -> Iterator[Path]:
    """Yield a temporary folder with links to a building's files and a state of its own.

    An engine that loads it under `SESSION` and `WORLD`, in this or another process, finds the scenes as they are on
    disk and the robot at `start`; the building itself stays as it is.

    Parameters
    ----------
    building : Path
        Folder of the building; what its sessions left is not seen.
    start : TaskStart, optional
        The spawn pose when absent.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when there is no building or it lacks the floor.
    """
    loaded = LoadedBuilding(building.expanduser().resolve())
    if start is not None and start.floor not in loaded.floors:
        raise MansionError(
            ErrorCode.NOT_FOUND,
            f"the building has no floor {start.floor}; floors are {loaded.floors}",
            path="$.start.floor",
        )
    with tempfile.TemporaryDirectory(prefix="mansion_episode_") as name:
        folder = Path(name).resolve()
        for entry in sorted(loaded.path.iterdir()):
            if entry.name != "state":
                (folder / entry.name).symlink_to(entry)
        if start is not None:
            save_overlay(overlay_path(folder, SESSION), _overlay(loaded, start), durable=False)
        yield folder


def _overlay(building: LoadedBuilding, start: TaskStart) -> WorldState:
    return WorldState(
        building_id=building.building_id,
        session=SESSION,
        world=WORLD,
        robot=RobotState(
            session=SESSION,
            floor=start.floor,
            label=building.label(start.floor),
            pose=start.pose,
            building_id=building.building_id,
        ),
    )


class WorldReplica:
    """The world of an episode folder whose robot another process drives.

    Parameters
    ----------
    folder : Path

    Attributes
    ----------
    world : World
    robot : RobotBody
        Both the same objects for as long as the replica lives.
    """

    def __init__(self, folder: Path) -> None:
        self._file = overlay_path(folder, SESSION)
        self.world = World(LoadedBuilding(folder), WORLD)
        self.robot: RobotBody = self.world.add_robot(SESSION)
        self._initial = {name: self.world.objects.state(name) for name in self.world.objects}
        self._last_saved = b""
        self._closing_since: dict[str, float] = {}
        self.follow()

    def follow(self) -> None:
        """Bring the world up to date with what was saved last."""
        try:
            data = self._file.read_bytes()
        except FileNotFoundError:
            return
        if data == self._last_saved:
            return
        self._last_saved, world = data, self.world
        saved = decode(WorldState, data)
        moved = {state.id: state for state in saved.objects}
        if moved != world.objects.changed or saved.doors != world.doors:
            for name in [name for name in world.objects.changed if name not in moved]:
                world.objects.put(self._initial[name])
            for state in saved.objects:
                world.objects.put(state)
            world.objects.commit()
            world.doors.clear()
            world.doors.update(saved.doors)
            world.reload()
        for entry in saved.lifts:
            self._restore_lift(entry, saved)
        world.time, world.step = saved.time, saved.step
        self.robot.call = None
        restore_robot(world, saved, self.robot)

    def _restore_lift(self, entry: LiftState, saved: WorldState) -> None:
        """Restore a lift; doors that were let go are as far closed as their time allows, which no overlay says."""
        name, lift = entry.lift_name, self.world.lifts[entry.lift_name]
        lift.restore(entry, saved.queues.get(name, []))
        if entry.door_state is not LiftDoor.MOVING:
            self._closing_since.pop(name, None)
            return
        lift.opening = 1.0
        since = self._closing_since.setdefault(name, saved.time)
        for _ in lift.advance(saved.time - since, since, saved.building_id):
            continue

"""A folder that stands in for a building, so that an episode leaves the building itself as it is."""

import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.task import TaskStart
from mansion_msgs_py.world import RobotState, WorldState
from mansion_skills.world.building import LoadedBuilding
from mansion_skills.world.overlay import overlay_path, save_overlay

__all__ = ["SESSION", "WORLD", "stand_in"]

SESSION = "episode"
WORLD = "episode"


@contextmanager
def stand_in(building: Path, start: TaskStart | None = None) -> Iterator[Path]:
    """Yield a temporary folder with links to a building's files and a state of its own.

    Whoever loads it under `SESSION` and `WORLD`, in this process or another one of this machine, finds the scenes as
    they are on disk and the robot at `start`.

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

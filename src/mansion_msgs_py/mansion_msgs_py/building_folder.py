"""A building folder: where its files are, and how they are read."""

from pathlib import Path
from typing import Final, TypeVar

from mansion_msgs_py.building import Building, FloorEntry
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import read_payload
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.topology import FloorTopology

__all__ = [
    "EDIT_LOG",
    "INDEX",
    "STATE",
    "TASKS",
    "BuildingFolder",
    "check_building_folder",
    "file_in",
    "floor_directory",
    "floor_file",
    "is_building_folder",
]

T = TypeVar("T")

INDEX: Final = "building.json"
"""The file that makes a folder a building folder; it names all the others."""

TASKS: Final = "tasks.json"
"""A `TaskSet` of the building, where tasks were made with it."""

EDIT_LOG: Final = "edits/log.jsonl"
"""What was changed in the building since it was built, one `Transaction` a line."""

STATE: Final = "state"
"""The folder with what robots did in the building, by session."""


def floor_directory(floor: int) -> str:
    """Return the folder of a floor, relative to the building's."""
    return f"floors/floor_{floor}"


def floor_file(entry: FloorEntry, key: str, name: str) -> str:
    """Return the path of a floor's file in the building's folder, where ``building.json`` names it or exports write it.

    Parameters
    ----------
    entry : FloorEntry
    key : str
        Its key in ``building.json``, which names what was written with the building.
    name : str
        Its name in the folder of the floor, where ``mansion export`` writes it later.
    """
    return entry.files.get(key) or f"{floor_directory(entry.floor)}/{name}"


def file_in(folder: Path, name: str) -> Path:
    """Return the path of a file of a folder that is to be written.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for a name that leads out of the folder: an absolute one, one with ``..``, or one below a
        link to another place.
    """
    path = folder / name
    if not path.parent.resolve().is_relative_to(folder.resolve()):
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD,
            f"{name[:200]!r} leads out of {folder}; name a file below it",
            details={"file": name[:200]},
        )
    return path


def is_building_folder(path: Path) -> bool:
    """Whether a folder holds a building."""
    return (path / INDEX).is_file()


def check_building_folder(path: Path) -> None:
    """Refuse a path that is not a building folder.

    Raises
    ------
    MansionError
        ``NOT_FOUND``.
    """
    if not is_building_folder(path):
        raise MansionError(ErrorCode.NOT_FOUND, f"{path} has no {INDEX}; name a folder that `mansion build` wrote")


class BuildingFolder:
    """The payloads of a building on disk, read when they are asked for.

    Parameters
    ----------
    path : Path or str
        The folder that ``mansion build`` wrote.

    Attributes
    ----------
    building : Building
        The content of ``building.json``.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for what is no building folder. The methods raise ``NOT_FOUND`` when a file is missing and
        ``INVALID_PAYLOAD`` when one does not fit its type; both name the file.
    """

    def __init__(self, path: Path | str) -> None:
        self.path = Path(path)
        check_building_folder(self.path)
        self.building = self._read(Building, INDEX)
        self._entries = {entry.floor: entry for entry in self.building.floors}

    @property
    def floors(self) -> list[int]:
        """Floor numbers, ascending."""
        return list(self._entries)

    def entry(self, floor: int) -> FloorEntry:
        """Return the entry of a floor in ``building.json``; ``NOT_FOUND`` if there is none of that number."""
        try:
            return self._entries[floor]
        except KeyError:
            known = ", ".join(map(str, self._entries))
            raise MansionError(
                ErrorCode.NOT_FOUND, f"{self.path / INDEX} has no floor {floor}; floors are {known}"
            ) from None

    def scene(self, floor: int) -> FloorScene:
        """Return the scene of a floor."""
        return self._read(FloorScene, f"{floor_directory(floor)}/scene.json")

    def scenes(self) -> list[FloorScene]:
        """Return the scenes of all floors, from below."""
        return [self.scene(floor) for floor in self.floors]

    def layout(self, floor: int) -> FloorLayout:
        """Return the layout of a floor."""
        return self._read(FloorLayout, f"{floor_directory(floor)}/layout.json")

    def topology(self, floor: int) -> FloorTopology:
        """Return the room graph of a floor."""
        return self._read(FloorTopology, f"{floor_directory(floor)}/topology.json")

    def _read(self, kind: type[T], name: str) -> T:
        return read_payload(kind, self.path / name, "a folder that `mansion build` wrote")

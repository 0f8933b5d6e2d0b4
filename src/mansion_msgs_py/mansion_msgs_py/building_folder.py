"""A building folder: where its files are, and how they are read."""

from pathlib import Path
from typing import TypeVar

from mansion_msgs_py.building import Building
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.reading import read_payload
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.topology import FloorTopology

__all__ = ["BuildingFolder", "floor_directory"]

T = TypeVar("T")


def floor_directory(floor: int) -> str:
    """Return the folder of a floor, relative to the building's."""
    return f"floors/floor_{floor}"


class BuildingFolder:
    """The payloads of a building on disk.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when a file is missing, ``INVALID_PAYLOAD`` when one does not fit its type; both name the file.
    """

    def __init__(self, path: Path | str) -> None:
        self.path = Path(path)
        self.building = self._read(Building, "building.json")

    @property
    def floors(self) -> list[int]:
        """Floor numbers, ascending."""
        return [entry.floor for entry in self.building.floors]

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

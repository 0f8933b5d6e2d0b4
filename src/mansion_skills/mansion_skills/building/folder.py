"""Read a building that ``mansion build`` wrote: floors by number or label, scenes when they are needed."""

from functools import lru_cache
from pathlib import Path

from mansion_msgs_py.building import Building, FloorEntry
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.reading import read_payload
from mansion_msgs_py.scene import FloorScene

__all__ = ["LoadedBuilding"]


class LoadedBuilding:
    """The floors of one building on disk.

    Parameters
    ----------
    path : Path
        The building's folder.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` at ``$.path`` when there is no building, ``INVALID_PAYLOAD`` when a file does not fit its type.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        file = path / "building.json"
        if not file.is_file():
            raise MansionError(
                ErrorCode.NOT_FOUND,
                f"{path} holds no building.json; name a folder that `mansion build` wrote",
                path="$.path",
            )
        self.index = read_payload(Building, file)
        self._entries = {entry.floor: entry for entry in self.index.floors}
        self.scene = lru_cache(maxsize=None)(self._read_scene)

    @property
    def building_id(self) -> str:
        """The building's id."""
        return self.index.building_id

    @property
    def floors(self) -> list[int]:
        """Floor numbers, ascending."""
        return sorted(self._entries)

    def entry(self, floor: int) -> FloorEntry:
        """Return the index entry of a floor."""
        return self._entries[floor]

    def label(self, floor: int) -> str:
        """Return what a lift button says for the floor."""
        return self._entries[floor].label

    def floor_number(self, value: object) -> int | None:
        """Return the floor that a number or an unambiguous label names, or ``None``."""
        if isinstance(value, float) and value.is_integer() and abs(value) < 1e6:
            value = int(value)
        if isinstance(value, int) and not isinstance(value, bool):
            return value if value in self._entries else None
        if not isinstance(value, str):
            return None
        text = value.strip().casefold()
        labelled = [f for f, e in self._entries.items() if e.label.casefold() == text]
        if len(labelled) == 1:
            return labelled[0]
        digits = text.removeprefix("-")
        if not labelled and digits.isdecimal() and digits.isascii() and len(digits) < 9:
            return self.floor_number(int(text))
        return None

    def _read_scene(self, floor: int) -> FloorScene:
        file = self.path / self._entries[floor].files["scene"]
        return read_payload(FloorScene, file, "a folder that `mansion build` wrote")

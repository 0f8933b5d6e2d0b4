"""A building on disk as the world reads it: floors by number or label, scenes cached."""

from functools import lru_cache
from pathlib import Path

from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = ["LoadedBuilding"]


class LoadedBuilding(BuildingFolder):
    """The floors of one building on disk; each scene is read once.

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
        if not (path / "building.json").is_file():
            raise MansionError(
                ErrorCode.NOT_FOUND,
                f"{path} holds no building.json; name a folder that `mansion build` wrote",
                path="$.path",
            )
        super().__init__(path)
        self.scene = lru_cache(maxsize=None)(super().scene)  # type: ignore[method-assign]

    @property
    def building_id(self) -> str:
        """The building's id."""
        return self.building.building_id

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

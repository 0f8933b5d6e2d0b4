"""All checks of a building folder: of the building itself, and of the files in other programs' formats."""

from pathlib import Path

from mansion_bringup.building.houses import check_house_files
from mansion_bringup.check import Fault, check_building

__all__ = ["verify_building"]


def verify_building(path: Path | str) -> list[Fault]:
    """Return every fault of a building folder; empty for a sound one.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when `path` is no building folder.
    """
    return check_building(path, further=(check_house_files,))

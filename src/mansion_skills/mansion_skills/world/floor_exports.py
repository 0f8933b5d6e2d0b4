"""What a robot needs of a floor in other programs' formats: as the building's folder has it, or made in memory.

The functions that make them are named and loaded on use, as those of `mansion_export.formats` are: robots import
nothing that makes buildings, and run without it in a folder that has all files.
"""

from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from pkgutil import resolve_name
from typing import Any, Final

from mansion_msgs_py.building_folder import BuildingFolder, floor_file
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.scene import FloorScene

__all__ = ["HOUSE", "MODEL", "FloorExport", "exported", "made"]

_KEPT = 16
"""Floors that are remembered by what they were made from: each episode loads its building again."""


@dataclass(frozen=True, slots=True)
class FloorExport:
    """A format of a floor.

    Attributes
    ----------
    key : str
        The file's key in ``building.json``.
    name : str
        Name of the file in the floor's folder.
    to : str
        As ``mansion export --to`` takes it.
    function : str
        ``module:function``; takes the floor's scene and returns all files by path in the building's folder.
    """

    key: str
    name: str
    to: str
    function: str


MODEL: Final = FloorExport("model", "model.xml", "mjcf", "mansion_export.mjcf:mjcf_files")
HOUSE: Final = FloorExport("house", "house.json", "thor", "mansion_export.thor.house:house_files")

_ASSETS: Final = "mansion_assets.catalogue.preferred_folders:preferring"
"""What tells that function of the own assets in the building's folder."""


def exported(building: BuildingFolder, floor: int, what: FloorExport) -> Path | None:
    """Return the file of a floor that the building's folder has, or ``None``."""
    file = building.path / floor_file(building.entry(floor), what.key, what.name)
    return file if file.is_file() else None


def made(building: BuildingFolder, floor: int, what: FloorExport) -> dict[str, bytes]:
    """Return the files of a floor by path in the building's folder, made in memory.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` where what makes them is not installed.
    """
    own = building.path / "assets"
    return _made(encode_bytes(building.scene(floor)), what, building.path.resolve() if own.is_dir() else None)


@lru_cache(maxsize=_KEPT)
def _made(scene: bytes, what: FloorExport, assets: Path | None) -> dict[str, bytes]:
    """Make the files of a scene whose own assets, if it has any, are in a building's folder."""
    try:
        with importing:
            function: Any = resolve_name(what.function)
            preferring: Any = resolve_name(_ASSETS)
    except ImportError:
        raise MansionError(
            ErrorCode.NOT_FOUND,
            f"the folder has no {what.name}, and mansion_export, which makes it, is not installed here; "
            f"`mansion export DIR --to {what.to}` writes it where it is",
            path="$.path",
        ) from None
    with preferring([] if assets is None else [assets]):
        files: dict[str, bytes] = function(decode(FloorScene, scene))
    return files

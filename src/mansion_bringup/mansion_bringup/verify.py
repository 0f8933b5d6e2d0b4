"""All checks of a building folder: of the building itself, and of its houses for AI2-THOR.

The export's own validator checks the houses, because they are a file format and not the building. Whether rooms and
objects can be reached is the question of `mansion_bringup.check.reach`, which answers it by exact geometry.
"""

import json
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any, Final

from mansion_assets.library.building_assets import assets_of
from mansion_bringup.check import Fault, check_building
from mansion_bringup.check.building import check_floors, check_records
from mansion_msgs_py.building import Building
from mansion_msgs_py.building_folder import floor_file
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.topology import FloorTopology

__all__ = ["check_assets", "check_house_files", "check_houses", "floor_faults", "record_faults", "verify_building"]


def check_assets(folder: Path, building: Building, scenes: Sequence[FloorScene]) -> Iterator[Fault]:
    """Yield objects of which the catalogue has no asset, so that no format can show them."""
    with importing:
        from mansion_assets.catalogue import load_catalogue

    known = load_catalogue().assets
    for scene in scenes:
        for item in scene.objects:
            if item.asset not in known:
                yield Fault("OBJECT_ASSET", item.id, f"is {item.asset[:80]!r}, which is not in the catalogue")


def check_house_files(folder: Path, building: Building, scenes: Sequence[FloorScene]) -> Iterator[Fault]:
    """Yield the faults of each ``house.json`` that is there; a file that is named and missing is `check_files`'s."""
    for floor in building.floors:
        name = floor_file(floor, "house", "house.json")
        try:
            house = json.loads((folder / name).read_bytes())
        except OSError:
            continue
        except (ValueError, RecursionError) as error:
            yield Fault("HOUSE", name, f"is not JSON: {error}")
            continue
        if not isinstance(house, dict):
            yield Fault("HOUSE", name, "is not a JSON object")
            continue
        yield from check_houses(name, house)


def check_houses(
    where: str, house: dict[str, Any], note: Callable[[str], object] = lambda text: None
) -> Iterator[Fault]:
    """Yield what ``CreateHouse`` would not read, or would build wrongly.

    Rooms with fewer than five positions on AI2-THOR's grid of 0.25 m are passed to `note` and are not a fault of the
    building: ``House.validate`` asks them of a house made for a task in that simulator, and a store of 1.5 m2 has no
    place for five wherever its shelf stands.

    Parameters
    ----------
    where : str
        The file, or the floor.
    note : callable
        Gets a line for each such room.
    """
    with importing:
        from mansion_assets.catalogue import load_catalogue
        from mansion_export.thor import validate_house

    known = {asset.asset_id for asset in load_catalogue().assets.values() if asset.asset_id}
    for fault in validate_house(house, known):
        if fault.kind == "reach":
            note(f"AI2-THOR, {where}: {fault.where}: {fault.message}")
        else:
            yield Fault("HOUSE", where, str(fault))


_FURTHER: Final = (check_assets, check_house_files)


def verify_building(path: Path | str) -> list[Fault]:
    """Return every fault of a building folder; empty for a sound one.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when `path` is not a building folder.
    """
    with assets_of(Path(path)):
        return check_building(path, further=_FURTHER)


def floor_faults(building_id: str, scenes: Sequence[FloorScene], topologies: Sequence[FloorTopology]) -> list[Fault]:
    """Return the faults of finished floors: the part of `verify_building` that takes its time."""
    return list(check_floors(building_id, scenes, topologies))


def record_faults(
    folder: Path, building: Building, layouts: Sequence[FloorLayout], scenes: Sequence[FloorScene]
) -> list[Fault]:
    """Return the other faults of `verify_building`: those of files and records."""
    with assets_of(folder):
        return list(check_records(folder, building, layouts, scenes, _FURTHER))

"""All checks of a building, in an order that goes from files to geometry to reach."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from pathlib import Path
from typing import Final

from mansion_bringup.check.cores import check_cores
from mansion_bringup.check.fault import Fault
from mansion_bringup.check.integrity import check_counts, check_files, check_identity, check_maps
from mansion_bringup.check.objects import check_lights, check_objects
from mansion_bringup.check.openings import check_openings
from mansion_bringup.check.reach import check_reach
from mansion_bringup.check.request import check_request
from mansion_bringup.check.rooms import check_partition, check_walls
from mansion_bringup.check.stairs import check_ways_up
from mansion_bringup.check.wishes import check_wishes
from mansion_geometry.sound_shapes import unsound_shapes
from mansion_msgs_py.building import Building, BuildingReport
from mansion_msgs_py.building_folder import BuildingFolder, check_building_folder
from mansion_msgs_py.codec import decode
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.topology import FloorTopology
from mansion_msgs_py.wishes import Wish

__all__ = ["FileCheck", "check_building", "check_floors", "check_records", "in_order"]


FileCheck = Callable[[Path, Building, Sequence[FloorScene]], Iterable[Fault]]
"""Yields the faults of some files of a building folder."""


def check_building(path: Path | str, further: Sequence[FileCheck] = ()) -> list[Fault]:
    """Return every fault of the building in a folder; empty for a sound one.

    Parameters
    ----------
    path : Path or str
    further : sequence of callable
        Further checks, of files in other programs' formats.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when `path` is not a building folder.
    """
    folder = Path(path)
    check_building_folder(folder)
    try:
        read = BuildingFolder(folder)
        scenes = read.scenes()
        layouts = [read.layout(floor) for floor in read.floors]
        topologies = [read.topology(floor) for floor in read.floors]
    except MansionError as error:
        return [Fault("FILE", str(error.info.details.get("file", folder)), str(error))]
    floors = check_floors(read.building.building_id, scenes, topologies)
    return in_order([*check_records(folder, read.building, layouts, scenes, further), *floors])


def in_order(faults: Iterable[Fault]) -> list[Fault]:
    """Return faults by kind and place, each once."""
    return sorted(set(faults), key=lambda fault: (fault.kind, fault.where, fault.message))


def check_records(
    folder: Path,
    building: Building,
    layouts: Sequence[FloorLayout],
    scenes: Sequence[FloorScene],
    further: Sequence[FileCheck] = (),
) -> Iterator[Fault]:
    """Yield the faults of files, and of the statements of ``building.json`` about the floors."""
    yield from check_files(folder, building)
    yield from check_maps(folder, building, list(scenes))
    for further_check in further:
        yield from further_check(folder, building, scenes)
    yield from check_counts(building, scenes)
    yield from check_request(building, layouts, scenes)
    yield from check_wishes(building, _reported(folder, building), layouts, scenes)


def _reported(folder: Path, building: Building) -> list[Wish] | None:
    """Return the wishes of the report; ``None`` where it cannot be read, which is a fault of files."""
    try:
        return decode(BuildingReport, (folder / building.files["report"]).read_bytes()).wishes
    except (KeyError, OSError, MansionError):
        return None


def check_floors(
    building_id: str, scenes: Sequence[FloorScene], topologies: Sequence[FloorTopology]
) -> Iterator[Fault]:
    """Yield the faults of finished scenes, from their geometry and their room graphs."""
    identity = list(check_identity(building_id, scenes))
    yield from identity
    if any(fault.kind == "NUMBER" for fault in identity):
        return
    unsound = [fault for scene in scenes for fault in _shapes(scene)]
    yield from unsound
    if unsound:
        return
    for scene, topology in zip(scenes, topologies):
        yield from check_partition(scene)
        yield from check_walls(scene)
        yield from check_openings(scene, _wished_doors(scene, topology))
        yield from check_objects(scene)
        yield from check_lights(scene)
    yield from check_cores(scenes)
    yield from check_ways_up(scenes)
    yield from check_reach(scenes)


_SHAPES: Final = {"polygon": "ROOM_SHAPE", "net interior": "ROOM_NET", "segment": "WALL", "outline": "OUTLINE"}


def _shapes(scene: FloorScene) -> Iterator[Fault]:
    """Yield the shapes that no further question can be asked of."""
    for shape in unsound_shapes(scene):
        yield Fault(_SHAPES[shape.part], shape.owner, shape.message)


def _wished_doors(scene: FloorScene, topology: FloorTopology) -> list[tuple[str, str]]:
    """Access edges between rooms that are there; an edge that a recorded downgrade gave up is left out."""
    cores = {core.id for core in scene.cores}
    rooms = {room.id for room in scene.rooms}
    given_up = {frozenset(wish.wish.split(" access ")) for wish in scene.downgrades}
    wished = []
    for edge in topology.edges:
        names = [name if name in cores else f"F{scene.floor}/{name}" for name in (edge.source, edge.target)]
        known = all(name in cores or name in rooms for name in names)
        if edge.kind == "access" and known and frozenset((edge.source, edge.target)) not in given_up:
            wished.append((names[0], names[1]))
    return wished

"""The documents of one storey before and after a change of its structure, and what the building's index says of it."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import msgspec

from mansion_assets.catalogue import Catalogue
from mansion_editing.tools.furnishing import Furnisher
from mansion_msgs_py.building import Building, FloorEntry
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.program import BuildingProgram, FloorProgram
from mansion_msgs_py.scene import FloorScene, SceneRoom
from mansion_msgs_py.topology import FloorTopology

__all__ = ["Judge", "Reshaped", "Storey", "Workshop", "node_of", "storey_of", "updated_building"]

Judge = Callable[[FloorScene], Sequence[str]]
"""Returns the faults that a building would have with a storey, and has not now."""


@dataclass(frozen=True)
class Storey:
    """A storey as its documents describe it.

    Attributes
    ----------
    program : BuildingProgram
        The building's program: the storey's own part says what its rooms are, the rest where its cores are.
    """

    program: BuildingProgram
    topology: FloorTopology
    layout: FloorLayout
    scene: FloorScene

    @property
    def number(self) -> int:
        """Number of the floor."""
        return self.scene.floor

    @property
    def floor(self) -> FloorProgram:
        """The storey's own part of the program."""
        return next(floor for floor in self.program.floors if floor.index == self.number)

    def room(self, room_id: str, path: str = "$.room_id") -> SceneRoom:
        """Return a room by its id in the scene.

        Raises
        ------
        MansionError
            ``NOT_FOUND`` with the rooms that there are.
        """
        for room in self.scene.rooms:
            if room.id == room_id:
                return room
        known = ", ".join(room.id for room in self.scene.rooms)
        raise MansionError(
            ErrorCode.NOT_FOUND, f"no room {room_id[:120]!r} on floor {self.number}; there are {known}", path=path
        )


@dataclass(frozen=True)
class Workshop:
    """What a change of structure needs beside the documents.

    Attributes
    ----------
    catalogue : Catalogue
        Furniture for rooms that are furnished again.
    furnisher : Furnisher
        The placer, which furnishes them.
    judge : callable
        Says what would be wrong with a finished storey; a change that adds a fault is not made.
    """

    catalogue: Catalogue
    furnisher: Furnisher
    judge: Judge


@dataclass(frozen=True)
class Reshaped:
    """A storey after a change.

    Attributes
    ----------
    storey : Storey
    moved : list of str
        A plain sentence for each thing that is not as it was.
    """

    storey: Storey
    moved: list[str]


def storey_of(folder: BuildingFolder, floor: int) -> Storey:
    """Return the documents of a storey from a building folder."""
    return Storey(folder.building.program, folder.topology(floor), folder.layout(floor), folder.scene(floor))


def node_of(room: SceneRoom | str) -> str:
    """Return the name of a room in its storey's program, room graph and layout.

    Examples
    --------
    >>> node_of("F2/office_1"), node_of("stair_1")
    ('office_1', 'stair_1')
    """
    name = room if isinstance(room, str) else room.id
    return name.partition("/")[2] or name


def updated_building(building: Building, changes: Sequence[tuple[Storey, Storey]]) -> Building:
    """Return ``building.json`` after a change of storeys: its program, areas and counts, not yet its wishes.

    Where one storey changes, another that was to repeat it, or that it was to repeat, stands for itself from then on;
    what changes all storeys changes copies alike.

    Parameters
    ----------
    building : Building
        As it was.
    changes : sequence of (Storey, Storey)
        Each changed storey before and after; the last has the new program.
    """
    after = {new.number: new for _, new in changes}
    entries = [_entry(entry, after[entry.floor]) if entry.floor in after else entry for entry in building.floors]
    checks = dict(building.checks)
    for before, now in ((old.scene, new.scene) for old, new in changes):
        grown = {
            "rooms": len(now.rooms) - len(before.rooms),
            "doors": len(now.doors) - len(before.doors),
            "objects": len(now.objects) - len(before.objects),
        }
        checks = {name: count + grown.get(name, 0) for name, count in checks.items()}
    program = changes[-1][1].program
    if len(changes) == 1:
        program = msgspec.structs.replace(program, floors=_independent(program.floors, changes[0][1].number))
    cores = program.vertical_connectivity.cores
    return msgspec.structs.replace(building, program=program, floors=entries, checks=checks, cores=cores)


def _entry(entry: FloorEntry, storey: Storey) -> FloorEntry:
    scene = storey.scene
    area = round(sum(room.area for room in scene.rooms), 3)
    return msgspec.structs.replace(entry, area=area, objects=len(scene.objects), rooms=len(scene.rooms))


def _independent(floors: Sequence[FloorProgram], changed: int) -> list[FloorProgram]:
    """Return the floors with no copy of the changed one; its copies repeat the first of them instead."""
    copies = [floor.index for floor in floors if floor.copy == changed]
    source = {index: copies[0] if index != copies[0] else None for index in copies} | {changed: None}
    return [
        msgspec.structs.replace(floor, copy=source[floor.index]) if floor.index in source else floor for floor in floors
    ]

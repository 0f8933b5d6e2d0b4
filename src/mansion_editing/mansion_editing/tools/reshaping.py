"""ReshapeFloor: a change of structure, found in memory and handed over as whole documents."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TypeVar

import msgspec

from mansion_assets.catalogue import Catalogue
from mansion_editing.state import SceneState
from mansion_editing.structure import (
    Reshaped,
    Storey,
    Workshop,
    add_core,
    add_door,
    change_area,
    swap_rooms,
    updated_building,
)
from mansion_editing.structure.cores import JudgeAll
from mansion_editing.tools.furnishing import Furnisher
from mansion_editing.tools.rooms import room_named
from mansion_msgs_py.building import Building
from mansion_msgs_py.building_folder import INDEX, floor_directory
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.editing.rooms import ReshapeFloorArgs
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.scene import SceneRoom
from mansion_msgs_py.topology import FloorTopology

__all__ = ["Documents", "ReshapedFloor", "reshape_floor"]

T = TypeVar("T")

Documents = Callable[[str], bytes | None]
"""Returns a document of the building by its path, as what waits to be saved makes it."""


@dataclass(frozen=True)
class ReshapedFloor:
    """What replaces the documents of a storey, or of all where a core runs through them.

    Attributes
    ----------
    files : dict of str to bytes
        By path, the building's index, and the room graph, the layout and the scene of each storey.
    moved : list of str
        Sentences on what is not as it was.
    rooms : list of str
        Ids of the rooms that have another polygon.
    """

    files: dict[str, bytes]
    moved: list[str]
    rooms: list[str]


def reshape_floor(
    state: SceneState,
    args: ReshapeFloorArgs,
    documents: Documents,
    judge: JudgeAll,
    catalogue: Catalogue,
    furnisher: Furnisher,
    go_on: Callable[[], None] = lambda: None,
) -> ReshapedFloor:
    """Change the structure of a storey; nothing is written.

    Parameters
    ----------
    go_on : callable
        Asked before each way to make the change; raises where nobody wants it any more.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` or ``CONFLICT`` for rooms that are not there or cannot be told apart, ``INFEASIBLE`` with the
        reason and, for an area, the one that can be had.
    """
    floor, room = room_named(state, args.room_id)
    index = _read(Building, documents, INDEX)
    workshop = Workshop(catalogue, furnisher, lambda scene: judge({floor: scene}), go_on)
    if args.what == "stair" or args.what == "elevator":
        storeys = [_storey(state, index, documents, number) for number in state.floors]
        made = add_core(storeys, args.what, workshop, judge, room_id=room.id)
        return _replaced(index, list(zip(storeys, made, strict=True)))
    storey = _storey(state, index, documents, floor)
    if args.what == "area":
        done = change_area(storey, room.id, args.area, workshop, absolute=args.absolute)
    else:
        other = _other(state, args, floor)
        join: Callable[[Storey, str, str, Workshop], Reshaped] = add_door if args.what == "door" else swap_rooms
        done = join(storey, room.id, other.id, workshop)
    return _replaced(index, [(storey, done)])


def _storey(state: SceneState, index: Building, documents: Documents, floor: int) -> Storey:
    place = floor_directory(floor)
    topology = _read(FloorTopology, documents, f"{place}/topology.json")
    layout = _read(FloorLayout, documents, f"{place}/layout.json")
    return Storey(index.program, topology, layout, state.scenes[floor])


def _read(kind: type[T], documents: Documents, path: str) -> T:
    data = documents(path)
    if data is None:
        raise MansionError(ErrorCode.NOT_FOUND, f"the building has no {path}, which a change of structure needs")
    return decode(kind, data)


def _replaced(index: Building, changes: Sequence[tuple[Storey, Reshaped]]) -> ReshapedFloor:
    """Return the documents that put storeys in the place of what they were."""
    payloads: dict[str, msgspec.Struct] = {
        INDEX: updated_building(index, [(before, made.storey) for before, made in changes])
    }
    for _, made in changes:
        place = floor_directory(made.storey.number)
        payloads[f"{place}/topology.json"] = made.storey.topology
        payloads[f"{place}/layout.json"] = made.storey.layout
        payloads[f"{place}/scene.json"] = made.storey.scene
    files = {path: encode_bytes(payload, indent=1) for path, payload in payloads.items()}
    moved = [sentence for _, made in changes for sentence in made.moved]
    rooms = [name for old, made in changes for name in _changed_rooms(old.scene.rooms, made.storey.scene.rooms)]
    return ReshapedFloor(files, moved, rooms)


def _other(state: SceneState, args: ReshapeFloorArgs, floor: int) -> SceneRoom:
    """Return the second room, which must be on the same floor."""
    if not args.other_id.strip():
        raise MansionError(ErrorCode.INVALID_PAYLOAD, f"a {args.what} concerns two rooms", path="$.other_id")
    there, other = room_named(state, args.other_id)
    if there != floor:
        raise MansionError(
            ErrorCode.INFEASIBLE, f"{other.id} is on floor {there}, the other room on floor {floor}", path="$.other_id"
        )
    return other


def _changed_rooms(before: Sequence[SceneRoom], after: Sequence[SceneRoom]) -> list[str]:
    known = {room.id: room for room in before}
    return [room.id for room in after if known.get(room.id) != room]

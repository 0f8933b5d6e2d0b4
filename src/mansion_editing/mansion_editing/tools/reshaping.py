"""ReshapeFloor: a change of one storey's structure, found in memory and handed over as whole documents."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import Any

from mansion_assets.catalogue import Catalogue
from mansion_editing.state import SceneState
from mansion_editing.storage import BuildingStore
from mansion_editing.structure import (
    Reshaped,
    Storey,
    Workshop,
    add_core,
    add_door,
    change_area,
    storey_of,
    swap_rooms,
    updated_building,
)
from mansion_editing.structure.cores import CoreKind
from mansion_editing.tools.furnishing import Furnisher
from mansion_editing.tools.rooms import room_named
from mansion_msgs_py.building_folder import INDEX, BuildingFolder, floor_directory
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.editing import DocumentChange, ReshapeFloorArgs
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneRoom

__all__ = ["ReshapedFloor", "reshape_floor"]


@dataclass(frozen=True)
class ReshapedFloor:
    """What replaces the documents of a storey, or of all where a core runs through them.

    Attributes
    ----------
    documents : list of DocumentChange
        The building's index, and the room graph, the layout and the scene of each storey.
    moved : list of str
        Sentences on what is not as it was.
    rooms : list of str
        Ids of the rooms that have another polygon or another door.
    """

    documents: list[DocumentChange]
    moved: list[str]
    rooms: list[str]


def reshape_floor(
    store: BuildingStore, state: SceneState, args: ReshapeFloorArgs, catalogue: Catalogue, furnisher: Furnisher
) -> ReshapedFloor:
    """Change the structure of one storey; nothing is written but copies of documents.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` or ``CONFLICT`` for rooms that are not there or cannot be told apart, ``INFEASIBLE`` with the
        reason and, for an area, the one that can be had.
    """
    floor, room = room_named(state, args.room_id)
    folder = BuildingFolder(store.folder)
    scenes = store.scenes()
    workshop = Workshop(catalogue, furnisher, lambda scene: store.new_faults(scenes, {**scenes, floor: scene}))
    if args.what in ("stair", "elevator"):
        storeys = [storey_of(folder, number) for number in folder.floors]
        judge = partial(store.new_faults, scenes)
        kind: CoreKind = "stair" if args.what == "stair" else "elevator"
        made = add_core(storeys, kind, workshop, judge, room_id=room.id)
        return _replaced(store, folder, list(zip(storeys, made, strict=True)))
    storey = storey_of(folder, floor)
    if args.what == "area":
        done = change_area(storey, room.id, args.area, workshop, absolute=args.absolute)
    else:
        other = _other(state, args, floor)
        join: Callable[[Storey, str, str, Workshop], Reshaped] = add_door if args.what == "door" else swap_rooms
        done = join(storey, room.id, other.id, workshop)
    return _replaced(store, folder, [(storey, done)])


def _replaced(
    store: BuildingStore, folder: BuildingFolder, changes: Sequence[tuple[Storey, Reshaped]]
) -> ReshapedFloor:
    """Return the documents that put storeys in the place of what they were."""
    index = updated_building(folder.building, [(before, made.storey) for before, made in changes])
    payloads: dict[str, Any] = {INDEX: index}
    for _, made in changes:
        place = floor_directory(made.storey.number)
        payloads[f"{place}/topology.json"] = made.storey.topology
        payloads[f"{place}/layout.json"] = made.storey.layout
        payloads[f"{place}/scene.json"] = made.storey.scene
    documents = [store.documents.replacement(path, encode_bytes(data, indent=1)) for path, data in payloads.items()]
    moved = [sentence for _, made in changes for sentence in made.moved]
    rooms = [name for old, made in changes for name in _changed_rooms(old.scene.rooms, made.storey.scene.rooms)]
    return ReshapedFloor(documents, moved, rooms)


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

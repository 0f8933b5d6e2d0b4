"""ReshapeFloor: a change of one storey's structure, found in memory and handed over as whole documents."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from mansion_assets.catalogue import Catalogue
from mansion_editing.state import SceneState
from mansion_editing.storage import BuildingStore
from mansion_editing.structure import (
    Reshaped,
    Storey,
    Workshop,
    add_door,
    change_area,
    storey_of,
    swap_rooms,
    updated_building,
)
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
    """What replaces a storey's documents.

    Attributes
    ----------
    documents : list of DocumentChange
        The building's index, and the room graph, the layout and the scene of the storey.
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
    if args.what in ("stair", "elevator"):
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"a further {args.what} takes floor of every storey at one place, and this changes one storey alone; "
            f"build the building anew with the {args.what} in its description",
            path="$.what",
        )
    folder = BuildingFolder(store.folder)
    scenes = store.scenes()
    storey = storey_of(folder, floor)
    workshop = Workshop(catalogue, furnisher, lambda scene: store.new_faults(scenes, {**scenes, floor: scene}))
    if args.what == "area":
        done = change_area(storey, room.id, args.area, workshop, absolute=args.absolute)
    else:
        other = _other(state, args, floor)
        join: Callable[[Storey, str, str, Workshop], Reshaped] = add_door if args.what == "door" else swap_rooms
        done = join(storey, room.id, other.id, workshop)
    index = updated_building(folder.building, storey, done.storey)
    place = floor_directory(floor)
    payloads = {
        INDEX: index,
        f"{place}/topology.json": done.storey.topology,
        f"{place}/layout.json": done.storey.layout,
        f"{place}/scene.json": done.storey.scene,
    }
    documents = [store.documents.replacement(path, encode_bytes(data, indent=1)) for path, data in payloads.items()]
    return ReshapedFloor(documents, done.moved, _changed_rooms(storey.scene.rooms, done.storey.scene.rooms))


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

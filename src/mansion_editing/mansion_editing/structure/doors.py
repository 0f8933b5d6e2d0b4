"""A door between two rooms that share a wall."""

from mansion_editing.structure.attempts import Change, attempt
from mansion_editing.structure.rebuilding import passages_of_scene
from mansion_editing.structure.storey_documents import (
    Reshaped,
    Storey,
    Workshop,
    added_access,
    node_of,
    region_shapes,
    with_topology,
)
from mansion_geometry.shared_walls import edge_array, longest_wall, shared_walls
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneRoom
from mansion_scene.structure.access import Passage, pair_key
from mansion_scene.structure.dimensions import CLEAR_WIDTH, INTERIOR_THICKNESS

__all__ = ["add_door"]

_LEAST_WALL = CLEAR_WIDTH + INTERIOR_THICKNESS
"""Shared wall, on centre lines, that takes a door of full width; metres."""


def add_door(storey: Storey, room_id: str, other_id: str, workshop: Workshop) -> Reshaped:
    """Make a door between two rooms, where furniture and other openings leave room, or furniture can make way.

    Parameters
    ----------
    storey : Storey
    room_id, other_id : str
        Ids of the rooms in the scene.
    workshop : Workshop

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an unknown room, ``INVALID_PAYLOAD`` for one room named twice, ``CONFLICT`` where the two open
        to each other already, ``INFEASIBLE`` where no wall of theirs takes a door.
    """
    room, other = storey.room(room_id), storey.room(other_id, "$.other_id")
    if room.id == other.id:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "a door joins two rooms; name another one", path="$.other_id")
    _refuse_joined(storey, room, other)
    _require_wall(storey, room, other)
    after = Storey(
        storey.program, added_access(storey.topology, node_of(room), node_of(other)), storey.layout, storey.scene
    )
    after = with_topology(after)
    change = Change(
        before=storey,
        after=after,
        passages=[*passages_of_scene(storey.scene), Passage(pair_key(room.id, other.id))],
        may_change={room.id, other.id},
    )
    return attempt(change, workshop).reshaped


def _refuse_joined(storey: Storey, room: SceneRoom, other: SceneRoom) -> None:
    for door in storey.scene.doors:
        if {room.id, other.id} == set(door.rooms):
            how = "stand open to each other" if door.kind == "open" else f"have the door {door.id} between them"
            raise MansionError(ErrorCode.CONFLICT, f"{room.id} and {other.id} {how} already", path="$.other_id")


def _require_wall(storey: Storey, room: SceneRoom, other: SceneRoom) -> None:
    shapes = region_shapes(storey, storey.layout)
    walls = shared_walls(edge_array(shapes[node_of(room)]), edge_array(shapes[node_of(other)]), 1e-3)
    longest = longest_wall(walls)
    if longest is None:
        raise MansionError(ErrorCode.INFEASIBLE, f"{room.id} and {other.id} share no wall", path="$.other_id")
    if longest.length < _LEAST_WALL:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"{room.id} and {other.id} share only {longest.length:.2f} m of straight wall; "
            f"a door needs {_LEAST_WALL:.2f} m",
            path="$.other_id",
        )

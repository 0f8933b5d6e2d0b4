"""Unsaved changes: the documents as they are going to be, the changes that make them so, and these in words."""

from collections.abc import Sequence
from typing import NamedTuple

import msgspec

from mansion_editing.document_copies import Documents, floor_of, is_scene
from mansion_editing.room_parts import program_with, records_of, topology_with
from mansion_editing.state import Change, SceneState, net_changes, net_rooms
from mansion_msgs_py.building import Building
from mansion_msgs_py.building_folder import INDEX, floor_directory
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.editing.changes import DocumentChange, ObjectChange, RoomChange, RoomParts
from mansion_msgs_py.program import RoomProgram
from mansion_msgs_py.topology import FloorTopology, TopologyNode

__all__ = ["Waiting", "document", "in_words", "room_records", "waiting"]


class Waiting(NamedTuple):
    """Changes that together do what was done since the last save."""

    changes: list[ObjectChange]
    rooms: list[RoomChange]
    documents: list[DocumentChange]


def waiting(state: SceneState, documents: Documents) -> Waiting:
    """Return what waits; changes of a floor whose scene is replaced are in the documents that replace it."""
    first: dict[str, DocumentChange] = {}
    for change in state.pending:
        if isinstance(change, DocumentChange):
            first.setdefault(change.path, change)
    replaced = {floor_of(path) for path in first if is_scene(path)}
    own = [c for c in state.pending if not isinstance(c, DocumentChange) and c.floor not in replaced]
    for room in net_rooms([c for c in state.pending if isinstance(c, RoomChange) and c.floor in replaced]):
        for path in (INDEX, _graph(room.floor)):
            if path not in first and documents.present(path) is not None:
                first[path] = documents.replacement(path, documents.present(path))
    net = [documents.kept(change, document(state, documents, path)) for path, change in first.items()]
    return Waiting(net_changes(own), net_rooms(own), [change for change in net if change.before != change.after])


def document(state: SceneState, documents: Documents, path: str) -> bytes | None:
    """Return a document with the unsaved changes; ``None`` if it does not exist."""
    number, last = max(
        ((n, c) for n, c in enumerate(state.pending) if isinstance(c, DocumentChange) and c.path == path),
        default=(-1, None),
        key=lambda pair: pair[0],
    )
    data = documents.present(path) if last is None else documents.copy(last.after) if last.after else None
    floor = floor_of(path)
    if data is None:
        return None
    if floor is not None and is_scene(path):
        return encode_bytes(state.scenes[floor], indent=1)
    return _with_rooms(path, data, [c for c in state.pending[number + 1 :] if isinstance(c, RoomChange)])


def _with_rooms(path: str, data: bytes, rooms: Sequence[RoomChange]) -> bytes:
    """Return a program or a room graph with rooms as they are after changes."""
    floor = floor_of(path)
    if path == INDEX and rooms:
        index = decode(Building, data)
        program = index.program
        for change in rooms:
            program = program_with(program, change)
        return encode_bytes(msgspec.structs.replace(index, program=program), indent=1)
    here = [change for change in rooms if floor is not None and change.floor == floor and path == _graph(floor)]
    if not here:
        return data
    graph = decode(FloorTopology, data)
    for change in here:
        graph = topology_with(graph, change)
    return encode_bytes(graph, indent=1)


def room_records(
    state: SceneState, documents: Documents, floor: int, room_id: str
) -> tuple[RoomProgram | None, TopologyNode | None]:
    """Return a room as the building's program and its floor's room graph have it, where they do."""
    index = document(state, documents, INDEX)
    graph = document(state, documents, _graph(floor))
    if index is None:
        return None, None
    topology = None if graph is None else decode(FloorTopology, graph)
    return records_of(decode(Building, index).program, topology, floor, room_id)


def _graph(floor: int) -> str:
    return f"{floor_directory(floor)}/topology.json"


def in_words(change: Change) -> str:
    """Return a change in words: ``+`` what comes, ``-`` what goes, ``~`` what differs and how a room does.

    Examples
    --------
    >>> in_words(DocumentChange(path="floors/floor_1/layout.json", before="6f1c", after="90aa"))
    '~ floors/floor_1/layout.json'
    """
    if isinstance(change, DocumentChange):
        return f"{_sign(change.before, change.after)} {change.path}"
    if isinstance(change, ObjectChange):
        return f"{_sign(change.before, change.after)} {change.id}"
    told = _facts(change.before)
    facts = [
        f"{name} {told[name] or 'none'} -> {value or 'none'}"
        for name, value in _facts(change.after).items()
        if value != told[name]
    ]
    return f"~ {change.id} ({'; '.join(facts) or 'as its records have it'})"


def _sign(before: object, after: object) -> str:
    if not before:
        return "+"
    return "~" if after else "-"


def _facts(parts: RoomParts) -> dict[str, str]:
    room = parts.room
    start = "" if parts.spawn is None else f"{parts.spawn.x} {parts.spawn.y}"
    return {
        "name": room.name,
        "type": room.room_type,
        "walls": room.wall_material,
        "floor": room.floor_material,
        "ceiling": room.ceiling_material,
        "lights": str(len(parts.lights)),
        "robot's start": start,
    }

"""Two rooms of a storey that change places."""

from dataclasses import replace

import msgspec

from mansion_editing.structure.attempts import Change, attempt
from mansion_editing.structure.rebuilding import passages_of_scene
from mansion_editing.structure.room_shapes import is_circulation
from mansion_editing.structure.storey_documents import Reshaped, Storey, Workshop, node_of, region_shapes, with_shapes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene, SceneRoom
from mansion_msgs_py.topology import Edge, FloorTopology
from mansion_scene.structure.access import Passage

__all__ = ["swap_rooms"]

_NOTABLE = 0.1
"""Share by which areas differ that the report mentions."""


def swap_rooms(storey: Storey, room_id: str, other_id: str, workshop: Workshop) -> Reshaped:
    """Let two rooms change places: each gets the other's polygon and entrances, and is furnished again there.

    Parameters
    ----------
    storey : Storey
    room_id, other_id : str
        Ids of the rooms in the scene; name, type and program stay with the id.
    workshop : Workshop

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an unknown room, ``INVALID_PAYLOAD`` for one room named twice, ``INFEASIBLE`` where one of the
        two cannot be where the other is.
    """
    room, other = storey.room(room_id), storey.room(other_id, "$.other_id")
    if room.id == other.id:
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "a room cannot change places with itself", path="$.other_id")
    for one in (room, other):
        if is_circulation(one) or one.kind == "main":
            raise MansionError(ErrorCode.INFEASIBLE, f"{one.id} is what other rooms are reached through and stays")
    shapes = region_shapes(storey, storey.layout)
    a, b = node_of(room), node_of(other)
    before = _renamed(storey, room.id, other.id)
    rewired = Storey(storey.program, _rewired(storey.topology, a, b), storey.layout, before.scene)
    inner = {
        door.id for door in before.scene.doors if {room.id, other.id} & set(door.rooms) and door.kind != "entrance"
    }
    change = Change(
        before=before,
        after=with_shapes(rewired, {a: shapes[b], b: shapes[a]}),
        passages=_passages(before.scene, room, other),
        may_change={room.id, other.id},
        refurnished={room.id, other.id},
        released=inner,
    )
    done = _with_fitting_doors(change, workshop)
    for one in (room, other):
        _require_garage_door(storey.scene, done.storey.scene, one.id)
    return Reshaped(done.storey, [*_opening_words(room, other), *done.moved])


def _with_fitting_doors(change: Change, workshop: Workshop) -> Reshaped:
    """Remake the doors as the rooms' types require; where that fails, leave them where they are."""
    try:
        return attempt(change, workshop).reshaped
    except MansionError as first:
        garages = {door.id for door in change.before.scene.doors if door.kind == "garage"}
        try:
            return attempt(replace(change, released=garages.intersection(change.released)), workshop).reshaped
        except MansionError:
            raise first from None


def _opening_words(room: SceneRoom, other: SceneRoom) -> list[str]:
    said = [f"{room.id} and {other.id} have changed places."]
    small, large = sorted((room, other), key=lambda one: one.area)
    if large.area > (1 + _NOTABLE) * small.area:
        share = large.area / small.area - 1.0
        said.append(f"The place that {small.id} now has is {share:.0%} larger than the one that {large.id} now has.")
    return said


def _renamed(storey: Storey, a: str, b: str) -> Storey:
    """Return a storey whose doors, and notes of missing ones, name each of two rooms for the other."""
    other = {a: b, b: a, node_of(a): node_of(b), node_of(b): node_of(a)}
    scene = storey.scene
    doors = [
        msgspec.structs.replace(
            door,
            rooms=(other.get(door.rooms[0], door.rooms[0]), other.get(door.rooms[1] or "", door.rooms[1])),
            swing=other.get(door.swing or "", door.swing),
        )
        if {a, b} & set(door.rooms)
        else door
        for door in scene.doors
    ]
    notes = [
        msgspec.structs.replace(note, wish=" ".join(other.get(word, word) for word in note.wish.split(" ")))
        if " access " in note.wish
        else note
        for note in scene.downgrades
    ]
    return replace(storey, scene=msgspec.structs.replace(scene, doors=doors, downgrades=notes))


def _rewired(topology: FloorTopology, a: str, b: str) -> FloorTopology:
    """Return the room graph with the ways into two rooms exchanged; wished neighbours stay a room's own."""
    other = {a: b, b: a}
    edges = [
        Edge(source=other.get(edge.source, edge.source), target=other.get(edge.target, edge.target), kind=edge.kind)
        if edge.kind == "access"
        else edge
        for edge in topology.edges
    ]
    return msgspec.structs.replace(topology, edges=edges)


def _passages(scene: FloorScene, room: SceneRoom, other: SceneRoom) -> list[Passage]:
    """Return the ways of the storey; a room stands open to a passage in its new place if it did so in its old one."""
    pair = {room.id: room, other.id: other}
    alike = room.open_relation == other.open_relation
    circulation = {entry.id for entry in scene.rooms if is_circulation(entry) or entry.kind == "main"}
    found = []
    for passage in passages_of_scene(scene):
        own = [pair[name] for name in passage.pair if name in pair]
        if len(own) == 1 and not alike and circulation.intersection(passage.pair):
            found.append(Passage(passage.pair, is_open=own[0].open_relation == "open"))
        else:
            found.append(passage)
    return found


def _require_garage_door(before: FloorScene, after: FloorScene, room: str) -> None:
    def driven(scene: FloorScene) -> bool:
        return any(door.kind == "garage" and room in door.rooms for door in scene.doors)

    if driven(before) and not driven(after):
        raise MansionError(ErrorCode.INFEASIBLE, f"{room} would have no outer wall for its garage door")

"""The parts of a building's documents that describe one room: read from them, and put back changed.

A room stands in three documents: its floor's scene (name, type, finishes, light), the building's program and the
floor's room graph.
"""

from collections.abc import Sequence
from typing import TypeVar

import msgspec

from mansion_msgs_py.editing.changes import RoomChange, RoomParts
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import BuildingProgram, RoomProgram
from mansion_msgs_py.scene import Discard, FloorScene, Light, Wall
from mansion_msgs_py.topology import FloorTopology, TopologyNode

__all__ = ["parts_of", "program_with", "records_of", "scene_with", "topology_with"]


def parts_of(
    scene: FloorScene, room_id: str, program: RoomProgram | None = None, node: TopologyNode | None = None
) -> RoomParts | None:
    """Return the description of a room; ``None`` if the scene has no such room."""
    room = next((room for room in scene.rooms if room.id == room_id), None)
    if room is None:
        return None
    return RoomParts(
        room=room,
        faces={wall.id: face for wall in scene.walls if (face := _face(wall, room_id)) is not None},
        lights=[light for light in scene.lights if light.room == room_id],
        discarded=[lost for lost in scene.discarded if lost.room == room_id],
        spawn=scene.spawn if scene.spawn is not None and scene.spawn.room == room_id else None,
        source=scene.sources.get(f"objects/{room_id}", ""),
        program=program,
        node=node,
    )


def _face(wall: Wall, room_id: str) -> str | None:
    if wall.left == room_id:
        return wall.left_material
    return wall.right_material if wall.right == room_id else None


def records_of(
    program: BuildingProgram, topology: FloorTopology | None, floor: int, room_id: str
) -> tuple[RoomProgram | None, TopologyNode | None]:
    """Return a room as the program and its floor's room graph have it, where they do."""
    short = room_id.partition("/")[2]
    rooms = next((storey.rooms for storey in program.floors if storey.index == floor), [])
    nodes = [] if topology is None else topology.nodes
    return next((room for room in rooms if room.id == short), None), next((n for n in nodes if n.id == short), None)


def scene_with(scene: FloorScene, change: RoomChange) -> FloorScene:
    """Return a scene with a room as it is after a change.

    Raises
    ------
    MansionError
        ``CONFLICT`` when the scene has the room otherwise than the change has it before.
    """
    before, after = change.before, change.after
    there = parts_of(scene, change.id, before.program, before.node)
    if there != before:
        raise MansionError(
            ErrorCode.CONFLICT,
            f"{change.id} was changed since this edit began; look again and repeat the edit",
            details={"room": change.id},
        )
    order = [room.id for room in scene.rooms]
    source = {f"objects/{change.id}": after.source} if after.source else {}
    return msgspec.structs.replace(
        scene,
        rooms=[after.room if room.id == change.id else room for room in scene.rooms],
        walls=[_with_face(wall, change.id, after.faces.get(wall.id)) for wall in scene.walls],
        lights=_with_own(scene.lights, after.lights, change.id, order),
        discarded=_with_own(scene.discarded, after.discarded, change.id, order),
        spawn=after.spawn if before.spawn is not None else scene.spawn,
        sources=scene.sources | source,
    )


def _with_face(wall: Wall, room_id: str, material: str | None) -> Wall:
    if material is None or material == _face(wall, room_id):
        return wall
    if wall.left == room_id:
        return msgspec.structs.replace(wall, left_material=material)
    return msgspec.structs.replace(wall, right_material=material)


_Owned = TypeVar("_Owned", bound=Light | Discard)


def _with_own(entries: Sequence[_Owned], own: Sequence[_Owned], room_id: str, order: Sequence[str]) -> list[_Owned]:
    """Return a floor's entries with those of a room replaced, where that room's stand or would stand among them."""
    rest: list[_Owned] = [entry for entry in entries if entry.room != room_id]
    places = [n for n, entry in enumerate(entries) if entry.room == room_id]
    if not places:
        later = set(order[order.index(room_id) + 1 :])
        places = [n for n, entry in enumerate(entries) if entry.room in later]
    at = places[0] if places else len(entries)
    return [*rest[:at], *own, *rest[at:]]


def program_with(program: BuildingProgram, change: RoomChange) -> BuildingProgram:
    """Return a building's program with a room as it is after a change."""
    wanted = change.after.program
    if wanted is None:
        return program
    floors = [
        msgspec.structs.replace(floor, rooms=[wanted if room.id == wanted.id else room for room in floor.rooms])
        if floor.index == change.floor
        else floor
        for floor in program.floors
    ]
    return msgspec.structs.replace(program, floors=floors)


def topology_with(topology: FloorTopology, change: RoomChange) -> FloorTopology:
    """Return a floor's room graph with a room as it is after a change."""
    wanted = change.after.node
    if wanted is None:
        return topology
    return msgspec.structs.replace(
        topology, nodes=[wanted if node.id == wanted.id else node for node in topology.nodes]
    )

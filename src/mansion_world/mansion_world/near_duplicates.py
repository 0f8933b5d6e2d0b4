"""Near-duplicates: buildings with equal room graphs and with rooms in nearly the same places.

The fingerprint of a building's graphs is the Weisfeiler-Lehman hash of each floor's room graph, its nodes labelled by
room type and its edges by kind. Buildings with the same fingerprint are near-duplicates when their rooms can be paired,
by type and floor, so that no two centres are more than `NEAR` apart and no two areas differ by more than the share
`ALIKE`.
"""

import hashlib
import math
from collections.abc import Sequence
from typing import Final

from mansion_msgs_py.scene import FloorScene, SceneRoom
from mansion_msgs_py.topology import FloorTopology
from mansion_world.records import RoomLikeness

__all__ = ["ALIKE", "NEAR", "graph_fingerprint", "likeness_cells", "nearly_the_same", "room_likeness"]

NEAR: Final = 0.5
"""Metres."""

ALIKE: Final = 0.1

_CELL: Final = 2 * NEAR

_ROUNDS: Final = 4
"""Rounds of relabelling: labels then tell rooms apart by what is up to four doors away."""


def graph_fingerprint(topologies: Sequence[FloorTopology]) -> str:
    """Return the hash of the room graphs of a building, whatever its rooms are called."""
    return _digest([_floor_fingerprint(topology) for topology in topologies])


def _floor_fingerprint(topology: FloorTopology) -> str:
    labels = {node.id: f"{node.type}:{node.room_type}" for node in topology.nodes}
    neighbours: dict[str, list[tuple[str, str]]] = {name: [] for name in labels}
    for edge in topology.edges:
        for one, other in ((edge.source, edge.target), (edge.target, edge.source)):
            if one in neighbours and other in labels:
                neighbours[one].append((edge.kind, other))
    for _ in range(_ROUNDS):
        labels = {
            name: _digest([label, *sorted(f"{kind} {labels[other]}" for kind, other in neighbours[name])])
            for name, label in labels.items()
        }
    return _digest(sorted(labels.values()))


def _digest(parts: Sequence[str]) -> str:
    return hashlib.sha256("\n".join(parts).encode()).hexdigest()[:32]


def room_likeness(scenes: Sequence[FloorScene]) -> list[RoomLikeness]:
    """Return the rooms of a building for comparison, in an order that does not depend on their names."""
    rooms = [_likeness(scene.floor, room) for scene in scenes for room in scene.rooms]
    return sorted(rooms, key=lambda room: (room.floor, room.type, room.x, room.y, room.area))


def _likeness(floor: int, room: SceneRoom) -> RoomLikeness:
    xs, ys = zip(*room.polygon)
    x, y = (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
    return RoomLikeness(floor=floor, type=room.room_type, x=round(x, 3), y=round(y, 3), area=round(room.area, 2))


def likeness_cells(rooms: Sequence[RoomLikeness]) -> list[tuple[int, int]]:
    """Return the cell of a grid in which the mean of the rooms' centres lies, and then the eight around it.

    Rooms that are paired within `NEAR` have means within `NEAR`: the cell of a near-duplicate is among these nine.
    """
    count = max(1, len(rooms))
    column = math.floor(sum(room.x for room in rooms) / count / _CELL)
    row = math.floor(sum(room.y for room in rooms) / count / _CELL)
    around = [(x, y) for x in (-1, 0, 1) for y in (-1, 0, 1) if (x, y) != (0, 0)]
    return [(column, row), *((column + x, row + y) for x, y in around)]


def nearly_the_same(one: Sequence[RoomLikeness], other: Sequence[RoomLikeness]) -> bool:
    """Whether the rooms of two buildings can be paired, each with the nearest that is left."""
    left = list(other)
    if len(one) != len(left):
        return False
    for room in one:
        near = [candidate for candidate in left if _near(room, candidate)]
        if not near:
            return False
        left.remove(min(near, key=lambda candidate: _distance(room, candidate)))
    return True


def _near(room: RoomLikeness, candidate: RoomLikeness) -> bool:
    same = (room.floor, room.type) == (candidate.floor, candidate.type)
    alike = abs(room.area - candidate.area) <= ALIKE * max(room.area, candidate.area)
    return same and alike and _distance(room, candidate) <= NEAR


def _distance(room: RoomLikeness, other: RoomLikeness) -> float:
    return float(((room.x - other.x) ** 2 + (room.y - other.y) ** 2) ** 0.5)

"""Which regions open to which: the access edges of the room graph that the layout allows, and repairs.

A repair is a passage between two regions without an access edge, where a room could not be reached otherwise.
"""

from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from mansion_knowledge import is_class
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.program import Downgrade
from mansion_msgs_py.topology import FloorTopology
from mansion_scene.structure.boundaries import BoundarySegment
from mansion_scene.structure.dimensions import INTERIOR_THICKNESS, MIN_CLEAR_WIDTH
from mansion_scene.structure.regions import FloorRegions, Region

__all__ = ["AccessPlan", "Pair", "Passage", "pair_key", "plan_access", "shared_boundaries"]

SHORTEST_ACCESS = MIN_CLEAR_WIDTH + INTERIOR_THICKNESS
"""Shortest straight wall, on centre lines, that takes a passage."""

Pair = tuple[str, str]


@dataclass(frozen=True)
class Passage:
    """A passage that two regions should have: through a door, or open over their whole boundary."""

    pair: Pair
    is_open: bool = False


@dataclass(frozen=True)
class AccessPlan:
    """The passages of a floor, and where they differ from the room graph."""

    passages: tuple[Passage, ...]
    downgrades: tuple[Downgrade, ...]


def pair_key(a: str, b: str) -> Pair:
    """Return an unordered pair of region ids in one order."""
    return (a, b) if a <= b else (b, a)


def shared_boundaries(boundaries: Sequence[BoundarySegment]) -> dict[Pair, list[BoundarySegment]]:
    """Group the boundaries that two regions share by pair."""
    shared: dict[Pair, list[BoundarySegment]] = {}
    for boundary in boundaries:
        if boundary.right is not None:
            shared.setdefault(pair_key(boundary.left, boundary.right), []).append(boundary)
    return shared


def _takes_passage(boundaries: Sequence[BoundarySegment]) -> bool:
    return any(boundary.length >= SHORTEST_ACCESS - 1e-6 for boundary in boundaries)


def plan_access(
    floor: FloorRegions,
    topology: FloorTopology,
    layout: FloorLayout,
    shared: Mapping[Pair, Sequence[BoundarySegment]],
    root: Region,
) -> AccessPlan:
    """Choose the floor's passages: one for each access edge, then those that keep all regions reachable.

    Parameters
    ----------
    shared : mapping
        What `shared_boundaries` returns.
    root : Region
        The region where the floor is entered; every other must be reachable from it.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` when a region has no wall to a reachable one that takes a door; `details` names the region.
    """
    edges = [(e.source, e.target) for e in topology.edges if e.kind == "access"]
    parents = _parents(floor, edges)
    reasons = {pair_key(e.source, e.target): e.reason for e in layout.unmet_edges}
    passages: dict[Pair, Passage] = {}
    missing: list[tuple[str, str]] = []
    for source, target in edges:
        a, b = floor.by_node.get(source), floor.by_node.get(target)
        if a is None or b is None or a.id == b.id:
            continue
        pair = pair_key(a.id, b.id)
        if _takes_passage(shared.get(pair, ())):
            passages.setdefault(pair, Passage(pair, is_open=_stands_open(a, b, parents)))
        elif (source, target) not in missing:
            missing.append((source, target))
    passages, repairs = _repaired(floor, shared, passages, root)
    downgrades = [
        Downgrade(
            wish=f"{source} access {target}",
            got=_detour(floor, (source, target), repairs),
            reason=reasons.get(pair_key(source, target))
            or f"they share no straight wall of {SHORTEST_ACCESS:.2f} m between walkable floor",
            stage="furnish_floor",
            floor=floor.floor,
        )
        for source, target in missing
    ]
    return AccessPlan(tuple(passages.values()), tuple(downgrades))


def _parents(floor: FloorRegions, edges: Sequence[tuple[str, str]]) -> dict[str, str]:
    """Return the node from which a breadth-first walk from the hub first reaches each node."""
    neighbours: dict[str, list[str]] = {}
    for a, b in edges:
        neighbours.setdefault(a, []).append(b)
        neighbours.setdefault(b, []).append(a)
    parents: dict[str, str] = {}
    queue = deque([floor.hub.node])
    seen = {floor.hub.node}
    while queue:
        node = queue.popleft()
        for other in neighbours.get(node, ()):
            if other not in seen:
                seen.add(other)
                parents[other] = node
                queue.append(other)
    return parents


def _stands_open(a: Region, b: Region, parents: Mapping[str, str]) -> bool:
    if not (a.is_room and b.is_room):
        return False
    if is_class(a.room_type, "outdoor") or is_class(b.room_type, "outdoor"):
        return False
    for child, parent in ((a, b), (b, a)):
        if parents.get(child.node) == parent.node:
            return child.open_relation == "open"
    return False


def _reached(start: str, passages: Mapping[Pair, Passage], blocked: frozenset[str]) -> set[str]:
    """Return the regions that can be reached without walking through a blocked one."""
    neighbours: dict[str, list[str]] = {}
    for a, b in passages:
        neighbours.setdefault(a, []).append(b)
        neighbours.setdefault(b, []).append(a)
    seen, queue = {start}, [start]
    while queue:
        region = queue.pop()
        if region in blocked:
            continue
        for other in neighbours.get(region, ()):
            if other not in seen:
                seen.add(other)
                queue.append(other)
    return seen


def _repaired(
    floor: FloorRegions, shared: Mapping[Pair, Sequence[BoundarySegment]], planned: Mapping[Pair, Passage], root: Region
) -> tuple[dict[Pair, Passage], dict[str, str]]:
    """Return passages with which every region is reached, and the new neighbour of each region that was joined so."""
    passages = dict(planned)
    cores = frozenset(region.id for region in floor.regions if not region.is_room)
    repairs: dict[str, str] = {}
    while True:
        seen = _reached(root.id, passages, cores)
        lost = [region for region in floor.regions if region.id not in seen]
        if not lost:
            return passages, repairs
        choices = [
            (_repair_cost(region, floor.by_id[other], boundaries), region.id, other)
            for region in lost
            for other, boundaries in _neighbours(region.id, shared)
            if other in seen and other not in cores and _takes_passage(boundaries)
        ]
        if not choices:
            raise MansionError(
                ErrorCode.INFEASIBLE,
                f"{lost[0].id} cannot be reached: it shares no straight wall of at least {SHORTEST_ACCESS:.2f} m "
                "between walkable floor with a room that can",
                path="$.layout.rooms",
                details={"unreachable": [region.id for region in lost]},
            )
        _, region_id, other = min(choices)
        pair = pair_key(region_id, other)
        passages[pair] = Passage(pair)
        repairs[region_id] = other


def _neighbours(
    region: str, shared: Mapping[Pair, Sequence[BoundarySegment]]
) -> list[tuple[str, Sequence[BoundarySegment]]]:
    return [(b if a == region else a, boundaries) for (a, b), boundaries in shared.items() if region in (a, b)]


def _repair_cost(region: Region, other: Region, boundaries: Sequence[BoundarySegment]) -> tuple[int, float]:
    """Rank a new passage: best through circulation, last through a wet room or a store, then by length of wall."""
    if other.node_kind == "main" or is_class(other.room_type, "circulation"):
        rank = 0
    elif is_class(other.room_type, "wet") or is_class(other.room_type, "store"):
        rank = 3
    elif is_class(other.room_type, "sleeping"):
        rank = 2
    else:
        rank = 1
    core_late = 0 if region.is_room else 4
    return rank + core_late, -max(boundary.length for boundary in boundaries)


def _detour(floor: FloorRegions, edge: tuple[str, str], repairs: Mapping[str, str]) -> str:
    for node in edge:
        region = floor.by_node[node]
        if region.id in repairs:
            return f"{region.id} opens to {repairs[region.id]}"
    return "reached through other rooms"

"""Exits, the ways to them, dead ends, lifts, and the widths of corridors and doors."""

import itertools
import math
from collections.abc import Iterator

import networkx as nx
from shapely import Polygon

from mansion_bringup.check.norms.premises import Deviation, Premises, rooms_of
from mansion_bringup.check.norms.walking import Place, exit_doors, ways_of
from mansion_bringup.check.shapes import net_area, segment_length
from mansion_knowledge.norms import Norm
from mansion_msgs_py.scene import FloorScene

__all__ = ["escape_deviations"]

_ROUNDING = 0.02


def escape_deviations(premises: Premises) -> Iterator[Deviation]:
    """Yield deviations from the rules of escape and access."""
    for scene in premises.scenes:
        yield from _exits(premises, scene)
    yield from _lift(premises)
    yield from _corridor_width(premises)
    yield from _door_width(premises)


def _exits(premises: Premises, scene: FloorScene) -> Iterator[Deviation]:
    norm = premises.norm("exits")
    if norm is None:
        return
    people = premises.people(scene)
    level = {0: "upper", 1: "ground", 2: "upper"}.get(scene.floor, "high")
    alone = people <= norm.limit(level)
    exits, where = exit_doors(scene), f"floor {scene.floor}"
    if not alone and len(exits) < 2:
        asked = f"2 for {people:.0f} occupants, as above {norm.limit(level):.0f}"
        yield premises.deviation(norm, where, f"{len(exits)} exit" + "s" * (len(exits) != 1), asked)
    yield from _distances(premises, scene, exits, "single_exit_travel" if alone else "travel_distance")
    if not alone and len(exits) > 1:
        yield from _dead_ends(premises, scene, exits)


def _distances(premises: Premises, scene: FloorScene, exits: list[str], rule: str) -> Iterator[Deviation]:
    norm = premises.norm(rule)
    ways = ways_of(scene)
    known = [door for door in exits if door in ways]
    if norm is None or not known:
        return
    reached = nx.multi_source_dijkstra_path_length(ways, known, weight="weight")
    for room in rooms_of(scene):
        far = max((reached.get((room.id, i), 0.0) for i in range(len(room.polygon))), default=0.0)
        if far > premises.limit(norm) + _ROUNDING:
            asked = f"at most {premises.limit(norm):.1f} m"
            yield premises.deviation(norm, room.id, f"{far:.1f} m to the nearest exit", asked)


def _dead_ends(premises: Premises, scene: FloorScene, exits: list[str]) -> Iterator[Deviation]:
    """Yield corridors with a place from which the ways to all exits begin with the same long stretch.

    Of a place and two exits, half of what its distances to them exceed theirs to each other is the stretch that both
    ways share; in a corridor, which branches like a tree, that is exact.
    """
    norm = premises.norm("dead_end")
    passages = [room for room in rooms_of(scene) if premises.knowledge.room(room.room_type).zone == "circulation"]
    ways = ways_of(scene, passages)
    found = {door: nx.single_source_dijkstra_path_length(ways, door, weight="weight") for door in exits if door in ways}
    if norm is None or len(found) < 2:
        return
    for room in passages:
        places: list[Place] = [(room.id, i) for i in range(len(room.polygon))]
        longest = max((_shared_stretch(found, place) for place in places), default=0.0)
        if longest > premises.limit(norm) + _ROUNDING:
            asked = f"at most {premises.limit(norm):.1f} m"
            yield premises.deviation(norm, room.id, f"a dead end of {longest:.1f} m", asked)


def _shared_stretch(found: dict[str, dict[Place, float]], place: Place) -> float:
    stretches = [
        (found[a][place] + found[b][place] - found[a][b]) / 2
        for a, b in itertools.combinations(found, 2)
        if place in found[a] and place in found[b] and b in found[a]
    ]
    return min(stretches, default=0.0)


def _lift(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("lift")
    storeys = len(premises.scenes)
    if norm is None or storeys <= premises.limit(norm):
        return
    if not any(core.type == "elevator" for scene in premises.scenes for core in scene.cores):
        asked = f"one, as above {premises.limit(norm):.0f} storey" + "s" * (premises.limit(norm) != 1)
        yield premises.deviation(norm, "building", f"{storeys} storeys and no lift", asked)


def _corridor_width(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("corridor_width")
    if norm is None:
        return
    for room in premises.of_types(norm.rooms):
        least = premises.limit(norm)
        shape = net_area(room)
        if not _is_passable(shape, least - _ROUNDING):
            steps = (least - 0.05 * step for step in range(1, int(least / 0.05)))
            width = next((width for width in steps if _is_passable(shape, width)), 0.0)
            yield premises.deviation(norm, room.id, f"narrows to about {width:.2f} m", f"{least:.2f} m")


def _is_passable(shape: Polygon, width: float) -> bool:
    inner = shape.buffer(-width / 2)
    return not inner.is_empty and inner.geom_type == "Polygon"


def _door_width(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("door_width")
    if norm is None:
        return
    kinds = {room.id: room.room_type for room in premises.rooms()}
    for scene in premises.scenes:
        for door in scene.doors:
            least = _widest(premises, norm, [kinds.get(name or "", "") for name in door.rooms])
            width = segment_length(door.segment)
            if width < least - _ROUNDING:
                yield premises.deviation(norm, door.id, f"{width:.2f} m clear", f"{least:.2f} m")


def _widest(premises: Premises, norm: Norm, kinds: list[str]) -> float:
    if any(premises.knowledge.room(kind).toilet or kind in ("bathroom", "") for kind in kinds):
        return norm.figure
    return max((norm.limit(kind) for kind in kinds), default=math.nan)

"""Rules on the exits of storeys and rooms: their number, distance and width, the ways to them, and dead ends."""

import itertools
import math
from collections.abc import Iterator

import networkx as nx

from mansion_bringup.check.norms.premises import ROUNDING, Deviation, Premises, rooms_of
from mansion_bringup.check.norms.walking import Place, exit_doors, middle_of, ways_of
from mansion_bringup.check.shapes import segment_length
from mansion_msgs_py.scene import FloorScene, StairDetails
from mansion_msgs_py.wording import counted

__all__ = ["escape_deviations"]


def escape_deviations(premises: Premises) -> Iterator[Deviation]:
    """Yield deviations from the rules of escape."""
    for scene in premises.scenes:
        yield from _exits(premises, scene)
        yield from _room_exits(premises, scene)


def _exits(premises: Premises, scene: FloorScene) -> Iterator[Deviation]:
    norm = premises.norm("exits")
    if norm is None:
        return
    people = premises.people(scene)
    level = {0: "upper", 1: "ground", 2: "upper"}.get(scene.floor, "high")
    limits = (norm.limit(level), norm.limit("three"), norm.limit("four"))
    needed = 1 + sum(people > limit for limit in limits)
    exits, where = exit_doors(scene), f"floor {scene.floor}"
    if len(exits) < needed:
        asked = f"{needed} for {people:.0f} occupants, as above {limits[needed - 2]:.0f}" if needed > 1 else "1"
        yield premises.deviation(norm, where, counted(len(exits), "exit"), asked)
    yield from _exit_width(premises, scene, exits, people)
    far = list(_distances(premises, scene, exits, "single_exit_travel")) if needed < 2 else []
    if needed < 2 and len(exits) < 2:
        yield from far
    elif needed > 1 or far:
        yield from _distances(premises, scene, exits, "travel_distance")
        if len(exits) > 1:
            yield from _exit_separation(premises, scene, exits)
            yield from _dead_ends(premises, scene, exits)


def _exit_width(premises: Premises, scene: FloorScene, exits: list[str], people: int) -> Iterator[Deviation]:
    norm = premises.norm("exit_width")
    if norm is None or not exits:
        return
    by_id = {door.id: segment_length(door.segment) for door in scene.doors}
    flights = {core.door: core.details.width for core in scene.cores if isinstance(core.details, StairDetails)}
    stairs = scene.floor != 1 and all(door in flights for door in exits)
    widths = [min(by_id[door], flights[door]) if stairs and flights[door] else by_id[door] for door in exits]
    needed = people * norm.limit("stair" if stairs else "")
    if sum(widths) < needed - ROUNDING:
        found = f"{sum(widths):.2f} m of {'stairs' if stairs else 'doors'}"
        yield premises.deviation(norm, f"floor {scene.floor}", found, f"{needed:.2f} m for {people} occupants")


def _exit_separation(premises: Premises, scene: FloorScene, exits: list[str]) -> Iterator[Deviation]:
    norm = premises.norm("exit_separation")
    if norm is None:
        return
    middles = [middle_of(door) for door in scene.doors if door.id in exits]
    apart = max((math.dist(one, other) for one, other in itertools.combinations(middles, 2)), default=0.0)
    xs, ys = zip(*scene.outline)
    least = premises.limit(norm) * math.hypot(max(xs) - min(xs), max(ys) - min(ys))
    if apart < least - ROUNDING:
        yield premises.deviation(norm, f"floor {scene.floor}", f"exits {apart:.1f} m apart", f"{least:.1f} m")


def _room_exits(premises: Premises, scene: FloorScene) -> Iterator[Deviation]:
    norm = premises.norm("room_exits")
    if norm is None:
        return
    for room in rooms_of(scene):
        people = premises.norms.people(room.room_type, room.area, premises.knowledge)
        doors = sum(room.id in door.rooms for door in scene.doors)
        if round(people) > premises.limit(norm, room.room_type) and doors < 2:
            yield premises.deviation(norm, room.id, counted(doors, "door"), f"2 for {people:.0f} occupants")


def _distances(premises: Premises, scene: FloorScene, exits: list[str], rule: str) -> Iterator[Deviation]:
    norm = premises.norm(rule)
    ways = ways_of(scene)
    known = [door for door in exits if door in ways]
    if norm is None or not known:
        return
    reached = nx.multi_source_dijkstra_path_length(ways, known, weight="weight")
    limit = premises.limit(norm)
    distances = {
        room.id: max((reached.get((room.id, i), 0.0) for i in range(len(room.polygon))), default=0.0)
        for room in rooms_of(scene)
    }
    too_far = sorted((far, room) for room, far in distances.items() if far > limit + ROUNDING)
    if too_far:
        far, room = too_far[-1]
        others = f", from {counted(len(too_far) - 1, 'other room')} more than is asked" if len(too_far) > 1 else ""
        exits_there = f"the nearest of {counted(len(known), 'exit')}"
        yield premises.deviation(norm, room, f"{far:.1f} m to {exits_there}{others}", f"at most {limit:.1f} m")


def _dead_ends(premises: Premises, scene: FloorScene, exits: list[str]) -> Iterator[Deviation]:
    """Yield corridors with a place from which the ways to all exits begin with the same long stretch.

    The ways from a place to two exits share half of the sum of their lengths less the distance between the exits; in a
    corridor, which branches like a tree, that is exact.
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
        if longest > premises.limit(norm) + ROUNDING:
            asked = f"at most {premises.limit(norm):.1f} m"
            yield premises.deviation(norm, room.id, f"a dead end of {longest:.1f} m", asked)


def _shared_stretch(found: dict[str, dict[Place, float]], place: Place) -> float:
    stretches = [
        (found[a][place] + found[b][place] - found[a][b]) / 2
        for a, b in itertools.combinations(found, 2)
        if place in found[a] and place in found[b] and b in found[a]
    ]
    return min(stretches, default=0.0)

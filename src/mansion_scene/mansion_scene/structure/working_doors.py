"""Doors between rooms that are used together, such as a kitchen and its store."""

from collections.abc import Collection, Mapping, Sequence

from mansion_knowledge import default_knowledge, is_class
from mansion_knowledge.leads_into import CalledRoom, leading_rules
from mansion_knowledge.norms import load_norms
from mansion_scene.structure.access import Pair, pair_key
from mansion_scene.structure.boundaries import BoundarySegment
from mansion_scene.structure.door_positions import Frontage, choose_position
from mansion_scene.structure.openings import (
    BED_WIDTH,
    Opening,
    is_circulation,
    narrower_widths,
    opening_at,
    opening_kind,
    with_doors,
)
from mansion_scene.structure.regions import FloorRegions, Region

__all__ = ["place_working_doors"]


def place_working_doors(
    floor: FloorRegions,
    shared: Mapping[Pair, Sequence[BoundarySegment]],
    openings: Sequence[Opening],
    frontages: Mapping[str, Frontage],
    building_type: str,
    wished: Collection[Pair] = (),
) -> list[Opening]:
    """Place a door between rooms that share a wall and lead into each other by use, in addition to the existing ones.

    A room is reached so from one other of each use, the storey's hub aside: the cold store from the kitchen that it has
    the longest wall with. Doors that the walls have no place for are left out.

    Parameters
    ----------
    wished : collection of (str, str)
        Rooms that the brief wants side by side: a store among them leads into the other.
    """
    known = default_knowledge().buildings.get(building_type.replace(" ", "_"))
    family = known.family if known is not None else ""
    rooms = sorted((region for region in floor.regions if region.is_room), key=lambda region: region.id)
    joined = {pair_key(a, b) for a, b in (opening.regions for opening in openings) if b is not None}
    placed: list[Opening] = []
    for into in rooms:
        beside = [room for room in rooms if pair_key(room.id, into.id) in shared]
        beside.sort(key=lambda room: -_longest(shared[pair_key(room.id, into.id)]))
        led = [room for room in beside if pair_key(room.id, into.id) in joined and not is_circulation(room)]
        met = {rule for room in led for rule in _rules(room, into, family)}
        for room in beside:
            pair = pair_key(room.id, into.id)
            stored = pair in wished and _is_fetched(room, into)
            rules = set(_rules(room, into, family)) - met | ({_WISHED} if stored else set())
            door = _door(room, into, shared[pair], frontages) if rules and pair not in joined else None
            if door is not None:
                placed.append(door)
                frontages = with_doors(frontages, [door])
                joined.add(pair)
                met |= rules
    return placed


_WISHED = -1
"""Stands for the rule that what is kept beside a room is fetched into it."""


def _is_fetched(room: Region, store: Region) -> bool:
    """Whether things are fetched from a store into a room: people do not fetch them to where they wash or sleep."""
    bare = is_class(room.room_type, "wet") or is_class(room.room_type, "sleeping")
    return is_class(store.room_type, "store") and not bare


def _rules(room: Region, into: Region, family: str) -> tuple[int, ...]:
    return leading_rules(_called(room), _called(into), family)


def _called(region: Region) -> CalledRoom:
    return CalledRoom(region.room_type, f"{region.name} {region.node}".replace("_", " "))


def _longest(walls: Sequence[BoundarySegment]) -> float:
    return round(max(wall.length for wall in walls), 3)


def _door(
    room: Region, into: Region, walls: Sequence[BoundarySegment], frontages: Mapping[str, Frontage]
) -> Opening | None:
    """Return the best door between two rooms; ``None`` where their wall has no space for one that is wide enough."""
    kind = opening_kind(room, into)
    if is_class(into.room_type, "outdoor"):
        return None
    rule = load_norms().rules["door_width"]
    least = max(rule.limit(region.room_type) for region in (room, into))
    widths = narrower_widths(max(kind.width, BED_WIDTH) if least > kind.width else kind.width)
    for width in (width for width in widths if width >= least):
        position = choose_position(walls, frontages, width)
        if position is not None:
            return opening_at(position, kind)
    return None

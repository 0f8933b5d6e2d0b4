"""Toilets of the entrance storey as the rules of building ask: for men, for women, and one for wheelchairs."""

import math
from collections.abc import Sequence

import msgspec

from mansion_knowledge import KnowledgeBase
from mansion_knowledge.norms import load_norms
from mansion_planner.program.allocation import Allocation
from mansion_planner.program.model import PlannedRoom, Storey
from mansion_planner.program.planned_rooms import planned_room

__all__ = ["TOILETS", "with_public_toilets"]

_STALL = 5.0
"""Square metres of a restroom for one water closet or urinal, with its basin and the way to it."""

_LEAST = 8.0
"""Square metres of a restroom for one sex."""

_MOST_SHARE = 0.15
"""Of a storey's rooms, what toilets may take beyond those of its own list: a small storey keeps its rooms."""

TOILETS = ("restroom", "toilet", "accessible_toilet")
"""Types of rooms that "the toilets" of a building may be."""


def with_public_toilets(
    storey: Storey, rooms: Sequence[PlannedRoom], allocation: Allocation, knowledge: KnowledgeBase, hub: float
) -> list[PlannedRoom]:
    """Return the rooms of a storey; on the entrance storey of a public building with the toilets of the rules.

    Toilets that the brief states or refuses stay as they are.

    Parameters
    ----------
    hub : float
        Square metres of the storey's hub, where it is its main room.
    """
    kept = list(rooms)
    own = [room for room in kept if room.kind.name in TOILETS]
    settled = any(room.stated for room in own) or not all(allocation.adds(name, storey.index) for name in TOILETS)
    if settled or storey.role not in ("single", "ground"):
        return kept
    before, whole = sum(room.gross for room in own), sum(room.gross for room in kept)
    choices = _choices(storey, kept, knowledge, hub)
    most = [_MOST_SHARE * (whole + (hub if number else 0.0)) + before for number in range(len(choices))]
    wanted = next((rooms for rooms, area in zip(choices, most) if sum(room.gross for room in rooms) <= area), None)
    if wanted is None:
        return kept
    place = kept.index(own[0]) if own else len(kept)
    others = [room for room in kept if room not in own]
    return [*others[:place], *wanted, *others[place:]]


def _choices(
    storey: Storey, rooms: Sequence[PlannedRoom], knowledge: KnowledgeBase, hub: float
) -> list[list[PlannedRoom]]:
    """Return the toilets for a storey's occupants, the best first, then for small storeys; none where its own do.

    Where one water closet is enough for each sex, two accessible toilets may serve instead of separate restrooms
    (International Plumbing Code 2018, 403.2.1).
    """
    norms, family, kind = load_norms(), storey.use.family, storey.use.name
    separate = norms.rules["separate_toilets"]
    if not separate.holds_for(family):
        return []
    restroom, accessible = knowledge.room("restroom"), knowledge.room("accessible_toilet")
    people = norms.people(storey.hub.name, hub, knowledge)
    people += sum(norms.people(room.kind.name, room.area, knowledge) for top in rooms for room in top.each())
    limits = {name: norms.rules[f"water_closets_{name}"].limit(kind, family) for name in ("men", "women")}
    small = planned_room(accessible, knowledge, area=accessible.least)
    if people <= separate.limit(kind, family):
        return [] if any(room.kind.toilet for room in rooms) else [[small]]
    closets = {name: math.ceil(people / 2 / limit) for name, limit in limits.items()}
    toilets = []
    for name in limits:
        room = planned_room(restroom, knowledge, area=max(_LEAST, _STALL * closets[name]))
        toilets.append(msgspec.structs.replace(room, id=f"{name}s_restroom", base=f"{name}s_restroom"))
    choices = [[*toilets, planned_room(accessible, knowledge)]]
    return choices if max(closets.values()) > 1 else [*choices, [small, small]]

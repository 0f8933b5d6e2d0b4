"""Rooms of a public building's storey that people pass from one into the other, so that they are to share a wall."""

import itertools

from mansion_knowledge.leads_into import CalledRoom, leading_rules
from mansion_planner.program.model import PlannedRoom, Storey

__all__ = ["pairs_used_together"]


def pairs_used_together(storey: Storey) -> list[tuple[str, str]]:
    """Return the rooms of a storey that are used together, by name: the one that leads into the other last.

    Homes have pairs of their own (`home_orders`).
    """
    family = storey.use.family
    if family == "home":
        return []
    pairs = [
        (into.base, room.base)
        for room, into in itertools.permutations(storey.rooms, 2)
        if room.base != into.base and leading_rules(_called(room), _called(into), family)
    ]
    return list(dict.fromkeys(pairs))


def _called(room: PlannedRoom) -> CalledRoom:
    return CalledRoom(room.kind.name, f"{room.label} {room.base}".replace("_", " "))

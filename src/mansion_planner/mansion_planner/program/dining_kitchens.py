"""The kitchen of a room where meals are served, as the rules of building ask."""

from collections.abc import Sequence

import msgspec

from mansion_knowledge import KnowledgeBase
from mansion_knowledge.norms import load_norms
from mansion_planner.program.allocation import Allocation
from mansion_planner.program.model import PlannedRoom, Storey
from mansion_planner.program.planned_rooms import planned_room

__all__ = ["with_kitchen"]

_KITCHEN = "commercial_kitchen"

_OF_DINING = 0.35
"""Area of a kitchen to that of the room that it cooks for."""

_TIGHT = 0.8
"""Share of that area to which it may shrink."""


def with_kitchen(
    rooms: Sequence[PlannedRoom], storey: Storey, allocation: Allocation, knowledge: KnowledgeBase, hub: float = 0.0
) -> list[PlannedRoom]:
    """Return the rooms of a storey, with a kitchen where meals are served without one and the brief allows it.

    A single kitchen that the brief asks for is as large as its guests need.

    Parameters
    ----------
    hub : float
        Square metres of the storey's hub, where it is its main room.
    """
    rule, kept = load_norms().rules["kitchen_of_dining"], list(rooms)
    dining = [room for room in kept if room.kind.name in rule.rooms]
    served = sum(room.area for room in dining) + (hub if storey.hub.name in rule.rooms else 0.0)
    least = _OF_DINING * served
    cooks = [room for top in kept for room in top.each() if room.kind.name in rule.others]
    if served and len(cooks) == 1 and not cooks[0].fixed and cooks[0].area < least:
        area = min(least, knowledge.room(_KITCHEN).usual)
        return [room.changed(lambda one: _at_least(one, area) if one is cooks[0] else one) for room in kept]
    refused = not all(allocation.adds(name, storey.index) for name in (_KITCHEN, "kitchen"))
    if not served or cooks or refused:
        return kept
    kind = knowledge.room(_KITCHEN)
    kitchen = planned_room(kind, knowledge, area=min(max(_OF_DINING * served, kind.least), kind.usual))
    place = kept.index(dining[0]) + 1 if dining else 0
    return [*kept[:place], kitchen, *kept[place:]]


def _at_least(kitchen: PlannedRoom, area: float) -> PlannedRoom:
    """Return a kitchen of no less than `area` square metres."""
    area = max(area, kitchen.area)
    return msgspec.structs.replace(
        kitchen, area=area, least=max(kitchen.least, _TIGHT * area), most=max(kitchen.most, area)
    )

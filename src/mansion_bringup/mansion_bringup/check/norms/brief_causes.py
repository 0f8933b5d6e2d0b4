"""Deviations that the brief itself asks for."""

from mansion_bringup.check.norms.premises import Deviation, Premises
from mansion_knowledge.norms import Norm
from mansion_msgs_py.wishes import Wish

__all__ = ["cause_of"]


def cause_of(premises: Premises, deviation: Deviation) -> str:
    """Return the words of the brief that ask for a deviation explicitly; empty where none do."""
    norm = premises.norms.rules[deviation.rule]
    if "outline" in norm.gives_way and premises.building.request.footprint is not None:
        return "the given footprint"
    wishes = (wish for wish in premises.building.wishes if wish.kind in norm.gives_way and wish.status == "met")
    return next((wish.text for wish in wishes if _asks_for_it(wish, norm, deviation)), "")


def _asks_for_it(wish: Wish, norm: Norm, deviation: Deviation) -> bool:
    value = wish.value
    concerned = any(room in deviation.where.split(" and ") for room in wish.rooms)
    match wish.kind:
        case "room" if norm.yields_to:
            return value.count is not None and value.type in norm.yields_to
        case "room":
            return concerned and value.area is not None
        case "no_room":
            return value.type in (*norm.yields_to, *norm.rooms, *norm.others)
        case "elevator":
            return value.unwanted
        case "stair":
            return value.unwanted or value.count == 1
        case "adjacent" | "apart" | "object" | "no_object":
            return concerned
        case "only" | "total_area" | "floor_area":
            return True
    return False

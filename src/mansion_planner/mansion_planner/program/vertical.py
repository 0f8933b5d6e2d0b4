"""Decide how storeys connect: stairs and lifts by height, use and brief."""

from typing import Literal

from mansion_knowledge import KnowledgeBase
from mansion_planner.program.allocation import Allocation
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.model import Storey
from mansion_planner.program.storeys import entries_of

__all__ = ["vertical_method"]

_MOST_LIFTS = 2
"""Lifts that a massing has places for."""

Method = Literal["none", "stair", "elevator", "stair_and_elevator"]


def vertical_method(
    decisions: Decisions, storeys: list[Storey], allocation: Allocation, knowledge: KnowledgeBase
) -> tuple[Method, int, int, str]:
    """Return the method, the numbers of stairs and lifts, and the reason."""
    levels = len(storeys)
    wishes = dict(decisions.facts.vertical)
    if levels == 1:
        return "none", 0, 0, "one storey needs no stair"
    home = decisions.building.family == "home"
    lifts = 0
    if levels >= (5 if home else 4 if decisions.building.parti == "house" else 3) or (
        decisions.building.stretcher and levels > 1
    ):
        lifts = 1
    if not home and levels >= 8 and decisions.area > 300:
        lifts = 2
    reason = f"{levels} storeys"
    if "no_elevator" in wishes:
        lifts, reason = 0, f'{levels} storeys, "{wishes["no_elevator"].words}"'
    elif "elevator" in wishes and lifts == 0:
        lifts, reason = 1, f'{levels} storeys, "{wishes["elevator"].words}"'
    wanted_lifts = max((int(quantity.value) for quantity in decisions.facts.lifts), default=0)
    if wanted_lifts and "no_elevator" not in wishes:
        lifts, reason = min(wanted_lifts, _MOST_LIFTS), f'{levels} storeys, "{decisions.facts.lifts[0].span.words}"'
    if "no_stair" in wishes:
        return "elevator", 0, max(lifts, 1), f'elevator alone, as "{wishes["no_stair"].words}" asks'
    stairs = 1
    largest = max(
        [fact.area or knowledge.room(fact.room_type).usual for facts in allocation.wanted.values() for fact in facts]
        + [entry.area or knowledge.room(entry.room_type).usual for storey in storeys for entry in entries_of(storey)],
        default=0.0,
    )
    if (
        not home
        and decisions.building.parti == "spine"
        and levels >= 3
        and decisions.area >= 340
        and largest <= 150
        and not decisions.facts.setback
        and not decisions.facts.protruding
    ):
        stairs = 2
        reason += ", more than 340 m2 a storey: a second stair at the far end"
    wanted_stairs = max((int(quantity.value) for quantity in decisions.facts.stairs), default=0)
    if wanted_stairs == 1:
        stairs = 1
    method: Method = "stair_and_elevator" if lifts else "stair"
    return method, stairs, lifts, f"{method.replace('_', ' ')} for {reason}"

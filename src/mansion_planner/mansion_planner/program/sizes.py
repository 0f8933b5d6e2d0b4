"""The gross area of a storey: stated, or what the rooms need."""

from mansion_knowledge import KnowledgeBase
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.wording import with_article
from mansion_planner.program.allocation import Allocation, planned_room
from mansion_planner.program.areas import AREA_CAP
from mansion_planner.program.decisions import Decisions, conflict
from mansion_planner.program.filling import base_rooms, hub_area
from mansion_planner.program.inference import note
from mansion_planner.program.massing import least_area
from mansion_planner.program.model import Storey
from mansion_planner.program.storeys import entries_of, is_hall

__all__ = ["storey_area", "typical_room"]

_SQUEEZE = 1.3
"""By how much rooms may ask for more than the stated area, at their least usual sizes: they are then made smaller."""

_HOPELESS = 1.5
"""From what share of the stated area on no building can hold the rooms asked for."""


def _circulation(decisions: Decisions, stairs: int, lifts: int) -> tuple[float, float]:
    """Return what cores and lobby take, and the share of the rest that corridors take."""
    cores = 18.0 * stairs + 4.0 * lifts
    if is_hall(decisions):
        return cores, 0.0
    return cores + (24.0 if lifts else 0.0), 0.17


def storey_area(
    decisions: Decisions,
    storeys: list[Storey],
    allocation: Allocation,
    knowledge: KnowledgeBase,
    stairs: int,
    lifts: int,
) -> float:
    """Return the gross area of a storey in square metres.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` when the rooms asked for do not fit into the area asked for.
    """
    fixed, share = _circulation(decisions, stairs, lifts)
    need, fullest, least = 0.0, storeys[0], 0.0
    for storey in storeys:
        rooms = base_rooms(storey, allocation, knowledge)
        hub = hub_area(storey, allocation) or storey.hub.least if is_hall(decisions) else 0.0
        wished = sum(room.gross for room in rooms)
        tight = sum(max(r.least, 0.0) for room in rooms for r in room.each()) + hub
        least = max(least, (tight + fixed) / (1.0 - 0.6 * share))
        if wished + hub > need:
            need, fullest = wished + hub, storey
    if decisions.area_stated:
        if least > decisions.area * _SQUEEZE:
            least = _grown(decisions, storeys, allocation, fullest, least)
        return decisions.area if least <= decisions.area * _SQUEEZE else least
    asked = (need + fixed) / (1.0 - share) * 1.02
    usual = decisions.area
    if decisions.building.parti != "spine":
        typical = _typical(decisions, storeys, allocation, knowledge, fixed, share)
        small = any(word == "small" for word, _ in decisions.facts.size)
        usual = typical * 0.85 if small else min(typical, 1.5 * usual)
    result = max(usual, asked, decisions.building.floor_area[0])
    if decisions.facts.shapes:
        result = max(result, least_area(decisions.facts.shapes[0][0]))
    if result > usual + 1.0 and asked > usual:
        note(decisions.trace, None, f"{result:.0f} m2 a storey, for the rooms of storey {fullest.index}")
    if result > AREA_CAP:
        note(decisions.trace, None, f"above {AREA_CAP:.0f} m2 a storey, for the rooms asked for")
    return result


def _grown(decisions: Decisions, storeys: list[Storey], allocation: Allocation, fullest: Storey, least: float) -> float:
    """Return the area that the rooms asked for need, and record that the stated one gave way.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` when the rooms alone take far more than the area asked for, or the outline is given.
    """
    facts = allocation.wanted[fullest.index]
    words = ", ".join(dict.fromkeys(fact.span.words for fact in facts))
    words = words or f"the rooms of {with_article(fullest.use.name.replace('_', ' '))}"
    given = decisions.area_span.startswith("$.")
    asked = sum(fact.area or 4.0 for storey in storeys for fact in allocation.wanted[storey.index])
    if given or asked > _HOPELESS * decisions.area * len(storeys):
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"{words} on storey {fullest.index} need at least {least:.0f} m2 with stairs and corridors; "
            f"{decisions.area_span} leaves {decisions.area:.0f} m2",
            path=decisions.area_span.split()[0] if given else "$.description",
            details={"first": words, "second": decisions.area_span, "stage": "program"},
        )
    wish = decisions.area_span.partition('"')[2].partition('"')[0] or decisions.area_span
    reason = f"{words} on storey {fullest.index} need it, with stairs and corridors"
    decisions.downgrades.append(conflict(wish, f"{least:.0f} m2 a storey", reason, fullest.index))
    return least


def _typical(
    decisions: Decisions,
    storeys: list[Storey],
    allocation: Allocation,
    knowledge: KnowledgeBase,
    fixed: float,
    share: float,
) -> float:
    """What a storey's own list and the rooms asked for take at their usual sizes."""
    most = 0.0
    for storey in storeys:
        total = sum(room.gross for room in base_rooms(storey, allocation, knowledge))
        if is_hall(decisions):
            total += 1.3 * storey.hub.usual
        for entry in entries_of(storey):
            if not allocation.adds(entry.room_type, storey.index) or entry.repeat:
                continue
            kind = knowledge.room(entry.room_type)
            total += entry.count * planned_room(kind, knowledge, area=entry.area).gross
        most = max(most, total)
    return (most + fixed) / (1.0 - share)


def typical_room(storeys: list[Storey], allocation: Allocation, knowledge: KnowledgeBase) -> float:
    """Return the median area of the rooms above 8 m2 on a typical storey, square metres."""
    areas: list[float] = []
    for storey in storeys:
        if storey.index < 1:
            continue
        areas += [room.gross for room in base_rooms(storey, allocation, knowledge)]
        for entry in entries_of(storey):
            kind = knowledge.room(entry.room_type)
            gross = planned_room(kind, knowledge, area=entry.area).gross
            areas += [gross] * (entry.count + 2 * entry.repeat)
    areas = sorted(area for area in areas if 8.0 <= area <= 90.0)
    return areas[len(areas) // 2] if areas else 40.0

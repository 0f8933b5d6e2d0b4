"""Resolve the numbers of a brief (Algorithm 1, line 1): type, storeys, areas, style; refuse what contradicts itself."""

import numpy as np

from mansion_knowledge import BuildingType, KnowledgeBase
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import Downgrade, TraceEntry
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief.facts import BriefFacts, FloorRef, Span
from mansion_planner.program.areas import area_of_footprint, settle_area
from mansion_planner.program.decisions import Decisions, contradiction, one_value, quoted
from mansion_planner.program.inference import MOST_FLOORS, infer_building, infer_floors, note

__all__ = ["decide"]


def decide(
    request: BuildRequest, facts: BriefFacts, knowledge: KnowledgeBase, generator: np.random.Generator
) -> Decisions:
    """Resolve type, storeys, area and style.

    Raises
    ------
    MansionError
        ``CONTRADICTION`` with both places, ``INFEASIBLE`` for numbers that no building can meet.
    """
    trace: list[TraceEntry] = []
    building = _building(facts, knowledge, trace)
    floors = _floors(request, facts, building, trace, generator)
    basements = _basements(facts, trace)
    style = building.style
    if facts.styles:
        style = facts.styles[0][0]
        note(trace, facts.styles[0][1], f"style {style}")
    _check_wishes(facts)
    decisions = Decisions(building, floors, basements, 0.0, False, "", style, facts, request.seed, trace=trace)
    if building.name == "bungalow" and floors > 1:
        decisions.downgrades.append(
            Downgrade(
                wish="bungalow", got=f"a house of {floors} storeys", stage="program",
                reason="a bungalow has one storey, and the number of storeys is stated",
            )
        )  # fmt: skip
    if request.footprint is not None:
        area_of_footprint(request, decisions)
    else:
        settle_area(request, decisions, generator)
    return decisions


def _check_wishes(facts: BriefFacts) -> None:
    """Refuse wishes that exclude each other."""
    wishes: dict[str, Span] = {}
    for name, span in facts.vertical:
        opposite = wishes.get(name[3:] if name.startswith("no_") else f"no_{name}")
        if opposite is not None:
            raise contradiction(f"{name.replace('_', ' ')}", quoted(opposite), quoted(span))
        wishes.setdefault(name, span)
    shapes = dict(reversed(facts.shapes))
    if len(shapes) > 1:
        first, second = list(shapes.values())[-1], list(shapes.values())[-2]
        raise contradiction("two outlines", quoted(first), quoted(second))
    no_basement = next((span for name, span in facts.excluded if name == "basement"), None)
    below = next((ref for room in facts.rooms for ref in room.floors if ref.kind == "basement"), None)
    if no_basement is not None and (below is not None or facts.basements):
        other = below.span if below is not None else facts.basements[0].span
        raise contradiction("a basement", quoted(no_basement), quoted(other))
    counted: dict[str, tuple[int, Span]] = {}
    for room in facts.rooms:
        if room.floors or room.each or room.count is None or room.count < 2 or room.area is not None:
            continue
        earlier = counted.setdefault(room.name, (room.count, room.span))
        if earlier[0] != room.count:
            raise contradiction(f"two numbers of {room.name}", quoted(earlier[1]), quoted(room.span))


def _building(facts: BriefFacts, knowledge: KnowledgeBase, trace: list[TraceEntry]) -> BuildingType:
    if facts.building:
        name, span = facts.building[0]
        note(trace, span, f"building type {name}")
        return knowledge.buildings[name]
    name = infer_building(facts)
    building = knowledge.buildings.get(name) or next(iter(knowledge.buildings.values()))
    note(trace, None, f"no building type is named: {building.name} suits the rooms best")
    return building


def _floors(
    request: BuildRequest,
    facts: BriefFacts,
    building: BuildingType,
    trace: list[TraceEntry],
    generator: np.random.Generator,
) -> int:
    stated = one_value(facts.floors, "numbers of storeys")
    needed, place = _highest(facts)
    if stated is not None and not 1 <= stated.value <= MOST_FLOORS:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"{quoted(stated.span)} asks for {stated.value:g} storeys; 1 to {MOST_FLOORS} can be planned",
            path="$.description",
            details={"stage": "program"},
        )
    if request.floors is not None:
        if stated is not None and int(stated.value) != request.floors:
            raise contradiction(
                "the number of storeys", f"$.floors = {request.floors}", quoted(stated.span), "$.floors"
            )
        count, words, span = request.floors, f"$.floors = {request.floors}", None
        note(trace, None, f"{count} storeys, as the request states")
    elif stated is not None:
        count, words, span = int(stated.value), quoted(stated.span), stated.span
        note(trace, span, f"{count} storeys")
    else:
        return infer_floors(facts, building, needed, trace, generator)
    if place is not None and needed > count:
        raise contradiction(f"a storey that the building does not have (it has {count})", quoted(place.span), words)
    return count


def _highest(facts: BriefFacts) -> tuple[int, FloorRef | None]:
    refs = [ref for room in facts.rooms for ref in room.floors]
    refs += [ref for use in facts.uses for ref in use.floors] + [copy.first for copy in facts.copies]
    refs = [ref for ref in refs if ref.kind in ("number", "range")]
    if not refs:
        return 0, None
    ref = max(refs, key=lambda entry: entry.last)
    return ref.last, ref


def _basements(facts: BriefFacts, trace: list[TraceEntry]) -> int:
    stated = max(facts.basements, key=lambda q: q.value, default=None)
    named = any(ref.kind == "basement" for room in facts.rooms for ref in room.floors)
    count = int(stated.value) if stated is not None else int(named)
    if count > 10:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"{count} basement storeys are asked for; up to 10 can be planned",
            path="$.description",
            details={"stage": "program"},
        )
    if count:
        note(trace, stated.span if stated else None, f"{count} basement storeys")
    return count

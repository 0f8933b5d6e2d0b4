"""Resolve the numbers of a brief (Algorithm 1, line 1): type, storeys, areas, style; settle what contradicts itself."""

from dataclasses import replace

import numpy as np

from mansion_knowledge import BuildingType, KnowledgeBase
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import Downgrade, TraceEntry
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief.facts import BriefFacts, FloorRef, Span
from mansion_planner.program.areas import area_of_footprint, settle_area
from mansion_planner.program.decisions import Decisions, conflict, quoted
from mansion_planner.program.inference import MOST_FLOORS, infer_building, infer_floors, note

__all__ = ["decide"]


def decide(
    request: BuildRequest, facts: BriefFacts, knowledge: KnowledgeBase, generator: np.random.Generator
) -> Decisions:
    """Resolve type, storeys, area and style; statements that exclude each other are settled and recorded.

    Fields of the request win over the text; in the text explicit counts and storeys win over rooms, rooms over areas.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` for numbers beyond the limits of a program.
    """
    trace: list[TraceEntry] = []
    given_way: list[Downgrade] = []
    facts = _settled(facts, given_way)
    building = _building(facts, knowledge, trace)
    floors, facts = _floors(request, facts, building, trace, generator, given_way)
    basements = _basements(facts, trace)
    style = building.style
    if facts.styles:
        style = facts.styles[0][0]
        note(trace, facts.styles[0][1], f"style {style}")
    decisions = Decisions(
        building, floors, basements, 0.0, False, "", style, facts, request.seed, trace=trace, downgrades=given_way
    )
    if building.name == "bungalow" and floors > 1:
        reason = "a bungalow has one storey, and the number of storeys is stated"
        decisions.downgrades.append(conflict("bungalow", f"a house of {floors} storeys", reason))
    if request.footprint is not None:
        area_of_footprint(request, decisions)
    else:
        settle_area(request, decisions, generator)
    return decisions


def _settled(facts: BriefFacts, given_way: list[Downgrade]) -> BriefFacts:
    """Return the facts without those that exclude others; record what gave way."""
    facts = replace(facts, vertical=_vertical_of(facts, given_way))
    if len({shape for shape, _ in facts.shapes}) > 1:
        kept, other = facts.shapes[0], next(entry for entry in facts.shapes if entry[0] != facts.shapes[0][0])
        given_way.append(conflict(other[1].words, f"outline {kept[0]}", "the outline named first is kept"))
        facts = replace(facts, shapes=[kept])
    below = next((ref for room in facts.rooms for ref in room.floors if ref.kind == "basement"), None)
    unwanted = next((span for name, span in facts.excluded if name == "basement"), None)
    if unwanted is not None and (below is not None or facts.basements):
        words = below.span.words if below is not None else facts.basements[0].span.words
        given_way.append(conflict(unwanted.words, "a basement", f'"{words}" asks for it'))
        facts = replace(facts, excluded=[entry for entry in facts.excluded if entry[0] != "basement"])
    return facts


def _vertical_of(facts: BriefFacts, given_way: list[Downgrade]) -> list[tuple[str, Span]]:
    """Return the wishes for stairs and lifts; what is not wanted wins over what is, but one way up stays."""
    unwanted = {name for name, _ in facts.vertical if name.startswith("no_")}
    kept = []
    for name, span in facts.vertical:
        if f"no_{name}" in unwanted:
            given_way.append(conflict(span.words, f"no {name}", "the brief says elsewhere that it is not wanted"))
        elif (name, span) not in kept:
            kept.append((name, span))
    return kept


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
    given_way: list[Downgrade],
) -> tuple[int, BriefFacts]:
    """Return the number of storeys, and the facts without storeys that the building does not have."""
    stated = facts.floors[0] if facts.floors else None
    needed, place = _highest(facts)
    if stated is not None and not 1 <= stated.value <= MOST_FLOORS:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"{quoted(stated.span)} asks for {stated.value:g} storeys; 1 to {MOST_FLOORS} can be planned",
            path="$.description",
            details={"stage": "program"},
        )
    if request.floors is not None:
        count = request.floors
        if stated is not None and int(stated.value) != count:
            given_way.append(conflict(stated.span.words, f"{count} storeys", "the request's own field says so"))
        note(trace, None, f"{count} storeys, as the request states")
    elif stated is not None:
        count = int(stated.value)
        note(trace, stated.span, f"{count} storeys")
        reason = f'"{stated.span.words}" is the larger number'
        given_way += [conflict(other.span.words, f"{count} storeys", reason) for other in facts.floors[1:]]
    else:
        return infer_floors(facts, building, needed, trace, generator), facts
    if place is not None and needed > count:
        reason = f"the building has {count} {'storeys' if count > 1 else 'storey'}"
        given_way.append(conflict(place.span.words, f"storey {count}", reason, count))
    return count, facts


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

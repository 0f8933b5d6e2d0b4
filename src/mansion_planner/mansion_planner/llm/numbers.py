"""Resolve what the brief leaves open with a model: type, style, storeys, area (Algorithm 1, line 1)."""

import dataclasses
from dataclasses import dataclass

import msgspec

from mansion_geometry.randomness import item_generator
from mansion_llm import Fault, Prompt, quoted_data
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.program import TraceEntry
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief.facts import BriefFacts, Quantity, Span
from mansion_planner.llm.answers import NumbersAnswer
from mansion_planner.llm.cleaning import clean_text
from mansion_planner.llm.context import ARCHITECT, CLOSING, Context, number
from mansion_planner.program.building import PlannedBuilding, plan_program
from mansion_planner.program.decisions import AREA_CAP

__all__ = ["INFERRED_FLOORS", "plan_reference", "planned_from"]

INFERRED_FLOORS = 10
"""Most storeys that are inferred (section B.1)."""

_INFERRED = Span("", 0, 0)


@dataclass(frozen=True)
class _Open:
    """What the brief and the request leave to be inferred."""

    floors: bool
    area: bool
    building: bool
    style: bool

    @property
    def any(self) -> bool:
        return self.floors or self.area or self.building or self.style


def _open(request: BuildRequest, facts: BriefFacts) -> _Open:
    area = not (request.area or request.floor_area or request.footprint or facts.area or facts.floor_area)
    return _Open(
        floors=request.floors is None and not facts.floors,
        area=area,
        building=not facts.building,
        style=not facts.styles,
    )


def planned_from(facts: BriefFacts, request: BuildRequest, context: Context, building_id: str) -> PlannedBuilding:
    """Plan facts by rules, which leaves them as they are.

    Raises
    ------
    MansionError
        See `mansion_planner.plan.plan_building`.
    """
    generator = item_generator(request.seed, "program")
    return plan_program(request, dataclasses.replace(facts), context.knowledge, building_id, generator)


def plan_reference(context: Context, request: BuildRequest, facts: BriefFacts, building_id: str) -> PlannedBuilding:
    """Plan by rules with the model's numbers where the brief states none.

    Returns
    -------
    PlannedBuilding
        Outline, cores and a complete program: the geometry that the later steps plan in, and what they fall back to.

    Raises
    ------
    MansionError
        See `mansion_planner.plan.plan_building`.
    """

    def plan(using: BriefFacts) -> PlannedBuilding:
        return planned_from(using, request, context, building_id)

    reference = plan(facts)
    left = _open(request, facts)
    if not context.client.wants("numbers") or not left.any:
        context.from_rules("numbers", "" if left.any else "the brief states them")
        return reference
    prompt = _numbers_prompt(context, request, facts, reference)

    def check(answer: NumbersAnswer) -> list[Fault]:
        faults = _faults(answer, left, context)
        if not faults:
            try:
                plan(_with_answer(facts, answer, left))
            except MansionError as error:
                faults.append(Fault(f"the offline rules refuse these numbers: {error.info.message}"))
        return faults

    answer = context.client.ask(prompt, NumbersAnswer, check)
    if answer.value is None or not answer.good:
        context.from_rules("numbers", answer.reason)
        return reference
    planned = plan(_with_answer(facts, answer.value, left))
    context.from_model("numbers")
    told = _retold(planned.program.trace, answer.value, left)
    return dataclasses.replace(planned, program=msgspec.structs.replace(planned.program, trace=told))


def _numbers_prompt(context: Context, request: BuildRequest, facts: BriefFacts, reference: PlannedBuilding) -> Prompt:
    """Return the question for type, style and numbers."""
    decisions = reference.decisions
    known = []
    if request.floors or facts.floors:
        known.append(f"floors above ground: {decisions.floors}")
    if not _open(request, facts).area:
        known.append(f"area of a floor: {number(decisions.area)}")
    if facts.building:
        known.append(f"building type: {decisions.building.name}")
    if facts.styles:
        known.append(f"style: {decisions.style}")
    lines = [
        quoted_data("brief", context.description),
        "Work out what building the brief describes: its type, its style, the number of floors at and above the "
        "ground, and the gross area of one floor. What is settled already must be repeated unchanged: "
        + ("; ".join(known) or "nothing")
        + ".",
        f"What the brief leaves open, choose as usual for such a building, but at most {INFERRED_FLOORS} floors and at "
        f"most {AREA_CAP:.0f} m2 a floor.",
        "building_type is one of: " + ", ".join(sorted(context.knowledge.buildings)) + ".",
        "style is one of: " + ", ".join(sorted(context.knowledge.styles)) + ".",
        CLOSING,
        '{"reasoning": "<one or two sentences>", "building_type": "<name>", "style": "<name>", "floors": <int>, '
        '"floor_area": <float>}',
    ]
    return Prompt("numbers", ARCHITECT, "\n".join(lines))


def _faults(answer: NumbersAnswer, left: _Open, context: Context) -> list[Fault]:
    out = []
    if left.building and answer.building_type not in context.knowledge.buildings:
        out.append(f"building_type {clean_text(answer.building_type, 60)!r} is none of the list")
    if left.style and answer.style not in context.knowledge.styles:
        out.append(f"style {clean_text(answer.style, 60)!r} is none of the list")
    if left.floors and not 1 <= answer.floors <= INFERRED_FLOORS:
        out.append(f"floors is {answer.floors}; 1 to {INFERRED_FLOORS} are accepted")
    if left.area and not 20.0 <= answer.floor_area <= AREA_CAP:
        out.append(f"floor_area is {answer.floor_area:g}; 20 to {AREA_CAP:.0f} are accepted")
    return [Fault(text) for text in out]


def _with_answer(facts: BriefFacts, answer: NumbersAnswer, left: _Open) -> BriefFacts:
    """Return the facts with the answer where the brief is silent."""
    out = dataclasses.replace(facts)
    if left.floors:
        out.floors = [Quantity(float(answer.floors), _INFERRED)]
    if left.area:
        out.floor_area = [Quantity(float(answer.floor_area), _INFERRED)]
    if left.building:
        out.building = [(answer.building_type, _INFERRED)]
    if left.style:
        out.styles = [(answer.style, _INFERRED)]
    return out


def _retold(trace: list[TraceEntry], answer: NumbersAnswer, left: _Open) -> list[TraceEntry]:
    """Return the trace with the model's reasons for the lines that take its numbers for statements of the brief."""
    chosen = [
        text
        for is_open, text in (
            (left.building, answer.building_type.replace("_", " ")),
            (left.floors, f"{answer.floors} storey{'s' if answer.floors > 1 else ''}"),
            (left.area, f"{answer.floor_area:.0f} m2 a storey"),
            (left.style, f"style {answer.style}"),
        )
        if is_open
    ]
    kept = [entry for entry in trace if not (entry.start == 0 and entry.end == 0 and not entry.words)]
    why = clean_text(answer.reasoning, 240)
    return [TraceEntry(words="", effect=f"language model: {', '.join(chosen)} ({why})"), *kept]

"""Resolve the numbers of a brief (Algorithm 1, line 1): type, storeys, areas, style; refuse what contradicts itself."""

from dataclasses import dataclass, field

import numpy as np
from shapely.geometry import Polygon

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import Downgrade, TraceEntry
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief.facts import BriefFacts, FloorRef, Quantity, Span
from mansion_planner.knowledge import BuildingType, KnowledgeBase
from mansion_planner.program.footprint import check_footprint, is_rectangle
from mansion_planner.program.inference import MOST_FLOORS, infer_building, infer_floors, note

__all__ = ["AREA_CAP", "Decisions", "contradiction", "decide", "quoted"]

AREA_CAP = 500.0
"""Most square metres of a storey that are inferred (section B.1)."""


@dataclass
class Decisions:
    """What the building is to be.

    Attributes
    ----------
    floors, basements : int
    area : float
        Gross area wished for a storey at and above the ground, square metres.
    area_stated : bool
        `area` follows from what the brief or the request states.
    outline : Polygon, optional
        The given footprint.
    free_form : bool
        The outline is given and is no rectangle.
    """

    building: BuildingType
    floors: int
    basements: int
    area: float
    area_stated: bool
    area_span: str
    style: str
    facts: BriefFacts
    seed: int
    free_form: bool = False
    outline: Polygon | None = None
    trace: list[TraceEntry] = field(default_factory=list)
    downgrades: list[Downgrade] = field(default_factory=list)


def contradiction(what: str, first: str, second: str, path: str = "$.description") -> MansionError:
    """Return the refusal of two statements that exclude each other."""
    return MansionError(
        ErrorCode.CONTRADICTION,
        f"{what}: {first} against {second}; keep one of the two",
        path=path,
        details={"first": first, "second": second, "stage": "program"},
    )


def quoted(span: Span) -> str:
    """Return the place of some words for an error message."""
    return f'"{span.words}" (characters {span.start} to {span.end} of the description)'


def _one(values: list[Quantity], what: str) -> Quantity | None:
    """Return the value that all statements share, or refuse."""
    if not values:
        return None
    for other in values[1:]:
        if abs(other.value - values[0].value) > 0.02 * values[0].value:
            raise contradiction(
                f"the description states two different {what}",
                quoted(values[0].span),
                quoted(other.span),
            )
    return values[0]


def decide(
    request: BuildRequest,
    facts: BriefFacts,
    knowledge: KnowledgeBase,
    generator: np.random.Generator,
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
    decisions = Decisions(
        building, floors, basements, 0.0, False, "", style, facts, request.seed, trace=trace
    )
    if building.name == "bungalow" and floors > 1:
        decisions.downgrades.append(
            Downgrade(
                wish="bungalow", got=f"a house of {floors} storeys", stage="program",
                reason="a bungalow has one storey, and the number of storeys is stated",
            )
        )  # fmt: skip
    if request.footprint is not None:
        _area_of_footprint(request, decisions)
    else:
        _area(request, decisions, generator)
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
    below = next(
        (ref for room in facts.rooms for ref in room.floors if ref.kind == "basement"), None
    )
    if no_basement is not None and (below is not None or facts.basements):
        other = below.span if below is not None else facts.basements[0].span
        raise contradiction("a basement", quoted(no_basement), quoted(other))
    counted: dict[str, tuple[int, Span]] = {}
    for room in facts.rooms:
        if (
            room.floors
            or room.each
            or room.count is None
            or room.count < 2
            or room.area is not None
        ):
            continue
        earlier = counted.setdefault(room.name, (room.count, room.span))
        if earlier[0] != room.count:
            raise contradiction(
                f"two numbers of {room.name}", quoted(earlier[1]), quoted(room.span)
            )


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
    stated = _one(facts.floors, "numbers of storeys")
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
                "the number of storeys",
                f"$.floors = {request.floors}",
                quoted(stated.span),
                "$.floors",
            )
        count, words, span = request.floors, f"$.floors = {request.floors}", None
        note(trace, None, f"{count} storeys, as the request states")
    elif stated is not None:
        count, words, span = int(stated.value), quoted(stated.span), stated.span
        note(trace, span, f"{count} storeys")
    else:
        return infer_floors(facts, building, needed, trace, generator)
    if place is not None and needed > count:
        raise contradiction(
            f"a storey that the building does not have (it has {count})", quoted(place.span), words
        )
    return count


def _highest(facts: BriefFacts) -> tuple[int, FloorRef | None]:
    refs = [ref for room in facts.rooms for ref in room.floors]
    refs += [ref for use in facts.uses for ref in use.floors] + [
        copy.first for copy in facts.copies
    ]
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


def _area(request: BuildRequest, decisions: Decisions, generator: np.random.Generator) -> None:
    facts, _building, trace = decisions.facts, decisions.building, decisions.trace
    total, floor = _one(facts.area, "total areas"), _one(facts.floor_area, "areas of a storey")
    storeys = decisions.floors + decisions.basements
    if request.area is not None and request.floor_area is not None:
        raise contradiction("two areas", "$.area", "$.floor_area", "$.floor_area")
    if (
        request.area is not None
        and total is not None
        and abs(request.area - total.value) > 0.02 * total.value
    ):
        raise contradiction(
            "the total area", f"$.area = {request.area:g}", quoted(total.span), "$.area"
        )
    if (
        request.floor_area is not None
        and floor is not None
        and abs(request.floor_area - floor.value) > 0.02 * floor.value
    ):
        raise contradiction(
            "the area of a storey",
            f"$.floor_area = {request.floor_area:g}",
            quoted(floor.span),
            "$.floor_area",
        )
    if (
        total is not None
        and floor is not None
        and abs(floor.value * storeys - total.value) > 0.12 * total.value
    ):
        raise contradiction(
            f"the areas for {storeys} storeys", quoted(total.span), quoted(floor.span)
        )
    if request.floor_area is not None or floor is not None:
        decisions.area = request.floor_area if request.floor_area is not None else floor.value  # type: ignore[union-attr]
        decisions.area_span = quoted(floor.span) if floor else f"$.floor_area = {decisions.area:g}"
        note(trace, floor.span if floor else None, f"{decisions.area:.0f} m2 a storey, as stated")
        decisions.area_stated = True
    elif request.area is not None or total is not None:
        whole = request.area if request.area is not None else total.value  # type: ignore[union-attr]
        decisions.area = whole / storeys
        decisions.area_span = quoted(total.span) if total else f"$.area = {whole:g}"
        note(
            trace,
            total.span if total else None,
            f"{whole:.0f} m2 over {storeys} storeys, as stated",
        )
        decisions.area_stated = True
    else:
        _infer_area(decisions, generator)


def _area_of_footprint(request: BuildRequest, decisions: Decisions) -> None:
    """Take the area of the given outline; a stated area must agree with it within 5%."""
    assert request.footprint is not None
    shape = check_footprint(request.footprint)
    facts, levels = decisions.facts, decisions.floors + decisions.basements
    area = float(shape.area)
    stated = [(q.value, quoted(q.span)) for q in facts.floor_area] + [
        (q.value / levels, quoted(q.span)) for q in facts.area
    ]
    if request.floor_area is not None:
        stated.append((request.floor_area, f"$.floor_area = {request.floor_area:g}"))
    if request.area is not None:
        stated.append((request.area / levels, f"$.area = {request.area:g}"))
    for value, words in stated:
        if abs(value - area) > 0.05 * area:
            raise contradiction(
                f"the area of a storey ({value:.0f} m2 asked for)",
                words,
                f"$.footprint of {area:.0f} m2",
                "$.footprint",
            )
    if facts.shapes and facts.shapes[0][0] not in ("rectangle", "square") and is_rectangle(shape):
        raise contradiction(
            "the outline", quoted(facts.shapes[0][1]), "the rectangle of $.footprint", "$.footprint"
        )
    decisions.area, decisions.area_stated = area, True
    decisions.area_span = f"$.footprint of {area:.0f} m2"
    decisions.outline = shape
    decisions.free_form = not is_rectangle(shape)
    note(decisions.trace, None, f"{area:.0f} m2 a storey, as the footprint gives")


def _infer_area(decisions: Decisions, generator: np.random.Generator) -> None:
    facts, building = decisions.facts, decisions.building
    least, usual = building.floor_area
    area = usual * float(generator.uniform(0.92, 1.08))
    words = {word for word, _ in facts.size}
    if "small" in words:
        area = max(least, 0.75 * area)
    elif "large" in words:
        area = min(1.25 * area, AREA_CAP)
    if facts.occupants and building.seats is None and building.family != "home":
        people = sum(o.count for o in facts.occupants)
        area = min(max(people * building.people / decisions.floors, least), AREA_CAP)
        note(
            decisions.trace,
            facts.occupants[0].span,
            f"{building.people:g} m2 for each of {people} people",
        )
    decisions.area = min(max(area, least), AREA_CAP)
    note(
        decisions.trace,
        None,
        f"about {decisions.area:.0f} m2 a storey, usual for a {building.name}",
    )

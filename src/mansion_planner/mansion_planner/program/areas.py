"""Settle the area of a storey: as the request or the brief states it, as the footprint gives it, or as is usual."""

import numpy as np

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.wording import with_article
from mansion_planner.brief.facts import Quantity
from mansion_planner.program.decisions import Decisions, conflict, quoted
from mansion_planner.program.footprint import check_footprint, is_rectangle
from mansion_planner.program.inference import note

__all__ = ["AREA_CAP", "area_of_footprint", "settle_area"]

AREA_CAP = 500.0
"""Most square metres of a storey that are inferred (section B.1)."""


def settle_area(request: BuildRequest, decisions: Decisions, generator: np.random.Generator) -> None:
    """Set the area of a storey from what the request and the brief state, or from what is usual.

    The request's own fields win over the text, and a total over the area of a storey that does not agree with it.

    Raises
    ------
    MansionError
        ``CONTRADICTION`` for two areas of the request that do not agree.
    """
    facts, trace = decisions.facts, decisions.trace
    total, floor = next(iter(facts.area), None), next(iter(facts.floor_area), None)
    storeys = decisions.floors + decisions.basements
    _check_request(request, storeys)
    if (request.area or request.floor_area) and (total or floor):
        total, floor = _overruled(request, total, floor, storeys, decisions)
    if total is not None and floor is not None and not _agree(total.value, floor.value, decisions):
        reason = f'"{total.span.words}" in all leaves less or more for {storeys} storeys'
        decisions.downgrades.append(conflict(floor.span.words, f"{total.value / storeys:.0f} m2 a storey", reason))
        floor = None
    if request.floor_area is not None or floor is not None:
        decisions.area = request.floor_area if request.floor_area is not None else floor.value  # type: ignore[union-attr]
        decisions.area_span = quoted(floor.span) if floor else f"$.floor_area = {decisions.area:g}"
        note(trace, floor.span if floor else None, f"{decisions.area:.0f} m2 a storey, as stated")
        decisions.area_stated = True
    elif request.area is not None or total is not None:
        whole = request.area if request.area is not None else total.value  # type: ignore[union-attr]
        decisions.area = whole / storeys
        decisions.area_span = quoted(total.span) if total else f"$.area = {whole:g}"
        note(trace, total.span if total else None, f"{whole:.0f} m2 over {storeys} storeys, as stated")
        decisions.area_stated = True
    else:
        _infer_area(decisions, generator)


def _agree(total: float, floor: float, decisions: Decisions) -> bool:
    """Whether a total is that of the storeys, with or without basements."""
    counts = (decisions.floors, decisions.floors + decisions.basements)
    return any(abs(floor * count - total) <= 0.12 * total for count in counts)


def _check_request(request: BuildRequest, storeys: int) -> None:
    """Refuse two areas of the request that do not agree."""
    if request.area is None or request.floor_area is None:
        return
    if abs(request.floor_area * storeys - request.area) > 0.12 * request.area:
        raise _two_fields(f"$.area = {request.area:g}", f"$.floor_area = {request.floor_area:g}", "$.floor_area")


def _two_fields(first: str, second: str, path: str) -> MansionError:
    """Return the refusal of two fields of a request that do not agree."""
    return MansionError(
        ErrorCode.CONTRADICTION,
        f"the area of a storey: {first} against {second}; keep one of the two",
        path=path,
        details={"first": first, "second": second, "stage": "program"},
    )


def _overruled(
    request: BuildRequest, total: Quantity | None, floor: Quantity | None, storeys: int, decisions: Decisions
) -> tuple[Quantity | None, Quantity | None]:
    """Return the areas of the text that agree with the request's; the others are recorded."""
    given = request.floor_area or (request.area or 0.0) / storeys
    for quantity, each in ((total, storeys), (floor, 1)):
        if quantity is not None and abs(quantity.value / each - given) > 0.12 * given:
            reason = "the request's own field says so"
            decisions.downgrades.append(conflict(quantity.span.words, f"{given:.0f} m2 a storey", reason))
            total, floor = (None, floor) if quantity is total else (total, None)
    return total, floor


def area_of_footprint(request: BuildRequest, decisions: Decisions) -> None:
    """Take the area of the given outline; areas and outlines of the text that do not agree with it give way.

    Raises
    ------
    MansionError
        ``CONTRADICTION`` for a field of the request that does not agree with it.
    """
    assert request.footprint is not None
    shape = check_footprint(request.footprint)
    facts, levels = decisions.facts, decisions.floors + decisions.basements
    area = float(shape.area)
    for given, name in ((request.floor_area, "floor_area"), (request.area and request.area / levels, "area")):
        if given and abs(given - area) > 0.05 * area:
            raise _two_fields(f"$.{name} = {getattr(request, name):g}", f"$.footprint of {area:.0f} m2", "$.footprint")
    stated = [(q.value, q.span.words) for q in facts.floor_area] + [
        (q.value / levels, q.span.words) for q in facts.area
    ]
    for value, words in stated:
        if abs(value - area) > 0.05 * area:
            decisions.downgrades.append(conflict(words, f"{area:.0f} m2 a storey", "$.footprint has this area"))
    if facts.shapes and facts.shapes[0][0] not in ("rectangle", "square") and is_rectangle(shape):
        decisions.downgrades.append(conflict(facts.shapes[0][1].words, "a rectangle", "$.footprint is one"))
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
        note(decisions.trace, facts.occupants[0].span, f"{building.people:g} m2 for each of {people} people")
    decisions.area = min(max(area, least), AREA_CAP)
    note(decisions.trace, None, f"about {decisions.area:.0f} m2 a storey, usual for {with_article(building.name)}")

"""Settle the area of a storey: as the request or the brief states it, as the footprint gives it, or as is usual."""

from itertools import product

import numpy as np

from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.wording import with_article
from mansion_planner.brief.facts import Quantity
from mansion_planner.program.decisions import Decisions, contradiction, one_value, quoted
from mansion_planner.program.footprint import check_footprint, is_rectangle
from mansion_planner.program.inference import note

__all__ = ["AREA_CAP", "area_of_footprint", "settle_area"]

AREA_CAP = 500.0
"""Most square metres of a storey that are inferred (section B.1)."""


def settle_area(request: BuildRequest, decisions: Decisions, generator: np.random.Generator) -> None:
    """Set the area of a storey from what the request and the brief state, or from what is usual.

    Raises
    ------
    MansionError
        ``CONTRADICTION`` for areas that do not agree.
    """
    facts, trace = decisions.facts, decisions.trace
    total = one_value(facts.area, "total areas")
    floor = one_value(facts.floor_area, "areas of a storey")
    storeys = decisions.floors + decisions.basements
    _check_areas(request, total, floor, storeys)
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


def _check_areas(request: BuildRequest, total: Quantity | None, floor: Quantity | None, storeys: int) -> None:
    """Refuse areas of the request and of the brief, total and of a storey, that do not agree."""
    if request.area is not None and request.floor_area is not None:
        raise contradiction("two areas", "$.area", "$.floor_area", "$.floor_area")
    if request.area is not None and total is not None and abs(request.area - total.value) > 0.02 * total.value:
        raise contradiction("the total area", f"$.area = {request.area:g}", quoted(total.span), "$.area")
    if (
        request.floor_area is not None
        and floor is not None
        and abs(request.floor_area - floor.value) > 0.02 * floor.value
    ):
        raise contradiction(
            "the area of a storey", f"$.floor_area = {request.floor_area:g}", quoted(floor.span), "$.floor_area"
        )
    totals = [(request.area, f"$.area = {request.area or 0:g}", "$.area")]
    parts = [(request.floor_area, f"$.floor_area = {request.floor_area or 0:g}", "$.floor_area")]
    if total is not None:
        totals.append((total.value, quoted(total.span), "$.description"))
    if floor is not None:
        parts.append((floor.value, quoted(floor.span), "$.description"))
    for (whole, first, path), (part, second, other) in product(totals, parts):
        if whole and part and abs(part * storeys - whole) > 0.12 * whole:
            place = other if path == "$.description" else path
            raise contradiction(f"the areas for {storeys} storeys", first, second, place)


def area_of_footprint(request: BuildRequest, decisions: Decisions) -> None:
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
        raise contradiction("the outline", quoted(facts.shapes[0][1]), "the rectangle of $.footprint", "$.footprint")
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

"""Decide type, storeys, areas and style of a building (Algorithm 1, line 1), and settle what contradicts itself."""

import math
from dataclasses import dataclass, field, replace

import msgspec
import numpy as np
from shapely.geometry import Polygon

from mansion_knowledge import BuildingType, KnowledgeBase
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import Clutter, Downgrade, RequestedObject, TraceEntry
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.wording import counted, with_article
from mansion_planner.brief.facts import BriefFacts, FloorRef, Quantity, Span
from mansion_planner.program.building_size import (
    ProgramSize,
    called_size,
    counted_rooms,
    people_of,
    size_of_program,
    within_called,
)
from mansion_planner.program.footprint import check_footprint, is_rectangle
from mansion_planner.program.lone_rooms import as_lone_room, lone_outline, lone_room
from mansion_planner.program.room_parts import with_master_suite, with_room_parts
from mansion_planner.program.shape_sizes import most_storeys
from mansion_planner.program.usual_meanings import as_meant_in, with_main_room

__all__ = ["AREA_CAP", "Decisions", "MOST_FLOORS", "conflict", "decide", "note", "quoted"]


MOST_FLOORS = 100


_STOREYS = {"high_rise": 10, "mid_rise": 6, "low_rise": 3, "duplex": 2, "triplex": 3, "bungalow": 1}


_PEOPLE_HINTS = {"pupil": "school", "student": "university", "patient": "hospital", "bed": "hospital",
                 "employee": "office", "guest": "hotel", "resident": "apartment_building", "worker": "office",
                 "family": "house", "kid": "kindergarten", "child": "kindergarten", "developer": "office",
                 "diner": "restaurant_building", "firefighter": "fire_station",
                 "tenant": "apartment_building"}  # fmt: skip


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
        The given footprint, or the outline of a home that is too small for wings along a corridor.
    free_form : bool
        `outline` is no rectangle.
    furniture : dict of (int, str) to list of RequestedObject
        What the brief wants in a room, by storey and room id.
    given_up : BriefFacts
        Statements that exclude others and gave way to them.
    floors_stated : bool
        The request or the brief says how many storeys there are.
    clutter : {"sparse", "dense"}, optional
        What the request says of all rooms.
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
    furniture: dict[tuple[int, str], list[RequestedObject]] = field(default_factory=dict)
    given_up: BriefFacts = field(default_factory=BriefFacts)
    floors_stated: bool = False
    clutter: Clutter | msgspec.UnsetType = msgspec.UNSET

    def as_called(self, area: float) -> float:
        """Return the area of a storey, lessened or raised to what the brief calls the building: small or large."""
        stated = self.floors if self.floors_stated else None
        return within_called(area, self.facts, self.building, self.floors, stated)


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
    stated, facts = facts, _settled(facts, given_way)
    building = _building(facts, knowledge, trace)
    if (lone := lone_room(facts, knowledge)) is not None:
        note(trace, lone.span, "one room, and nothing besides")
        building, facts = as_lone_room(building, facts, lone, knowledge)
    building = _without_unwanted_hub(building, facts)
    stated, facts = as_meant_in(building, stated), as_meant_in(building, facts)
    facts = with_room_parts(building, with_main_room(building, facts))
    facts = with_master_suite(facts) if building.family == "home" else facts
    sized = request.floors or request.area or request.floor_area or request.footprint or facts.floors
    size = None if sized else size_of_program(facts, building, knowledge)
    floors, facts = _floors(request, facts, building, size, trace, generator, given_way)
    basements = _basements(facts, trace)
    style = building.style
    if facts.styles:
        style, span = _chosen_style(facts)
        note(trace, span, f"style {style}")
    decisions = Decisions(
        building, floors, basements, 0.0, False, "", style, facts, request.seed, trace=trace, downgrades=given_way,
        given_up=_given_up(stated, facts), floors_stated=bool(request.floors or facts.floors),
        clutter=request.clutter,
    )  # fmt: skip
    if building.name == "bungalow" and floors > 1:
        reason = "a bungalow has one storey, and the number of storeys is stated"
        decisions.downgrades.append(conflict("bungalow", f"a house of {floors} storeys", reason))
    if request.footprint is not None:
        _area_of_footprint(request, decisions)
    else:
        _settle_area(request, decisions, size, generator, knowledge)
        _outline_of_lone_room(decisions)
    return decisions


def _outline_of_lone_room(decisions: Decisions) -> None:
    """Give a building that is one room an outline as large as the room, unless the brief wants another form."""
    building, facts = decisions.building, decisions.facts
    if not building.alone or any(shape != "rectangle" for shape, _ in facts.shapes):
        return
    if not decisions.area_stated:
        decisions.area = building.floor_area[1]
    decisions.outline = lone_outline(decisions.area)
    decisions.area, decisions.area_stated = float(decisions.outline.area), True


def _without_unwanted_hub(building: BuildingType, facts: BriefFacts) -> BuildingType:
    """Return a building whose ground floor is reached through a corridor, where the brief wants no lobby."""
    unwanted = {name for name, _ in facts.excluded}
    other = building.hub_upper
    if building.hub not in unwanted or not other or other == building.hub or other in unwanted:
        return building
    return replace(building, hub=other)


_MOODS = frozenset({"elegant", "traditional", "classic", "warm", "cosy", "cozy", "modern", "contemporary", "luxurious"})
"""Words of styles that many buildings are praised with; a place or an age beside them says more of the style."""


def _chosen_style(facts: BriefFacts) -> tuple[str, Span]:
    """Return the first style that the brief tells by more than a mood, else its first."""
    telling = (found for found in facts.styles if found[1].words.lower() not in _MOODS)
    return next(telling, facts.styles[0])


def conflict(wish: str, got: str, reason: str, floor: int | None = None) -> Downgrade:
    """Return the record of a statement that gave way to another one."""
    return Downgrade(wish=wish, got=got, reason=reason, stage="program", floor=floor)


def quoted(span: Span) -> str:
    """Return the place of some words for an error message."""
    return f'"{span.words}" (characters {span.start} to {span.end} of the description)'


def note(trace: list[TraceEntry], span: Span | None, effect: str) -> None:
    """Add a line to the trace: the words (or none, for a rule) and what they led to."""
    if span is None:
        trace.append(TraceEntry(words="", effect=effect))
    else:
        trace.append(TraceEntry(words=span.words, effect=effect, start=span.start, end=span.end))


def _infer_building(facts: BriefFacts, knowledge: KnowledgeBase) -> str:
    """Return the building type that the uses, rooms and occupants of a brief suggest."""
    if len({use.building_type for use in facts.uses}) > 1:
        return "mixed_use"
    homes = sum(room.count or 2 for room in facts.rooms if room.unit)
    use = facts.uses[0].building_type if facts.uses else ""
    if use and (homes != 1 or use == "apartment_building"):
        return use  # a practice below a single flat does not make a clinic of a home
    votes: dict[str, float] = {}
    for room in facts.rooms:
        kinds = [knowledge.room(part.room_type) for part in (room, *room.suite)]
        hints = [kind.suggests for kind in kinds if kind.suggests]
        alone = room.unit and room.count == 1 and not room.each
        for hint in hints[: None if alone else 1]:
            votes[hint] = votes.get(hint, 0.0) + min(room.count or 2, 4)
    for occupants in facts.occupants:
        hint = _PEOPLE_HINTS.get(occupants.noun, "")
        if hint:
            votes[hint] = votes.get(hint, 0.0) + 3.0
    if facts.trades:  # who works at home lives there too: the trade tells more than a bedroom
        trade = facts.trades[0][0]
        votes = {name: votes[name] for name in votes if knowledge.buildings[name].family != "home"}
        votes[trade] = votes.get(trade, 0.0) + 3.0
    if votes:
        kind = max(votes, key=lambda name: (votes[name], name))
        shops = sum(room.count or 2 for room in facts.rooms if knowledge.room(room.room_type).suggests == kind)
        return "shop_building" if kind == "shopping_mall" and shops == 1 else kind
    if any(word == "high_rise" for word, _ in facts.size) or any(q.value >= 4 for q in facts.floors):
        return "office"
    return "house" if not any(q.value > 300 for q in facts.area) else "office"


def _names_two_storeys(facts: BriefFacts) -> bool:
    """Whether rooms lie on a ground floor and on one "upper storey" or "upstairs", and on no other."""
    refs = [ref for room in facts.rooms for ref in room.floors]
    upper = [ref for ref in refs if ref.kind == "upper" and not ref.first]
    others = [ref for ref in refs if ref.kind not in ("upper", "every", "basement") and ref.last != 1]
    plural = any(ref.span.words.lower().endswith(("floors", "storeys", "levels", "stories")) for ref in upper)
    return bool(upper) and not others and not plural


_BESIDE_LARGEST = 1.4
"""Area of a storey to that of its largest room, at least: the way there, stairs and others are beside it."""


_SMALLEST_HOME, _SMALLEST = 0.65, 0.8
"""Share of the least usual area that a storey of a home, and of another building, has when it is divided."""


def _storeys_to_divide_over(facts: BriefFacts, building: BuildingType) -> tuple[int, str]:
    """Return over how many storeys the stated area may be divided at most, and why.

    The largest room has its stated area on one of them, each has the outline that is wanted, and none is a mere stair
    with a corridor.
    """
    if not facts.area or facts.floor_area:
        return MOST_FLOORS, ""
    area = facts.area[0].value
    largest = max((room.area for room in facts.rooms if room.area and not room.unit), default=0.0)
    roomy = max(1, int(area / (_BESIDE_LARGEST * largest))) if largest else MOST_FLOORS
    shape = facts.shapes[0][0] if facts.shapes else "rectangle"
    shaped = most_storeys(shape, area, MOST_FLOORS)
    share = _SMALLEST_HOME if building.family == "home" else _SMALLEST
    usable = max(1, int(area / (share * building.floor_area[0])))
    return min(
        (roomy, "so that the largest room fits into one"),
        (shaped, "so that each has the outline that is wanted"),
        (usable, "so that each has room beside its stair"),
    )


def _infer_floors(
    facts: BriefFacts,
    building: BuildingType,
    size: ProgramSize | None,
    needed: int,
    trace: list[TraceEntry],
    generator: np.random.Generator,
) -> int:
    """Return a number of storeys that suits the type, the sizes named and the storeys that rooms are put on."""
    sized = next(((word, span) for word, span in facts.size if word in _STOREYS), None)
    count, reason = _usual_floors(facts, building, size, sized, generator)
    holding, why = _storeys_to_divide_over(facts, building)
    if sized is None and count > holding:
        count, reason = holding, why
    repeated = counted_rooms(facts, building)
    if sized is None and 2 <= needed < count and repeated and all(room.floors for room in repeated):
        count, reason = needed, "the rooms that are counted have their storeys"
    if facts.uses and needed:
        tops = [ref.first for use in facts.uses for ref in use.floors if ref.kind == "top"]
        count, needed = needed + max(tops, default=0), needed + max(tops, default=0)
        reason = "the storeys that are given a use"
    kinds = {ref.kind for room in facts.rooms for ref in room.floors}
    if "upper" in kinds and kinds <= {"number", "upper", "basement"} and needed <= 1 and not sized and not facts.area:
        count, reason = 2, "a lower and an upper one are described"
    pinned = {ref.first for room in facts.rooms for ref in room.floors if ref.kind == "number"}
    if needed >= 2 and pinned >= set(range(1, needed + 1)) and not sized:
        count, reason = needed + ("top" in kinds), "each of them is described"
    floor_least = 3 if kinds & {"middle"} or {"upper", "top"} <= kinds else 2 if kinds & {"upper", "top"} else 1
    if sum(use.count or 0 for use in facts.uses):
        above = any(use.floors for use in facts.uses if use.count)
        floor_least = max(floor_least, sum(use.count or 0 for use in facts.uses) + above)
        count = floor_least
    result = max(count, needed, floor_least)
    if result > count:
        reason = "the highest storey that is named"
    note(trace, sized[1] if sized else None, f"{counted(result, 'storey')}: {reason}")
    return result


def _usual_floors(
    facts: BriefFacts,
    building: BuildingType,
    size: ProgramSize | None,
    sized: tuple[str, Span] | None,
    generator: np.random.Generator,
) -> tuple[int, str]:
    """Return a number of storeys by the building's type and size alone, and the reason."""
    usual, most = building.floors
    if sized is not None:
        kept = building.name == "penthouse" or (sized[0] == "high_rise" and building.family == "home")
        return usual if kept else _STOREYS[sized[0]], f'"{sized[1].words}"'
    if {"no_stair", "elevator"} & {name for name, _ in facts.vertical} == {"no_stair"}:
        return 1, "no stair is wanted"
    if _names_two_storeys(facts):
        return 2, "the brief names a ground floor and one above"
    if facts.area and facts.floor_area:
        ratio = facts.area[0].value / facts.floor_area[0].value
        return max(1, min(round(ratio), MOST_FLOORS)), "total area over area of a storey"
    if facts.area and facts.area[0].value > 1.25 * building.floor_area[1]:
        needed = -(-int(facts.area[0].value) // int(max(building.floor_area[1], 150)))
        return min(max(needed, 1), max(most, 1)), "the stated area"
    if size is not None:
        return size.storeys, f'enough for "{size.words}"'
    people, _ = people_of(facts, building)
    if people and building.seats is None and building.family != "home":
        enough = max(1, math.ceil(people * building.people / building.floor_area[1]))
        if enough < usual:
            return enough, f"enough for {people} people"
    reason = f"{with_article(building.name)} usually has {usual}"
    if called_size(facts) == "small":
        return max(1, usual - 1) if usual > 2 else usual, reason
    if usual > 2 and generator.random() < 0.3:
        return usual + 1 if usual < most else usual, reason
    return usual, reason


def _settle_area(
    request: BuildRequest,
    decisions: Decisions,
    size: ProgramSize | None,
    generator: np.random.Generator,
    knowledge: KnowledgeBase,
) -> None:
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
        decisions.area = request.floor_area if request.floor_area is not None else _kept(floor)  # type: ignore[arg-type]
        decisions.area_span = quoted(floor.span) if floor else f"$.floor_area = {decisions.area:g}"
        note(trace, floor.span if floor else None, f"{decisions.area:.0f} m2 a storey, as stated")
        decisions.area_stated = True
    elif request.area is not None or total is not None:
        whole = request.area if request.area is not None else _kept(total)  # type: ignore[arg-type]
        storeys = decisions.floors if facts.above_ground and request.area is None else storeys
        decisions.area = whole / storeys
        decisions.area_span = quoted(total.span) if total else f"$.area = {whole:g}"
        note(trace, total.span if total else None, f"{whole:.0f} m2 over {counted(storeys, 'storey')}, as stated")
        decisions.area_stated = True
    else:
        _infer_area(decisions, size, generator, knowledge)


def _kept(area: Quantity) -> float:
    """Return the area that is planned for a stated one: a little less or more where that is a bound."""
    return area.value * {"most": 0.95, "least": 1.05, "": 1.0}[area.limit]


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


def _area_of_footprint(request: BuildRequest, decisions: Decisions) -> None:
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


_PRACTICE = 55.0
"""Gross square metres of a practice for each of the professionals who have a room of their own there."""


def _infer_area(
    decisions: Decisions, size: ProgramSize | None, generator: np.random.Generator, knowledge: KnowledgeBase
) -> None:
    facts, building = decisions.facts, decisions.building
    least, usual = building.floor_area
    area = usual * float(generator.uniform(0.92, 1.08))
    called = called_size(facts)
    if called == "small":
        area = max(least, 0.75 * area)
    cap = AREA_CAP
    if called == "large":
        area, cap = 1.25 * min(area, AREA_CAP), 1.25 * AREA_CAP
    people, told = people_of(facts, building)
    if people and building.seats is None and building.family != "home":
        own_rooms = bool(facts.occupants) and all(o.noun in knowledge.groups.room_of for o in facts.occupants)
        each = max(_PRACTICE, building.people) if own_rooms else building.people
        area = min(max(people * each / decisions.floors, usual if own_rooms else least), cap)
        note(decisions.trace, told, f"{each:g} m2 for each of {people} people")
    if size is not None:
        decisions.area = min(size.area, AREA_CAP)
        note(decisions.trace, None, f"about {decisions.area:.0f} m2 a storey, for the rooms that are counted")
        return
    decisions.area = min(max(decisions.as_called(area), least), cap)
    note(decisions.trace, None, f"about {decisions.area:.0f} m2 a storey, usual for {with_article(building.name)}")


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


def _given_up(stated: BriefFacts, kept: BriefFacts) -> BriefFacts:
    """Return the statements that `_settled` leaves out."""
    return BriefFacts(
        vertical=[entry for entry in stated.vertical if entry not in kept.vertical],
        shapes=[entry for entry in stated.shapes if entry not in kept.shapes],
        excluded=[entry for entry in stated.excluded if entry not in kept.excluded],
    )


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
    name = facts.building_like or _infer_building(facts, knowledge)
    building = knowledge.buildings.get(name) or next(iter(knowledge.buildings.values()))
    note(trace, None, f"no building type is named: {building.name} suits the rooms best")
    return building


def _floors(
    request: BuildRequest,
    facts: BriefFacts,
    building: BuildingType,
    size: ProgramSize | None,
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
            given_way.append(conflict(stated.span.words, counted(count, "storey"), "the request's own field says so"))
        note(trace, None, f"{counted(count, 'storey')}, as the request states")
    elif stated is not None:
        count = int(stated.value)
        note(trace, stated.span, counted(count, "storey"))
        for other in facts.floors[1:]:
            why = "is the larger number" if stated.value >= other.value else "was read first"
            given_way.append(conflict(other.span.words, counted(count, "storey"), f'"{stated.span.words}" {why}'))
    else:
        return _infer_floors(facts, building, size, needed, trace, generator), facts
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
        note(trace, stated.span if stated else None, counted(count, "basement storey"))
    return count

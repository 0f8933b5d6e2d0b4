"""Arrange the storeys: the massing in which most wished neighbours are side by side."""

import itertools
import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

import numpy as np

from mansion_geometry.randomness import item_generator
from mansion_knowledge import KnowledgeBase
from mansion_msgs_py.program import Downgrade
from mansion_planner.brief.facts import AdjacencyFact
from mansion_planner.program.adjacency import behind_staff_rooms, entered_as_told, pairs_used_together
from mansion_planner.program.aisle_sketch import aisle_massings, plan_price
from mansion_planner.program.allocation import Allocation
from mansion_planner.program.blocks import needs_outer_wall
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.footprint import free_cores, free_massing, sketch_free
from mansion_planner.program.foyers import foyer_length
from mansion_planner.program.hall_sketch import most_fronts
from mansion_planner.program.hall_wings import hall_of_wing, with_hall_wing
from mansion_planner.program.home_orders import HOME_PAIRS
from mansion_planner.program.household import STUDIO
from mansion_planner.program.massing import MassingWish, choose_massing, gross_area, rectangle_massing
from mansion_planner.program.model import (
    Massing,
    Sketch,
    Storey,
    box_area,
    joined_pairs,
    loosened,
    misses_areas,
    short_edges,
    touching,
)
from mansion_planner.program.outline import Envelope, Frame, envelope_of
from mansion_planner.program.plan_quality import (
    aspect,
    carved,
    comes_out_as_strips,
    crosswise,
    dark_rooms,
    home_faults,
    is_shallow_bay,
    long_halls,
    shallow_garages,
    shrunk_rooms,
    strips,
    swollen_rooms,
)
from mansion_planner.program.public_toilets import TOILETS, Served, served_by, with_public_toilets
from mansion_planner.program.required_rooms import for_sleepers, with_changing_rooms, with_kitchen
from mansion_planner.program.setbacks import set_back
from mansion_planner.program.storey_forms import capacity, form_of, sketched
from mansion_planner.program.storey_rooms import (
    MOST_ROOMS,
    base_rooms,
    fill_storey,
    fit_areas,
    hub_area,
    listed_area,
    name_rooms,
    needed_area,
)

__all__ = [
    "Arrangement",
    "apart_pairs",
    "best_arrangement",
    "neighbours",
    "unmet_neighbours",
    "unwanted_pairs",
    "wanted_pairs",
]


@dataclass(frozen=True)
class Arrangement:
    """A massing, where it stands, the storeys with their rooms, and each one's sketch and envelope by index."""

    massing: Massing
    frame: Frame
    storeys: list[Storey]
    sketches: dict[int, Sketch]
    envelopes: dict[int, Envelope]


_AREA_MISSED = 3
"""Rooms out of place that count as much as a storey whose stated area is missed: the solver may still place rooms."""


def best_arrangement(
    decisions: Decisions, wish: MassingWish, storeys: Sequence[Storey], allocation: Allocation, knowledge: KnowledgeBase
) -> Arrangement:
    """Lay the building out; when rooms lack a door's wall, wished neighbours or good proportions, try other depths."""
    best: tuple[tuple[int, int, float], Arrangement] | None = None
    home = decisions.building.family == "home"
    attempts = _ATTEMPTS if decisions.outline is None and not decisions.free_form else 1
    # The first depth without a fault is taken, and each seed begins at another one.
    free = home and not decisions.area_stated
    first = int(item_generator(decisions.seed, "first depth").integers(_FIRST)) if free else 0
    asked = {storey.index: base_rooms(storey, allocation, knowledge) for storey in storeys}
    hall = hall_of_wing(decisions, storeys, asked)
    for attempt in range(attempts):
        growth = 1.0 if decisions.area_stated else 1.0 + 0.03 * attempt
        generator = item_generator(decisions.seed, "massing", attempt)
        varied = replace(wish, area=wish.area * growth, variant=(attempt + first) % attempts)
        massing = _massing(decisions, varied, generator)
        shaped = set_back(decisions, massing, storeys, allocation, knowledge)
        shaped = with_hall_wing(massing, shaped, hall)
        layout = _arranged(decisions, massing, shaped, allocation, knowledge, generator)
        missed, (shallow, ill) = _missed(decisions, wish, layout), _ill_shaped(layout, home=home)
        price = missed, shallow, ill
        if best is None or price < best[0]:
            best = (price, layout)
        if not any(price):
            break
    assert best is not None
    layout = _deep_where_it_suits(decisions, wish, best[1], allocation, knowledge)
    return _loosened_where_missed(decisions, layout)


_FIRST = 4
"""Depths that a home whose area nobody states may begin with."""

_ATTEMPTS = 6
"""Massings that are tried at most."""


def _own_sketches(layout: Arrangement) -> list[Sketch]:
    """Return the sketches of the storeys that copy no other."""
    return [layout.sketches[storey.index] for storey in layout.storeys if storey.copy is None]


def _ill_shaped(layout: Arrangement, *, home: bool) -> tuple[int, float]:
    """Count the garages that are too shallow for their cars, and rooms: strips, too small or large, without a window.

    Homes count what is wrong with them as such besides.
    """
    own = _own_sketches(layout)
    ill: float = sum(
        len(strips(sketch)) + len(carved(sketch)) + len(shrunk_rooms(sketch)) + len(swollen_rooms(sketch))
        + len(crosswise(sketch)) + len(long_halls(sketch))
        for sketch in own
    )  # fmt: skip
    if layout.massing.hall and not home:
        entered = [layout.sketches[s.index] for s in layout.storeys if s.role in _ENTERED]
        ill += sum(aspect(sketch.corridors[0].boxes) > _LONG_HALL for sketch in entered)
    ill += sum(_unlit(layout.sketches[storey.index], layout.massing) for storey in layout.storeys if _is_plain(storey))
    if home:
        above = [storey for storey in layout.storeys if storey.copy is None and storey.index >= 1]
        ill += home_faults([(s, layout.sketches[s.index], layout.envelopes[s.index].area) for s in above])
    bays = sum(is_shallow_bay(s, layout.sketches[s.index]) for s in layout.storeys if s.copy is None)
    return sum(len(shallow_garages(sketch)) for sketch in own) + bays, ill


_LONG_HALL = 2.4
"""Length to width from which on a hall that other rooms line is too long."""


def _is_plain(storey: Storey) -> bool:
    """Whether a storey has a plan of its own, under the same walls as the others."""
    return storey.copy is None and not (storey.setback or storey.extension)


def _unlit(sketch: Sketch, massing: Massing) -> int:
    """Count the rooms of a bar without wings that must have a window and lie behind others."""
    if massing.wings:
        return 0
    return sum(
        needs_outer_wall(placement.room.kind) and bool(placement.boxes) for placement in dark_rooms(sketch, massing)
    )


_DEEP_FROM = 450.0
"""Least gross area of a storey that may get parallel corridors, square metres."""

_LONG, _LONG_ALONE = 6.0, 3.3
"""From so many times its depth on, a bar of rooms may become a deeper rectangle where nobody asked for an outline; from
the second on where it has one storey, so that each corridor may end at a door to the outside."""

_LONG_PRICE = 2.0
"""What each time more counts for beside a room of a wrong form, which counts 1: the way to the bar's ends is long."""

_COMPACT = (1.3, 1.8)
"""Length to depth of the deeper rectangles."""


def _compact(area: float) -> list[tuple[float, float]]:
    """Return length and depth of rectangles of an area in whole metres, the most compact first."""
    depths = [float(round(math.sqrt(area / ratio))) for ratio in _COMPACT]
    return [(float(round(area / depth)), depth) for depth in depths]


def _deep_where_it_suits(
    decisions: Decisions, wish: MassingWish, layout: Arrangement, allocation: Allocation, knowledge: KnowledgeBase
) -> Arrangement:
    """Return the arrangement along parallel corridors where rooms along one are strips, and fewer are so then."""
    facts, massing = decisions.facts, layout.massing
    own = _own_sketches(layout)
    if (
        decisions.free_form or massing.hall or massing.wings
        or any(storey.setback or storey.extension for storey in layout.storeys)
        or gross_area(massing) < _DEEP_FROM
    ):  # fmt: skip
        return layout
    free = decisions.outline is None and not facts.shapes
    long = _LONG_ALONE if len(layout.storeys) == 1 else _LONG
    beyond = max(massing.length / massing.depth - long, 0.0) if free else 0.0
    if not beyond and not any(comes_out_as_strips(sketch) for sketch in own):
        return layout
    best = _price(decisions, wish, layout) + _LONG_PRICE * beyond, layout
    bare = [replace(storey, rooms=()) for storey in layout.storeys]
    rectangles = [(massing.length, massing.depth)]
    if beyond:
        rectangles += _compact(gross_area(massing))
    for candidate in (each for rectangle in rectangles for each in aisle_massings(wish, *rectangle)):
        generator = item_generator(decisions.seed, "aisles")
        found = _arranged(decisions, candidate, bare, allocation, knowledge, generator)
        price = _price(decisions, wish, found)
        if price < best[0]:
            best = price, found
    return best[1]


def _price(decisions: Decisions, wish: MassingWish, layout: Arrangement) -> float:
    """Return what an arrangement does not give and what is wrong with its rooms."""
    own = _own_sketches(layout)
    return 5.0 * _missed(decisions, wish, layout) + sum(plan_price(sketch, layout.massing) for sketch in own)


def _missed(decisions: Decisions, wish: MassingWish, layout: Arrangement) -> int:
    """Count what an arrangement does not give."""
    own = _own_sketches(layout)
    missed = sum(len(apart_pairs(decisions, storey, layout.sketches[storey.index])) for storey in layout.storeys)
    missed += sum(len(short_edges(sketch)) + misses_areas(sketch) for sketch in own)
    missed += sum(len(joined_pairs(sketch, unwanted_pairs(decisions))) for sketch in own)
    if decisions.area_stated and abs(gross_area(layout.massing) - wish.area) > 0.06 * wish.area:
        missed += _AREA_MISSED
    return missed


def _loosened_where_missed(decisions: Decisions, layout: Arrangement) -> Arrangement:
    """Return the arrangement with loose sketches of storeys that miss areas or neighbours: the solver may find them."""
    sketches: dict[int, Sketch] = {}
    for storey in layout.storeys:
        sketch = layout.sketches[storey.index]
        if storey.copy is not None:
            sketches[storey.index] = sketches[storey.copy]
        elif misses_areas(sketch) or apart_pairs(decisions, storey, sketch):
            sketches[storey.index] = loosened(sketch)
        else:
            sketches[storey.index] = sketch
    return replace(layout, sketches=sketches)


def wanted_pairs(decisions: Decisions) -> list[tuple[str, str]]:
    """Return room types to be side by side: the brief's wishes last, so that they win."""
    usual = [("kitchen", "dining_room"), ("commercial_kitchen", "restaurant"), ("commercial_kitchen", "cafeteria")]
    usual = [*HOME_PAIRS, *usual] if decisions.building.family == "home" else usual
    return usual + [_names(fact) for fact in decisions.facts.adjacent]


def unwanted_pairs(decisions: Decisions) -> list[tuple[str, str]]:
    """Return the rooms that the brief wants apart; away from "the toilets" is away from those of every type."""
    pairs: list[tuple[str, str]] = []
    for fact in decisions.facts.apart:
        first, second = _names(fact)
        pairs += itertools.product(_meant(first, fact.first), _meant(second, fact.second))
    return pairs


def _meant(name: str, kind: str) -> tuple[str, ...]:
    return tuple(dict.fromkeys((name, *TOILETS))) if kind in TOILETS and "_" not in name else (name,)


def _names(fact: AdjacencyFact) -> tuple[str, str]:
    return fact.first_name or fact.first, fact.second_name or fact.second


def apart_pairs(decisions: Decisions, storey: Storey, sketch: Sketch) -> list[AdjacencyFact]:
    """Return the wished neighbours that both are on the storey and do not touch."""
    apart = []
    for fact in decisions.facts.adjacent:
        firsts, seconds = ([p for p in sketch.rooms if p.room.called(name)] for name in _names(fact))
        if storey.hub.name in (fact.first, fact.second) or not firsts or not seconds:
            continue
        if not sketch.loose and not any(a is not b and touching(a, b) for a in firsts for b in seconds):
            apart.append(fact)
    return apart


def neighbours(decisions: Decisions, storey: Storey, sketch: Sketch) -> dict[str, list[str]]:
    """Return the neighbours that the brief wishes and the storey can give, by room id."""
    beside: dict[str, list[str]] = {}
    apart = _apart_for_good(decisions, storey, sketch)
    for fact in decisions.facts.adjacent:
        firsts, seconds = ([p for p in sketch.rooms if p.room.called(name)] for name in _names(fact))
        pairs = [(a, b) for a in firsts for b in seconds if a is not b]
        if fact not in apart and pairs and storey.hub.name not in (fact.first, fact.second):
            pair = next((p for p in pairs if decisions.free_form or sketch.loose or touching(*p)), pairs[0])
            beside.setdefault(pair[0].room.id, []).append(pair[1].room.id)
    return beside


def unmet_neighbours(decisions: Decisions, storey: Storey, sketch: Sketch) -> list[Downgrade]:
    """Return the wished neighbours that the storey cannot give."""
    apart = _apart_for_good(decisions, storey, sketch)
    return [
        Downgrade(
            wish=fact.span.words, got="both on one storey, reached from one corridor", stage="program",
            reason="their sizes leave no place side by side", floor=storey.index,
        )
        for fact in decisions.facts.adjacent
        if fact in apart
    ]  # fmt: skip


def _apart_for_good(decisions: Decisions, storey: Storey, sketch: Sketch) -> list[AdjacencyFact]:
    """Return the wished neighbours that no solver brings together; in a free outline it places all rooms itself."""
    return apart_pairs(decisions, storey, sketch) if not decisions.free_form else []


def _arranged(
    decisions: Decisions,
    massing: Massing,
    storeys: Sequence[Storey],
    allocation: Allocation,
    knowledge: KnowledgeBase,
    generator: np.random.Generator,
) -> Arrangement:
    """Fill every storey of a massing with rooms and sketch it; a copy shares its original's."""
    frame = _frame(decisions, massing, storeys, generator)
    filled = _filled(decisions, massing, storeys, allocation, knowledge)
    sketches: dict[int, Sketch] = {}
    envelopes: dict[int, Envelope] = {}
    pairs = wanted_pairs(decisions)
    for storey in filled:
        source = sketches.get(storey.copy) if storey.copy is not None else None
        beside = [*pairs_used_together(storey), *pairs]
        sketches[storey.index] = source or entered_as_told(
            _sketch(decisions, massing, storey, beside), decisions.facts.adjacent
        )
        envelopes[storey.index] = (
            Envelope.of(decisions.outline)
            if decisions.free_form and decisions.outline is not None
            else envelope_of(massing, storey, frame)
        )
    return Arrangement(massing, frame, filled, sketches, envelopes)


def _filled(
    decisions: Decisions, massing: Massing, storeys: Sequence[Storey], allocation: Allocation, knowledge: KnowledgeBase
) -> list[Storey]:
    """Return the storeys with their rooms; the entrance storey is filled last, with the toilets that others lack.

    In a home it is the basement, with what the storeys above leave out.
    """
    filled: dict[int, Storey] = {}
    others = Served()
    home = decisions.building.family == "home"
    for bare in sorted(storeys, key=lambda storey: storey.role == "basement" if home else storey.role in _ENTERED):
        source = filled.get(bare.copy) if bare.copy is not None else None
        added = {room.kind.name for storey in filled.values() for room in storey.rooms if not room.stated}
        storey = filled[bare.index] = (
            replace(bare, rooms=source.rooms)
            if source is not None
            else _with_rooms(bare, massing, allocation, knowledge, decisions, others, added)
        )
        hub = max(capacity(massing, storey) - sum(room.gross for room in storey.rooms), 0.0)
        others += served_by(storey, hub, knowledge)
    return [filled[storey.index] for storey in storeys]


_ENTERED = frozenset({"single", "ground"})
"""Roles of the storey that a building is entered on."""


def _massing(decisions: Decisions, wish: MassingWish, generator: np.random.Generator) -> Massing:
    shape = decisions.outline
    if shape is None:
        return choose_massing(wish, generator)
    if decisions.free_form:
        return free_massing(shape, free_cores(shape, wish.cores))
    x0, y0, x1, y1 = shape.bounds
    return rectangle_massing(wish, max(x1 - x0, y1 - y0), min(x1 - x0, y1 - y0))


def _frame(decisions: Decisions, massing: Massing, storeys: Sequence[Storey], generator: np.random.Generator) -> Frame:
    """Turn and mirror by chance; a given outline stays where it is."""
    mirror_x, mirror_y, swap = (bool(value) for value in generator.random(3) < 0.5)
    length = massing.length + max(storey.extension for storey in storeys)
    bounds = (0.0, -massing.drop, length, massing.depth)
    shape = decisions.outline
    if shape is None:
        return Frame(bounds, mirror_x, mirror_y, swap)
    if decisions.free_form:
        return Frame((0.0, 0.0, 0.0, 0.0))
    x0, y0, x1, y1 = shape.bounds
    return Frame(bounds, mirror_x, mirror_y, y1 - y0 > x1 - x0, origin=(x0, y0))


def _sketch(decisions: Decisions, massing: Massing, storey: Storey, pairs: list[tuple[str, str]]) -> Sketch:
    if decisions.free_form and decisions.outline is not None:
        cores = sum(box_area(core.box) for core in massing.cores)
        return sketch_free(storey, storey.hub.name, decisions.outline.area - cores)
    return sketched(massing, storey, storey.hub.name, pairs, unwanted_pairs(decisions))


def _named(decisions: Decisions) -> list[str]:
    """Return the rooms that the brief wants beside or apart from others."""
    return [name for fact in (*decisions.facts.adjacent, *decisions.facts.apart) for name in _names(fact)]


_SALES, _WAITING = "sales_area", "waiting_hall"
"""The rooms that a shop and a station are there for, and that take what the other rooms leave."""

_MOST_HUB = 0.75
"""Greatest share of a public hall's storey for its main room: the rest is for toilets, stores and staff."""

_MOST_STORE = 0.9
"""The same of a hall for cars, goods or machines, which takes all that the rooms of its list leave."""


_LEAST_HOME_HUB = 0.4
"""Least share of a home's storey for its main room beside the other rooms."""


def _most_home_hub(storey: Storey, allocation: Allocation, knowledge: KnowledgeBase, room: float) -> float:
    """Return what the main room of a home may take of the area for rooms and leave the others their least."""
    return max(room - needed_area(storey, allocation, knowledge), _LEAST_HOME_HUB * room)


_FREE, _FREE_WITH_STAIRS = 0.84, 0.78
"""Share of a given outline that rooms take, stairs apart; a hall that also leads to stairs takes more of it."""


def _takes_rest(storey: Storey) -> bool:
    """Whether the main room of a hall takes what the rooms of its list leave."""
    return storey.hub.zone == "service" or storey.hub.name in (STUDIO, _SALES, _WAITING)


def _hall_share(storey: Storey, allocation: Allocation, knowledge: KnowledgeBase, room: float) -> float:
    """Return what the main room of a hall takes of the area for rooms, where the brief does not state it."""
    most = _most_home_hub(storey, allocation, knowledge, room)
    if storey.use.family != "home":
        most = (_MOST_STORE if storey.hub.zone == "service" else _MOST_HUB) * room
    usual = room - listed_area(storey, allocation, knowledge) if _takes_rest(storey) else 0.38 * room
    least = storey.hub.least if storey.hub.name == STUDIO else storey.hub.usual
    return min(max(least, usual), most)


def _with_rooms(
    storey: Storey,
    massing: Massing,
    allocation: Allocation,
    knowledge: KnowledgeBase,
    decisions: Decisions,
    others: Served,
    elsewhere: Collection[str],
) -> Storey:
    """Choose a storey's rooms, with their areas and names; `others` are the building's other storeys.

    Parameters
    ----------
    elsewhere : collection of str
        Types of rooms that those have although the brief does not ask for them.
    """
    stated = hub_area(storey, allocation)
    form = form_of(massing, storey)
    hall = form.hall
    if decisions.free_form and decisions.outline is not None:
        cores = sum(box_area(core.box) for core in massing.cores)
        share_of_rooms = _FREE_WITH_STAIRS if cores else _FREE
        room, share = share_of_rooms * (decisions.outline.area - cores), 0.0
    else:
        room, share = capacity(massing, storey), 0.0
    takes_rest = hall and _takes_rest(storey)
    if hall:
        share = stated or _hall_share(storey, allocation, knowledge, room)
    most = most_fronts(form) if hall else MOST_ROOMS
    filled = fill_storey(storey, allocation, knowledge, room, hub_share=share, most_rooms=most, elsewhere=elsewhere)
    filled = with_kitchen(filled, storey, allocation, knowledge, share)
    filled = with_changing_rooms(filled, storey, allocation, knowledge)
    grows_to = 0.0 if hall else room
    chosen = with_public_toilets(storey, filled, allocation, knowledge, share, others, grows_to)
    chosen = behind_staff_rooms(for_sleepers(chosen, storey), storey, _named(decisions))
    if hall and stated:
        room -= share
    elif hall:
        asked = sum(r.gross for r in chosen)
        wanted = sum(r.gross for r in chosen if r.stated)
        share = max(storey.hub.least, 0.5 * share, min(share, room - wanted))
        room = min(room - share, asked if takes_rest or allocation.told else max(asked, 0.45 * room))
    foyer = 0.0 if decisions.free_form else foyer_length(storey, form, chosen, room, stated)
    rooms = name_rooms(fit_areas(chosen, room - foyer * form.south), storey.hub.name)
    return replace(storey, rooms=rooms, foyer=foyer)

"""Choose the massing: stairs and lifts, the gross area of a storey, and the dimensions that all storeys share."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from mansion_geometry.wall_sizes import INTERIOR_THICKNESS
from mansion_knowledge import BuildingType, KnowledgeBase
from mansion_knowledge.norms import load_norms
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import Downgrade, TraceEntry
from mansion_msgs_py.wording import with_article
from mansion_planner.program.allocation import Allocation
from mansion_planner.program.building_size import called_size
from mansion_planner.program.decisions import AREA_CAP, Decisions, conflict, note
from mansion_planner.program.hall_wings import hall_of_wing
from mansion_planner.program.model import LIFT, CoreBox, CoreWish, Massing, Storey, Wing
from mansion_planner.program.plan_quality import FACING
from mansion_planner.program.shape_sizes import holds_shape, least_area
from mansion_planner.program.stairs import second_stair
from mansion_planner.program.step_record import Record
from mansion_planner.program.storey_rooms import base_rooms, hub_area, listed_area
from mansion_planner.program.storeys import entries_of, is_hall

__all__ = [
    "MassingWish",
    "choose_massing",
    "choose_shape",
    "corridor_width",
    "rectangle_massing",
    "storey_area",
    "typical_room",
    "vertical_method",
]

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
    rule = load_norms().rules["lift"]
    if lifts == 0 and rule.holds_for(decisions.building.family):
        lifts = int(levels > rule.limit(decisions.building.name, decisions.building.family))
    if "no_elevator" in wishes:
        lifts, reason = 0, f'{levels} storeys, "{wishes["no_elevator"].words}"'
    elif "elevator" in wishes and lifts == 0:
        lifts, reason = 1, f'{levels} storeys, "{wishes["elevator"].words}"'
    wanted_lifts = max((int(quantity.value) for quantity in decisions.facts.lifts), default=0)
    if wanted_lifts and "no_elevator" not in wishes:
        lifts, reason = min(wanted_lifts, _MOST_LIFTS), f'{levels} storeys, "{decisions.facts.lifts[0].span.words}"'
    if "no_stair" in wishes:
        return "elevator", 0, max(lifts, 1), f'elevator alone, as "{wishes["no_stair"].words}" asks'
    far = second_stair(decisions, storeys, allocation, knowledge)
    stairs = 2 if far else 1
    reason += f", {far}: a second stair at the far end" if far else ""
    wanted_stairs = max((int(quantity.value) for quantity in decisions.facts.stairs), default=0)
    if wanted_stairs == 1:
        stairs = 1
    method: Method = "stair_and_elevator" if lifts else "stair"
    return method, stairs, lifts, f"{method.replace('_', ' ')} for {reason}"


_SQUEEZE = 1.3
"""Factor by which rooms at their least usual sizes may exceed the stated area: they are then made smaller."""

_TINY, _TINY_SQUEEZE = 60.0, 1.7
"""Square metres up to which a storey is for people who want small rooms, and by how much these may ask for more."""

_LARGER = 1.25
"""Area of a storey of a home or hall that is called large, as a share of what its rooms usually take."""

_HOPELESS = 1.5
"""Share of the stated area above which no building can hold the rooms asked for."""


_OF_STOREY = 0.6
"""Greatest share of a usual storey for its main room, where the brief tells the others."""

_SEAT = 2.2
"""Square metres of a hall for each person that it is for."""


def _hub_of(storey: Storey, decisions: Decisions, allocation: Allocation) -> float:
    """Return the square metres that the main room of a hall needs."""
    people = sum(occupants.count for occupants in decisions.facts.occupants)
    usual = min(storey.hub.usual, _OF_STOREY * decisions.building.floor_area[1])
    usual = max(_SEAT * people, storey.hub.least) if people else usual
    return hub_area(storey, allocation) or (usual if allocation.told else storey.hub.least)


def _circulation(decisions: Decisions, cores: CoreWish) -> tuple[float, float]:
    """Return what cores and lobby take, and the share of the rest that corridors take."""
    if is_hall(decisions):
        return cores.area, 0.0
    return cores.area + (24.0 if cores.lifts else 0.0), 0.17


def _foyer(decisions: Decisions, cores: CoreWish) -> float:
    """Return the square metres of the foyer of a public building without a lift's lobby."""
    units = any(fact.unit for fact in decisions.facts.rooms)
    alone = is_hall(decisions) or cores.lifts or decisions.building.family == "home" or units
    return 0.0 if alone else _FOYER_AREA


_FOYER_AREA = 14.0


def storey_area(
    decisions: Decisions, storeys: list[Storey], allocation: Allocation, knowledge: KnowledgeBase, cores: CoreWish
) -> tuple[float, Record]:
    """Return the gross area of a storey in square metres; a stated one that the rooms do not fit in gives way.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` when the rooms asked for do not fit into the area asked for.
    """
    fixed, share = _circulation(decisions, cores)
    need, fullest, least = 0.0, storeys[0], 0.0
    wanted = {storey.index: base_rooms(storey, allocation, knowledge) for storey in storeys}
    wing = hall_of_wing(decisions, storeys, wanted)
    for storey in storeys:
        rooms = wanted[storey.index]
        hub = _hub_of(storey, decisions, allocation) if is_hall(decisions) else 0.0
        wished = sum(room.gross for room in rooms)
        wished = listed_area(storey, allocation, knowledge) if allocation.told else wished
        wished -= wing.area if wing is not None and storey.role == "ground" else 0.0
        tight = sum(max(r.least, 0.0) for room in rooms for r in room.each()) + hub
        least = max(least, (tight + fixed) / (1.0 - 0.6 * share))
        if wished + hub > need:
            need, fullest = wished + hub, storey
    if decisions.area_stated:
        squeeze = _TINY_SQUEEZE if decisions.area <= _TINY else _SQUEEZE
        if least <= decisions.area * squeeze:
            return decisions.area, Record()
        return least, Record(downgrades=(_outgrown(decisions, storeys, allocation, fullest, least),))
    fixed += _foyer(decisions, cores)
    asked = (need + fixed) / (1.0 - share) * 1.02
    usual = decisions.area
    if decisions.building.parti != "spine" or _is_counted(storeys, allocation):
        typical = _typical(decisions, storeys, allocation, knowledge, fixed, share)
        called = called_size(decisions.facts)
        usual = typical * 0.85 if called == "small" else min(typical, 1.5 * usual)
        usual = decisions.as_called(usual * _LARGER if called == "large" else usual)
    least = decisions.as_called(decisions.building.floor_area[0])
    if decisions.building.family != "home" and _is_told(storeys, allocation):
        usual, least = min(usual, _BEYOND_TOLD * asked), min(least, asked)
    result = max(usual, asked, least)
    if decisions.facts.shapes:
        result = max(result, least_area(decisions.facts.shapes[0][0], cores.stairs))
    trace: list[TraceEntry] = []
    if result > usual + 1.0 and asked > usual:
        note(trace, None, f"{result:.0f} m2 a storey, for the rooms of storey {fullest.index}")
    if result > AREA_CAP:
        note(trace, None, f"above {AREA_CAP:.0f} m2 a storey, for the rooms asked for")
    return result, Record(tuple(trace))


def _is_counted(storeys: Sequence[Storey], allocation: Allocation) -> bool:
    """Whether the brief says how many there are of all that storeys would be filled up with, as guest rooms of a hotel.

    Such a building is as large as what it holds, and not as large as others of its kind.
    """
    repeated = {entry.room_type for storey in storeys for entry in entries_of(storey) if entry.repeat}
    return bool(repeated) and not any(
        allocation.adds(name, storey.index) for name in repeated for storey in storeys if storey.index >= 1
    )


_KINDS_TOLD, _KINDS_A_STOREY = 5, 3.0
"""Number of kinds of rooms, in all and for each storey, from which a brief says what a building holds."""

_BEYOND_TOLD = 1.2
"""Area of a storey of such a building at most, as a share of what its rooms take, where nobody states it."""


def _is_told(storeys: Sequence[Storey], allocation: Allocation) -> bool:
    """Whether a brief tells what a building holds, so that it is as large as that and has hardly a room besides."""
    kinds = {fact.room_type for storey in storeys for fact in allocation.wanted[storey.index]}
    return allocation.told or len(kinds) >= max(_KINDS_TOLD, _KINDS_A_STOREY * len(storeys))


def _outgrown(
    decisions: Decisions, storeys: Sequence[Storey], allocation: Allocation, fullest: Storey, least: float
) -> Downgrade:
    """Return the record that the stated area gave way to the one that the rooms asked for need.

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
    return conflict(wish, f"{least:.0f} m2 a storey", reason, fullest.index)


_WITH_WAYS = 1.1
"""A storey's area for a main room's furniture and the ways through it, as a share of what the furniture needs."""


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
        stated = _WITH_WAYS * hub_area(storey, allocation)
        hub = max(1.3 * storey.hub.usual, stated) if is_hall(decisions) else 0.0
        most = max(most, listed_area(storey, allocation, knowledge) + hub)
    return (most + fixed) / (1.0 - share)


def typical_room(storeys: list[Storey], allocation: Allocation, knowledge: KnowledgeBase) -> float:
    """Return the median area of the rooms above 8 m2 on a typical storey, square metres.

    Where the brief tells what the building holds, it is that of the rooms which take most of the floor.
    """
    areas: list[float] = []
    if allocation.told:
        told = [room.gross for s in storeys if s.index >= 1 for room in base_rooms(s, allocation, knowledge)]
        return _half_of_floor(told)
    for storey in storeys:
        if storey.index < 1:
            continue
        areas += [room.gross for room in base_rooms(storey, allocation, knowledge)]
        for entry in entries_of(storey):
            gross = allocation.added(entry, knowledge).gross
            areas += [gross] * (entry.count + 2 * entry.repeat)
    areas = sorted(area for area in areas if 8.0 <= area <= 90.0)
    return areas[len(areas) // 2] if areas else 40.0


def _half_of_floor(areas: Sequence[float]) -> float:
    """Return the area of the room in which half of the floor of all is reached, the smallest first."""
    ordered, reached = sorted(areas), 0.0
    for area in ordered:
        reached += area
        if 2.0 * reached >= sum(ordered):
            return area
    return 40.0


@dataclass(frozen=True)
class MassingWish:
    """What the massing has to meet.

    Attributes
    ----------
    area : float
        Gross area of a storey, square metres.
    cores : CoreWish
    shape : str
        ``rectangle``, ``square``, ``L``, ``U``, ``T``, ``H`` or ``courtyard``.
    room : float
        Area of a typical room, which sets the depth of the band opposite the stair.
    variant : int
        Takes another of the candidate depths than the most fitting one.
    exact : bool
        The area is asked for, so it is met as closely as whole metres allow.
    hall : bool
        The main room is the hub (see `mansion_planner.program.storeys.is_hall`).
    """

    area: float
    use: BuildingType
    cores: CoreWish
    shape: str = "rectangle"
    exact: bool = False
    room: float = 40.0
    variant: int = 0
    hall: bool = False


def _is_narrow(shape: str, area: float, stairs: int) -> bool:
    """Whether a U has shallow rooms along a narrow corridor, no stair being as deep as they are."""
    return shape == "U" and not stairs and area < least_area("U", 1)


def choose_shape(decisions: Decisions, area: float, stairs: int, generator: np.random.Generator) -> tuple[str, Record]:
    """Return the outline's shape: stated, or sampled by use and size; a plan too small for its shape is simpler."""
    draw = float(generator.random())
    if decisions.facts.shapes:
        shape, span = decisions.facts.shapes[0]
        least = least_area(shape, stairs)
        if decisions.free_form or holds_shape(shape, area, stairs):
            trace: list[TraceEntry] = []
            note(trace, span, f"{shape} outline")
            return "rectangle" if decisions.free_form else str(shape), Record(tuple(trace))
        simpler = Downgrade(
            wish=f"{shape} outline", got="rectangle", stage="program",
            reason=f"{with_article(shape)} plan takes at least {least:.0f} m2 a storey, "
            f"there are {area:.0f}",
        )  # fmt: skip
        return "rectangle", Record(downgrades=(simpler,))
    wings = decisions.floors == 1  # the corridor of a wing above others is a dead end, or asks for a stair of its own
    if wings and decisions.building.parti == "spine" and area >= 300 and draw < 0.25:
        return "L" if draw < 0.17 else "T", Record()
    return "rectangle", Record()


def corridor_width(use: BuildingType, area: float) -> float:
    """Return the width of the corridors of a building whose storeys have `area` square metres, metres."""
    if use.family == "home" and use.parti != "spine":
        return 1.3 if area < 140 else 1.4
    if use.family == "home" or use.parti == "house":
        return 1.4 if area < 140 else 1.6
    if not FACING.isdisjoint(use.main) and "stage" not in use.main:
        return _FOYER
    usual = 1.8 if area < 300 else 2.0
    if use.family in ("health", "education", "retail", "culture", "transport"):
        usual = 2.0 if area < 300 else 2.4
    asked = load_norms().rules["corridor_width"].limit(use.name, use.family) + INTERIOR_THICKNESS
    return max(usual, math.ceil(10.0 * asked) / 10.0)


_FOYER = 3.0
"""Width of the corridor between rooms for audiences, which is where these wait and buy their tickets, metres."""


def _bands(wish: MassingWish) -> list[tuple[float, float, float]]:
    """List candidate (north, corridor, south) depths with a whole-metre sum, the most fitting first."""
    area, cores = wish.area, wish.cores
    corridor = corridor_width(wish.use, area)
    stair = float(cores.stair[1])
    if _is_narrow(wish.shape, area, cores.stairs):
        corridor = 1.4
        return [((d - corridor) / 2, corridor, (d - corridor) / 2) for d in (8, 9)]
    if wish.shape in ("H", "courtyard", "U") and area < 620:
        corridor = corridor if wish.use.family == "home" else 1.8
        return [(stair, corridor, d - stair - corridor) for d in (12, 13)]
    if wish.hall and wish.shape in ("rectangle", "square"):
        side = math.sqrt(area / 1.35)
        return [(0.0, float(d), 0.0) for d in _around(side, 4 if not cores.stairs else 6)]
    if cores.stairs and cores.domestic:
        depth = min(max(math.sqrt(area / 1.4), 7.0), 11.5)
        return [_domestic_bands(d, corridor, stair) for d in _around(depth, 7, 14)]
    if cores.stairs and area >= 150:
        south = min(max(math.sqrt(1.35 * wish.room), 4.0), _DEEPEST if wish.room > _LARGE else 8.0)
        depth = min(max(stair + corridor + south, math.sqrt(area / 2.6)), math.sqrt(area / 1.2))
        bands = [(stair, corridor, d - stair - corridor) for d in _around(depth, 11, 19 if wish.room > _LARGE else 17)]
        return [band for band in bands if band[2] >= _SHALLOWEST] or bands
    if cores.stairs:
        depth = min(max(math.sqrt(area / 1.25), 8.0), 10.5)
        upright = [(stair, corridor, d - stair - corridor) for d in (11, 12, 13)]
        return [
            (max(3.0, 0.42 * (d - corridor)), corridor, d - corridor - max(3.0, 0.42 * (d - corridor)))
            for d in _around(depth, 7, 11)
        ] + (upright if area >= 85 else [])
    depth = min(max(math.sqrt(area / 1.5), 5.0), 16.0)
    return [((d - corridor) / 2, corridor, (d - corridor) / 2) for d in _around(depth, 5, 17)]


_LARGE, _DEEPEST = 90.0, 10.0
"""Area of a typical room from which on the rooms across the corridor from a public stair are so deep, in m2 and m."""

_SHALLOWEST = 3.0
"""Least depth of the rooms across the corridor from a public stair, metres."""

_SHALLOW = 2.7
"""Least depth of the rooms across the corridor from a domestic stair that stands upright, metres."""


def _domestic_bands(depth: float, corridor: float, stair: float) -> tuple[float, float, float]:
    """Return the bands of a home, the stair along the depth where that leaves rooms across the corridor."""
    north = 0.45 * (depth - corridor)
    north = max(north, stair) if depth - corridor - stair >= _SHALLOW else max(north, 2.4)
    return north, corridor, depth - corridor - north


def _around(wish: float, least: int, most: int = 60) -> list[int]:
    values = range(max(least, round(wish) - 3), min(most, round(wish) + 3) + 1)
    ordered = sorted(values, key=lambda value: (abs(value - wish), value))
    return ordered or [least]


def choose_massing(wish: MassingWish, generator: np.random.Generator) -> Massing:
    """Choose dimensions in whole metres for the wished area and shape, and place the cores.

    Parameters
    ----------
    wish : MassingWish
    generator : numpy.random.Generator
        Varies proportions within what suits the building.
    """
    if wish.shape == "square":
        side = max(round(math.sqrt(wish.area)), _least_side(wish.cores))
        return rectangle_massing(wish, float(side), float(side))
    candidates = _bands(wish)
    if wish.variant:
        candidates = _near_the_area(wish, candidates) if wish.exact else candidates
        candidates = [candidates[-wish.variant % len(candidates)]]
    jitter = generator.random(len(candidates))
    best: tuple[float, Massing] | None = None
    for number, (north, corridor, south) in enumerate(candidates):
        massing = _dimensions(wish, north, corridor, south)
        error = abs(gross_area(massing) - wish.area) / wish.area
        cost = (14.0 if wish.exact else 4.0) * error + 0.25 * number + 0.3 * float(jitter[number])
        if wish.exact and error > 0.03:
            cost += 5.0
        if best is None or cost < best[0]:
            best = (cost, massing)
    assert best is not None
    return best[1]


_FURTHER = 0.05
"""Share of a stated area by which another depth may miss it more than the nearest does."""


def _near_the_area(wish: MassingWish, candidates: list[tuple[float, float, float]]) -> list[tuple[float, float, float]]:
    """Return the depths whose storeys are nearly as close to the area as the closest; no variant gives up an area."""
    errors = [abs(gross_area(_dimensions(wish, *bands)) - wish.area) / wish.area for bands in candidates]
    return [bands for bands, error in zip(candidates, errors, strict=True) if error <= min(errors) + _FURTHER]


def _least_side(cores: CoreWish) -> int:
    """Return the least side of a square that holds the stairs beside rooms, metres."""
    if cores.domestic:
        return 7
    return (5, 9, 12)[min(cores.stairs, 2)]


def rectangle_massing(wish: MassingWish, length: float, depth: float) -> Massing:
    """Return the massing of a given rectangle; the corridor runs along its longer side."""
    corridor = corridor_width(wish.use, wish.area)
    north = (depth - corridor) / 2
    if wish.hall:
        north, corridor, south = 0.0, depth, 0.0
    else:
        if wish.cores.stairs and wish.cores.domestic:
            north, corridor, _ = _domestic_bands(depth, corridor, float(wish.cores.stair[1]))
        elif wish.cores.stairs and depth >= 10.8:
            north = float(wish.cores.stair[1])
        elif wish.cores.stairs:
            north = max(3.0, 0.42 * (depth - corridor))
        south = depth - corridor - north
    if depth < 6.0 and not wish.hall:
        corridor = max(1.4, min(corridor, 0.3 * depth))
        south = max(depth - corridor - north, 0.3)
        north = depth - corridor - south
    return _dimensions(replace(wish, shape="rectangle"), north, corridor, south, length)


def gross_area(massing: Massing) -> float:
    """Return the area inside the outline of a storey without setback."""
    area = massing.length * massing.depth + massing.court * massing.far_length
    return area + sum((wing.x1 - wing.x0) * wing.reach for wing in massing.wings)


def _dimensions(wish: MassingWish, north: float, corridor: float, south: float, given: float | None = None) -> Massing:
    depth = north + corridor + south
    least = 6 if wish.cores.domestic else 6 + wish.cores.stairs * wish.cores.stair[0]
    hall = wish.hall and wish.shape in ("rectangle", "square")
    wings: tuple[Wing, ...] = ()
    length, court = given or 0.0, 0.0
    if given is None:
        length, wings, court = _plan_shape(wish, depth, corridor, least)
    lobby = 0.0
    corner = not any(wing.x0 < 1.0 for wing in wings)
    if wish.cores.lifts and corner and _is_dead_end(wish, south):
        # Lifts at the corridor end where it begins, and every core in whole metres.
        north, south = north + south - math.floor(south + 1e-9), float(math.floor(south + 1e-9))
    if wish.cores.lifts and not hall and corner:
        lobby = max(4.0, 2.0 * wish.cores.lifts) if wish.use.family != "home" else 3.5
    cores = _cores(wish, float(length), depth, (north, south), south + corridor if not corner else -1.0)
    entrance = 3.0 if wish.area >= 220 and lobby else 0.0
    if wings and not hall:
        entrance = min(entrance, max(min(wing.x0 for wing in wings) - lobby - 3.0, 0.0))
    return Massing(
        length=float(length), north=north, corridor=corridor, south=south, cores=cores,
        lobby=lobby, wings=wings, court=court, hall=hall, entrance=entrance,
    )  # fmt: skip


def _plan_shape(wish: MassingWish, depth: float, corridor: float, least: int) -> tuple[int, tuple[Wing, ...], float]:
    """Return the main bar's length, the wings and the depth of the far bar for the wished outline."""
    shape, area = wish.shape, wish.area
    if shape in ("rectangle", "square"):
        return max(least, round(area / depth)), (), 0.0
    side = 3.2 if area < 180 else 4.0 if area < 320 else 5.0
    if (shape in ("H", "courtyard") and area < 620) or (shape == "U" and area < 420):
        side = 3.2
    if _is_narrow(shape, area, wish.cores.stairs):
        side = 2.8
    gap = 4 if area < 520 else 6
    lobby = max(4, 2 * wish.cores.lifts) + 1 if wish.cores.lifts else 3
    width = max(6, round(2 * side + corridor))
    arms = {"L": 1, "T": 1, "U": 2, "H": 1, "courtyard": 2}[shape]
    flank = 2 * max(5, lobby)
    room = {
        "L": max(least, width + lobby), "T": width + flank, "U": 2 * width + gap, "H": width + flank,
        "courtyard": 2 * width + gap,
    }[shape]  # fmt: skip
    court = width if shape in ("H", "courtyard") else 0
    reach = 5
    length = max(room, round((area - arms * width * reach) / (depth + court)))
    if shape in ("L", "T", "U"):
        length = max(room, round(0.62 * area / depth))
        reach = max(4, round((area - length * depth) / (arms * width)))
    last = float(length)
    if shape == "L":
        wings: tuple[Wing, ...] = (Wing(last - width, last, float(reach)),)
    elif shape in ("T", "H"):
        middle = float((length - width) // 2)
        wings = (Wing(middle, middle + width, float(reach)),)
    else:
        wings = (Wing(0.0, float(width), float(reach)), Wing(last - width, last, float(reach)))
    return length, wings, float(court)


def _cores(
    wish: MassingWish, length: float, depth: float, bands: tuple[float, float], pocket: float
) -> tuple[CoreBox, ...]:
    """Place stairs in the upper corners and lifts in the lower one, each against two outer walls.

    Where a lobby from there to the corridor would be a longer dead end than the rules of building allow, lifts stand at
    the corridor. Where a wing takes the lower corner, `pocket` is the corridor's upper edge and the lifts stand beside
    the stair.

    Parameters
    ----------
    bands : (float, float)
        Depth of the bands above and below the corridor, metres.
    """
    cores: list[CoreBox] = []
    north, south = bands
    wide, high = wish.cores.stair
    if north < high - 0.01 and not (wish.hall and depth >= high + 10):
        wide, high = high, wide
    for number in range(wish.cores.stairs):
        x0 = 0.0 if number == 0 else length - wide
        box = (x0, depth - high, x0 + wide, depth)
        cores.append(CoreBox(f"stair_{number + 1}", "stair", box, "south"))
    for number in range(wish.cores.lifts):
        if pocket >= 0.0:
            x0 = float(wide + LIFT * number)
            low = math.ceil(pocket - 1e-9)
            cores.append(
                CoreBox(f"elevator_{number + 1}", "elevator", (x0, float(low), x0 + LIFT, float(low + LIFT)), "south")
            )
            continue
        y0 = max(south - LIFT, 0.0) if _is_dead_end(wish, south) else 0.0
        box = (float(LIFT * number), y0, float(LIFT * (number + 1)), y0 + LIFT)
        cores.append(CoreBox(f"elevator_{number + 1}", "elevator", box, "north"))
    return tuple(cores)


_AROUND = 0.7
"""Metres by which the way from the far corner of a lobby exceeds the depth of the lobby."""


def _is_dead_end(wish: MassingWish, lobby: float) -> bool:
    """Whether a lift lobby is so deep, in metres, that it is a longer dead end than where two exits are needed."""
    norm = load_norms().rules["dead_end"]
    asked = wish.cores.stairs > 1 and norm.holds_for(wish.use.family) and not wish.hall
    return asked and lobby + _AROUND > norm.limit(wish.use.name, wish.use.family)

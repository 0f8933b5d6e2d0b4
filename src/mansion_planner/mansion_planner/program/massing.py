"""Choose the massing: the bar's dimensions for an area, and the cores in its corners (Fig. 23, core preferences)."""

import math
from dataclasses import dataclass, replace

import numpy as np

from mansion_knowledge import BuildingType
from mansion_msgs_py.program import Downgrade
from mansion_msgs_py.wording import with_article
from mansion_planner.program.decisions import Decisions
from mansion_planner.program.inference import note
from mansion_planner.program.model import CoreBox, Massing, Wing

__all__ = ["MassingWish", "choose_massing", "choose_shape", "least_area", "rectangle_massing"]

STAIR = (3, 6)
LIFT = 2
STAIR_DEPTH = 6.0


@dataclass(frozen=True)
class MassingWish:
    """What the massing has to meet.

    Attributes
    ----------
    area : float
        Gross area of a storey, square metres.
    stairs, lifts : int
    shape : str
        ``rectangle``, ``square``, ``L``, ``U``, ``T``, ``H`` or ``courtyard``.
    room : float
        Area of a typical room, which sets the depth of the band opposite the stair.
    variant : int
        Takes another of the candidate depths than the most fitting one.
    exact : bool
        The area is asked for, so it is met as closely as whole metres allow.
    """

    area: float
    use: BuildingType
    stairs: int
    lifts: int
    shape: str = "rectangle"
    exact: bool = False
    room: float = 40.0
    variant: int = 0


_LEAST_AREA = {"L": 110.0, "T": 170.0, "U": 300.0, "H": 380.0, "courtyard": 440.0}


def least_area(shape: str) -> float:
    """Return the least gross area of a storey with an outline of that shape, square metres."""
    return _LEAST_AREA.get(shape, 0.0)


def choose_shape(decisions: Decisions, area: float, generator: np.random.Generator) -> str:
    """Return the outline's shape: stated, or sampled by use and size; a plan too small for its shape is simpler."""
    draw = float(generator.random())
    if decisions.facts.shapes:
        shape, span = decisions.facts.shapes[0]
        if area >= _LEAST_AREA.get(shape, 0.0) * 0.98:
            note(decisions.trace, span, f"{shape} outline")
            return str(shape)
        decisions.downgrades.append(
            Downgrade(
                wish=f"{shape} outline", got="rectangle", stage="program",
                reason=f"{with_article(shape)} plan takes at least {_LEAST_AREA[shape]:.0f} m2 a storey, "
                f"there are {area:.0f}",
            )
        )  # fmt: skip
        return "rectangle"
    if decisions.building.parti == "spine" and area >= 300 and draw < 0.25:
        return "L" if draw < 0.17 else "T"
    return "rectangle"


def _corridor_width(use: BuildingType, area: float) -> float:
    if use.family == "home" or use.parti == "house":
        return 1.6 if area < 140 else 2.0
    if use.family in ("health", "education", "retail", "culture", "transport"):
        return 2.0 if area < 300 else 2.4
    return 1.8 if area < 300 else 2.0


def _bands(use: BuildingType, area: float, stairs: int, room: float, shape: str) -> list[tuple[float, float, float]]:
    """List candidate (north, corridor, south) depths with a whole-metre sum, the most fitting first."""
    corridor = _corridor_width(use, area)
    plain = shape in ("rectangle", "square")
    if shape in ("H", "courtyard", "U") and area < 620:
        corridor = 1.8
        return [(STAIR_DEPTH, corridor, d - STAIR_DEPTH - corridor) for d in (12, 13)]
    if use.parti == "hall" and plain:
        side = math.sqrt(area / 1.35)
        return [(0.0, float(d), 0.0) for d in _around(side, 4 if not stairs else 6)]
    if stairs and area >= 150:
        south = min(max(math.sqrt(1.35 * room), 4.0), 8.0)
        wish = min(max(STAIR_DEPTH + corridor + south, math.sqrt(area / 2.6)), math.sqrt(area / 1.2))
        return [(STAIR_DEPTH, corridor, d - STAIR_DEPTH - corridor) for d in _around(wish, 11, 17)]
    if stairs:
        wish = min(max(math.sqrt(area / 1.25), 8.0), 10.5)
        upright = [(STAIR_DEPTH, corridor, d - STAIR_DEPTH - corridor) for d in (11, 12, 13)]
        return [
            (max(3.0, 0.42 * (d - corridor)), corridor, d - corridor - max(3.0, 0.42 * (d - corridor)))
            for d in _around(wish, 7, 11)
        ] + (upright if area >= 85 else [])
    wish = min(max(math.sqrt(area / 1.5), 5.0), 16.0)
    return [((d - corridor) / 2, corridor, (d - corridor) / 2) for d in _around(wish, 5, 17)]


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
    candidates = _bands(wish.use, wish.area, wish.stairs, wish.room, wish.shape)
    if wish.variant:
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


def rectangle_massing(wish: MassingWish, length: float, depth: float) -> Massing:
    """Return the massing of a given rectangle; the corridor runs along its longer side."""
    corridor = _corridor_width(wish.use, wish.area)
    north = (depth - corridor) / 2
    if wish.use.parti == "hall":
        north, corridor, south = 0.0, depth, 0.0
    else:
        if wish.stairs and depth >= 10.8:
            north = STAIR_DEPTH
        elif wish.stairs:
            north = max(3.0, 0.42 * (depth - corridor))
        south = depth - corridor - north
    if depth < 6.0 and wish.use.parti != "hall":
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
    least = 6 + (3 if wish.stairs else 0) + (3 if wish.stairs > 1 else 0)
    hall = wish.use.parti == "hall" and wish.shape in ("rectangle", "square")
    wings: tuple[Wing, ...] = ()
    length, court = given or 0.0, 0.0
    if given is None:
        length, wings, court = _plan_shape(wish, depth, corridor, least)
    lobby = 0.0
    corner = not any(wing.x0 < 1.0 for wing in wings)
    if wish.lifts and not hall and corner:
        lobby = max(4.0, 2.0 * wish.lifts) if wish.use.family != "home" else 3.5
    cores = _cores(wish, float(length), depth, north, south + corridor if not corner else -1.0)
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
    if shape in ("H", "courtyard") and area < 620:
        side = 3.2
    gap = 4 if area < 520 else 6
    lobby = max(4, 2 * wish.lifts) + 1 if wish.lifts else 3
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


def _cores(wish: MassingWish, length: float, depth: float, north: float, pocket: float) -> tuple[CoreBox, ...]:
    """Place stairs in the upper corners and lifts in the lower one, each against two outer walls.

    Where a wing takes the lower corner, `pocket` is the corridor's upper edge and the lifts stand beside the stair.
    """
    cores: list[CoreBox] = []
    upright = north >= STAIR_DEPTH - 0.01 or (wish.use.parti == "hall" and depth >= 16)
    wide, high = (STAIR[0], STAIR[1]) if upright else (STAIR[1], STAIR[0])
    for number in range(wish.stairs):
        x0 = 0.0 if number == 0 else length - wide
        box = (x0, depth - high, x0 + wide, depth)
        cores.append(CoreBox(f"stair_{number + 1}", "stair", box, "south"))
    for number in range(wish.lifts):
        if pocket >= 0.0:
            x0 = float(wide + LIFT * number)
            low = math.ceil(pocket - 1e-9)
            cores.append(
                CoreBox(f"elevator_{number + 1}", "elevator", (x0, float(low), x0 + LIFT, float(low + LIFT)), "south")
            )
            continue
        box = (float(LIFT * number), 0.0, float(LIFT * (number + 1)), float(LIFT))
        cores.append(CoreBox(f"elevator_{number + 1}", "elevator", box, "north"))
    return tuple(cores)

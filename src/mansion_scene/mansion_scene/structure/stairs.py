"""Dog-leg stairs that fit their core.

The floor landing lies at the same end of the core on every floor, so that flights stack.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Final

from shapely.geometry import Polygon, box

from mansion_geometry.dog_legs import FLIGHT_WELL, dog_leg, landing_depth
from mansion_geometry.stair_landings import landing_end
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import CorePlan
from mansion_msgs_py.scene import Box3, StairDetails
from mansion_msgs_py.shapes import CompassSide, Point, Point3, Ring
from mansion_scene.structure.dimensions import INTERIOR_THICKNESS

__all__ = ["StairFrame", "core_interior", "landing_zone", "stair_details", "stair_frame"]

_RAIL_HEIGHT: Final = 0.95
_LANDING_THICKNESS: Final = 0.18

_INWARD: Final[dict[CompassSide, Point]] = {
    "south": (0.0, 1.0),
    "north": (0.0, -1.0),
    "west": (1.0, 0.0),
    "east": (-1.0, 0.0),
}


@dataclass(frozen=True)
class StairFrame:
    """The net interior of a stair core as seen from its floor landing.

    Attributes
    ----------
    origin : Point
        Left corner of the landing's end, looking up the stair.
    forward : Point
        Unit vector from the landing's end to the other.
    length, width : float
        Along and across `forward`.
    """

    origin: Point
    forward: Point
    length: float
    width: float

    @property
    def landing(self) -> float:
        """Depth of the floor landing; depends on the core alone, so that it is the same on every floor."""
        return landing_depth(self.length)

    def point(self, along: float, across: float) -> Point:
        """Return the plan point at a distance up the stair and to the right of its left edge."""
        (fx, fy), (ox, oy) = self.forward, self.origin
        return round(ox + fx * along + fy * across, 4) + 0.0, round(oy + fy * along - fx * across, 4) + 0.0

    def rectangle(self, along: tuple[float, float], across: tuple[float, float]) -> Ring:
        """Return a rectangle of the frame as a counter-clockwise ring."""
        (x0, y0), (x1, y1) = self.point(along[0], across[0]), self.point(along[1], across[1])
        x0, x1, y0, y1 = min(x0, x1), max(x0, x1), min(y0, y1), max(y0, y1)
        return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]

    def box(self, along: tuple[float, float], across: tuple[float, float], z: tuple[float, float]) -> Box3:
        """Return a box over a rectangle of the frame."""
        ring = self.rectangle(along, across)
        return (*ring[0], round(z[0], 4)), (*ring[2], round(z[1], 4))


def core_interior(core: CorePlan) -> Polygon:
    """Return a core within walls on all its sides, whatever stands there on a single floor."""
    (x0, x1), (y0, y1) = sorted(core.x), sorted(core.y)
    wall = INTERIOR_THICKNESS / 2
    return box(x0 + wall, y0 + wall, x1 - wall, y1 - wall)


def stair_frame(core: CorePlan, net: Polygon, outline: Polygon) -> StairFrame:
    """Return the frame of a stair core.

    Parameters
    ----------
    core : CorePlan
    net : Polygon
        Net interior of the core (its bounding box is used).
    outline : Polygon
        Outline of the floor; decides the landing's end when the core does not state it.
    """
    x0, y0, x1, y1 = net.bounds
    side = core.landing or landing_end(core, outline)
    corners: dict[CompassSide, Point] = {"south": (x0, y0), "north": (x1, y1), "west": (x0, y1), "east": (x1, y0)}
    along_y = side in ("south", "north")
    length, width = (y1 - y0, x1 - x0) if along_y else (x1 - x0, y1 - y0)
    return StairFrame(corners[side], _INWARD[side], length, width)


def landing_zone(core: CorePlan, outline: Polygon) -> Polygon:
    """Return the part of a stair core, on wall centre lines, through whose walls a door reaches the floor landing."""
    (x0, x1), (y0, y1) = sorted(core.x), sorted(core.y)
    frame = stair_frame(core, box(x0, y0, x1, y1), outline)
    ring = frame.rectangle((0.0, frame.landing), (0.0, frame.width))
    return Polygon(ring).buffer(1e-3, join_style="mitre")


def stair_details(
    core_id: str, frame: StairFrame, height: float, *, goes_up: bool, comes_from_below: bool
) -> StairDetails:
    """Lay out the flights that leave a floor.

    Parameters
    ----------
    frame : StairFrame
    height : float
        Height from this floor to the next, metres.
    goes_up, comes_from_below : bool
        Whether the core serves a floor above and one below.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` when no stair with risers of 0.15 to 0.19 m fits the core.
    """
    fit = dog_leg(frame.length, frame.width, height)
    if fit is None:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"no stair fits {core_id}: {frame.width:.2f} x {frame.length:.2f} m inside its walls for a storey of "
            f"{height:.2f} m; 3 x 6 m serves storeys up to 4.2 m, 2 x 4 m up to 3.0 m",
            path="$.connectivity.cores",
        )
    risers, going = fit
    width = round((frame.width - FLIGHT_WELL) / 2, 4)
    well = frame.rectangle((frame.landing, frame.length), (0.0, frame.width))
    flights = _flights(frame, height, risers, going, width) if goes_up else _Flights()
    rails = flights.rails
    if comes_from_below and not goes_up:
        # The top floor has no flight up: a guard closes the half of the landing's edge where one would start.
        edge = frame.landing
        rails = [_rail(frame, (edge, edge), (0.0, width), (0.0, 0.0))]
    return StairDetails(
        form="dog_leg",
        risers=risers if goes_up else 0,
        riser=round(height / risers, 4),
        going=going,
        width=width,
        treads=flights.treads,
        landings=flights.landings,
        rails=rails,
        floor_landing=frame.rectangle((0.0, frame.landing), (0.0, frame.width)),
        floor_opening=well if comes_from_below else [],
        ceiling_opening=well if goes_up else [],
    )


@dataclass(frozen=True)
class _Flights:
    """Both flights of a dog-leg, its half landing, and the rails along the well."""

    treads: list[Box3] = field(default_factory=list)
    landings: list[Box3] = field(default_factory=list)
    rails: list[tuple[Point3, Point3]] = field(default_factory=list)


def _flights(frame: StairFrame, height: float, risers: int, going: float, width: float) -> _Flights:
    half, riser = risers // 2, height / risers
    foot, turn = frame.landing, frame.landing + (half - 1) * going
    left, right = (0.0, width), (frame.width - width, frame.width)
    middle = half * riser
    treads = []
    for step in range(half - 1):
        top = (step + 1) * riser
        span = (foot + step * going, foot + (step + 1) * going)
        treads.append(frame.box(span, left, (max(top - 2 * riser, 0.0), top)))
    for step in range(half - 1):
        top = middle + (step + 1) * riser
        span = (turn - (step + 1) * going, turn - step * going)
        treads.append(frame.box(span, right, (top - 2 * riser, top)))
    inner = (width, width)
    outer = (frame.width - width, frame.width - width)
    return _Flights(
        treads,
        [frame.box((turn, frame.length), (0.0, frame.width), (middle - _LANDING_THICKNESS, middle))],
        [
            _rail(frame, (foot, turn), inner, (riser, middle)),
            _rail(frame, (turn, turn), (width, frame.width - width), (middle, middle)),
            _rail(frame, (turn, foot), outer, (middle, height)),
        ],
    )


def _rail(
    frame: StairFrame, along: Sequence[float], across: Sequence[float], z: Sequence[float]
) -> tuple[Point3, Point3]:
    ends = [(*frame.point(along[i], across[i]), round(z[i] + _RAIL_HEIGHT, 4)) for i in (0, 1)]
    return ends[0], ends[1]

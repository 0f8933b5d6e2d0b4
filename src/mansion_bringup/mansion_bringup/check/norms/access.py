"""Rules on lifts, stairs, and the widths of corridors and doors."""

import math
from collections.abc import Iterator

from shapely import Polygon

from mansion_bringup.check.norms.premises import ROUNDING, Deviation, Premises
from mansion_bringup.check.shapes import net_area, segment_length
from mansion_knowledge.norms import Norm
from mansion_msgs_py.scene import LiftDetails, StairDetails

__all__ = ["access_deviations"]

_STEP_ROUNDING = 0.0015


def access_deviations(premises: Premises) -> Iterator[Deviation]:
    """Yield deviations from the rules of lifts, stairs, corridors and doors."""
    yield from _lift(premises)
    for scene in premises.scenes:
        for core in scene.cores:
            where = f"floor {scene.floor}: {core.id}"
            if isinstance(core.details, LiftDetails):
                yield from _cabin(premises, where, core.details)
            elif isinstance(core.details, StairDetails) and core.details.risers:
                yield from _stair(premises, where, core.details)
    yield from _corridor_width(premises)
    yield from _door_width(premises)


def _cabin(premises: Premises, where: str, lift: LiftDetails) -> Iterator[Deviation]:
    """Yield a cabin that is too small, by its side towards the door and the one away from it."""
    norm = premises.norm("lift_cabin")
    if norm is None:
        return
    (x0, y0, _), (x1, y1, _) = lift.cabin
    sides = (x1 - x0 - 2 * norm.limit("wall"), y1 - y0 - 2 * norm.limit("wall"))
    depth, width = sides if abs(math.cos(math.radians(lift.facing))) > math.sqrt(0.5) else sides[::-1]
    if width < norm.figure - ROUNDING or depth < norm.limit("depth") - ROUNDING:
        asked = f"{norm.figure:.2f} by {norm.limit('depth'):.2f} m"
        yield premises.deviation(norm, where, f"{width:.2f} m wide and {depth:.2f} m deep", asked)


def _stair(premises: Premises, where: str, stair: StairDetails) -> Iterator[Deviation]:
    for name, found, least in (
        ("stair_width", stair.width, True),
        ("stair_going", stair.going, True),
        ("stair_riser", stair.riser, False),
    ):
        norm = premises.norm(name)
        if norm is None:
            continue
        limit = premises.limit(norm)
        if (limit - found if least else found - limit) > _STEP_ROUNDING:
            asked = f"{'at least' if least else 'at most'} {limit:.2f} m"
            yield premises.deviation(norm, where, f"{found:.3f} m", asked)


def _lift(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("lift")
    storeys = len(premises.scenes)
    if norm is None or storeys <= premises.limit(norm):
        return
    if not any(core.type == "elevator" for scene in premises.scenes for core in scene.cores):
        asked = f"one, as above {premises.limit(norm):.0f} storey" + "s" * (premises.limit(norm) != 1)
        yield premises.deviation(norm, "building", f"{storeys} storeys and no lift", asked)


def _corridor_width(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("corridor_width")
    if norm is None:
        return
    for room in premises.of_types(norm.rooms):
        least = premises.limit(norm)
        shape = net_area(room)
        if not _is_passable(shape, least - ROUNDING):
            steps = (least - 0.05 * step for step in range(1, int(least / 0.05)))
            width = next((width for width in steps if _is_passable(shape, width)), 0.0)
            yield premises.deviation(norm, room.id, f"narrows to about {width:.2f} m", f"{least:.2f} m")


def _is_passable(shape: Polygon, width: float) -> bool:
    inner = shape.buffer(-width / 2)
    return not inner.is_empty and inner.geom_type == "Polygon"


def _door_width(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("door_width")
    if norm is None:
        return
    kinds = {room.id: room.room_type for room in premises.rooms()}
    for scene in premises.scenes:
        for door in scene.doors:
            least = _widest(premises, norm, [kinds.get(name or "", "") for name in door.rooms])
            width = segment_length(door.segment)
            if width < least - ROUNDING:
                yield premises.deviation(norm, door.id, f"{width:.2f} m clear", f"{least:.2f} m")


def _widest(premises: Premises, norm: Norm, kinds: list[str]) -> float:
    if any(premises.knowledge.room(kind).toilet or kind in ("bathroom", "") for kind in kinds):
        return norm.figure
    return max((norm.limit(kind) for kind in kinds), default=math.nan)

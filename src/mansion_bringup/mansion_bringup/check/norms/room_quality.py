"""Daylight, least areas and proportions of rooms, and the share of circulation."""

import math
from collections import defaultdict
from collections.abc import Iterator

from shapely import Polygon

from mansion_bringup.check.norms.premises import Deviation, Premises
from mansion_bringup.check.shapes import net_area, segment_length
from mansion_msgs_py.scene import SceneRoom

__all__ = ["room_deviations"]

_ROUNDING = 0.02


def room_deviations(premises: Premises) -> Iterator[Deviation]:
    """Yield deviations from the rules of daylight, room sizes and circulation."""
    yield from _daylight(premises)
    yield from _sizes(premises)
    yield from _circulation_share(premises)


def _daylight(premises: Premises) -> Iterator[Deviation]:
    outer, share = premises.norm("outer_wall"), premises.norm("window_share")
    if outer is None or share is None:
        return
    glass: dict[str, float] = defaultdict(float)
    for scene in premises.scenes:
        for window in scene.windows:
            glass[window.room] += segment_length(window.segment) * window.height
        for door in scene.doors:
            if None in door.rooms and door.kind in ("glazed", "balcony"):
                glass[door.rooms[0]] += door.width * door.height
    above = {room.id for scene in premises.scenes if scene.floor >= 1 for room in scene.rooms}
    rooms = [room for room in premises.of_types((*outer.rooms, *share.rooms)) if room.id in above]
    for room in rooms:
        if not glass[room.id] and premises.is_one_of(room, outer.rooms):
            yield premises.deviation(outer, room.id, "no window", "a window in an outer wall")
        elif premises.is_one_of(room, share.rooms):
            found, least = glass[room.id] / net_area(room).area, premises.limit(share, room.room_type)
            if found < least - 0.001:
                yield premises.deviation(share, room.id, f"windows of {found:.1%} of the floor", f"{least:.0%}")


def _sides(room: SceneRoom) -> tuple[float, float]:
    """Return the short and the long side of the smallest rectangle around a room, metres."""
    box = net_area(room).minimum_rotated_rectangle
    if not isinstance(box, Polygon):
        return 0.0, 0.0
    corners = list(box.exterior.coords)
    first, second = math.dist(corners[0], corners[1]), math.dist(corners[1], corners[2])
    return min(first, second), max(first, second)


def _sizes(premises: Premises) -> Iterator[Deviation]:
    norms = [premises.norm(name) for name in ("room_area", "room_dimension", "proportion")]
    for norm in norms:
        for room in premises.of_types(norm.rooms) if norm is not None else ():
            assert norm is not None
            limit = premises.limit(norm, room.room_type)
            short, long = _sides(room)
            area = net_area(room).area
            if norm.id == "room_area" and area < limit - _ROUNDING:
                yield premises.deviation(norm, room.id, f"{area:.1f} m2 net", f"at least {limit:.1f} m2")
            if norm.id == "room_dimension" and short < limit - _ROUNDING:
                yield premises.deviation(norm, room.id, f"{short:.2f} m from side to side", f"at least {limit:.2f} m")
            if norm.id == "proportion" and long > limit * max(short, 0.01):
                yield premises.deviation(norm, room.id, f"1 to {long / max(short, 0.01):.1f}", f"at most 1 to {limit}")


def _circulation_share(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("circulation_share")
    if norm is None:
        return
    floor = passages = 0.0
    for scene in premises.scenes:
        floor += Polygon(scene.outline, scene.holes).area
        passages += sum(Polygon(core.polygon).area for core in scene.cores)
    passages += sum(r.area for r in premises.rooms() if premises.knowledge.room(r.room_type).zone == "circulation")
    limit = premises.limit(norm)
    if passages > (limit + 0.005) * floor:
        found = f"{passages / floor:.0%} of the floor is circulation"
        yield premises.deviation(norm, "building", found, f"at most {limit:.0%}")

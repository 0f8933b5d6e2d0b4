"""Rules on the daylight, least areas and proportions of rooms, and on the share of circulation."""

import math
from collections import defaultdict
from collections.abc import Iterator

from shapely import Polygon

from mansion_bringup.check.norms.premises import ROUNDING, Deviation, Premises
from mansion_bringup.check.shapes import net_area, segment_length
from mansion_msgs_py.scene import SceneRoom
from mansion_msgs_py.wording import counted

__all__ = ["room_deviations", "sides_of"]


def room_deviations(premises: Premises) -> Iterator[Deviation]:
    """Yield deviations from the rules of daylight, room sizes and circulation."""
    yield from _daylight(premises)
    yield from _sizes(premises)
    yield from _workplaces(premises)
    yield from _heights(premises)
    yield from _circulation_share(premises)


def _daylight(premises: Premises) -> Iterator[Deviation]:
    outer, share, work = (premises.norm(name) for name in ("outer_wall", "window_share", "work_window"))
    if outer is None or share is None or work is None:
        return
    glass: dict[str, float] = defaultdict(float)
    for scene in premises.scenes:
        for window in scene.windows:
            glass[window.room] += segment_length(window.segment) * window.height
        for door in scene.doors:
            if None in door.rooms and door.kind in ("glazed", "balcony"):
                glass[door.rooms[0]] += door.width * door.height
    above = {room.id for scene in premises.scenes if scene.floor >= 1 for room in scene.rooms}
    rooms = [room for room in premises.of_types((*outer.rooms, *share.rooms, *work.rooms)) if room.id in above]
    for room in rooms:
        if not glass[room.id] and premises.is_one_of(room, outer.rooms):
            yield premises.deviation(outer, room.id, "no window", "a window in an outer wall")
            continue
        for norm in (share, work):
            found, least = glass[room.id] / net_area(room).area, premises.limit(norm, room.room_type)
            if premises.is_one_of(room, norm.rooms) and found < least - 0.001:
                yield premises.deviation(norm, room.id, f"windows of {found:.1%} of the floor", f"{least:.0%}")


def sides_of(room: SceneRoom) -> tuple[float, float]:
    """Return the short and the long side of the smallest rectangle around a room, metres."""
    box = net_area(room).minimum_rotated_rectangle
    if not isinstance(box, Polygon):
        return 0.0, 0.0
    corners = list(box.exterior.coords)
    first, second = math.dist(corners[0], corners[1]), math.dist(corners[1], corners[2])
    return min(first, second), max(first, second)


def _sizes(premises: Premises) -> Iterator[Deviation]:
    norms = [premises.norm(name) for name in ("room_area", "room_dimension", "proportion", "cell_area")]
    for norm in norms:
        for room in premises.of_types(norm.rooms) if norm is not None else ():
            assert norm is not None
            limit = premises.limit(norm, room.room_type)
            short, long = sides_of(room)
            area = net_area(room).area
            if norm.id in ("room_area", "cell_area") and area < limit - ROUNDING:
                yield premises.deviation(norm, room.id, f"{area:.1f} m2 net", f"at least {limit:.1f} m2")
            if norm.id == "room_dimension" and short < limit - ROUNDING:
                yield premises.deviation(norm, room.id, f"{short:.2f} m from side to side", f"at least {limit:.2f} m")
            if norm.id == "proportion" and long > limit * max(short, 0.01):
                yield premises.deviation(norm, room.id, f"1 to {long / max(short, 0.01):.1f}", f"at most 1 to {limit}")


def _workplaces(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("workplace_area")
    for room in premises.of_types(norm.rooms) if norm is not None else ():
        assert norm is not None
        places = premises.pieces(norm, [room])
        area, least = net_area(room).area, norm.figure + norm.limit("further") * (places - 1)
        if places and area < least - ROUNDING:
            found = f"{area:.1f} m2 net for {counted(places, 'workplace')}"
            yield premises.deviation(norm, room.id, found, f"at least {least:.1f} m2")


def _heights(premises: Premises) -> Iterator[Deviation]:
    norm = premises.norm("ceiling_height")
    for room in premises.rooms() if norm is not None else ():
        assert norm is not None
        low = premises.knowledge.room(room.room_type).zone in ("service", "circulation")
        least = norm.limit("low" if low else "")
        if room.ceiling_height < least - ROUNDING:
            yield premises.deviation(norm, room.id, f"{room.ceiling_height:.2f} m high", f"{least:.2f} m")


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

"""The rooms that close a bar over its whole depth: a large one, two for audiences, or the hall of a wing."""

from collections.abc import Sequence

from mansion_planner.program.model import DOOR_WALL, Box, Massing, PlannedRoom, Storey, box_area, far_stair
from mansion_planner.program.plan_quality import FACING

__all__ = ["boxes_at_end", "corner_of", "end_rooms"]

_HALL = 260.0
"""Square metres from which a room closes the bar though a stair stands at its end."""


def end_rooms(massing: Massing, storey: Storey, length: float) -> tuple[list[PlannedRoom], list[PlannedRoom]]:
    """Choose the rooms that close the bar over its whole depth: one too large for a band, or two for audiences.

    Where a stair stands at that end, only a hall does, with the stair in its corner; the hall of a wing lies beyond it.
    """
    rooms = storey.rooms
    if storey.hall_wing:
        hall = max(rooms, key=lambda room: (room.kind.whole and room.stated, room.area, room.id))
        return [hall], [room for room in rooms if room is not hall]
    if massing.wings:
        return [], list(rooms)
    pair = _side_by_side(massing, rooms, length)
    if pair:
        return pair, [room for room in rooms if not any(room is other for other in pair)]
    deep = max(massing.north, massing.south)
    least = _HALL if far_stair(massing) else 90.0
    large = [r for r in rooms if not r.suite and r.area > 2.4 * deep * deep and r.area > least]
    large = [r for r in large if r.area / massing.depth < 0.55 * length]
    if not large or len(rooms) < 2:
        return [], list(rooms)
    end = max(large, key=lambda room: (room.area, room.id))
    return [end], [room for room in rooms if room is not end]


_AUDIENCE = 45.0
"""Least square metres of each of two rooms in rows that close the bar together."""


def _side_by_side(massing: Massing, rooms: Sequence[PlannedRoom], length: float) -> list[PlannedRoom]:
    """Return two rooms in rows that close the bar side by side, both entered from the end of the corridor, or none."""
    large = [room for room in rooms if room.kind.name in FACING and room.area >= _AUDIENCE and not room.suite]
    pair = sorted(large, key=lambda room: (-room.area, room.id))[:2]
    deep = sum(room.area for room in pair) / massing.depth
    fits = 0.45 * massing.depth <= deep < 0.7 * length and massing.corridor >= 2 * DOOR_WALL
    return pair if len(pair) == _PAIR and fits and not far_stair(massing) and len(rooms) > _PAIR else []


_PAIR = 2


def boxes_at_end(
    massing: Massing, ends: Sequence[PlannedRoom], stop: float, length: float, *, beyond: bool
) -> list[list[Box]]:
    """Return the boxes of each room that closes the bar over its whole depth, two on either side of its middle.

    Parameters
    ----------
    massing : Massing
    ends : sequence of PlannedRoom
    stop, length : float
        Where the rooms begin and end along the bar.
    beyond : bool
        The room lies beyond the stair at the end.
    """
    if len(ends) < _PAIR:
        whole: list[Box] = [(stop, 0.0, length, massing.depth)] if beyond else _around_corner(massing, stop, length)
        return [whole] * len(ends)
    first, second = ends
    middle = massing.south + massing.corridor / 2
    spare = massing.corridor / 2 - DOOR_WALL
    cut = massing.depth * first.gross / (first.gross + second.gross)
    cut = min(max(cut, middle - spare), middle + spare)
    return [[(stop, 0.0, length, cut)], [(stop, cut, length, massing.depth)]]


def corner_of(massing: Massing) -> Box:
    """Return the box of the stair at the far end; an empty one where there is none."""
    far = [core.box for core in massing.cores if core.box[0] >= 0.5 * massing.length]
    return far[0] if far and far_stair(massing) else (0.0, 0.0, 0.0, 0.0)


def _around_corner(massing: Massing, x0: float, x1: float) -> list[Box]:
    """Return the boxes of a room over the whole depth of the bar, around the stair in its far corner."""
    corner = corner_of(massing)
    if not box_area(corner):
        return [(x0, 0.0, x1, massing.depth)]
    return [(x0, 0.0, x1, corner[1]), (x0, corner[1], corner[0], massing.depth)]

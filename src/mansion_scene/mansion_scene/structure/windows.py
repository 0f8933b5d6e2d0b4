"""Windows in outer walls, by room type."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from mansion_knowledge import default_knowledge, is_class
from mansion_msgs_py.program import GROUND_FLOOR
from mansion_msgs_py.shapes import Segment
from mansion_scene.structure.boundaries import BoundarySegment, reentrant_corners, usable_part
from mansion_scene.structure.openings import Opening
from mansion_scene.structure.regions import FloorRegions, Region

__all__ = ["WindowKind", "WindowOpening", "fitting_window", "place_windows", "usual_window", "window_kind"]

_END = 0.3  # metres of wall between a window and a wall end or a door
_SAME_LINE = 0.01
_HEAD = 0.2  # metres of wall above a window


@dataclass(frozen=True)
class WindowKind:
    """Size and spacing of a room type's windows: clear width, height, sill, wall between two; metres."""

    width: float
    height: float
    sill: float
    gap: float
    name: str = "fixed"


@dataclass(frozen=True)
class WindowOpening:
    """A window: its opening on the outline."""

    region: str
    kind: WindowKind
    boundary: BoundarySegment
    segment: Segment


_KINDS: tuple[tuple[str, WindowKind | None], ...] = (
    ("outdoor", None),
    ("store", None),
    ("dark", None),
    ("wet", WindowKind(0.6, 0.5, 1.6, 1.5, "hung")),
    # The sill lies above worktops, sinks and stoves.
    ("cooking", WindowKind(1.5, 1.1, 1.15, 0.9, "hung")),
    # Pictures need the walls, and light that does not blind.
    ("hung", WindowKind(2.4, 0.7, 2.3, 0.8)),
    ("worship", WindowKind(0.9, 2.8, 1.1, 1.7)),
    ("assembly", WindowKind(2.4, 1.9, 0.6, 0.8)),
    ("office", WindowKind(1.8, 1.7, 0.85, 0.7)),
    ("teaching", WindowKind(1.8, 1.7, 0.9, 0.5)),
    ("clinical", WindowKind(1.5, 1.6, 0.9, 1.0)),
    ("welcome", WindowKind(2.0, 2.1, 0.3, 0.7)),
    ("circulation", WindowKind(1.2, 1.5, 0.9, 1.5)),
    ("living", WindowKind(1.8, 1.4, 0.9, 0.9, "hung")),
    ("sleeping", WindowKind(1.5, 1.3, 0.9, 1.0, "hung")),
)
_DEFAULT = WindowKind(1.5, 1.6, 0.9, 1.0)
_SHOP = WindowKind(2.4, 2.2, 0.3, 0.25)  # goods and guests are seen from the street
_STAIR = WindowKind(1.2, 1.5, 1.0, 1.4)
_FRENCH = WindowKind(1.8, 2.1, 0.2, 0.9, "hung")
_NARROWEST = 0.6
_TO_LOOK_OUT = 1.2  # metres: highest sill of windows that one looks out of
_PANE, _PLINTH, _MULLION = 1.68, 0.2, 0.12  # metres: width of a glass facade's panes, below and between them


def window_kind(region: Region) -> WindowKind | None:
    """Return the windows of a region's type; ``None`` for stores, lift shafts and outdoor rooms."""
    if not region.is_room:
        return _STAIR if region.kind == "stair" else None
    for name, kind in _KINDS:
        if is_class(region.room_type, name):
            return kind
    return _DEFAULT


def usual_window(region: Region) -> WindowKind:
    """Return the windows of a region's type; those of a room like any other where such a room usually has none."""
    return window_kind(region) or _DEFAULT


def place_windows(
    floor: FloorRegions,
    boundaries: Sequence[BoundarySegment],
    openings: Sequence[Opening],
    ceiling: float,
    *,
    glazed: bool = False,
    french: bool = False,
) -> list[WindowOpening]:
    """Place windows, evenly spaced between wall ends and doors, in every outer wall of a floor above ground.

    Parameters
    ----------
    openings : sequence of Opening
        Doors; those in outer walls keep their distance.
    ceiling : float
        Height of the ceilings, metres; windows stay below.
    glazed : bool
        The facade is of glass: all rooms that have windows to look out of have them from the floor to the ceiling.
    french : bool
        Living rooms upstairs have windows that reach down to the floor, as of flats.
    """
    if floor.floor < GROUND_FLOOR:
        return []
    front = _front(openings) if floor.floor == GROUND_FLOOR else None
    doors: dict[str, list[Segment]] = {}
    for opening in openings:
        if opening.regions[1] is None:
            doors.setdefault(opening.regions[0], []).append(opening.segment)
    windows: list[WindowOpening] = []
    corners = reentrant_corners(floor.outline)
    for wall in boundaries:
        kind = window_kind(floor.by_id[wall.left]) if wall.exterior else None
        boundary = usable_part(wall, corners)
        if kind is None or boundary is None:
            continue
        if front is not None and _faces(boundary, front) and is_class(floor.by_id[wall.left].room_type, "shopfront"):
            kind = _SHOP
        if french and floor.floor > GROUND_FLOOR and _is_lived_in(floor.by_id[wall.left].room_type):
            kind = _FRENCH
        if glazed and kind.sill <= _TO_LOOK_OUT:
            kind = WindowKind(_PANE, ceiling, _PLINTH, _MULLION)
        kind = fitting_window(kind, ceiling)
        for low, high in _free(boundary, doors.get(boundary.left, [])):
            windows.extend(_row(boundary, kind, low, high))
    return windows


def _is_lived_in(room_type: str) -> bool:
    """Whether a room is a living room, or the main one of a flat."""
    return is_class(room_type, "living") or default_knowledge().room(room_type).unit


def _front(openings: Sequence[Opening]) -> BoundarySegment | None:
    """Return the wall of the building's widest entrance, which faces the street."""
    entrances = [opening for opening in openings if opening.kind.kind == "entrance"]
    return max(entrances, key=lambda opening: opening.kind.width).boundary if entrances else None


def _faces(boundary: BoundarySegment, front: BoundarySegment) -> bool:
    """Whether a wall looks the way that the front does."""
    (ax, ay), (bx, by) = boundary.direction, front.direction
    return ax * bx + ay * by > 1.0 - 1e-6


def fitting_window(kind: WindowKind, ceiling: float) -> WindowKind:
    """Return a kind of window that stays below the ceiling, with a wall above it."""
    height = min(kind.height, ceiling - _HEAD - kind.sill)
    return WindowKind(kind.width, round(max(height, 0.3), 4), kind.sill, kind.gap, kind.name)


def _free(boundary: BoundarySegment, doors: Sequence[Segment]) -> list[tuple[float, float]]:
    (x0, y0), (dx, dy) = boundary.start, boundary.direction
    intervals = [(_END, boundary.length - _END)]
    for door in doors:
        if any(abs((x - x0) * dy - (y - y0) * dx) > _SAME_LINE for x, y in door):
            continue
        low, high = sorted((p[0] - x0) * dx + (p[1] - y0) * dy for p in door)
        intervals = [
            piece
            for start, end in intervals
            for piece in ((start, min(end, low - _END)), (max(start, high + _END), end))
            if piece[1] > piece[0]
        ]
    return intervals


def _row(boundary: BoundarySegment, kind: WindowKind, low: float, high: float) -> list[WindowOpening]:
    room = high - low
    if room < _NARROWEST - 1e-6:
        return []
    count = max(int((room + kind.gap) / (kind.width + kind.gap) + 1e-9), 1)
    if kind.name == "hung" and kind.sill > 1.2:
        # A high toilet window is for air: one is enough.
        count = 1
    width = min(kind.width, room)
    starts = _on_grid(boundary, kind, width, low, high, count)
    if not starts:
        spare = (room - count * width - (count - 1) * kind.gap) / (count + 1)
        starts = [low + spare + index * (width + kind.gap + spare) for index in range(count)]
    return [
        WindowOpening(boundary.left, kind, boundary, (boundary.at(start), boundary.at(start + width)))
        for start in starts
    ]


_MODULE = 0.6
"""Metres between the lines of the facade's grid, on which the middles of windows stand on every storey."""


def _on_grid(
    boundary: BoundarySegment, kind: WindowKind, width: float, low: float, high: float, count: int
) -> list[float]:
    """Return where windows start whose middles stand on lines of the grid that all storeys share.

    Nothing where the wall runs across the grid, or where fewer windows than `count` would find a line. Among the lines
    that are far enough apart those are taken that windows of the same kind take on other storeys too.
    """
    dx, dy = boundary.direction
    if min(abs(dx), abs(dy)) > 1e-6:
        return []
    origin = boundary.start[0] * dx + boundary.start[1] * dy
    step = max(round((width + kind.gap) / _MODULE), math.ceil((width + _END) / _MODULE))
    lines = range(
        math.ceil((origin + low + width / 2) / _MODULE - 1e-9),
        math.floor((origin + high - width / 2) / _MODULE + 1e-9) + 1,
    )
    sign = round(dx + dy)
    phases = [[line for line in lines if sign * line % step == phase] for phase in range(step)]
    row = max(phases, key=len)  # the first of the longest, so that rooms above each other choose alike
    if len(row) < count:
        return []
    return [line * _MODULE - origin - width / 2 for line in (row if count > 1 else row[len(row) // 2 :][:1])]

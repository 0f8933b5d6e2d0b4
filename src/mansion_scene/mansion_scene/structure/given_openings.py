"""Openings that a plan gives a floor: which regions open to which, and doors and windows where the plan has them."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Literal

import msgspec

from mansion_geometry.wall_sizes import SHORTEST_WINDOW
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.openings import GivenDoor, GivenOpenings, GivenWindow
from mansion_msgs_py.program import Downgrade
from mansion_msgs_py.shapes import Segment
from mansion_scene.structure.access import AccessPlan, Pair, Passage, pair_key
from mansion_scene.structure.boundaries import BoundarySegment, reentrant_corners, usable_part
from mansion_scene.structure.dimensions import CLEAR_WIDTH
from mansion_scene.structure.held_openings import takes
from mansion_scene.structure.openings import Opening, OpeningKind, entrance_kind, opening_kind
from mansion_scene.structure.regions import FloorRegions, Region
from mansion_scene.structure.windows import WindowKind, WindowOpening, fitting_window, usual_window

__all__ = [
    "as_planned",
    "given_access",
    "given_doors",
    "given_windows",
    "narrow_doors",
    "stated_entrance",
    "stated_kinds",
]

_DOUBLE = 1.4
"""Clear width from which a door has two leaves, metres."""

_LOWEST_WINDOW = 0.5
"""Metres from a sill to the ceiling: the lowest window and the wall above it."""


def given_access(floor: FloorRegions, given: GivenOpenings) -> AccessPlan:
    """Return the passages of a plan: those between the rooms of its doors."""
    passages: dict[Pair, Passage] = {}
    for door in given.doors:
        a, b = _regions(floor, door)
        if b is not None:
            pair = pair_key(a.id, b.id)
            is_open = door.kind == "open" or (pair in passages and passages[pair].is_open)
            passages[pair] = Passage(pair, is_open=is_open)
    return AccessPlan(tuple(passages.values()), ())


def _regions(floor: FloorRegions, door: GivenDoor) -> tuple[Region, Region | None]:
    for name in door.rooms:
        if name is not None and name not in floor.by_node:
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD,
                f"a door leads to {name!r}, which the floor does not have",
                path="$.floor.openings",
            )
    first, second = door.rooms
    return floor.by_node[first], floor.by_node[second] if second is not None else None


def given_doors(floor: FloorRegions, given: GivenOpenings, boundaries: Sequence[BoundarySegment]) -> list[Opening]:
    """Return the openings of the doors whose place the plan states.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for a door that lies on no boundary between its two sides.
    """
    openings = []
    for index, door in enumerate(given.doors):
        if door.segment is None or door.kind == "open":
            continue
        a, b = _regions(floor, door)
        rooms = (a.id, b.id if b is not None else None)
        boundary = next((each for each in boundaries if takes(each, rooms, door.segment)), None)
        if boundary is None:
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD,
                f"the door at {door.segment} lies on no wall between {rooms[0]} and {rooms[1] or 'the outside'}",
                path=f"$.floor.openings.doors[{index}]",
            )
        kind = _kind(a, b, door, math.dist(*door.segment))
        openings.append(Opening(rooms, kind, boundary, _along(boundary, door.segment)))
    return openings


def _along(boundary: BoundarySegment, segment: Segment) -> Segment:
    """Return a segment on a boundary in the boundary's direction."""
    (x0, y0), (dx, dy) = boundary.start, boundary.direction
    low, high = sorted((x - x0) * dx + (y - y0) * dy for x, y in segment)
    return boundary.at(low), boundary.at(high)


def _kind(a: Region, b: Region | None, door: GivenDoor, width: float) -> OpeningKind:
    """Return the kind of a door as the plan states it, else by what it joins; a door of a plan has a leaf."""
    width = round(width, 4)
    if b is None:
        usual = entrance_kind(public=width >= _DOUBLE)
        return OpeningKind("garage", width, "painted_steel") if door.kind == "garage" else replace(usual, width=width)
    usual = opening_kind(a, b)
    if usual.kind in ("sliding", "frame"):
        return replace(usual, width=width)
    leaf: Literal["double", "single"] = "double" if width >= _DOUBLE else "single"
    if door.kind in ("single", "double"):
        return OpeningKind(leaf, width, "painted_wood")
    if door.kind in ("glazed", "doorway"):
        return OpeningKind(door.kind, width, "glass" if door.kind == "glazed" else "painted_wood")
    if usual.kind == "doorway" or usual.kind == "double":
        return OpeningKind(leaf, width, usual.material)
    return replace(usual, width=width)


def stated_kinds(floor: FloorRegions, given: GivenOpenings) -> dict[Pair, OpeningKind]:
    """Return the kinds of doors of which the plan states a width or a kind, but no place."""
    kinds = {}
    for door in given.doors:
        a, b = _regions(floor, door)
        stated = door.width is not None or door.kind is not None
        if b is not None and door.segment is None and stated and door.kind != "open":
            kinds[pair_key(a.id, b.id)] = _kind(a, b, door, door.width or opening_kind(a, b).width)
    return kinds


def narrow_doors(floor: FloorRegions, given: GivenOpenings, openings: Sequence[Opening]) -> list[Downgrade]:
    """Record the doors that the plan itself has narrower than a door should be."""
    stated = set(_stated_widths(floor, given))
    return [
        Downgrade(
            wish=f"door of {CLEAR_WIDTH} m between {opening.regions[0]} and {opening.regions[1] or 'outside'}",
            got=f"{opening.kind.width:.2f} m clear",
            reason="the plan has it so",
            stage="plan",
            floor=floor.floor,
        )
        for opening in openings
        if (frozenset(opening.regions), opening.kind.width) in stated and opening.kind.width < CLEAR_WIDTH - 1e-6
    ]


def as_planned(narrowed: Sequence[Downgrade]) -> list[Downgrade]:
    """Return records of doors that walls made narrower, as those of the plan's own walls."""
    return [msgspec.structs.replace(entry, stage="plan") for entry in narrowed]


def _stated_widths(floor: FloorRegions, given: GivenOpenings) -> Iterator[tuple[frozenset[str | None], float]]:
    for door in given.doors:
        a, b = _regions(floor, door)
        width = math.dist(*door.segment) if door.segment is not None else door.width
        if width is not None:
            yield frozenset((a.id, b.id if b is not None else None)), round(width, 4)


def given_windows(
    floor: FloorRegions,
    windows: Sequence[GivenWindow],
    boundaries: Sequence[BoundarySegment],
    openings: Sequence[Opening],
    ceiling: float,
) -> list[WindowOpening]:
    """Return the windows of a plan on the outer walls that stand where it has them, clear of outer doors."""
    doors = [opening.segment for opening in openings if opening.regions[1] is None]
    corners = reentrant_corners(floor.outline)
    walls = [usable_part(boundary, corners) for boundary in boundaries if boundary.exterior]
    outer = [wall for wall in walls if wall is not None]
    return [opening for window in windows for opening in _pieces(floor, window, outer, doors, ceiling)]


def _pieces(
    floor: FloorRegions,
    window: GivenWindow,
    boundaries: Sequence[BoundarySegment],
    doors: Sequence[Segment],
    ceiling: float,
) -> Iterator[WindowOpening]:
    for boundary in boundaries:
        span = boundary.span_of(window.segment)
        if span is None:
            continue
        low, high = max(span[0], 0.0), min(span[1], boundary.length)
        for other in (boundary.span_of(door) for door in doors):
            if other is not None and other[0] < high and low < other[1]:
                low, high = (other[1], high) if other[1] < (low + high) / 2 else (low, min(high, other[0]))
        if high - low >= SHORTEST_WINDOW:
            kind = _window_kind(floor.by_id[boundary.left], window, high - low, ceiling)
            segment = (boundary.at(low), boundary.at(high))
            yield WindowOpening(boundary.left, fitting_window(kind, ceiling), boundary, segment)


def _window_kind(region: Region, window: GivenWindow, width: float, ceiling: float) -> WindowKind:
    usual = usual_window(region)
    sill = min(usual.sill if window.sill is None else window.sill, ceiling - _LOWEST_WINDOW)
    return replace(usual, width=round(width, 4), sill=round(sill, 4), height=window.height or usual.height)


def stated_entrance(floor: FloorRegions, given: GivenOpenings) -> Region | None:
    """Return the room that the plan gives an entrance without saying where."""
    return next((_regions(floor, d)[0] for d in given.doors if d.rooms[1] is None and d.segment is None), None)

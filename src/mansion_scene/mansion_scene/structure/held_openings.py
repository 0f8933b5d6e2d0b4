"""Openings that stay where they are when a finished floor is built again around another layout."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from shapely.geometry import Polygon

from mansion_msgs_py.scene import Door
from mansion_msgs_py.shapes import Point, Segment
from mansion_scene.structure.access import AccessPlan, pair_key
from mansion_scene.structure.boundaries import BoundarySegment
from mansion_scene.structure.dimensions import EXTERIOR_THICKNESS, INTERIOR_THICKNESS
from mansion_scene.structure.door_positions import Frontage
from mansion_scene.structure.openings import Opening, OpeningKind

__all__ = ["HeldAccess", "held_openings", "takes", "with_furniture", "without_held"]

_ROUNDING = 1e-3


@dataclass(frozen=True)
class HeldAccess:
    """How a finished floor is walked through, to be kept in another layout of it.

    Attributes
    ----------
    plan : AccessPlan
        Which regions open to which.
    doors : tuple of Door
        Doors that stay where they are as long as a wall between their two sides stands there.
    standing : mapping of str to sequence of Polygon
        By region, the footprints of furniture that further doors avoid where they can.
    """

    plan: AccessPlan
    doors: tuple[Door, ...]
    standing: Mapping[str, Sequence[Polygon]] = field(default_factory=dict)


def held_openings(held: HeldAccess, boundaries: Sequence[BoundarySegment]) -> list[Opening]:
    """Return the openings of doors whose wall still stands.

    A door keeps its hinge and swing. Half a wall's thickness stays between it and the end of its boundary. Openings of
    kind ``open`` follow the layout and are left out, and so are doors between rooms that stand open to each other now.
    """
    opened = {passage.pair for passage in held.plan.passages if passage.is_open}
    found = []
    for door in held.doors:
        a, b = door.rooms
        if door.kind != "open" and (b is None or pair_key(a, b) not in opened):
            places = (_opening_in(door, boundary) for boundary in boundaries)
            found.append(next((opening for opening in places if opening is not None), None))
    return [opening for opening in found if opening is not None]


def _opening_in(door: Door, boundary: BoundarySegment) -> Opening | None:
    segment = _on_outline(door.segment, boundary) if boundary.exterior else door.segment
    if not takes(boundary, door.rooms, segment):
        return None
    kind = OpeningKind(door.kind, door.width, door.material)
    return Opening(door.rooms, kind, boundary, segment, door.hinge, door.swing)


def takes(boundary: BoundarySegment, rooms: tuple[str, str | None], segment: Segment) -> bool:
    """Whether a door between two regions, or one and the outside, has its place on a boundary."""
    if {boundary.left, boundary.right} != set(rooms) or boundary.exterior != (None in rooms):
        return False
    span = boundary.span_of(segment)
    if span is None:
        return False
    low, high = span
    margin = 0.0 if boundary.exterior else INTERIOR_THICKNESS / 2
    return low >= margin - _ROUNDING and high <= boundary.length - margin + _ROUNDING


def _on_outline(segment: Segment, boundary: BoundarySegment) -> Segment:
    """Move a segment from the outer wall's centre line on to the outline."""
    dx, dy = boundary.direction
    half = EXTERIOR_THICKNESS / 2

    def moved(point: Point) -> Point:
        return point[0] - dy * half, point[1] + dx * half

    return moved(segment[0]), moved(segment[1])


def without_held(plan: AccessPlan, held: Sequence[Opening]) -> AccessPlan:
    """Return a plan without the passages that have their door."""
    pairs = {pair_key(a, b) for a, b in (opening.regions for opening in held) if b is not None}
    return replace(plan, passages=tuple(passage for passage in plan.passages if passage.pair not in pairs))


def with_furniture(frontages: Mapping[str, Frontage], standing: Mapping[str, Sequence[Polygon]]) -> dict[str, Frontage]:
    """Return the frontages of all regions with the furniture that stands in them."""
    return {
        region: replace(frontage, standing=tuple(standing.get(region, ()))) for region, frontage in frontages.items()
    }

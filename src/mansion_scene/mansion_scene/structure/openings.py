"""The doors of a floor before they are numbered: kind, clear width and position."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

from shapely.geometry import Polygon

from mansion_knowledge import is_class, kin_of
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import Downgrade
from mansion_msgs_py.scene import DoorKind
from mansion_msgs_py.shapes import Point, Segment
from mansion_scene.structure.access import AccessPlan, Pair, pair_key
from mansion_scene.structure.boundaries import BoundarySegment
from mansion_scene.structure.dimensions import CLEAR_WIDTH, INTERIOR_THICKNESS, MIN_CLEAR_WIDTH, WALL_END
from mansion_scene.structure.door_positions import Frontage, Position, approach_zone, choose_position, ranked_positions
from mansion_scene.structure.interiors import Partition
from mansion_scene.structure.regions import FloorRegions, Region
from mansion_scene.structure.stairs import landing_zone

__all__ = [
    "BED_WIDTH",
    "Opening",
    "OpeningKind",
    "entrance_kind",
    "is_circulation",
    "make_frontages",
    "narrower_widths",
    "open_passages",
    "opening_at",
    "opening_kind",
    "other_places",
    "place_doors",
    "served_room",
    "with_doors",
]

_LARGE_PUBLIC = 45.0  # square metres from which a public room gets a double door

BED_WIDTH = 1.06
"""Clear width through which beds are moved (rule ``door_width``), for wide doors that find no place, metres."""


@dataclass(frozen=True)
class OpeningKind:
    """A kind of door, the clear width that it should have in metres, and the material of its leaf."""

    kind: DoorKind
    width: float
    material: str = ""

    @property
    def leaves(self) -> int:
        """Hinged leaves: 0 for a passage, a sliding door or a garage door."""
        if self.kind in ("open", "doorway", "sliding", "frame", "garage"):
            return 0
        return 2 if self.width >= 1.4 else 1


def is_circulation(region: Region) -> bool:
    """Return whether people pass through the region to reach others."""
    return region.node_kind == "main" or is_class(region.room_type, "circulation")


def served_room(a: Region, b: Region) -> Region:
    """Return which of two rooms the door serves: not circulation, not the larger."""
    if is_circulation(a) != is_circulation(b):
        return b if is_circulation(a) else a
    for name in ("wet", "store"):
        if is_class(a.room_type, name) != is_class(b.room_type, name):
            return a if is_class(a.room_type, name) else b
    return min(a, b, key=lambda region: (round(region.polygon.area, 3), region.id))


def opening_kind(a: Region, b: Region) -> OpeningKind:
    """Return the kind of door between two regions of which at most one is a core."""
    for core in (a, b):
        if core.kind == "elevator":
            return OpeningKind("sliding", 1.0, "brushed_steel")
        if core.kind == "stair":
            return OpeningKind("frame", 1.1, "painted_steel")
    if is_class(a.room_type, "outdoor") or is_class(b.room_type, "outdoor"):
        return OpeningKind("balcony", CLEAR_WIDTH, "glass")
    if is_circulation(a) and is_circulation(b):
        return OpeningKind("doorway", 1.4, "painted_wood")
    served = served_room(a, b)
    kind, area = served.room_type, served.polygon.area
    if kin_of(kind) == "commercial_kitchen":
        return OpeningKind("single", 1.0, "painted_steel")
    if is_class(kind, "wet") or is_class(kind, "store") or is_class(kind, "sleeping"):
        return OpeningKind("single", CLEAR_WIDTH, "painted_wood")
    if is_class(kind, "assembly"):
        return OpeningKind("double", 1.6 if area >= _LARGE_PUBLIC else 1.4, "painted_wood")
    large = area >= _LARGE_PUBLIC
    if is_class(kind, "clinical"):
        # Beds pass through.
        return OpeningKind("double" if large else "single", 1.6 if large else 1.2, "light_wood")
    if is_class(kind, "teaching"):
        return OpeningKind("double" if large else "single", 1.4 if large else 1.0, "light_wood")
    if is_class(kind, "office") and not _is_private_study(kind):
        return OpeningKind("glazed", 1.6 if large else CLEAR_WIDTH, "glass")
    if is_class(kind, "living"):
        return OpeningKind("doorway", 1.2, "painted_wood")
    return OpeningKind("single", CLEAR_WIDTH, "painted_wood")


def _is_private_study(room_type: str) -> bool:
    return "home" in room_type.lower() or room_type.lower() in ("study", "den")


def entrance_kind(*, public: bool) -> OpeningKind:
    """Return the kind of the building's entrance: a double glazed one, or a house door."""
    return OpeningKind("entrance", 1.8, "glass") if public else OpeningKind("entrance", 1.0, "dark_wood")


@dataclass(frozen=True)
class Opening:
    """A passage through a wall, or a boundary without wall (kind ``open``).

    Attributes
    ----------
    regions : (str, str or None)
    boundary : BoundarySegment
        The segment whose wall it interrupts.
    segment : Segment
        Clear opening on the boundary, which is the wall's centre line inside and the outline outside.
    """

    regions: tuple[str, str | None]
    kind: OpeningKind
    boundary: BoundarySegment
    segment: Segment
    hinge: Literal["start", "end", "both", "none"] = "none"
    swing: str | None = None

    def inward(self, region: str) -> Point:
        """Return the unit vector from the wall into a region."""
        dx, dy = self.boundary.direction
        return (-dy, dx) if region == self.boundary.left else (dy, -dx)


def make_frontages(floor: FloorRegions, partition: Partition) -> dict[str, Frontage]:
    """Return the frontage of each region, without doors."""
    return {
        region.id: Frontage.without_doors(partition.nets[region.id], _wall_worth(region)) for region in floor.regions
    }


def _wall_worth(region: Region) -> float:
    if not region.is_room:
        return 0.0
    return 0.25 if is_circulation(region) else 1.0


def with_doors(frontages: Mapping[str, Frontage], openings: Iterable[Opening]) -> dict[str, Frontage]:
    """Return the frontages of all regions with openings entered on both their sides."""
    entered = dict(frontages)
    for opening in openings:
        for region in opening.regions:
            if region is not None:
                zone = approach_zone(opening.segment, opening.inward(region))
                before = entered[region]
                entered[region] = replace(before, zones=(*before.zones, zone), taken=(*before.taken, opening.segment))
    return entered


def open_passages(partition: Partition) -> list[Opening]:
    """Return an opening of kind ``open`` for each boundary where two rooms share no wall."""
    return [
        Opening((boundary.left, boundary.right), OpeningKind("open", CLEAR_WIDTH), boundary, segment)
        for parts in partition.open_boundaries.values()
        for boundary, segment in parts
    ]


def place_doors(
    floor: FloorRegions,
    plan: AccessPlan,
    shared: Mapping[Pair, Sequence[BoundarySegment]],
    frontages: Mapping[str, Frontage],
    kinds: Mapping[Pair, OpeningKind] | None = None,
) -> tuple[list[Opening], list[Downgrade]]:
    """Place a door for each passage that is not open.

    Cores come first, then the pairs with the shortest walls, so that those with the least choice choose first.

    Parameters
    ----------
    kinds : mapping, optional
        Kinds and widths of doors that a plan states; the others follow from what they join.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` when other openings leave a passage no room; access was planned on walls long enough.
    """
    passages = [passage for passage in plan.passages if not passage.is_open]

    def freedom(pair: Pair) -> tuple[bool, float, Pair]:
        rooms = all(floor.by_id[region].is_room for region in pair)
        return rooms, round(sum(boundary.length for boundary in shared[pair]), 3), pair

    openings: list[Opening] = []
    downgrades: list[Downgrade] = []
    for passage in sorted(passages, key=lambda passage: freedom(passage.pair)):
        opening, downgrade = _place(
            floor, passage.pair, shared.get(passage.pair, ()), frontages, (kinds or {}).get(passage.pair)
        )
        openings.append(opening)
        frontages = with_doors(frontages, [opening])
        if downgrade is not None:
            downgrades.append(downgrade)
    return openings, downgrades


def other_places(
    opening: Opening, shared: Mapping[Pair, Sequence[BoundarySegment]], frontages: Mapping[str, Frontage]
) -> Iterator[Opening]:
    """Yield the same door at other positions between its two regions, best first, then all again narrower."""
    a, b = opening.regions
    if b is None:
        return
    sides = {region: _without(frontages[region], opening.segment) for region in (a, b)}
    for width in narrower_widths(opening.kind.width):
        for position in ranked_positions(shared[pair_key(a, b)], sides, width):
            yield opening_at(position, opening.kind)


def narrower_widths(wished: float) -> list[float]:
    """Return the clear widths of a door, the wanted one first, down to 0.9 m."""
    return [wished, *(width for width in (BED_WIDTH, CLEAR_WIDTH) if width < wished)]


def _without(frontage: Frontage, segment: Segment) -> Frontage:
    kept = [i for i, taken in enumerate(frontage.taken) if taken != segment]
    return replace(frontage, zones=tuple(frontage.zones[i] for i in kept), taken=tuple(frontage.taken[i] for i in kept))


def _place(
    floor: FloorRegions,
    pair: Pair,
    boundaries: Sequence[BoundarySegment],
    frontages: Mapping[str, Frontage],
    stated: OpeningKind | None = None,
) -> tuple[Opening, Downgrade | None]:
    a, b = floor.by_id[pair[0]], floor.by_id[pair[1]]
    kind = stated or opening_kind(a, b)
    stair = next((region for region in (a, b) if region.kind == "stair" and region.core), None)
    if stair is not None and stair.core is not None:
        zone = landing_zone(stair.core, floor.outline)
        position = _widest(boundaries, frontages, kind.width, zone)
        if position is not None and position.width >= CLEAR_WIDTH - 1e-6:
            return opening_at(position, kind), None
    lift = next((region for region in (a, b) if region.kind == "elevator"), None)
    center = (lift.polygon.centroid.x, lift.polygon.centroid.y) if lift is not None else None
    position = _widest(boundaries, frontages, kind.width, None, center)
    if position is None:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"no room for a door of {MIN_CLEAR_WIDTH} m between {a.id} and {b.id}; "
            "1.20 m of free shared wall would be enough",
            path="$.layout.rooms",
            details={"rooms": list(pair)},
        )
    if stair is not None:
        return opening_at(position, kind), _note(
            floor, pair, "a door off the floor landing", "the shared wall does not reach the landing's end of the core"
        )
    if position.width < min(CLEAR_WIDTH, kind.width) - 1e-6:
        return opening_at(position, kind), _note(
            floor, pair, f"{position.width:.2f} m clear", "the shared wall is shorter than 1.02 m"
        )
    return opening_at(position, kind), None


def opening_at(position: Position, wished: OpeningKind) -> Opening:
    boundary, kind = position.boundary, replace(wished, width=round(position.width, 4))
    if kind.kind == "double" and kind.leaves < 2:
        kind = replace(kind, kind="single")
    return Opening((boundary.left, boundary.right), kind, boundary, position.segment)


def _note(floor: FloorRegions, pair: Pair, got: str, reason: str) -> Downgrade:
    return Downgrade(
        wish=f"door of {CLEAR_WIDTH} m between {pair[0]} and {pair[1]}",
        got=got,
        reason=reason,
        stage="furnish_floor",
        floor=floor.floor,
    )


def _widest(
    boundaries: Sequence[BoundarySegment],
    frontages: Mapping[str, Frontage],
    width: float,
    within: Polygon | None,
    center: Point | None = None,
) -> Position | None:
    """Choose the position of the widest opening that fits: as wide as wished, for beds, 0.9 m, with thinner jambs."""
    bare = INTERIOR_THICKNESS / 2
    trials = [(trial, WALL_END) for trial in narrower_widths(width)] + [(CLEAR_WIDTH, bare)]
    trials += [(trial, bare) for trial in (0.85, 0.8, 0.75, MIN_CLEAR_WIDTH)]
    for trial, margin in trials:
        position = choose_position(boundaries, frontages, trial, margin=margin, within=within, center=center)
        if position is not None:
            return position
    return None

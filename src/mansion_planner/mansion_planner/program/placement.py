"""A storey's sketch: corridors and placed rooms, and the measures of the massing that both need."""

from dataclasses import dataclass, field

from mansion_planner.program.model import Box, Massing, PlannedRoom, Storey, box_area

__all__ = [
    "DOOR_WALL",
    "Corridor",
    "Placement",
    "Sketch",
    "far_stair",
    "lobby_length",
    "loosened",
    "misses_areas",
    "pocket",
    "shared_wall",
    "short_edges",
    "touching",
]

DOOR_WALL = 1.22
"""Least straight wall that a sketch gives an access edge: the solver's 1.20 m and what rounding takes, metres."""


@dataclass
class Corridor:
    """A corridor, or the hub (the first): its boxes, what it is reached from, and the rooms on it."""

    id: str
    boxes: list[Box]
    parent: str = ""
    given: float = 0.0

    @property
    def area(self) -> float:
        """Sum of its boxes, or the area given where it has no place yet."""
        return self.given or sum(box_area(box) for box in self.boxes)


@dataclass
class Placement:
    """A room's place: disjoint boxes, and the room or corridor that it is reached from."""

    room: PlannedRoom
    boxes: list[Box]
    parent: str
    given: float = 0.0

    @property
    def area(self) -> float:
        """Sum of its boxes, or the area given where it has no place yet."""
        return self.given or sum(box_area(box) for box in self.boxes)


@dataclass
class Sketch:
    """Corridors (the hub first), placed rooms, and which corridor each core opens to.

    Attributes
    ----------
    loose : bool
        Rooms have areas and a room graph, and no places: the floor solver finds them.
    bearing : dict of float to list of (float, float)
        Stretches along x, by their y, where both sides of the main corridor are walls.
    """

    corridors: list[Corridor]
    rooms: list[Placement]
    core_parent: dict[str, str] = field(default_factory=dict)
    loose: bool = False
    bearing: dict[float, list[tuple[float, float]]] = field(default_factory=dict)


def misses_areas(sketch: Sketch) -> int:
    """Return how many rooms of a stated area a sketch gives another one, by more than a tenth."""
    return sum(abs(p.area - p.room.area) > 0.1 * p.room.area for p in sketch.rooms if p.room.fixed)


def loosened(sketch: Sketch) -> Sketch:
    """Return a sketch with the areas that the rooms are to have and without places; its room graph stays.

    Corridors keep their share of the floor, a twentieth at least; rooms without a stated area share the rest.
    """
    total = sum(corridor.area for corridor in sketch.corridors) + sum(placement.area for placement in sketch.rooms)
    passages = sum(corridor.area for corridor in sketch.corridors)
    widened = max(passages, 0.05 * total) / max(passages, 1e-9)
    fixed = sum(p.room.area for p in sketch.rooms if p.room.fixed)
    others = sum(p.room.area for p in sketch.rooms if not p.room.fixed)
    scale = max(total - fixed - passages * widened, 0.3 * others) / max(others, 1e-9)
    return Sketch(
        [Corridor(c.id, [], c.parent, given=c.area * widened) for c in sketch.corridors],
        [Placement(p.room, [], p.parent, given=_given(p.room, scale)) for p in sketch.rooms],
        dict(sketch.core_parent),
        loose=True,
    )


def _given(room: PlannedRoom, scale: float) -> float:
    return room.area if room.fixed else max(room.area * scale, 0.8 * room.kind.least)


def lobby_length(massing: Massing, storey: Storey) -> float:
    """Return the length of the lift lobby on a storey: larger where the building is entered."""
    if not massing.lobby:
        return 0.0
    return massing.lobby + (massing.entrance if storey.role in ("ground", "single") else 0.0)


def pocket(massing: Massing) -> float:
    """Where the north band is free from: behind the stair, and the lift beside it."""
    inner = [
        core.box[2] for core in massing.cores if core.box[1] >= massing.south and core.box[0] < 0.5 * massing.length
    ]
    return max(inner, default=0.0)


def far_stair(massing: Massing) -> float:
    return sum(
        core.box[2] - core.box[0]
        for core in massing.cores
        if core.box[0] >= 0.5 * massing.length and core.box[1] >= massing.south
    )


def touching(first: Placement, second: Placement) -> bool:
    """Whether two rooms of a sketch share at least half a metre of wall."""
    for a in first.boxes:
        for b in second.boxes:
            wide = min(a[2], b[2]) - max(a[0], b[0])
            high = min(a[3], b[3]) - max(a[1], b[1])
            if (abs(wide) < 1e-6 and high >= 0.5) or (abs(high) < 1e-6 and wide >= 0.5):
                return True
    return False


def shared_wall(first: list[Box], second: list[Box]) -> float:
    """Return the longest straight wall that two sets of boxes share, metres."""
    spans: dict[tuple[bool, float], list[tuple[float, float]]] = {}
    for a in first:
        for b in second:
            wide = (max(a[0], b[0]), min(a[2], b[2]))
            high = (max(a[1], b[1]), min(a[3], b[3]))
            if abs(high[1] - high[0]) < 1e-6 < wide[1] - wide[0]:
                spans.setdefault((True, round(high[0], 4)), []).append(wide)
            elif abs(wide[1] - wide[0]) < 1e-6 < high[1] - high[0]:
                spans.setdefault((False, round(wide[0], 4)), []).append(high)
    return max((_longest_run(line) for line in spans.values()), default=0.0)


def _longest_run(spans: list[tuple[float, float]]) -> float:
    best, begin, end = 0.0, 0.0, float("-inf")
    for low, high in sorted(spans):
        if low > end + 1e-6:
            begin, end = low, high
        end = max(end, high)
        best = max(best, end - begin)
    return best


def short_edges(sketch: Sketch) -> list[tuple[str, str]]:
    """Return the access edges of a sketch, as (parent, room), whose rooms share less wall than a door needs."""
    places = {corridor.id: corridor.boxes for corridor in sketch.corridors}
    places |= {placement.room.id: placement.boxes for placement in sketch.rooms}
    edges = [(corridor.parent, corridor.id) for corridor in sketch.corridors if corridor.parent]
    edges += [(placement.parent, placement.room.id) for placement in sketch.rooms]
    return [
        (parent, name) for parent, name in edges
        if places[name] and shared_wall(places.get(parent, []), places[name]) < DOOR_WALL
    ]  # fmt: skip

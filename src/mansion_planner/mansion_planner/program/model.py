"""What the program planner works with: rooms and storeys before they have a place, the massing, and a storey's sketch.

The massing frame has its x axis along the main corridor and the first stair in the corner at the lower x and upper y;
`mansion_planner.program.outline` turns and mirrors the finished plan.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from typing import Final, Literal

import msgspec

from mansion_knowledge import BuildingType, RoomType
from mansion_msgs_py.shapes import CompassSide

__all__ = [
    "joined_pairs",
    "Aisles",
    "Box",
    "CoreBox",
    "Corridor",
    "DOOR_WALL",
    "Massing",
    "Placement",
    "PlannedRoom",
    "Sketch",
    "Storey",
    "Wing",
    "aliases_of",
    "behind_lifts",
    "box_area",
    "CoreWish",
    "LIFT",
    "PUBLIC_STAIR",
    "far_stair",
    "lobby_length",
    "loosened",
    "misses_areas",
    "shared_wall",
    "pocket",
    "short_edges",
    "touching",
]


Box = tuple[float, float, float, float]
"""Axis-aligned ``(x0, y0, x1, y1)`` in metres."""


def box_area(box: Box) -> float:
    """Return the area of a box."""
    return max(box[2] - box[0], 0.0) * max(box[3] - box[1], 0.0)


class PlannedRoom(msgspec.Struct, frozen=True):
    """A room of a storey before it has a place.

    Attributes
    ----------
    area, least, most : float
        Wished area and its limits, square metres.
    fixed : bool
        The brief states the area.
    stated : bool
        The brief asks for the room.
    suite : tuple of PlannedRoom
        Rooms that are reached through it.
    base : str
        The name that the brief or the type gives it; rooms of one name differ by the number in their `id`.
    label : str
        What the user calls it, as written; empty for a room that the brief does not name.
    serves_as : tuple of str
        Names of rooms that the brief asks for and this one is too: a flat's main room is its living room.
    """

    id: str
    kind: RoomType
    area: float
    least: float
    most: float
    fixed: bool = False
    stated: bool = False
    suite: tuple["PlannedRoom", ...] = ()
    notes: str = ""
    base: str = ""
    label: str = ""
    serves_as: tuple[str, ...] = ()

    @property
    def gross(self) -> float:
        """Area with its suite."""
        return self.area + sum(room.gross for room in self.suite)

    def called(self, name: str) -> bool:
        """Whether a name means this room: its own, or its type's."""
        return name in (self.base, self.kind.name, *self.serves_as)

    def each(self) -> list["PlannedRoom"]:
        """Return the room and its suite, the room first."""
        return [self, *(room for child in self.suite for room in child.each())]

    def changed(self, change: Callable[["PlannedRoom"], "PlannedRoom"]) -> "PlannedRoom":
        """Return the room with a change to it and to each of its suite; `change` leaves the suite of a room alone."""
        made = change(self)
        if not self.suite:
            return made
        return msgspec.structs.replace(made, suite=tuple(child.changed(change) for child in self.suite))


@dataclass(frozen=True)
class Storey:
    """A storey while it is planned.

    Attributes
    ----------
    role : str
        ``single``, ``ground``, ``second``, ``upper``, ``top`` or ``basement``.
    use : BuildingType
        Whose room lists it follows.
    copy : int, optional
        The storey that it repeats.
    lead : RoomType, optional
        The main room of its use, where the building's circulation needs another hub.
    setback, extension : float
        Metres by which it is shorter or longer than the main bar.
    hall_wing : bool
        It is longer by a hall that closes its bar, beyond the stair at the end of the storeys above.
    foyer : float
        Metres of the band beside the entrance that its hub has beyond the lift lobby.
    """

    index: int
    role: str
    use: BuildingType
    hub: RoomType
    rooms: tuple[PlannedRoom, ...] = ()
    copy: int | None = None
    lead: RoomType | None = None
    setback: float = 0.0
    extension: float = 0.0
    hall_wing: bool = False
    foyer: float = 0.0


PUBLIC_STAIR: Final = (3, 6)
"""Width and length of a core with two flights of 1.4 m, for many people at once and as an exit, metres."""

LIFT: Final = 2
"""Side of a lift's shaft, metres."""


@dataclass(frozen=True)
class CoreWish:
    """How many cores a building has, and the width and length of each stair, metres."""

    stairs: int
    lifts: int
    stair: tuple[int, int] = PUBLIC_STAIR

    @property
    def domestic(self) -> bool:
        """Whether there are the small stairs of a home."""
        return self.stairs > 0 and self.stair != PUBLIC_STAIR

    @property
    def area(self) -> float:
        """Square metres of a storey that the cores take."""
        return float(self.stairs * self.stair[0] * self.stair[1] + self.lifts * LIFT**2)


@dataclass(frozen=True)
class CoreBox:
    """A stair or lift in the massing frame; `side` is where it opens."""

    id: str
    type: Literal["stair", "elevator"]
    box: Box
    side: CompassSide | None = None


@dataclass(frozen=True)
class Wing:
    """A wing at right angles to the main bar: from `x0` to `x1`, `reach` metres beyond the bar's edge."""

    x0: float
    x1: float
    reach: float
    north: bool = False


@dataclass(frozen=True)
class Aisles:
    """The corridors of a deep storey: parallel ones along x, and one across that joins them from front to back.

    Attributes
    ----------
    lines : tuple of (float, float)
        Lower and upper edge of each parallel corridor, from the lowest.
    cross : (float, float)
        Sides of the corridor across.
    lobby : tuple, optional
        Box beside the corridor across that holds the lifts and the floor before them.
    outer, inner : float
        Depth of the two bands along the outer walls, and of each band between two corridors, which lie in pairs.
    """

    lines: tuple[tuple[float, float], ...]
    cross: tuple[float, float]
    lobby: Box | None
    outer: float
    inner: float


@dataclass(frozen=True)
class Massing:
    """Dimensions that all storeys share.

    Attributes
    ----------
    length : float
        Length of the main bar.
    north, corridor, south : float
        Depth of the band above the corridor, width of the corridor, depth of the band below it; in a hall the hub
        itself takes `corridor`, and `south` is 0.
    lobby : float
        Length of the lift lobby in the south band; 0 without a lift in the corner.
    wings : tuple of Wing
    entrance : float
        How much longer the lobby of the entrance storey is.
    court : float
        Depth of the bar that closes a courtyard below the wings; 0 without.
    hall : bool
        The hub is the main room, which the others line.
    aisles : Aisles, optional
        Corridors of a storey too deep for one; `north`, `corridor` and `south` then only add up to its depth.
    """

    length: float
    north: float
    corridor: float
    south: float
    cores: tuple[CoreBox, ...] = ()
    lobby: float = 0.0
    wings: tuple[Wing, ...] = ()
    court: float = 0.0
    entrance: float = 0.0
    hall: bool = False
    aisles: Aisles | None = None

    @property
    def drop(self) -> float:
        """How far the building reaches below the main bar."""
        return max((w.reach for w in self.wings if not w.north), default=0.0) + self.court

    @property
    def far(self) -> tuple[float, float]:
        """Ends of the far bar along x; equal without one."""
        if not self.court:
            return 0.0, 0.0
        if len(self.wings) == 1:
            return 0.0, self.length
        return self.wings[0].x0, self.wings[-1].x1

    @property
    def far_length(self) -> float:
        """Length of the far bar."""
        return self.far[1] - self.far[0]

    @property
    def far_band(self) -> float:
        """Depth of each band of the far bar."""
        return (self.court - self.corridor) / 2

    @property
    def depth(self) -> float:
        """Depth of the main bar."""
        return self.north + self.corridor + self.south


DOOR_WALL = 1.22
"""Least straight wall that a sketch gives an access edge: the solver's 1.20 m and a margin for rounding, metres."""


@dataclass(frozen=True)
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


class Placement(msgspec.Struct, frozen=True):
    """A room's place: disjoint boxes, and the room or corridor that it is reached from."""

    room: PlannedRoom
    boxes: list[Box]
    parent: str
    given: float = 0.0

    @property
    def area(self) -> float:
        """Sum of its boxes, or the area given where it has no place yet."""
        return self.given or sum(box_area(box) for box in self.boxes)


@dataclass(frozen=True)
class Sketch:
    """Corridors (the hub first), placed rooms, and which corridor each core opens to.

    Attributes
    ----------
    loose : bool
        Rooms have areas and a room graph, and no places: the floor solver finds them.
    placed : Sketch, optional
        For a loose sketch, the one with places that it was made from: a layout that certainly exists.
    bearing : dict of float to list of (float, float)
        Stretches along x, by their y, where both sides of the main corridor are walls.
    """

    corridors: list[Corridor]
    rooms: list[Placement]
    core_parent: dict[str, str] = field(default_factory=dict)
    loose: bool = False
    placed: "Sketch | None" = None
    bearing: dict[float, list[tuple[float, float]]] = field(default_factory=dict)


def misses_areas(sketch: Sketch) -> int:
    """Return how many rooms of a stated area a sketch gives another one, by more than a tenth."""
    return sum(abs(p.area - p.room.area) > 0.1 * p.room.area for p in sketch.rooms if p.room.fixed)


LEAST_PASSAGES = 0.12
"""Least share of a loose storey that is for the ways to its rooms, where the stated areas leave that much or not."""


def loosened(sketch: Sketch) -> Sketch:
    """Return a sketch with the areas that the rooms are to have and without places; its room graph stays.

    Rooms without a stated area share what the others leave. Where stated areas take so much that these would be cut
    down, corridors give way as far as `LEAST_PASSAGES`: in a sketch they also have what no room fits into. Where all of
    it is more than the floor has, everything gives way in proportion.
    """
    drawn = sum(corridor.area for corridor in sketch.corridors)
    total = drawn + sum(placement.area for placement in sketch.rooms)
    fixed = sum(p.room.area for p in sketch.rooms if p.room.fixed)
    loose = [p.room for p in sketch.rooms if not p.room.fixed]
    wished = sum(max(room.area, room.kind.least) for room in loose)
    passages = max(min(drawn, total - fixed - wished), min(drawn, LEAST_PASSAGES * total), _FEWEST_PASSAGES * total)
    others = sum(room.area for room in loose)
    scale = max(total - fixed - passages, 0.3 * others) / max(others, 1e-9)
    asked = passages + sum(_given(p.room, scale) for p in sketch.rooms)
    fit = min(total / max(asked, 1e-9), 1.0)
    widened = passages / max(drawn, 1e-9)
    return Sketch(
        [Corridor(c.id, [], c.parent, given=c.area * widened * fit) for c in sketch.corridors],
        [Placement(p.room, [], p.parent, given=_given(p.room, scale) * fit) for p in sketch.rooms],
        dict(sketch.core_parent),
        loose=True,
        placed=sketch,
    )


_FEWEST_PASSAGES = 0.05
"""Share of a loose storey that is for the ways to its rooms though the sketch has fewer."""


def _given(room: PlannedRoom, scale: float) -> float:
    return room.area if room.fixed else max(room.area * scale, 0.8 * room.kind.least)


def lobby_length(massing: Massing, storey: Storey) -> float:
    """Return the length of the lift lobby and the foyer on a storey: larger where the building is entered.

    Lifts that stand at the corridor have none above the entrance storey: their own length is returned.
    """
    if not massing.lobby:
        return storey.foyer
    if storey.role in ("ground", "single"):
        return massing.lobby + massing.entrance + storey.foyer
    return behind_lifts(massing)[2] or massing.lobby


def behind_lifts(massing: Massing) -> Box:
    """Return the floor between the lifts at the corridor and the outer wall below; an empty box where there is none."""
    lifts = [core.box for core in massing.cores if core.type == "elevator" and core.box[3] <= massing.south + 0.01]
    low = min((box[1] for box in lifts), default=0.0)
    return (0.0, 0.0, max(box[2] for box in lifts), low) if low > 0.0 else (0.0, 0.0, 0.0, 0.0)


def pocket(massing: Massing) -> float:
    """Where the north band is free from: behind the stair, and the lift beside it."""
    inner = [
        core.box[2] for core in massing.cores if core.box[1] >= massing.south and core.box[0] < 0.5 * massing.length
    ]
    return max(inner, default=0.0)


def far_stair(massing: Massing) -> float:
    """Return the length that the stairs at the far end take of the north band, metres."""
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


def joined_pairs(sketch: Sketch, apart: Iterable[tuple[str, str]]) -> list[tuple[str, str]]:
    """Return the pairs of rooms that are to be apart and share a wall."""
    found = []
    for one, other in apart:
        firsts, seconds = ([p for p in sketch.rooms if p.room.called(name)] for name in (one, other))
        if any(a is not b and touching(a, b) for a in firsts for b in seconds):
            found.append((one, other))
    return found


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


def aliases_of(room: PlannedRoom) -> list[str]:
    """Return the names of a room beside its label: its type where the user calls it otherwise."""
    if not room.label:
        return []
    plain = room.label.lower()
    names = [name.replace("_", " ") for name in (room.base, room.kind.name, *room.serves_as)]
    return list(dict.fromkeys(name for name in names if name != plain))

"""How good the plan of a storey is: proportions, sizes and windows of its rooms; and as a home, hall and day rooms."""

from collections.abc import Iterable, Sequence

from mansion_planner.program.model import Box, Massing, Placement, PlannedRoom, Sketch, Storey, box_area, touching

__all__ = [
    "FACING",
    "STRIP",
    "aspect",
    "carved",
    "comes_out_as_strips",
    "crosswise",
    "dark_rooms",
    "fill",
    "home_faults",
    "is_shallow_bay",
    "long_halls",
    "ragged",
    "shallow_garages",
    "shrunk_rooms",
    "strips",
    "swollen_rooms",
]

STRIP = 3.0
"""Long side of a room to its short one from which it is a strip."""

_FEW, _SHARE = 3, 0.2
"""So many strips, and such a share of a storey's rooms, leave it usable."""

_LEAST_OUTER_WALL = 1.0


def aspect(boxes: list[Box]) -> float:
    """Return the long side to the short one of the rectangle around a room; infinity where it has no floor."""
    short, long = _sides(boxes)
    return long / short if short > 0.01 else float("inf")


def _sides(boxes: list[Box]) -> list[float]:
    """Return the sides of the rectangle around a room, the short one first."""
    wide = max(box[2] for box in boxes) - min(box[0] for box in boxes)
    high = max(box[3] for box in boxes) - min(box[1] for box in boxes)
    return sorted((wide, high))


_COMPACT = 0.75
"""Share of the rectangle around it that a compact room fills."""


def fill(boxes: list[Box]) -> float:
    """Return what share of the rectangle around a room its boxes fill; 1 where it has no floor."""
    short, long = _sides(boxes)
    return sum(box_area(box) for box in boxes) / (short * long) if short > 0.01 else 1.0


def ragged(sketch: Sketch) -> list[Placement]:
    """Return the rooms of a sketch that leave much of the rectangle around them to others."""
    return [placement for placement in sketch.rooms if placement.boxes and fill(placement.boxes) < _COMPACT]


_WHOLE = 0.9
"""Share of the rectangle around it that a room fills which is of use as one rectangle alone."""


def carved(sketch: Sketch) -> list[Placement]:
    """Return the halls of a sketch out of which other rooms are cut, though they are of use as rectangles alone."""
    return [p for p in sketch.rooms if p.room.kind.whole and p.boxes and fill(p.boxes) < _WHOLE]


def strips(sketch: Sketch) -> list[Placement]:
    """Return the rooms of a sketch that are long and narrow."""
    return [placement for placement in sketch.rooms if placement.boxes and aspect(placement.boxes) > STRIP]


_LONG_HALL, _HALL = 2.6, 100.0
"""Long side to the short one from which a hall is too long, and the area of a hall, square metres."""


def long_halls(sketch: Sketch) -> list[Placement]:
    """Return the large rooms of a sketch that are of use as rectangles alone and long for that."""
    return [
        p for p in sketch.rooms if p.room.kind.whole and p.area >= _HALL and p.boxes and aspect(p.boxes) > _LONG_HALL
    ]


FACING = frozenset({"cinema_hall", "auditorium", "lecture_hall"})
"""Rooms in rows that look to one end, which people enter at the other or beside it."""

_SQUARE = 1.05
"""Width to depth of such a room at most."""


def crosswise(sketch: Sketch) -> list[Placement]:
    """Return the rooms in rows of a sketch that are wider than deep, as seen from the corridor or hall before them."""
    boxes = {corridor.id: corridor.boxes for corridor in sketch.corridors}
    return [
        p for p in sketch.rooms
        if p.room.kind.name in FACING and p.boxes and p.parent in boxes and _is_wide(p.boxes, boxes[p.parent])
    ]  # fmt: skip


def _is_wide(room: list[Box], before: list[Box]) -> bool:
    """Whether a room is wider along what is before it than it is deep."""
    x0, y0 = (min(box[i] for box in room) for i in (0, 1))
    x1, y1 = (max(box[i] for box in room) for i in (2, 3))
    along = max(
        (min(x1, b[2]) - max(x0, b[0]) for b in before if min(abs(b[3] - y0), abs(b[1] - y1)) < 0.01), default=0
    )
    up = max((min(y1, b[3]) - max(y0, b[1]) for b in before if min(abs(b[2] - x0), abs(b[0] - x1)) < 0.01), default=0)
    wide, deep = (x1 - x0, y1 - y0) if along >= up else (y1 - y0, x1 - x0)
    return wide > _SQUARE * deep


_TWO_CARS = 30.0
"""Area from which a garage is for two cars side by side, square metres."""

_CAR = (2.9, 5.2)
"""Least width and length of the place of a car with the ways around it, metres, walls included."""


def shallow_garages(sketch: Sketch) -> list[Placement]:
    """Return the garages of a sketch into which no car drives along its length, or not two side by side."""
    garages = [p for p in sketch.rooms if "garage" in (p.room.kind.name, p.room.kind.counts_as) and p.boxes]
    if not garages:
        return []
    boxes = [box for room in sketch.rooms for box in room.boxes]
    boxes += [box for corridor in sketch.corridors for box in corridor.boxes]
    bounds = (*(min(box[i] for box in boxes) for i in (0, 1)), *(max(box[i] for box in boxes) for i in (2, 3)))
    return [each for each in garages if not _holds_cars(each, bounds)]


def _holds_cars(garage: Placement, bounds: Sequence[float]) -> bool:
    """Whether a car, or two side by side, stand behind a facade of the largest part of a garage."""
    box = max(garage.boxes, key=box_area)
    on_facade = [any(abs(box[i] - bounds[i]) < 0.01 for i in (side, side + 2)) for side in (0, 1)]
    wide, high = box[2] - box[0], box[3] - box[1]
    ways_in = [sides for sides, open_ in zip(((high, wide), (wide, high)), on_facade) if open_]
    width, length = _CAR
    least = length if garage.room.area >= _TWO_CARS else width
    return any(front >= least - 0.01 and depth >= length - 0.01 for front, depth in ways_in)


_ENGINE = 7.4
"""Depth of a bay for a fire engine behind its door, with the way around it, metres."""


def is_shallow_bay(storey: Storey, sketch: Sketch) -> bool:
    """Whether the hall that engines drive out of is too shallow for one to stand behind its door."""
    if storey.hub.name not in ("apparatus_bay", "ambulance_bay") or not sketch.corridors:
        return False
    largest = max(sketch.corridors[0].boxes, key=box_area)
    return min(largest[2] - largest[0], largest[3] - largest[1]) < _ENGINE


_SHRUNK = 0.9
"""Share of its planned area below which a room that the brief asks for counts as too small."""


def shrunk_rooms(sketch: Sketch) -> list[Placement]:
    """Return the rooms that the brief asks for and a sketch gives clearly less than their planned area."""
    return [p for p in sketch.rooms if p.room.stated and p.boxes and p.area < _SHRUNK * p.room.area]


_SWOLLEN, _AT_LEAST = 2.0, 10.0
"""By how many times a room exceeds its planned area to count as swollen, and by how many square metres at least."""


_SWOLLEN_WET, _AT_LEAST_WET = 1.5, 3.0
"""The same of a bathroom or toilet of the brief, which nobody wants larger than it need be."""


def swollen_rooms(sketch: Sketch) -> list[Placement]:
    """Return the rooms that fill a place far too large for them: a toilet alone in a band."""
    return [p for p in sketch.rooms if p.boxes and p.area > _most(p.room)]


def _most(room: PlannedRoom) -> float:
    """Return the square metres from which on a room is swollen."""
    small = room.kind.toilet and room.stated
    times, more = (_SWOLLEN_WET, _AT_LEAST_WET) if small else (_SWOLLEN, _AT_LEAST)
    return max(times * room.area, room.area + more)


def comes_out_as_strips(sketch: Sketch) -> bool:
    """Whether so many rooms are long and narrow that the form of the plan does not suit the storey."""
    found = len(strips(sketch))
    return found >= _FEW and found > _SHARE * len(sketch.rooms)


def dark_rooms(sketch: Sketch, massing: Massing) -> list[Placement]:
    """Return the rooms that want a window and have no outer wall of the main bar."""
    return [p for p in sketch.rooms if p.room.kind.daylight and not any(_lies_outside(box, massing) for box in p.boxes)]


def _lies_outside(box: Box, massing: Massing) -> bool:
    x0, y0, x1, y1 = box
    on_end = min(x0, massing.length - x1) < 0.01 and y1 - y0 >= _LEAST_OUTER_WALL
    return on_end or (min(y0, massing.depth - y1) < 0.01 and x1 - x0 >= _LEAST_OUTER_WALL)


_KITCHENS = ("kitchen", "open_kitchen", "kitchen_diner")
_GROUP = ("living_room", "dining_room", "open_kitchen", "kitchen_diner", "lounge", "studio_room")
_BATHS = ("bathroom", "ensuite_bathroom")
_UTILITY = ("utility_room", "laundry_room", "pantry")

_MOST_HALL = 0.15
"""Share of a home that its halls take at most, stairs not counted."""

_SLENDER = 2.2
"""Long side of a room to live in to its short one from which furniture is hard to place."""

_HALL_PRICE, _KITCHEN_PRICE, _UTILITY_PRICE, _SLENDER_PRICE = 1.0, 1.5, 0.75, 0.4
"""What each fault counts for, beside a strip or a room of a wrong size, which counts 1."""

_LONG, _LONG_PRICE = 2.0, 1.5
"""Long side to short side from which a living room that others line is long, and what each time more counts for."""

_EACH_SHARE = 8.0
"""What the share of the halls beyond the most adds to its price."""


def home_faults(storeys: Sequence[tuple[Storey, Sketch, float]]) -> float:
    """Return what is wrong with a home as such; 0 for nothing.

    Parameters
    ----------
    storeys : sequence of (Storey, Sketch, float)
        Storeys above ground that repeat no other, with their gross areas in square metres.

    Notes
    -----
    Figures follow what architects ask of dwellings (Neufert, Architects' Data): circulation of 12 to 15%, kitchen,
    dining and living room as one group, the utility room by the kitchen.
    """
    halls = sum(
        corridor.area
        for storey, sketch, _ in storeys
        for corridor in sketch.corridors
        if storey.hub.zone == "circulation"
    )
    over = halls / max(sum(area for *_, area in storeys), 1.0) - _MOST_HALL
    price = _HALL_PRICE + _EACH_SHARE * over if over > 0.0 else 0.0
    return price + sum(_storey_faults(storey, sketch) for storey, sketch, _ in storeys)


def _storey_faults(storey: Storey, sketch: Sketch) -> float:
    """Return what is wrong with the places and forms of a storey's rooms."""
    placed = [placement for placement in sketch.rooms if placement.boxes]
    kitchens, group, utility = (_of(placed, kinds) for kinds in (_KITCHENS, _GROUP, _UTILITY))
    slender = (p for p in placed if p.room.kind.daylight or p.room.kind.name in _BATHS)
    price = _SLENDER_PRICE * sum(aspect(p.boxes) > _SLENDER for p in slender)
    if storey.hub.daylight and sketch.corridors:
        # The room that the others line is not among the placed rooms, so whether it is a strip is checked here.
        form = aspect(sketch.corridors[0].boxes)
        price += _LONG_PRICE * max(form - _LONG, 0.0)
    if kitchens and group and storey.hub.name not in _GROUP:
        price += _KITCHEN_PRICE * (not _are_beside(kitchens, group))
    if kitchens and utility:
        price += _UTILITY_PRICE * (not _are_beside(kitchens, utility))
    return price


def _of(placements: Iterable[Placement], kinds: Sequence[str]) -> list[Placement]:
    """Return the rooms of some types, or counted as one."""
    return [p for p in placements if p.room.kind.name in kinds or p.room.kind.counts_as in kinds]


def _are_beside(ours: Iterable[Placement], theirs: Sequence[Placement]) -> bool:
    """Whether one of our rooms shares a wall with one of theirs."""
    return any(a is not b and touching(a, b) for a in ours for b in theirs)

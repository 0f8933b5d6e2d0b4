"""A storey's sketch: corridors and placed rooms, and the measures of the massing that both need."""

from dataclasses import dataclass, field

from mansion_planner.program.model import Box, Massing, PlannedRoom, Storey, box_area

__all__ = ["Corridor", "Placement", "Sketch", "far_stair", "lobby_length", "pocket", "touching"]


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
    bearing : dict of float to list of (float, float)
        Stretches along x, by their y, where both sides of the main corridor are walls.
    """

    corridors: list[Corridor]
    rooms: list[Placement]
    core_parent: dict[str, str] = field(default_factory=dict)
    bearing: dict[float, list[tuple[float, float]]] = field(default_factory=dict)


def lobby_length(massing: Massing, storey: Storey) -> float:
    """Return the length of the lift lobby on a storey: larger where the building is entered."""
    if not massing.lobby:
        return 0.0
    return massing.lobby + (massing.entrance if storey.role in ("ground", "single") else 0.0)


def pocket(massing: Massing) -> float:
    """Where the north band is free from: behind the stair, and the lift beside it."""
    inner = [
        core.box[2]
        for core in massing.cores
        if core.box[1] >= massing.south and core.box[0] < 0.5 * massing.length
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

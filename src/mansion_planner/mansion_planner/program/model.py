"""What the program planner works with: planned rooms, storeys and the massing of the building.

The massing frame has its x axis along the main corridor and the first stair in the corner at the lower x and upper y;
`mansion_planner.program.frame` turns and mirrors the finished plan.
"""

from dataclasses import dataclass, field
from typing import Literal

from mansion_knowledge import BuildingType, RoomType

__all__ = ["Box", "CoreBox", "Massing", "PlannedRoom", "Side", "Storey", "Wing", "box_area"]

Side = Literal["north", "south", "east", "west"]

Box = tuple[float, float, float, float]
"""Axis-aligned ``(x0, y0, x1, y1)`` in metres."""


def box_area(box: Box) -> float:
    """Return the area of a box."""
    return max(box[2] - box[0], 0.0) * max(box[3] - box[1], 0.0)


@dataclass
class PlannedRoom:
    """A room of a storey before it has a place.

    Attributes
    ----------
    area, least, most : float
        Wished area and its limits, square metres.
    fixed : bool
        The brief states the area.
    stated : bool
        The brief asks for the room.
    suite : list of PlannedRoom
        Rooms that are reached through it.
    base : str
        The name that the brief or the type gives it; rooms of one name differ by the number in their `id`.
    label : str
        What the user calls it, as written; empty for a room that the brief does not name.
    """

    id: str
    kind: RoomType
    area: float
    least: float
    most: float
    fixed: bool = False
    stated: bool = False
    suite: list["PlannedRoom"] = field(default_factory=list)
    notes: str = ""
    base: str = ""
    label: str = ""

    @property
    def gross(self) -> float:
        """Area with its suite."""
        return self.area + sum(room.gross for room in self.suite)

    def called(self, name: str) -> bool:
        """Whether a name means this room: its own, or its type's."""
        return name in (self.base, self.kind.name)

    def each(self) -> list["PlannedRoom"]:
        """Return the room and its suite, the room first."""
        return [self, *(room for child in self.suite for room in child.each())]


@dataclass
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
    """

    index: int
    role: str
    use: BuildingType
    hub: RoomType
    rooms: list[PlannedRoom] = field(default_factory=list)
    copy: int | None = None
    lead: RoomType | None = None
    setback: float = 0.0
    extension: float = 0.0


@dataclass(frozen=True)
class CoreBox:
    """A stair or lift in the massing frame; `side` is where it opens."""

    id: str
    type: Literal["stair", "elevator"]
    box: Box
    side: Side | None = None


@dataclass(frozen=True)
class Wing:
    """A wing at right angles to the main bar: from `x0` to `x1`, `reach` metres beyond the bar's edge."""

    x0: float
    x1: float
    reach: float
    north: bool = False


@dataclass(frozen=True)
class Massing:
    """Dimensions that all storeys share.

    Attributes
    ----------
    length : float
        Of the main bar.
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

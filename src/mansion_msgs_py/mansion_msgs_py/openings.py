"""Doors and windows that a plan gives, on the walls of a floor's layout; they are built as given."""

from typing import Annotated, Literal, TypeAlias

import msgspec

from mansion_msgs_py.limits import MAX_OBJECTS
from mansion_msgs_py.shapes import Elevation, Identifier, Length, Segment

__all__ = ["DoorKind", "GivenDoor", "GivenOpenings", "GivenWindow"]

DoorKind: TypeAlias = Literal[
    "open", "doorway", "single", "double", "glazed", "sliding", "frame", "entrance", "balcony", "garage"
]
"""``open`` is a stretch of missing wall; ``sliding`` a lift's landing door; ``frame`` a stair's door frame;
``garage`` an outer door for vehicles, of slats that roll up."""


class GivenDoor(msgspec.Struct, frozen=True, kw_only=True):
    """A door between two rooms or cores, or between one and the outside.

    Attributes
    ----------
    rooms : (str, str or None)
        Ids in the floor's room graph; ``None`` is outside.
    segment : Segment, optional
        The clear opening on the boundary of the layout; where absent, a place on the wall is chosen.
    width : float, optional
        Clear width where no segment says it.
    kind : DoorKind, optional
        Chosen by what it joins where absent; ``open`` takes the whole wall between the two away.
    """

    rooms: tuple[Identifier, Identifier | None]
    segment: Segment | None = None
    width: Length | None = None
    kind: DoorKind | None = None


class GivenWindow(msgspec.Struct, frozen=True, kw_only=True):
    """A window on the outline; sill and height are those that the room's type usually has where absent."""

    segment: Segment
    sill: Elevation | None = None
    height: Length | None = None


class GivenOpenings(msgspec.Struct, frozen=True, kw_only=True):
    """All openings of a floor.

    Attributes
    ----------
    doors : list of GivenDoor
    windows : list of GivenWindow, optional
        Chosen by room type where absent.
    further_doors : bool
        The building may get outer doors beyond those listed: an entrance, a second exit, doors for vehicles.
    """

    doors: Annotated[list[GivenDoor], msgspec.Meta(max_length=MAX_OBJECTS)] = []
    windows: Annotated[list[GivenWindow], msgspec.Meta(max_length=MAX_OBJECTS)] | None = None
    further_doors: bool = False

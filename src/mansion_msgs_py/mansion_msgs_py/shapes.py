"""Plane and space primitives, and names, that payloads share.

Lengths are metres in plan coordinates: x to the right, y up (REP-103), z up. A ring is counter-clockwise and does
not repeat its first point.
"""

from typing import Annotated, Literal, TypeAlias

import msgspec

from mansion_msgs_py.limits import MAX_COORDINATE, MAX_CORNERS, MAX_FLOOR_AREA, MAX_HEIGHT, MIN_AREA

__all__ = [
    "Area",
    "BuildingId",
    "CompassSide",
    "Coordinate",
    "Degrees",
    "Elevation",
    "FileInFolder",
    "FileName",
    "Identifier",
    "Length",
    "PathText",
    "Point",
    "Point3",
    "Ring",
    "Segment",
    "Size3",
]

Coordinate: TypeAlias = Annotated[float, msgspec.Meta(ge=-MAX_COORDINATE, le=MAX_COORDINATE)]
"""Metres in plan."""

Elevation: TypeAlias = Annotated[float, msgspec.Meta(ge=-MAX_HEIGHT, le=MAX_HEIGHT)]
"""Metres above the ground, or above a finished floor."""

Degrees: TypeAlias = Annotated[float, msgspec.Meta(ge=-36_000.0, le=36_000.0)]
"""An angle."""

Point: TypeAlias = tuple[Coordinate, Coordinate]
Point3: TypeAlias = tuple[Coordinate, Coordinate, Elevation]
Ring: TypeAlias = Annotated[list[Point], msgspec.Meta(max_length=MAX_CORNERS)]
Segment: TypeAlias = tuple[Point, Point]

CompassSide: TypeAlias = Literal["north", "south", "east", "west"]
"""A side of an upright rectangle in plan; north is up."""

Length: TypeAlias = Annotated[float, msgspec.Meta(gt=0.0, le=MAX_COORDINATE)]
"""A positive length in metres."""

Area: TypeAlias = Annotated[float, msgspec.Meta(ge=MIN_AREA, le=MAX_FLOOR_AREA)]
"""An area of a room or a storey in square metres."""

Size3: TypeAlias = tuple[Length, Length, Length]
"""Width along the front, depth and height, in metres."""

Identifier: TypeAlias = Annotated[str, msgspec.Meta(min_length=1, max_length=200)]
"""A stable, readable id such as ``F2/meeting_room_1``."""

BuildingId: TypeAlias = Annotated[
    str,
    msgspec.Meta(
        pattern=r"^[A-Za-z0-9][A-Za-z0-9_-]{0,63}$",
        description="an id of letters, digits, '_' and '-', 64 at most, that begins with a letter or a digit",
    ),
]
"""A building's id, which is also the name of its folder where none is given."""

FileName: TypeAlias = Annotated[
    str,
    msgspec.Meta(
        pattern=r"^[A-Za-z0-9_][A-Za-z0-9_.-]{0,95}$",
        description="a name of letters, digits, '_', '.' and '-', 96 at most, that begins with no '.' or '-'",
    ),
]
"""What becomes the name of a file or a part of it."""

PathText: TypeAlias = Annotated[
    str,
    msgspec.Meta(pattern=r"^[^\x00]+$", max_length=4096, description="a path of at most 4096 characters without NUL"),
]
"""A path on the machine of the node."""

FileInFolder: TypeAlias = Annotated[
    str,
    msgspec.Meta(
        pattern=r"^(?!/)(?!([^\x00-\x1f\\]*/)?\.\.(/|$))[^\x00-\x1f\\]{0,400}$",
        description="a path inside the folder: no '/' at its beginning and no '..' in it",
    ),
]
"""Where a file is, relative to the folder of the file that names it; empty for one that is not there."""

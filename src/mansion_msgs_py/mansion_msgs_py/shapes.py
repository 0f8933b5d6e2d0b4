"""Plane and space primitives, and names, that payloads share.

Lengths are metres in plan coordinates: x to the right, y up (REP-103), z up. A ring is counter-clockwise and does
not repeat its first point.
"""

from typing import Annotated, TypeAlias

import msgspec

__all__ = [
    "Area",
    "BuildingId",
    "FileInFolder",
    "FileName",
    "Identifier",
    "Length",
    "Point",
    "Point3",
    "Ring",
    "Segment",
    "Size3",
]

Point: TypeAlias = tuple[float, float]
Point3: TypeAlias = tuple[float, float, float]
Ring: TypeAlias = list[Point]
Segment: TypeAlias = tuple[Point, Point]

Length: TypeAlias = Annotated[float, msgspec.Meta(gt=0.0)]
"""A positive length in metres."""

Area: TypeAlias = Annotated[float, msgspec.Meta(gt=0.0)]
"""A positive area in square metres."""

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

FileInFolder: TypeAlias = Annotated[
    str,
    msgspec.Meta(
        pattern=r"^(?!/)(?!([^\x00-\x1f\\]*/)?\.\.(/|$))[^\x00-\x1f\\]{0,400}$",
        description="a path inside of the folder: no '/' at its beginning and no '..' in it",
    ),
]
"""Where a file is, relative to the folder of the file that names it; empty for one that is not there."""

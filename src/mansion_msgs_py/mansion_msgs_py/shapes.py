"""Plane and space primitives that payloads share.

Lengths are metres in plan coordinates: x to the right, y up (REP-103), z up. A ring is counter-clockwise and does
not repeat its first point.
"""

from typing import Annotated, TypeAlias

import msgspec

__all__ = ["Area", "Identifier", "Length", "Point", "Point3", "Ring", "Segment", "Size3"]

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

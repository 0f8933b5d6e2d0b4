"""Limits on the size of a building: what is beyond is refused, with the limit named, before any work begins.

The greatest buildings that people plan lie well within. A storey at the limit is built in minutes, in less than 1 GB.
"""

from typing import Final

__all__ = [
    "MAX_BUILDING_AREA",
    "MAX_CELLS",
    "MAX_COORDINATE",
    "MAX_CORNERS",
    "MAX_EXTENT",
    "MAX_FLOORS",
    "MAX_FLOOR_AREA",
    "MAX_HEIGHT",
    "MAX_OBJECTS",
    "MAX_PAYLOAD",
    "MAX_ROOMS",
    "MIN_AREA",
]

MAX_PAYLOAD: Final = 64_000_000
"""Bytes of a JSON text."""

MAX_COORDINATE: Final = 10_000.0
"""Metres from the origin in plan."""

MAX_HEIGHT: Final = 10_000.0
"""Metres above or below the ground."""

MIN_AREA: Final = 0.1
"""Square metres of a room: less is no cupboard, and no wall could be moved finely enough for it."""

MAX_FLOOR_AREA: Final = 50_000.0
"""Square metres of a storey."""

MAX_BUILDING_AREA: Final = 1_000_000.0
"""Square metres of all storeys."""

MAX_EXTENT: Final = 400.0
"""Metres from end to end of an outline that is given."""

MAX_CELLS: Final = 64_000_000
"""Cells of a grid: those of 0.05 m in a square of `MAX_EXTENT`."""

MAX_FLOORS: Final = 100
"""Storeys above ground; as many again may lie below."""

MAX_CORNERS: Final = 20_000
"""Points of a ring."""

MAX_ROOMS: Final = 1_000
"""Rooms of a storey."""

MAX_OBJECTS: Final = 20_000
"""Objects, or anything else of one kind, of a storey."""

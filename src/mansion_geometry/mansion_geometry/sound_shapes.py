"""Shapes of a scene that no geometry can be computed with: rings that cross themselves or enclose nothing, walls
without a length."""

import math
from collections.abc import Iterator, Sequence
from typing import Final, NamedTuple

from shapely.geometry import Polygon

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.shapes import Ring

__all__ = ["UnsoundShape", "require_sound_shapes", "unsound_shapes"]

LEAST_AREA: Final = 1e-4
"""Square metres below which a ring encloses nothing."""

LEAST_LENGTH: Final = 1e-3
"""Metres below which a wall has no length."""


class UnsoundShape(NamedTuple):
    """A degenerate shape: the id of its owner, which of its shapes it is, and the reason."""

    owner: str
    part: str
    message: str


def unsound_shapes(scene: FloorScene) -> Iterator[UnsoundShape]:
    """Yield the shapes of a floor's outline, rooms, cores and walls that are degenerate."""
    yield from _region(f"floor {scene.floor}", "outline", scene.outline, scene.holes)
    for room in scene.rooms:
        yield from _region(room.id, "polygon", room.polygon, room.holes)
        yield from _region(room.id, "net interior", room.net_polygon, room.net_holes)
    for core in scene.cores:
        yield from _region(f"{core.id} on floor {scene.floor}", "polygon", core.polygon, ())
    for wall in scene.walls:
        if math.dist(*wall.segment) < LEAST_LENGTH:
            yield UnsoundShape(wall.id, "segment", "has no length")


def _region(owner: str, part: str, ring: Ring, holes: Sequence[Ring]) -> Iterator[UnsoundShape]:
    if len(ring) < 3 or any(len(hole) < 3 for hole in holes):
        yield UnsoundShape(owner, part, f"its {part} has fewer than three corners")
        return
    shape = Polygon(ring, holes)
    if not shape.is_valid:
        yield UnsoundShape(owner, part, f"its {part} crosses itself")
    elif shape.area < LEAST_AREA:
        yield UnsoundShape(owner, part, f"its {part} encloses nothing")


def require_sound_shapes(scenes: Sequence[FloorScene]) -> None:
    """Refuse floors with a degenerate shape.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` with the first of them.
    """
    for scene in scenes:
        for shape in unsound_shapes(scene):
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD,
                f"{shape.owner}: {shape.message}; `mansion check` names all faults of the building",
                details={"floor": scene.floor, "owner": shape.owner},
            )

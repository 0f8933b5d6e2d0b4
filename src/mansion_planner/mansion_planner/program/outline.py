"""The massing frame in plan coordinates: how the building stands, outlines of its storeys, and bearing walls."""

from collections.abc import Iterator
from dataclasses import dataclass, field

import shapely
from shapely.geometry import Polygon
from shapely.ops import unary_union

from mansion_msgs_py.shapes import CompassSide
from mansion_planner.program.model import Box, Massing, Sketch, Storey

__all__ = ["Envelope", "Frame", "bearing_walls", "envelope_of", "ring_of"]


@dataclass(frozen=True)
class Frame:
    """Mirror in x, mirror in y, then exchange the axes; the result lies at non-negative coordinates.

    Attributes
    ----------
    box : tuple
        Bounds of the building in the massing frame.
    origin : (float, float)
        Where their lower corner goes in plan coordinates.
    """

    box: Box
    mirror_x: bool = False
    mirror_y: bool = False
    swap: bool = False
    origin: tuple[float, float] = (0.0, 0.0)

    def point(self, point: tuple[float, float]) -> tuple[float, float]:
        """Return a point of the massing frame in plan coordinates."""
        x = self.box[2] - point[0] if self.mirror_x else point[0] - self.box[0]
        y = self.box[3] - point[1] if self.mirror_y else point[1] - self.box[1]
        x, y = round(x, 6) + 0.0, round(y, 6) + 0.0
        x, y = (y, x) if self.swap else (x, y)
        return (round(x + self.origin[0], 6), round(y + self.origin[1], 6))

    def area_box(self, box: Box) -> Box:
        """Return a box of the massing frame in plan coordinates."""
        ax, ay = self.point((box[0], box[1]))
        bx, by = self.point((box[2], box[3]))
        return (min(ax, bx), min(ay, by), max(ax, bx), max(ay, by))

    def side(self, side: CompassSide | None) -> CompassSide | None:
        """Return a side of the massing frame in plan coordinates."""
        if side is None:
            return None
        flipped: dict[CompassSide, CompassSide] = {"east": "west", "west": "east", "north": "south", "south": "north"}
        turned: dict[CompassSide, CompassSide] = {"north": "east", "east": "north", "south": "west", "west": "south"}
        across = side in ("east", "west")
        if (self.mirror_x and across) or (self.mirror_y and not across):
            side = flipped[side]
        return turned[side] if self.swap else side


Ring = list[tuple[float, float]]


@dataclass
class Envelope:
    """Outline and courtyards of a storey in plan coordinates."""

    outline: Ring
    holes: list[Ring] = field(default_factory=list)

    @classmethod
    def of(cls, shape: Polygon) -> "Envelope":
        """Return the envelope of a polygon."""
        return cls(ring_of(shape.exterior.coords), [ring_of(hole.coords) for hole in shape.interiors])

    @property
    def area(self) -> float:
        """Area inside the outline without the courtyards, square metres."""
        return float(Polygon(self.outline, self.holes).area)


def ring_of(coordinates: object) -> Ring:
    """Return an open ring of plain floats."""
    points = [(round(float(x), 6) + 0.0, round(float(y), 6) + 0.0) for x, y in coordinates]  # type: ignore[attr-defined]
    return points[:-1] if points[0] == points[-1] else points


def envelope_of(massing: Massing, storey: Storey, frame: Frame) -> Envelope:
    """Return the union of the main bar and the wings of a storey."""
    length = massing.length - storey.setback + storey.extension
    boxes = [(0.0, 0.0, length, massing.depth)]
    for wing in massing.wings:
        if wing.north:
            boxes.append((wing.x0, massing.depth, wing.x1, massing.depth + wing.reach))
        else:
            boxes.append((wing.x0, -wing.reach, wing.x1, 0.0))
    if massing.court:
        low = -massing.wings[0].reach
        boxes.append((massing.far[0], low - massing.court, massing.far[1], low))
    shape = unary_union([shapely.box(*frame.area_box(box)) for box in boxes]).simplify(1e-6)
    shape = shapely.geometry.polygon.orient(shape)
    return Envelope.of(shape)


LEAST_BEARING = 3.0
"""Shortest structural wall, metres."""

Wall = tuple[tuple[float, float], tuple[float, float]]


def bearing_walls(sketches: list[Sketch], frame: Frame) -> list[Wall]:
    """Return the walls along the corridor that stand on every storey, as centre lines in plan coordinates.

    A single storey has none: nothing bears on it.
    """
    if len(sketches) < 2 or not all(sketch.bearing for sketch in sketches):
        return []
    walls: list[Wall] = []
    for y, spans in sorted(sketches[0].bearing.items()):
        for sketch in sketches[1:]:
            spans = _common(spans, sketch.bearing.get(y, []))
        clear = [_clear_of_doors(span, y, sketches) for span in spans]
        walls += [(frame.point((x0, y)), frame.point((x1, y))) for x0, x1 in clear if x1 - x0 >= LEAST_BEARING]
    return walls


_DOOR_PIECE = 1.2
"""Metres of one wall that a door with its frame takes."""


def _clear_of_doors(span: tuple[float, float], y: float, sketches: list[Sketch]) -> tuple[float, float]:
    """Return a stretch without the fronts that its ends cut in two pieces of which neither takes a door."""
    low, high = span
    for x0, x1 in (front for sketch in sketches for front in _door_fronts(sketch, y)):
        if x0 < low < x1 and max(low - x0, x1 - low) < _DOOR_PIECE:
            low = x1
        if x0 < high < x1 and max(high - x0, x1 - high) < _DOOR_PIECE:
            high = x0
    return low, high


def _door_fronts(sketch: Sketch, y: float) -> Iterator[tuple[float, float]]:
    """Yield where the rooms of a sketch lie along a line, each as far as what it is reached from lies along it too."""
    passages = {corridor.id: corridor.boxes[0] for corridor in sketch.corridors if corridor.boxes}
    for placement in sketch.rooms:
        passage = passages.get(placement.parent)
        for x0, y0, x1, y1 in placement.boxes:
            if min(abs(y0 - y), abs(y1 - y)) > 0.01:
                continue
            if passage is not None and min(abs(passage[1] - y), abs(passage[3] - y)) <= 0.01:
                x0, x1 = max(x0, passage[0]), min(x1, passage[2])
            if x1 > x0:
                yield x0, x1


def _common(first: list[tuple[float, float]], second: list[tuple[float, float]]) -> list[tuple[float, float]]:
    both = [(max(a, c), min(b, d)) for a, b in first for c, d in second]
    return sorted((a, b) for a, b in both if b - a > 0.5)

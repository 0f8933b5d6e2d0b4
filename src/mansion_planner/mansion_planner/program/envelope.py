"""Outline of a storey from the massing."""

from dataclasses import dataclass, field

import shapely
from shapely.geometry import Polygon
from shapely.ops import unary_union

from mansion_planner.program.frame import Frame
from mansion_planner.program.model import Massing, Storey

__all__ = ["Envelope", "envelope_of", "ring_of"]

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

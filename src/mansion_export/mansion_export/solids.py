"""Walls cut at their openings and joined at their corners, as intervals and as boxes."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.scene import FloorScene, Wall
from mansion_msgs_py.shapes import Segment

__all__ = ["Box", "Opening", "WallBodies", "box_between", "segment_box", "span"]

FloatArray = npt.NDArray[np.float64]

SEAM = 0.002
"""Metres by which a lengthened wall stays behind the face it meets, so that no two faces coincide."""

NEAR = 0.05


@dataclass(frozen=True, slots=True)
class Opening:
    """A hole in a wall, in metres along its centre line and above the floor."""

    id: str
    low: float
    high: float
    sill: float
    head: float


@dataclass(frozen=True, slots=True)
class Box:
    """A box in plan coordinates: centre, full sizes, and its heading in degrees."""

    center: tuple[float, float, float]
    size: tuple[float, float, float]
    rotation: float = 0.0


def box_between(low: tuple[float, float, float], high: tuple[float, float, float], least: float = 1e-3) -> Box:
    """Return the upright box between two corners, at least `least` thick each way."""
    center = tuple((a + b) / 2 for a, b in zip(low, high))
    size = tuple(max(abs(b - a), least) for a, b in zip(low, high))
    return Box((center[0], center[1], center[2]), (size[0], size[1], size[2]))


def segment_box(segment: Segment, thickness: float, height: float, base: float = 0.0) -> Box:
    """Return the box that stands on a segment, e.g. a door's leaf when it is closed."""
    (ax, ay), (bx, by) = segment
    rotation = float(np.degrees(np.arctan2(by - ay, bx - ax)))
    length = float(np.hypot(bx - ax, by - ay))
    center = ((ax + bx) / 2, (ay + by) / 2, base + height / 2)
    return Box(center, (length, thickness, height), rotation)


def span(wall: Wall, segment: Segment) -> tuple[float, float]:
    """Project a segment on a wall's centre line; metres from the wall's start, ascending."""
    (ax, ay), (bx, by) = wall.segment
    length = float(np.hypot(bx - ax, by - ay)) or 1.0
    ux, uy = (bx - ax) / length, (by - ay) / length
    t = sorted((x - ax) * ux + (y - ay) * uy for x, y in segment)
    return t[0], t[1]


class WallBodies:
    """The bodies of a floor's walls.

    Parameters
    ----------
    scene : FloorScene
    """

    def __init__(self, scene: FloorScene) -> None:
        walls = scene.walls
        starts = np.array([wall.segment[0] for wall in walls], dtype=float).reshape(-1, 2)
        ends = np.array([wall.segment[1] for wall in walls], dtype=float).reshape(-1, 2)
        vectors = ends - starts
        self._lengths = np.maximum(np.hypot(vectors[:, 0], vectors[:, 1]), 1e-9)
        self._units = vectors / self._lengths[:, None]
        self._starts, self._ends = starts, ends
        self._half = np.array([wall.thickness / 2 for wall in walls])
        self._beyond_ends = self._extensions()
        self._index = {wall.id: i for i, wall in enumerate(walls)}
        self._openings: dict[str, list[Opening]] = {wall.id: [] for wall in walls}
        by_id = {wall.id: wall for wall in walls}
        for door in scene.doors:
            wall = by_id.get(door.wall)
            if wall is not None:
                low, high = span(wall, door.segment)
                head = min(door.height, wall.height)
                self._openings[wall.id].append(Opening(door.id, low, high, 0.0, head))
        for window in scene.windows:
            wall = by_id.get(window.wall)
            if wall is not None:
                low, high = span(wall, window.segment)
                head = min(window.sill + window.height, wall.height)
                self._openings[wall.id].append(Opening(window.id, low, high, window.sill, head))
        for found in self._openings.values():
            found.sort(key=lambda opening: opening.low)

    def openings(self, wall: Wall) -> list[Opening]:
        """Return the doors and windows of a wall from its start to its end."""
        return self._openings[wall.id]

    def stretch(self, wall: Wall) -> tuple[float, float]:
        """Return from where to where a wall goes along its centre line, lengthened to close corners."""
        i = self._index[wall.id]
        before, after = self._beyond_ends[i].tolist()
        return -before, float(self._lengths[i]) + after

    def pieces(self, wall: Wall) -> list[tuple[float, float]]:
        """Return the full-height parts of a wall between its openings, lengthened to close corners."""
        reached, end = self.stretch(wall)
        pieces = []
        for opening in self._openings[wall.id]:
            if opening.low > reached + 1e-6:
                pieces.append((reached, opening.low))
            reached = max(reached, opening.high)
        if end > reached + 1e-6:
            pieces.append((reached, end))
        return pieces

    def boxes(self, wall: Wall) -> list[Box]:
        """Return a wall as boxes between, below and above its openings; local x runs along the wall."""
        parts = [(low, high, 0.0, wall.height) for low, high in self.pieces(wall)]
        for opening in self._openings[wall.id]:
            if opening.sill > 0.0:
                parts.append((opening.low, opening.high, 0.0, opening.sill))
            if opening.head < wall.height - 1e-6:
                parts.append((opening.low, opening.high, opening.head, wall.height))
        i = self._index[wall.id]
        (ax, ay), (ux, uy) = self._starts[i].tolist(), self._units[i].tolist()
        rotation = float(np.degrees(np.arctan2(uy, ux)))
        boxes = []
        for low, high, bottom, top in parts:
            middle = (low + high) / 2
            center = (ax + ux * middle, ay + uy * middle, (bottom + top) / 2)
            boxes.append(Box(center, (high - low, wall.thickness, top - bottom), rotation))
        return boxes

    def _extensions(self) -> FloatArray:
        """How far walls go on beyond start and end, (n, 2): to the far face at a corner, to the middle at a T."""
        count = len(self._half)
        found = np.zeros((count, 2))
        if not count:
            return found
        cross = np.outer(self._units[:, 0], self._units[:, 1])
        cross -= np.outer(self._units[:, 1], self._units[:, 0])
        parallel = np.abs(cross) < 0.05
        reach = np.add.outer(self._half, self._half) + NEAR
        for side, (points, sign) in enumerate(((self._starts, -1.0), (self._ends, 1.0))):
            to_start = self._starts[None] - points[:, None]
            to_end = self._ends[None] - points[:, None]
            along = np.clip(-np.einsum("ijk,jk->ij", to_start, self._units), 0.0, self._lengths[None])
            nearest = to_start + along[..., None] * self._units[None]
            gap = np.minimum(np.hypot(*np.moveaxis(to_start, 2, 0)), np.hypot(*np.moveaxis(to_end, 2, 0)))
            goes_on = parallel & (gap < NEAR)
            np.fill_diagonal(goes_on, False)
            close = ~parallel & (np.hypot(nearest[..., 0], nearest[..., 1]) < reach)
            for i in np.flatnonzero(close.any(1) & ~goes_on.any(1)):
                others = np.flatnonzero(close[i])
                found[i, side] = self._beyond(
                    int(i), others, sign * cross[i, others], to_start[i, others], to_end[i, others], sign
                )
        return found

    def _beyond(
        self,
        i: int,
        others: npt.NDArray[np.int64],
        cross: FloatArray,
        to_start: FloatArray,
        to_end: FloatArray,
        sign: float,
    ) -> float:
        """How far wall `i` goes on among the walls that its end meets."""
        ahead = sign * self._units[i]
        # Where this wall's line meets the other's, counted from the end.
        meets = (to_start[:, 0] * self._units[others, 1] - to_start[:, 1] * self._units[others, 0]) / cross
        sides = np.stack([ahead[0] * to[:, 1] - ahead[1] * to[:, 0] for to in (to_start, to_end)])
        wide = float(self._half[i]) + NEAR
        if (sides.max(0) > wide).any() and (sides.min(0) < -wide).any():
            return max(float(meets.max()), 0.0)
        corner = meets + self._half[others] / np.abs(cross) - SEAM
        return max(float(corner.max()), 0.0)

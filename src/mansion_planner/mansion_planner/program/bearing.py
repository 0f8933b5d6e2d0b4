"""Structural walls: what the sketches of all storeys have in common along the main corridor (section A.3)."""

from mansion_planner.program.frame import Frame
from mansion_planner.program.placement import Sketch

__all__ = ["bearing_walls"]

LEAST = 3.0
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
        walls += [(frame.point((x0, y)), frame.point((x1, y))) for x0, x1 in spans if x1 - x0 >= LEAST]
    return walls


def _common(first: list[tuple[float, float]], second: list[tuple[float, float]]) -> list[tuple[float, float]]:
    both = [(max(a, c), min(b, d)) for a, b in first for c, d in second]
    return sorted((a, b) for a, b in both if b - a > 0.5)

"""An engine without dynamics: the object comes down straight on what lies below it, or topples."""

import math

from shapely import Polygon

from mansion_editing.physics.problem import PosedBox, SettleProblem, SettleResult
from mansion_scene.decor.frames import footprint

__all__ = ["StaticEngine"]

TOUCH = 1e-4


class StaticEngine:
    """Rests an object on the highest support under it; it topples where its centre is not over one.

    It needs no simulator and sees no friction and no bumps: for machines without MuJoCo, and for comparison.
    """

    name = "static"

    def settle(self, problem: SettleProblem) -> SettleResult:
        """See `PhysicsEngine.settle`."""
        body = problem.body
        area = _area(body)
        foot = body.center[2] - body.size[2] / 2
        below = [
            box
            for box in problem.support
            if box.center[2] + box.size[2] / 2 <= foot + 0.02 and _area(box).intersects(area)
        ]
        top = max((box.center[2] + box.size[2] / 2 for box in below), default=-math.inf)
        carriers = [box for box in below if box.center[2] + box.size[2] / 2 > top - 1e-3]
        held = any(_area(box).covers(area.centroid) for box in carriers)
        drop = 0.0 if top == -math.inf else foot - top
        x, y, z = body.center
        rested = PosedBox((x, y, z - drop), body.size, body.rotation)
        others = [*problem.shell, *problem.neighbours.values()]
        depth = max((_depth(rested, other) for other in others), default=0.0)
        return SettleResult(
            position=rested.center,
            rotation=body.rotation,
            tilt=0.0 if held else 90.0,
            at_rest=top > -math.inf,
            penetration=depth,
            pushed=dict.fromkeys(problem.neighbours, 0.0),
        )


def _area(box: PosedBox) -> Polygon:
    return footprint(box.center, box.size, box.rotation)


def _depth(one: PosedBox, other: PosedBox) -> float:
    height = (one.size[2] + other.size[2]) / 2 - abs(one.center[2] - other.center[2])
    if height <= TOUCH:
        return 0.0
    shared = _area(one).intersection(_area(other))
    if shared.is_empty or shared.area < TOUCH * TOUCH:
        return 0.0
    x0, y0, x1, y1 = shared.minimum_rotated_rectangle.bounds
    return float(min(height, x1 - x0, y1 - y0))

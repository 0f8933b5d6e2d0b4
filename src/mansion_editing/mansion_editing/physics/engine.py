"""Physics engines by name: the problem that each is given, the result that it returns, and the static engine."""

import math
from dataclasses import dataclass, field
from typing import Final, NamedTuple, Protocol

from shapely import Polygon

from mansion_geometry.object_footprints import footprint_at
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.shapes import Point3

__all__ = [
    "ENGINES",
    "PhysicsEngine",
    "PosedBox",
    "SLOW",
    "SLOW_TURN",
    "SettleProblem",
    "SettleResult",
    "StaticEngine",
    "engine_named",
]

SLOW: Final = 0.01
SLOW_TURN: Final = 0.1
"""Speed limits of rest, m/s and rad/s."""


class PosedBox(NamedTuple):
    """A box: centre, full extent, degrees counter-clockwise about z."""

    center: Point3
    size: Point3
    rotation: float = 0.0


@dataclass(frozen=True)
class SettleProblem:
    """One object let go above its place.

    Attributes
    ----------
    body : PosedBox
        The object at its start.
    shell : list of PosedBox
        What of the receptacle the object can touch beside what carries it.
    support : list of PosedBox
        What carries the object and its neighbours.
    neighbours : dict of str to PosedBox
        What stands near and could be pushed; free to move.
    """

    body: PosedBox
    support: list[PosedBox]
    shell: list[PosedBox] = field(default_factory=list)
    neighbours: dict[str, PosedBox] = field(default_factory=dict)


@dataclass(frozen=True)
class SettleResult:
    """Where the object came to lie.

    Attributes
    ----------
    tilt : float
        Between its vertical axis and the world's, degrees.
    at_rest : bool
        Slower than 1 cm/s and 0.1 rad/s at the end.
    penetration : float
        Greatest depth of a contact of the object at the end, metres.
    pushed : dict of str to float
        How far each neighbour moved, metres.
    """

    position: Point3
    rotation: float
    tilt: float
    at_rest: bool
    penetration: float
    pushed: dict[str, float] = field(default_factory=dict)


class PhysicsEngine(Protocol):
    """Settles one object; nothing of the engine outlives the call."""

    name: str

    def settle(self, problem: SettleProblem) -> SettleResult:
        """Let the object go and say where it came to rest.

        Raises
        ------
        MansionError
            ``UNAVAILABLE`` when the engine is not installed.
        """


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
    return footprint_at(box.center, box.size, box.rotation)


def _depth(one: PosedBox, other: PosedBox) -> float:
    height = (one.size[2] + other.size[2]) / 2 - abs(one.center[2] - other.center[2])
    if height <= TOUCH:
        return 0.0
    shared = _area(one).intersection(_area(other))
    if shared.is_empty or shared.area < TOUCH * TOUCH:
        return 0.0
    x0, y0, x1, y1 = shared.minimum_rotated_rectangle.bounds
    return float(min(height, x1 - x0, y1 - y0))


ENGINES: Final = ("mujoco", "static", "thor")


def engine_named(name: str) -> PhysicsEngine:
    """Return an engine.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an unknown name.
    """
    if name == "mujoco":
        with importing:
            from mansion_editing.physics.mujoco_engine import MujocoEngine

        return MujocoEngine()
    if name == "static":
        with importing:
            from mansion_editing.physics.engine import StaticEngine

        return StaticEngine()
    if name == "thor":
        with importing:
            from mansion_editing.physics.thor_engine import ThorEngine

        return ThorEngine()
    raise MansionError(ErrorCode.NOT_FOUND, f"no physics engine {name!r}; engines are {', '.join(ENGINES)}")

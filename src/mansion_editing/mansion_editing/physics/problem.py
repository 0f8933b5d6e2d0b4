"""What a physics engine is asked and what it answers; engines differ behind `PhysicsEngine`."""

from dataclasses import dataclass, field
from math import prod
from typing import Final, NamedTuple, Protocol

from mansion_msgs_py.shapes import Point3

__all__ = ["SLOW", "SLOW_TURN", "PhysicsEngine", "PosedBox", "SettleProblem", "SettleResult", "mass"]

SLOW: Final = 0.01
SLOW_TURN: Final = 0.1
"""Speed limits of rest, m/s and rad/s."""

DENSITY: Final = 300.0
LEAST_MASS: Final = 0.02


class PosedBox(NamedTuple):
    """A box: centre, full extent, degrees counter-clockwise about z."""

    center: Point3
    size: Point3
    rotation: float = 0.0


def mass(box: PosedBox) -> float:
    """Return what a box weighs that stands for a thing, kilograms."""
    return max(LEAST_MASS, DENSITY * prod(box.size))


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

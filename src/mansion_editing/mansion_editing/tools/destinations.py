"""Where an object is to go: into a room, or onto or into a receptacle, with the wish for its place there."""

from collections.abc import Callable, Collection
from dataclasses import dataclass
from typing import TypeAlias

from mansion_editing.tools.relations import NO_WISH, PlacingWish
from mansion_msgs_py.scene import SceneObject, SceneRoom

__all__ = ["Accept", "AtReceptacle", "InRoom"]

Accept: TypeAlias = Callable[[int, SceneObject], bool]
"""Whether the building stays free of new faults with an object on a floor."""


@dataclass(frozen=True)
class InRoom:
    """On a wall, the ceiling or the floor of a room, as the object is made for.

    Attributes
    ----------
    wish : PlacingWish
        What it is to be beside, below, turned to, ...
    accept : callable, optional
        Judges a place before it is taken; others are tried while it refuses.
    companions : collection of str
        Ids of the objects that go with it, which are not in its way.
    """

    floor: int
    room: SceneRoom
    wish: PlacingWish = NO_WISH
    accept: Accept | None = None
    companions: Collection[str] = ()


@dataclass(frozen=True)
class AtReceptacle:
    """On a receptacle, or inside it.

    Attributes
    ----------
    wish : PlacingWish
        What it is to lie beside, left of, between, ... on the same surface.
    companions : collection of str
        Ids of the objects that go with it, which are not in its way.
    """

    floor: int
    receptacle: SceneObject
    inside: bool
    wish: PlacingWish = NO_WISH
    companions: Collection[str] = ()

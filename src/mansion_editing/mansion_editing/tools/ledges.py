"""Ledges, the flat places on and in a receptacle, and the free places on them."""

import math
from collections.abc import Callable, Iterable, Sequence
from itertools import islice
from typing import NamedTuple, TypeAlias

import numpy as np
import numpy.typing as npt

from mansion_assets.catalogue import Asset
from mansion_editing.state import FloorIndex
from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.shapes import Point, Point3
from mansion_scene.decor.frames import to_local

__all__ = ["GAP", "Admit", "Ledge", "Place", "free_places", "ledges_of", "obstacles", "places_on_ledge"]


class Ledge(NamedTuple):
    """A flat place of a receptacle, in its frame: a surface, or the floor of an inner box.

    Attributes
    ----------
    z : float
        Height of the flat place above the centre of the receptacle's box.
    clearance : float
        Free height above it.
    vessel : bool
        Whether it is open at the top (a bowl), so that an object may stick out by less than half of its height.
    """

    kind: str
    inside: bool
    x: float
    y: float
    z: float
    w: float
    d: float
    clearance: float
    round: bool = False
    vessel: bool = False

    @property
    def headroom(self) -> float:
        """Greatest height of what lies there, metres."""
        return self.clearance * (2.0 if self.vessel else 1.0)


class Place(NamedTuple):
    """A free place: centre in the receptacle's frame, degrees of turn, and its cost (less is better)."""

    ledge: Ledge
    x: float
    y: float
    turn: float
    cost: float


Admit: TypeAlias = Callable[["Place"], bool]
"""Whether a place on a ledge is one that a wish allows."""

GAP = 0.008
"""Least distance between neighbours, metres."""

HAND = 0.05
"""Distance to neighbours that leaves room for a hand, metres."""

HEADROOM = 0.01
STEP = 0.02
"""Least distance between places that are tried, metres."""

EDGE = 0.01
BESIDE = 20.0
"""Cost of a metre from what an object is to lie beside."""

MOST_ROWS = 80
MOST_ON_LEDGE = 40


def ledges_of(asset: Asset, *, inside: bool) -> list[Ledge]:
    """Return the ledges on, or in, a receptacle; those at a good height for a hand first.

    Shelves count as both.
    """
    out = [
        Ledge(s.kind, False, s.x, s.y, s.z, s.w, s.d, s.clearance, s.round)
        for s in asset.surfaces
        if not inside or s.kind == "shelf"
    ]
    if inside:
        bare = asset.pickupable and not asset.openable
        out = [Ledge(v.kind, True, v.x, v.y, v.z - v.h / 2, v.w, v.d, v.h, vessel=bare) for v in asset.volumes] + out
    return out


def free_places(
    index: FloorIndex,
    receptacle: SceneObject,
    ledges: Sequence[Ledge],
    size: Point3,
    skip: Iterable[str] = (),
    most: int = 6,
    near: Sequence[float] | None = None,
    admit: Admit | None = None,
) -> list[Place]:
    """Return free places for an object, the best first.

    Parameters
    ----------
    size : (w, d, h)
        Size of the object.
    skip : iterable of str
        Objects that are not obstacles, because they are being moved.
    most : int
        Greatest number of places, spread over ledges and over each ledge.
    near : (x, y), optional
        Point of the floor that the object is to lie close to.
    admit : callable, optional
        Whether a place may be taken; with it, places turned by all quarters are looked at.
    """
    landmark = None if near is None else to_local(receptacle, near)
    boxes = obstacles(index, receptacle, {receptacle.id, *skip})
    found: list[Place] = []
    for order, ledge in enumerate(_by_height(ledges, receptacle)):
        if size[2] > ledge.headroom - HEADROOM:
            continue
        places = [
            place
            for turn in ((0.0, 90.0) if admit is None else (0.0, 90.0, 180.0, 270.0))
            for place in places_on_ledge(ledge, boxes, size, turn, 0.4 * order + turn / 450.0, landmark, admit)
        ]
        places.sort(key=lambda p: p.cost)
        found += _apart(places, 3)
    found.sort(key=lambda p: p.cost)
    return found[:most]


def _by_height(ledges: Sequence[Ledge], receptacle: SceneObject) -> list[Ledge]:
    return sorted(ledges, key=lambda ledge: abs(receptacle.position[2] + ledge.z - 1.0))


def obstacles(index: FloorIndex, receptacle: SceneObject, skip: set[str]) -> npt.NDArray[np.float64]:
    """Return objects near a receptacle in its frame: x, y, half extents along its axes, lower and upper end."""
    ancestors = set(skip)
    above = receptacle.parent
    while above is not None and above not in ancestors and above in index.at:
        ancestors.add(above)
        above = index.objects[index.at[above]].parent
    boxes = index.boxes
    reach = math.hypot(receptacle.size[0], receptacle.size[1]) / 2 + 0.5
    spread = np.hypot(boxes[:, 3], boxes[:, 4]) / 2
    distance = np.hypot(boxes[:, 0] - receptacle.position[0], boxes[:, 1] - receptacle.position[1])
    rows = []
    for number in np.flatnonzero(distance < reach + spread):
        item = index.objects[int(number)]
        if item.id in ancestors:
            continue
        x, y = to_local(receptacle, item.position)
        turn = math.radians(item.rotation - receptacle.rotation)
        c, s = abs(math.cos(turn)), abs(math.sin(turn))
        z = item.position[2] - receptacle.position[2]
        rows.append(
            (
                x,
                y,
                (c * item.size[0] + s * item.size[1]) / 2,
                (s * item.size[0] + c * item.size[1]) / 2,
                z - item.size[2] / 2,
                z + item.size[2] / 2,
            )
        )
    return np.array(rows, dtype=float).reshape(-1, 6)


def places_on_ledge(
    ledge: Ledge,
    boxes: npt.NDArray[np.float64],
    size: Point3,
    turn: float,
    handicap: float,
    landmark: Point | None = None,
    admit: Admit | None = None,
) -> list[Place]:
    """Return the free places on one ledge for an object turned so, the best first; `handicap` adds to their cost."""
    hw, hd = (size[0] / 2, size[1] / 2) if turn % 180.0 == 0.0 else (size[1] / 2, size[0] / 2)
    rx, ry = ledge.w / 2 - hw - 0.002, ledge.d / 2 - hd - 0.002
    if rx < 0 or ry < 0:
        return []
    xs, ys = ledge.x + _steps(rx), ledge.y + _steps(ry)
    gx, gy = (grid.ravel() for grid in np.meshgrid(xs, ys))
    if ledge.round:
        ratio = np.hypot((np.abs(gx - ledge.x) + hw) / (ledge.w / 2), (np.abs(gy - ledge.y) + hd) / (ledge.d / 2))
        gx, gy = gx[ratio <= 1.0], gy[ratio <= 1.0]
    near = boxes[(boxes[:, 4] < ledge.z + size[2] + 0.002) & (boxes[:, 5] > ledge.z + 0.002)]
    gap = np.full(len(gx), 1.0)
    for x, y, half_w, half_d, _, _ in near:
        apart = np.maximum(np.abs(gx - x) - hw - half_w, np.abs(gy - y) - hd - half_d)
        gap = np.minimum(gap, apart)
    edge = np.minimum(ledge.w / 2 - np.abs(gx - ledge.x) - hw, ledge.d / 2 - np.abs(gy - ledge.y) - hd)
    front = ledge.y + ledge.d / 2 - hd - gy
    cost = (
        handicap
        + 2.0 * np.maximum(0.0, HAND - gap) / HAND
        + np.maximum(0.0, EDGE - edge) / EDGE * 0.5
        + np.abs(front - min(0.08, ry)) * 1.5
        + 0.3 * np.abs(gx - ledge.x)
    )
    if landmark is not None:
        cost += BESIDE * np.hypot(gx - landmark[0], gy - landmark[1])
    free = np.flatnonzero(gap >= GAP)
    order = free[np.argsort(cost[free], kind="stable")]
    places = (Place(ledge, float(gx[k]), float(gy[k]), turn, round(float(cost[k]), 6)) for k in order)
    return list(islice(places if admit is None else filter(admit, places), MOST_ON_LEDGE))


def _steps(reach: float) -> npt.NDArray[np.float64]:
    count = min(MOST_ROWS, int(2 * reach / STEP))
    return np.linspace(-reach, reach, count + 1) if count else np.zeros(1)


def _apart(places: Sequence[Place], most: int) -> list[Place]:
    """Keep the best places that are not all beside each other."""
    kept: list[Place] = []
    for place in places:
        if all(math.dist((place.x, place.y), (p.x, p.y)) > 0.1 for p in kept):
            kept.append(place)
        if len(kept) == most:
            break
    return kept

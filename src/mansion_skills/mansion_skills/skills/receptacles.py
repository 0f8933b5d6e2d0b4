"""Free places on, in or in front of a receptacle for what the hand holds."""

from dataclasses import dataclass
from math import cos, dist, hypot, radians, sin

import numpy as np
import numpy.typing as npt

from mansion_geometry.floor_grid import RESOLUTION
from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.shapes import Point, Point3
from mansion_msgs_py.world import ObjectState
from mansion_skills.skills.visibility import REACH
from mansion_skills.world.objects import ObjectTable, corners
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["Spot", "can_contain", "floor_spot", "support_heights", "surface_spot"]

STEP = 0.05
"""Spacing of the places that are tried, metres."""

EDGE = 0.01
"""Clearance to the edge of a surface and between objects, metres."""

CONTAINERS = (
    "waste_bin",
    "bin",
    "bucket",
    "basket",
    "box",
    "crate",
    "bathtub",
    "sink",
    "washbasin",
    "bowl",
    "pot",
    "cart",
    "safe",
    "shopping_cart",
    "recycling_station",
)
"""Categories, or their last words, of open containers."""

SEATS = {"bed": 0.55, "sofa": 0.45, "chair": 0.45, "armchair": 0.45, "stool": 0.75, "bench": 0.45}
"""Heights at which objects rest on furniture with a back or a headboard, metres."""


@dataclass(frozen=True)
class Spot:
    """Where a box can rest: its centre, and its rotation in degrees."""

    position: Point3
    rotation: float


def can_contain(world: World, kind: SceneObject) -> bool:
    """Whether an object can contain others."""
    if not kind.receptacle:
        return False
    if kind.openable or kind.category in CONTAINERS:
        return True
    last = kind.category.rsplit("_", 1)[-1]
    inside = any(entry.parent == kind.id and entry.mount == "inside" for entry in world.objects.kinds.values())
    return last in CONTAINERS or inside


def support_heights(objects: ObjectTable, kind: SceneObject, mount: str) -> list[float]:
    """Return the heights above an object's lower side at which others rest on or in it, lowest first.

    They are read from what the scene has put there; else a session, the top, or the bottom of a container.
    """
    low = kind.bottom
    found = {
        round(entry.bottom - low, 2)
        for entry in (objects.kinds[name] for name in objects.children(kind.id))
        if entry.mount == mount and entry.parent == kind.id
    }
    if found:
        return sorted(found)
    if mount == "inside":
        return [min(0.02, kind.size[2] / 4)]
    height = kind.size[2]
    seat = SEATS.get(kind.category.rsplit("_", 1)[-1])
    return [height if seat is None else min(seat, height)]


def surface_spot(world: World, robot: RobotBody, target: ObjectState, item: SceneObject, mount: str) -> Spot | None:
    """Return the free place on or in `target` that is nearest to the robot and within its reach, or ``None``."""
    kind = world.objects.kinds[target.id]
    assert target.position is not None
    bottom = target.position[2] - kind.size[2] / 2
    for height in support_heights(world.objects, kind, mount):
        room = kind.size[2] - height
        if mount == "inside" and kind.openable and item.size[2] > room:
            continue
        for turn in (0.0, 90.0):
            w, d = (item.size[0], item.size[1]) if turn == 0.0 else (item.size[1], item.size[0])
            place = _packed(world, robot, target, (w, d), bottom + height, item)
            if place is not None:
                z = round(bottom + height + item.size[2] / 2, 6)
                rotation = round((target.rotation + turn) % 360.0, 6)
                return Spot((round(place[0], 6), round(place[1], 6), z), rotation)
    return None


def _packed(
    world: World, robot: RobotBody, target: ObjectState, size: tuple[float, float], z: float, item: SceneObject
) -> Point | None:
    kind = world.objects.kinds[target.id]
    assert target.position is not None
    free = [(kind.size[i] - size[i]) / 2 - EDGE for i in (0, 1)]
    if min(free) < -EDGE:
        return None
    us, vs = (np.arange(-max(f, 0.0), max(f, 0.0) + 1e-9, STEP) for f in free)
    grid = np.array(np.meshgrid(us, vs)).reshape(2, -1).T
    c, s = cos(radians(target.rotation)), sin(radians(target.rotation))
    x = target.position[0] + c * grid[:, 0] - s * grid[:, 1]
    y = target.position[1] + s * grid[:, 0] + c * grid[:, 1]
    away = np.hypot(x - robot.pose.x, y - robot.pose.y)
    allowed = away <= REACH
    for name in world.objects.children(target.id):
        allowed &= ~_overlaps(world, target, name, grid, size, (z, z + item.size[2]))
    if not allowed.any():
        return None
    best = int(np.argmin(np.where(allowed, np.round(away, 6), np.inf)))
    return float(x[best]), float(y[best])


def _overlaps(
    world: World,
    target: ObjectState,
    name: str,
    grid: npt.NDArray[np.float64],
    size: tuple[float, float],
    heights: tuple[float, float],
) -> npt.NDArray[np.bool_]:
    """Whether a box of `size` at each place of the target's frame would overlap another object there."""
    state, kind = world.objects.state(name), world.objects.kinds[name]
    assert state.position is not None and target.position is not None
    low, high = state.position[2] - kind.size[2] / 2, state.position[2] + kind.size[2] / 2
    if high <= heights[0] + 1e-3 or low >= heights[1] - 1e-3:
        return np.zeros(len(grid), dtype=bool)
    c, s = cos(radians(-target.rotation)), sin(radians(-target.rotation))
    local = [
        (
            c * (x - target.position[0]) - s * (y - target.position[1]),
            s * (x - target.position[0]) + c * (y - target.position[1]),
        )
        for x, y in corners(state, kind)
    ]
    box = np.array(local)
    (u0, v0), (u1, v1) = box.min(0) - EDGE, box.max(0) + EDGE
    inside: npt.NDArray[np.bool_] = (
        (grid[:, 0] + size[0] / 2 > u0)
        & (grid[:, 0] - size[0] / 2 < u1)
        & (grid[:, 1] + size[1] / 2 > v0)
        & (grid[:, 1] - size[1] / 2 < v1)
    )
    return inside


def floor_spot(
    world: World, robot: RobotBody, origin: Point, facing: float, start: float, item: SceneObject
) -> Spot | None:
    """Return a free place on the floor in front of something, or ``None``.

    Parameters
    ----------
    origin : Point
        Centre of what to stand in front of, metres.
    facing : float
        Direction of its front, degrees from +x.
    start : float
        Distance from its centre to its front, metres.
    """
    c, s = cos(radians(facing)), sin(radians(facing))
    half = item.size[1] / 2
    found: list[tuple[float, float, float]] = []
    for ahead in np.arange(start + half + 0.05, start + half + 0.8, STEP):
        for aside in (0.0, 0.15, -0.15, 0.3, -0.3, 0.45, -0.45):
            x, y = origin[0] + c * ahead - s * aside, origin[1] + s * ahead + c * aside
            found.append((round(hypot(ahead - start, aside), 6), float(x), float(y)))
    turn = round((facing - 90.0) % 360.0, 6)
    for _, x, y in sorted(found):
        spot = Spot((round(x, 6), round(y, 6), round(item.size[2] / 2, 6)), turn)
        if dist(robot.place, (x, y)) <= REACH and _stands_free(world, robot, spot, item):
            return spot
    return None


def _stands_free(world: World, robot: RobotBody, spot: Spot, item: SceneObject) -> bool:
    grid = world.view(robot.floor).map
    w, d, _ = item.size
    c, s = cos(radians(spot.rotation)), sin(radians(spot.rotation))
    across = np.linspace(-w / 2, w / 2, max(2, int(w / RESOLUTION) + 2))
    along = np.linspace(-d / 2, d / 2, max(2, int(d / RESOLUTION) + 2))
    places = [(spot.position[0] + c * u - s * v, spot.position[1] + s * u + c * v) for u in across for v in along]
    bodies = [robot.place, *world.others(robot.session, robot.floor)]
    for x, y in places:
        row, column = grid.frame.cell(x, y)
        if not grid.frame.holds(row, column) or grid.occupied[row, column]:
            return False
        if any(dist((x, y), body) < world.radius + 2 * RESOLUTION for body in bodies):
            return False
    return True

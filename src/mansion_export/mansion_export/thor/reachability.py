"""Where AI2-THOR's agent can stand: ``GetReachablePositions`` from the house JSON alone."""

from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

from mansion_geometry.boxes import TOUCH, unit_vector
from mansion_geometry.disc_cells import near_boxes, segment_boxes
from mansion_geometry.floor_grid import GridFrame, fill_rings
from mansion_geometry.free_cells import connected_components
from mansion_geometry.thor.house_format import object_nodes
from mansion_msgs_py.shapes import Point, Segment

__all__ = ["ENOUGH_POSITIONS", "GRID", "connected_positions", "reachable_positions"]

Json: TypeAlias = dict[str, Any]
Bools: TypeAlias = npt.NDArray[np.bool_]
Labels: TypeAlias = npt.NDArray[np.int32]

GRID = 0.25
"""AI2-THOR's default ``gridSize``, metres."""

RADIUS = 0.2
"""Radius of the agent's capsule, metres."""

AGENT_TOP = 1.8
"""Height of the capsule; what hangs higher is not an obstacle."""

STEP_OVER = 0.05
"""Height that the agent steps over, metres."""

QUARTERS = 4
"""Parts of a step at whose ends the agent must not touch a wall."""

ENOUGH_POSITIONS = 5
"""Reachable grid points that ``House.validate`` of ProcTHOR asks of each room."""


def connected_positions(house: Json, start: Point) -> list[list[Point]]:
    """Return the grid points (x, z) where the agent fits, in sets that steps of `GRID` in four directions connect.

    Parameters
    ----------
    house : dict
        House JSON; objects need ``size``.
    start : (x, z)
        A point of the grid, metres.
    """
    frame, labels = _labelled_grid(house, start)
    return [_points(frame, labels == label) for label in range(1, int(labels.max()) + 1)]


def reachable_positions(house: Json, start: Point) -> list[Point]:
    """Return the grid points (x, z) that the agent reaches from `start`, as ``GetReachablePositions`` does.

    Parameters
    ----------
    house : dict
        House JSON; objects need ``size``.
    start : (x, z)
        A point of the grid, metres.

    Returns
    -------
    list of (x, z)
        Empty where the agent does not fit at `start`.
    """
    frame, labels = _labelled_grid(house, start)
    label = labels[frame.cell(*start)] if frame.holds(*frame.cell(*start)) else 0
    return _points(frame, labels == label) if label else []


def _points(frame: GridFrame, chosen: Bools) -> list[Point]:
    xs, zs = frame.centers()
    return [(round(float(xs[j]), 4), round(float(zs[i]), 4)) for i, j in np.argwhere(chosen)]


def _labelled_grid(house: Json, start: Point) -> tuple[GridFrame, Labels]:
    """Return a grid with its centres a step of `GRID` apart, one at `start`, and each cell's connected set, 0: none."""
    frame = GridFrame.through(start, [point for ring in _rings(house) for point in ring], GRID)
    rooms = np.zeros(frame.shape, dtype=np.int16)
    for ring in _rings(house):
        fill_rings(rooms, frame, [ring], 1)
    finer = frame.refined(QUARTERS)
    walls = near_boxes(finer, segment_boxes(_solid_parts(house)), RADIUS - TOUCH)
    fits = (rooms > 0) & ~walls[::QUARTERS, ::QUARTERS] & ~near_boxes(frame, _obstacles(house), RADIUS - TOUCH)
    labels, _ = connected_components((~_ways(fits, walls)).astype(np.int16))
    return frame, labels[::QUARTERS, ::QUARTERS]


def _rings(house: Json) -> list[list[Point]]:
    return [[(p["x"], p["z"]) for p in room["floorPolygon"]] for room in house["rooms"]]


def _ways(fits: Bools, walls: Bools) -> Bools:
    """Return the places where the agent fits, and the steps between two of them that no wall hinders, on a finer grid.

    Parameters
    ----------
    fits : (rows, columns) array
    walls : array of the finer grid
        Where the agent would touch a wall. Furniture counts at the ends of a step only, as in AI2-THOR.
    """
    ways = np.zeros_like(walls)
    ways[::QUARTERS, ::QUARTERS] = fits
    for here, there, towards in ((fits, ways, walls), (fits.T, ways.T, walls.T)):
        inner = [slice(part, None, QUARTERS) for part in range(1, QUARTERS)]
        hindered = np.logical_or.reduce([towards[::QUARTERS, part] for part in inner])
        for part in inner:
            there[::QUARTERS, part] = here[:, :-1] & here[:, 1:] & ~hindered
    return ways


def _obstacles(house: Json) -> npt.NDArray[np.float64]:
    """Return the objects that the agent neither steps over nor walks under, as boxes (see `mansion_geometry.boxes`)."""
    rows = []
    for item in object_nodes(house["objects"]):
        place, size = item["position"], item["size"]
        bottom = place["y"] - size["y"] / 2
        if bottom < AGENT_TOP and bottom + size["y"] > STEP_OVER:
            # AI2-THOR turns clockwise.
            ux, uz = unit_vector(-item["rotation"]["y"])
            rows.append((place["x"], place["z"], ux, uz, size["x"] / 2, size["z"] / 2))
    return np.array(rows, dtype=np.float64).reshape(-1, 6)


def _solid_parts(house: Json) -> list[Segment]:
    """Return walls between their passable doors, one face of each twin."""
    gaps: dict[str, tuple[float, float]] = {}
    for door in house["doors"]:
        if not door["openable"] or door["openness"] > 0.5:
            low, high = (point["x"] for point in door["holePolygon"])
            gaps[door["wall0"]] = (low, high)
    parts: list[Segment] = []
    twins = {door["wall1"]: door["wall0"] for door in house["doors"]}
    for wall in house["walls"]:
        if wall.get("empty") or wall["id"] in twins:
            continue
        (a, b) = wall["polygon"][0], wall["polygon"][1]
        ax, az, bx, bz = a["x"], a["z"], b["x"], b["z"]
        length = float(np.hypot(bx - ax, bz - az))
        low, high = gaps.get(wall["id"], (length, length))
        for s, t in ((0.0, low), (high, length)):
            if t - s > 1e-6:
                u, v = s / length, t / length
                parts.append(((ax + (bx - ax) * u, az + (bz - az) * u), (ax + (bx - ax) * v, az + (bz - az) * v)))
    return parts

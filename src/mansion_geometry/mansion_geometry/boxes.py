"""Oriented rectangles ("boxes") in the plane: corners, containment, overlap and gap.

A box is a row ``(x, y, ux, uy, hw, hd)``: centre, unit vector along its width, half width and half depth, in metres.
Its front looks along ``v = (-uy, ux)``. A pose is a row ``(x, y, ux, uy)``. A room's boundary is an array of edges
``(ax, ay, bx, by)`` with the interior on the left (exterior ring counter-clockwise, holes clockwise). Touching is not
overlapping: every test is slack by `TOUCH`.
"""

import math

import numpy as np

from mansion_geometry.compiled import Floats, kernel
from mansion_geometry.plane import crosses

__all__ = [
    "TOUCH",
    "box_corners",
    "box_inside",
    "boxes_overlap",
    "compose",
    "gap_matrix",
    "point_inside",
    "rotation_of",
    "unit_vector",
]


TOUCH = 1e-6
"""Depth to which boxes may overlap, metres."""


def unit_vector(degrees: float) -> tuple[float, float]:
    """Return (cos, sin) of an angle, exact for quarter turns."""
    quarter, rest = divmod(degrees, 90.0)
    if rest == 0.0:
        return ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[int(quarter) % 4]
    angle = math.radians(degrees)
    return math.cos(angle), math.sin(angle)


def rotation_of(ux: float, uy: float) -> float:
    """Return the rotation in degrees, in [0, 360), of a box whose width runs along (ux, uy)."""
    degrees = round(math.degrees(math.atan2(uy, ux)), 6) % 360.0
    return degrees + 0.0


def box_corners(box: Floats) -> Floats:
    """Return the four corners of a box, counter-clockwise, shape (4, 2)."""
    x, y, ux, uy, hw, hd = (float(value) for value in box[:6])
    signs = ((-1, -1), (1, -1), (1, 1), (-1, 1))
    return np.array([(x + a * hw * ux - b * hd * uy, y + a * hw * uy + b * hd * ux) for a, b in signs])


@kernel
def compose(pose: Floats, parts: Floats) -> Floats:
    """Return the boxes of `parts` (given in a local frame, shape (k, >=6)) under `pose`, shape (k, 6)."""
    out = np.empty((parts.shape[0], 6))
    x, y, ux, uy = pose[0], pose[1], pose[2], pose[3]
    for k in range(parts.shape[0]):
        px, py, pux, puy = parts[k, 0], parts[k, 1], parts[k, 2], parts[k, 3]
        out[k, 0] = x + px * ux - py * uy
        out[k, 1] = y + px * uy + py * ux
        out[k, 2] = pux * ux - puy * uy
        out[k, 3] = pux * uy + puy * ux
        out[k, 4] = parts[k, 4]
        out[k, 5] = parts[k, 5]
    return out


_crosses = kernel(crosses)


@kernel
def point_inside(x: float, y: float, edges: Floats) -> bool:
    """Tell whether a point lies in the region that `edges` bound (even-odd rule)."""
    inside = False
    for k in range(edges.shape[0]):
        ax, ay, bx, by = edges[k, 0], edges[k, 1], edges[k, 2], edges[k, 3]
        if _crosses(x, y, ax, ay, bx, by):
            inside = not inside
    return inside


@kernel
def _edge_cuts(box: Floats, ax: float, ay: float, bx: float, by: float) -> bool:
    """Tell whether a segment enters the box's interior (Liang-Barsky clipping in the box's frame)."""
    ux, uy = box[2], box[3]
    px = (ax - box[0]) * ux + (ay - box[1]) * uy
    py = -(ax - box[0]) * uy + (ay - box[1]) * ux
    dx = (bx - ax) * ux + (by - ay) * uy
    dy = -(bx - ax) * uy + (by - ay) * ux
    low, high = 0.0, 1.0
    for axis in range(2):
        p, d, h = (px, dx, box[4] - TOUCH) if axis == 0 else (py, dy, box[5] - TOUCH)
        if abs(d) < 1e-12:
            if p <= -h or p >= h:
                return False
        else:
            t0, t1 = (-h - p) / d, (h - p) / d
            if t0 > t1:
                t0, t1 = t1, t0
            low = max(low, t0)
            high = min(high, t1)
            if low >= high:
                return False
    return True


@kernel
def box_inside(box: Floats, edges: Floats) -> bool:
    """Tell whether a box lies in the region that `edges` bound."""
    radius = math.hypot(box[4], box[5])
    for k in range(edges.shape[0]):
        ax, ay, bx, by = edges[k, 0], edges[k, 1], edges[k, 2], edges[k, 3]
        if (
            max(ax, bx) < box[0] - radius
            or min(ax, bx) > box[0] + radius
            or max(ay, by) < box[1] - radius
            or min(ay, by) > box[1] + radius
        ):
            continue
        if _edge_cuts(box, ax, ay, bx, by):
            return False
    return point_inside(box[0], box[1], edges)


@kernel
def boxes_overlap(a: Floats, b: Floats, gap: float) -> bool:
    """Tell whether two boxes come nearer than `gap` along every separating axis (0: overlap)."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    reach = math.hypot(a[4], a[5]) + math.hypot(b[4], b[5]) + gap
    if dx * dx + dy * dy >= reach * reach:
        return False
    cos = a[2] * b[2] + a[3] * b[3]
    sin = a[2] * b[3] - a[3] * b[2]
    c, s = abs(cos), abs(sin)
    slack = gap - TOUCH
    if abs(dx * a[2] + dy * a[3]) >= a[4] + b[4] * c + b[5] * s + slack:
        return False
    if abs(-dx * a[3] + dy * a[2]) >= a[5] + b[4] * s + b[5] * c + slack:
        return False
    if abs(dx * b[2] + dy * b[3]) >= b[4] + a[4] * c + a[5] * s + slack:
        return False
    return not abs(-dx * b[3] + dy * b[2]) >= b[5] + a[4] * s + a[5] * c + slack


@kernel
def _point_gap(x: float, y: float, box: Floats) -> float:
    dx = abs((x - box[0]) * box[2] + (y - box[1]) * box[3]) - box[4]
    dy = abs(-(x - box[0]) * box[3] + (y - box[1]) * box[2]) - box[5]
    return math.hypot(max(dx, 0.0), max(dy, 0.0))


@kernel
def _gap(a: Floats, b: Floats) -> float:
    """Return the distance of two boxes, 0 where they overlap (some vertex attains it otherwise)."""
    if boxes_overlap(a, b, 0.0):
        return 0.0
    best = math.inf
    for i in (-1.0, 1.0):
        for j in (-1.0, 1.0):
            px = a[0] + i * a[4] * a[2] - j * a[5] * a[3]
            py = a[1] + i * a[4] * a[3] + j * a[5] * a[2]
            best = min(best, _point_gap(px, py, b))
            qx = b[0] + i * b[4] * b[2] - j * b[5] * b[3]
            qy = b[1] + i * b[4] * b[3] + j * b[5] * b[2]
            best = min(best, _point_gap(qx, qy, a))
    return best


@kernel
def gap_matrix(poses: Floats, hw: float, hd: float, targets: Floats) -> Floats:
    """Return the distances between a box at each pose and each target box.

    Parameters
    ----------
    poses : (n, 4) array
    hw, hd : float
        Half width and half depth of the moving box.
    targets : (m, 6) array

    Returns
    -------
    (n, m) array, metres, 0 where they overlap.
    """
    out = np.empty((poses.shape[0], targets.shape[0]))
    box = np.empty(6)
    box[4], box[5] = hw, hd
    for i in range(poses.shape[0]):
        box[:4] = poses[i]
        for j in range(targets.shape[0]):
            out[i, j] = _gap(box, targets[j])
    return out

"""Oriented rectangles ("boxes") in the plane: containment, overlap, gap and clearance.

A box is a row ``(x, y, ux, uy, hw, hd)``: centre, unit vector along its width, half width and half depth, in metres.
Its front looks along ``v = (-uy, ux)``. A pose is a row ``(x, y, ux, uy)``. A room's boundary is an array of edges
``(ax, ay, bx, by)`` with the interior on the left (exterior ring counter-clockwise, holes clockwise). Touching is not
overlapping: every test is slack by `TOUCH`.
"""

import math

import numpy as np
import numpy.typing as npt

from mansion_geometry.box_index import box_buckets, bucket_of
from mansion_geometry.compiled import kernel

__all__ = [
    "TOUCH",
    "box_corners",
    "box_inside",
    "boxes_overlap",
    "compose",
    "feasible_poses",
    "front_clearance",
    "gap_matrix",
    "point_inside",
    "rotation_of",
    "unit_vector",
]

Floats = npt.NDArray[np.float64]
Bools = npt.NDArray[np.bool_]
Labels = npt.NDArray[np.int32]

_FEW, _BUCKET = 24, 0.8
"""Up to so many boxes are compared one by one, more through buckets of at least this side in metres."""

TOUCH = 1e-6


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
    return np.array(
        [(x + a * hw * ux - b * hd * uy, y + a * hw * uy + b * hd * ux) for a, b in signs]
    )


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


@kernel
def point_inside(x: float, y: float, edges: Floats) -> bool:
    """Tell whether a point lies in the region that `edges` bound (even-odd rule)."""
    inside = False
    for k in range(edges.shape[0]):
        ax, ay, bx, by = edges[k, 0], edges[k, 1], edges[k, 2], edges[k, 3]
        if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
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


@kernel
def _backed(box: Floats, edges: Floats, limit: float) -> bool:
    """Tell whether both ends and the middle of a box's back are within `limit` of the boundary."""
    for k in range(-1, 2):
        x = box[0] + box[5] * box[3] + k * box[4] * box[2]
        y = box[1] - box[5] * box[2] + k * box[4] * box[3]
        near = False
        for e in range(edges.shape[0]):
            dx, dy = edges[e, 2] - edges[e, 0], edges[e, 3] - edges[e, 1]
            qx, qy = x - edges[e, 0], y - edges[e, 1]
            t = min(1.0, max(0.0, (qx * dx + qy * dy) / max(dx * dx + dy * dy, 1e-12)))
            if (qx - t * dx) ** 2 + (qy - t * dy) ** 2 <= limit * limit:
                near = True
                break
        if not near:
            return False
    return True


@kernel
def _hits(
    box: Floats,
    boxes: Floats,
    gap: float,
    x0: float,
    y0: float,
    size: float,
    across: int,
    starts: Labels,
    items: Labels,
) -> bool:
    """Tell whether a box comes nearer than `gap` to any of many (see `box_buckets`)."""
    radius = math.hypot(box[4], box[5]) + gap
    for row in range(
        bucket_of(box[1] - radius, y0, size, across),
        bucket_of(box[1] + radius, y0, size, across) + 1,
    ):
        for col in range(
            bucket_of(box[0] - radius, x0, size, across),
            bucket_of(box[0] + radius, x0, size, across) + 1,
        ):
            bucket = row * across + col
            for i in range(starts[bucket], starts[bucket + 1]):
                if boxes_overlap(box, boxes[items[i]], gap):
                    return True
    return False


@kernel
def feasible_poses(
    poses: Floats, parts: Floats, edges: Floats, boxes: Floats, zones: Floats, gap: float
) -> Bools:
    """Tell at which poses a rigid set of boxes fits.

    Parameters
    ----------
    poses : (n, 4) array
    parts : (k, 8) array
        Boxes in the local frame; the 7th column their height, the 8th above 0 where the back must be at a wall, at most
        that far from it.
    edges : (e, 4) array
        The room's boundary.
    boxes : (m, 6) array
        What stands already; kept at least `gap` away.
    zones : (z, 7) array
        Areas kept free of parts higher than the 7th column (a door's area: -1; a window's: its sill).
    """
    fits = np.zeros(poses.shape[0], dtype=np.bool_)
    x0, y0, size, across, starts, items = box_buckets(boxes, _BUCKET)
    for i in range(poses.shape[0]):
        moved = compose(poses[i], parts)
        ok = True
        for k in range(parts.shape[0]):
            for z in range(zones.shape[0]):
                if parts[k, 6] > zones[z, 6] + TOUCH and boxes_overlap(moved[k], zones[z], 0.0):
                    ok = False
                    break
            if ok:
                if boxes.shape[0] > _FEW:
                    ok = not _hits(moved[k], boxes, gap, x0, y0, size, across, starts, items)
                else:
                    for m in range(boxes.shape[0]):
                        if boxes_overlap(moved[k], boxes[m], gap):
                            ok = False
                            break
            if ok and not box_inside(moved[k], edges):
                ok = False
            if ok and parts[k, 7] > 0.0 and not _backed(moved[k], edges, parts[k, 7]):
                ok = False
            if not ok:
                break
        fits[i] = ok
    return fits


@kernel
def _ray(
    x: float, y: float, dx: float, dy: float, edges: Floats, boxes: Floats, far: float
) -> float:
    """Return the free length of a ray, at most `far`."""
    best = far
    for k in range(edges.shape[0]):
        ex, ey = edges[k, 2] - edges[k, 0], edges[k, 3] - edges[k, 1]
        det = dx * ey - dy * ex
        if abs(det) < 1e-12:
            continue
        wx, wy = edges[k, 0] - x, edges[k, 1] - y
        t = (wx * ey - wy * ex) / det
        s = (wx * dy - wy * dx) / det
        if 0.0 <= s <= 1.0 and 0.0 <= t < best:
            best = t
    for m in range(boxes.shape[0]):
        reach = best + math.hypot(boxes[m, 4], boxes[m, 5])
        qx, qy = x - boxes[m, 0], y - boxes[m, 1]
        if qx * qx + qy * qy > reach * reach:
            continue
        low, high = 0.0, best
        for axis in range(2):
            ax, ay = (boxes[m, 2], boxes[m, 3]) if axis == 0 else (-boxes[m, 3], boxes[m, 2])
            p, d = qx * ax + qy * ay, dx * ax + dy * ay
            h = boxes[m, 4 + axis]
            if abs(d) < 1e-12:
                if abs(p) > h:
                    high = -1.0
            else:
                t0, t1 = (-h - p) / d, (h - p) / d
                low = max(low, min(t0, t1))
                high = min(high, max(t0, t1))
        if low <= high:
            best = min(best, low)
    return best


@kernel
def front_clearance(
    poses: Floats, hw: float, hd: float, edges: Floats, boxes: Floats, far: float
) -> Floats:
    """Return the free depth before, behind, right and left of a box at each pose.

    Parameters
    ----------
    poses : (n, 4) array
    hw, hd : float
        Half width and half depth of the box.
    edges, boxes : (e, 4) and (m, 6) arrays
        What ends the free depth.
    far : float
        Largest depth of interest, metres.

    Returns
    -------
    (n, 4) array: before, behind, to the right (+u), to the left; the least of three rays from that side.
    """
    out = np.empty((poses.shape[0], 4))
    near = np.empty_like(boxes)
    beyond = math.hypot(hw, hd) + far
    for i in range(poses.shape[0]):
        x, y, ux, uy = poses[i, 0], poses[i, 1], poses[i, 2], poses[i, 3]
        count = 0
        for m in range(boxes.shape[0]):
            reach = beyond + math.hypot(boxes[m, 4], boxes[m, 5])
            if (x - boxes[m, 0]) ** 2 + (y - boxes[m, 1]) ** 2 <= reach * reach:
                near[count] = boxes[m]
                count += 1
        for side in range(4):
            if side < 2:
                sign = 1.0 if side == 0 else -1.0
                dx, dy, half, along = -uy * sign, ux * sign, hd, hw
            else:
                sign = 1.0 if side == 2 else -1.0
                dx, dy, half, along = ux * sign, uy * sign, hw, hd
            best = far
            for k in range(-1, 2):
                shift = 0.9 * along * k
                px = x + dx * (half + TOUCH) - dy * shift
                py = y + dy * (half + TOUCH) + dx * shift
                best = min(best, _ray(px, py, dx, dy, edges, near[:count], best))
            out[i, side] = best
    return out

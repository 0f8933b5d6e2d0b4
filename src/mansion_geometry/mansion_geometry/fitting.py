"""Where a rigid set of boxes fits in a room, and how deep the room is free around a box.

Boxes, poses and boundaries are arrays as in `mansion_geometry.boxes`.
"""

import math

import numpy as np

from mansion_geometry.box_index import box_buckets, bucket_of
from mansion_geometry.boxes import TOUCH, box_inside, boxes_overlap, compose
from mansion_geometry.compiled import Bools, Floats, Labels, kernel

__all__ = ["feasible_poses", "front_clearance"]


_FEW, _BUCKET = 24, 0.8
"""Most boxes that are compared one by one, and the least side of the buckets for more, metres."""


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
    for row in range(bucket_of(box[1] - radius, y0, size, across), bucket_of(box[1] + radius, y0, size, across) + 1):
        for col in range(
            bucket_of(box[0] - radius, x0, size, across), bucket_of(box[0] + radius, x0, size, across) + 1
        ):
            bucket = row * across + col
            for i in range(starts[bucket], starts[bucket + 1]):
                if boxes_overlap(box, boxes[items[i]], gap):
                    return True
    return False


@kernel
def feasible_poses(poses: Floats, parts: Floats, edges: Floats, boxes: Floats, zones: Floats, gap: float) -> Bools:
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
def _ray(x: float, y: float, dx: float, dy: float, edges: Floats, boxes: Floats, far: float) -> float:
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
def front_clearance(poses: Floats, hw: float, hd: float, edges: Floats, boxes: Floats, far: float) -> Floats:
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

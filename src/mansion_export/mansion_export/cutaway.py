"""What the overview shows: a building's shell, and a floor with its walls cut open."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
from shapely.geometry import Polygon

from mansion_export.model import Model, Node
from mansion_export.solids3d import triangulate
from mansion_export.triangles import Triangles, flatten
from mansion_msgs_py.scene import FloorScene

__all__ = ["CUT", "cut_open", "quarter_turns", "shell"]

Floats = npt.NDArray[np.float64]

CUT = 1.5
"""Height at which walls are cut open, metres."""

CAP = np.array([0.23, 0.25, 0.28])
DEPTH = np.array([0.36, 0.38, 0.41])
"""What is seen below the openings of stairs and lifts."""

_SHAFT = 0.35
"""How far below the floor a shaft's dark ground lies, metres."""


def quarter_turns(scenes: Sequence[FloorScene]) -> int:
    """Return by how many quarters to turn a building so that its long side and its entrance face the viewer."""
    above = (scene for scene in scenes if scene.floor >= 1)
    ground = min(above, key=lambda scene: scene.floor, default=None)
    if ground is None:
        return 0
    points = np.array(ground.outline)
    low, high = points.min(0), points.max(0)
    turns = 1 if high[1] - low[1] > 1.1 * (high[0] - low[0]) else 0
    door = next((door for door in ground.doors if None in door.rooms), None)
    if door is None:
        return turns
    x, y = np.mean(door.segment, axis=0)
    # Sides in the order in which quarter turns bring them round to the south.
    sides = [y - low[1], x - low[0], high[1] - y, high[0] - x]
    side = int(np.argmin(sides))
    return turns if (side - turns) % 4 in (0, 3) else turns + 2


def cut_open(model: Model, scene: FloorScene, turns: int = 0) -> Triangles:
    """Return a floor without ceilings, its walls cut at `CUT`."""
    solid = flatten(model, lambda node: node.group not in ("objects", "ceiling"))
    movable = flatten(model, lambda node: node.group == "objects" and _low(node))
    shafts = [_ground(core.polygon) for core in scene.cores]
    return _turned(Triangles.join([_cut(solid), movable, *shafts]), turns)


def shell(models: Sequence[Model], scenes: Sequence[FloorScene], turns: int = 0) -> Triangles:
    """Return what is seen of a building above the ground, and the floors behind its windows."""
    parts = []
    buried = all(scene.floor < 1 for scene in scenes)
    for model, scene in zip(models, scenes):
        if scene.floor < 1 and not buried:
            continue
        outer = {wall.id for wall in scene.walls if wall.exterior}
        inner = {wall.id for wall in scene.walls} - outer
        inner |= {door.id for door in scene.doors if None not in door.rooms}
        part = flatten(model, lambda node, inner=inner: _outside(node, inner))  # type: ignore[misc]
        part.corners[..., 2] += model.elevation
        parts.append(part)
    return _turned(Triangles.join(parts), turns)


def _outside(node: Node, inner: set[str]) -> bool:
    if node.group in ("structure", "windows", "doors"):
        return node.id not in inner and node.id.removesuffix("/leaf") not in inner
    return node.group == "ceiling" and node.id.endswith("/roof")


def _turned(triangles: Triangles, turns: int) -> Triangles:
    """Turn by quarters about the vertical, counter-clockwise."""
    x, y = triangles.corners[..., 0].copy(), triangles.corners[..., 1].copy()
    c, s = ((1, 0), (0, 1), (-1, 0), (0, -1))[turns % 4]
    triangles.corners[..., 0], triangles.corners[..., 1] = c * x - s * y, s * x + c * y
    return triangles


def _low(node: Node) -> bool:
    return node.position[2] < CUT + 0.4


def _ground(ring: Sequence[tuple[float, float]]) -> Triangles:
    flat, faces = triangulate(Polygon(ring))
    corners = np.column_stack([flat, np.full(len(flat), -_SHAFT)])[faces]
    return Triangles(corners, np.tile(DEPTH, (len(faces), 1)), np.ones(len(faces)))


def _cut(triangles: Triangles) -> Triangles:
    """Cut upright bodies at `CUT`: flatten what rises above, drop what begins above."""
    heights = triangles.corners[..., 2]
    a, b, c = heights[:, 0], heights[:, 1], heights[:, 2]
    lowest = np.minimum(np.minimum(a, b), c)
    highest = np.maximum(np.maximum(a, b), c)
    keep = lowest < CUT - 1e-6
    corners, colors = triangles.corners[keep], triangles.colors[keep]
    above = highest[keep] > CUT
    corners[..., 2] = np.minimum(corners[..., 2], CUT)
    flat = ~keep & (highest - lowest < 1e-6)
    lids = triangles.corners[flat]
    # A box's lid lies above the cut: bring it down to close the box, unless the box began above, too.
    lids = lids[_over_kept(lids, corners[above])]
    lids[..., 2] = CUT
    capped = Triangles(corners, colors, triangles.alpha[keep])
    closing = Triangles(lids, np.tile(CAP, (len(lids), 1)), np.ones(len(lids)))
    return Triangles.join([capped, closing])


def _over_kept(lids: Floats, sides: Floats) -> npt.NDArray[np.bool_]:
    """Tell which lids have all their corners on sides that reach below the cut."""
    if not len(lids) or not len(sides):
        return np.zeros(len(lids), dtype=bool)
    known = np.unique(_plan_keys(sides).reshape(-1))
    found: npt.NDArray[np.bool_] = np.isin(_plan_keys(lids), known).all(axis=1)
    return found


def _plan_keys(corners: Floats) -> npt.NDArray[np.int64]:
    """Return one number for the place in plan of each corner, to a tenth of a millimetre."""
    places = np.round(corners[..., :2] * 1e4).astype(np.int64)
    keys: npt.NDArray[np.int64] = places[..., 0] * (1 << 31) + places[..., 1]
    return keys

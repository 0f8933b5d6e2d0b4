"""A floor as one sees it from above with its walls cut open."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt
from shapely.geometry import Polygon

from mansion_export.meshes.model import Model, Node
from mansion_export.meshes.solids import triangulate
from mansion_export.pictures.projecting import turned
from mansion_export.pictures.renderer import Triangles, flatten
from mansion_geometry.compiled import Floats
from mansion_msgs_py.scene import FloorScene, SceneObject

__all__ = ["cut_open"]

CUT = 1.5
"""Height at which walls are cut open, metres."""

CAP = np.array([0.23, 0.25, 0.28])
"""Colour of cut walls."""

DEPTH = np.array([0.36, 0.38, 0.41])
"""Colour of the ground of shafts, which is seen through the openings of stairs and lifts."""

_SHAFT = 0.35
"""How far below the floor a shaft's dark ground lies, metres."""

_FLAT = 0.15
"""Depth up to which a thing on a wall hangs flat against it, metres."""


def cut_open(model: Model, scene: FloorScene, turns: int = 0) -> Triangles:
    """Return a floor without ceilings, its walls cut at `CUT` and turned by quarters.

    Pictures and boards hang as much lower as the walls are, so that each still hangs on its wall.
    """
    solid = flatten(model, lambda node: node.group not in ("objects", "ceiling", "site"))
    falls = {item.id: fall for item in scene.objects if (fall := _fall(item))}
    lowered = [_lower(node, falls.get(node.id, 0.0)) for node in model.nodes if node.group == "objects"]
    movable = flatten(replace(model, nodes=tuple(node for node in lowered if node.position[2] < CUT + 0.4)))
    shafts = [_ground(core.polygon) for core in scene.cores]
    whole = Triangles.join([_cut(solid), movable, *shafts])
    return replace(whole, corners=turned(whole.corners, turns))


def _fall(item: SceneObject) -> float:
    """Return by how much to lower a thing that hangs flat on a wall beyond the cut, at most to the floor."""
    if item.mount != "wall" or item.size[1] > _FLAT:
        return 0.0
    bottom = item.position[2] - item.size[2] / 2
    return max(min(bottom + item.size[2] - CUT + 0.03, bottom - 0.1), 0.0)


def _lower(node: Node, fall: float) -> Node:
    return replace(node, position=(*node.position[:2], node.position[2] - fall)) if fall else node


def _ground(ring: Sequence[tuple[float, float]]) -> Triangles:
    flat, faces = triangulate(Polygon(ring))
    corners = np.column_stack([flat, np.full(len(flat), -_SHAFT)])[faces]
    return Triangles.plain(corners, DEPTH)


def _cut(triangles: Triangles) -> Triangles:
    """Cut upright bodies at `CUT`: flatten what rises above, drop what begins above."""
    heights = triangles.corners[..., 2]
    a, b, c = heights[:, 0], heights[:, 1], heights[:, 2]
    lowest = np.minimum(np.minimum(a, b), c)
    highest = np.maximum(np.maximum(a, b), c)
    keep = lowest < CUT - 1e-6
    kept = triangles.where(keep).apart()
    above = highest[keep] > CUT
    _bring_down(kept)
    flat = ~keep & (highest - lowest < 1e-6)
    lids = triangles.corners[flat]
    # A box's lid lies above the cut: bring it down to close the box, unless the box began above, too.
    lids = lids[_over_kept(lids, kept.corners[above])]
    lids[..., 2] = CUT
    return Triangles.join([kept, Triangles.plain(lids, CAP)])


def _bring_down(triangles: Triangles) -> None:
    """Bring corners above `CUT` down to it, and their places on textures with them; each has looks of its own."""
    corners, looks = triangles.corners, triangles.looks
    fall = np.minimum(CUT - corners[..., 2], 0.0)
    some = (fall < 0.0).any(axis=1) & (looks.textures >= 0)
    sides, laid = (values[some][:, 1:] - values[some][:, :1] for values in (corners, looks.coordinates))
    # How far a place moves on its texture with each metre up: least squares over the two sides of the triangle.
    (aa, ab), (_, bb) = np.einsum("kix,kjx->ijk", sides, sides)
    a, b = sides[:, 0, 2], sides[:, 1, 2]
    weights = np.stack([bb * a - ab * b, aa * b - ab * a], axis=1) / np.maximum(aa * bb - ab * ab, 1e-12)[:, None]
    rise = np.einsum("ki,kil->kl", weights, laid)
    looks.coordinates[some] += fall[some][..., None] * rise[:, None]
    corners[..., 2] += fall


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

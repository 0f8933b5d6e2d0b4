"""One picture of a whole building: its outside, and each floor cut open."""

import io
import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.scene import FloorScene
from mansion_scene.export.meshes import building_models, floor_model
from mansion_scene.export.model import Node
from mansion_scene.export.plan.palette import INK
from mansion_scene.export.plan.raster import load_font
from mansion_scene.export.triangles import Triangles, flatten
from mansion_scene.export.zbuffer import View, render

if TYPE_CHECKING:
    from PIL.Image import Image

__all__ = ["cutaway", "overview_png"]

CUT = 1.5
"""Height at which walls are cut open, metres."""

WIDTH = 1800
PAPER = (0.965, 0.968, 0.974)
CAP = np.array([0.23, 0.25, 0.28])
SUPERSAMPLING = 2


def overview_png(scenes: Sequence[FloorScene], width: int = WIDTH) -> bytes:
    """Draw a building from outside, and beside it each floor with its walls cut open.

    Parameters
    ----------
    scenes : sequence of FloorScene
    width : int
        Of the picture, pixels.

    Returns
    -------
    bytes
        PNG without metadata; the same bytes for the same scenes.
    """
    from PIL import Image, ImageDraw

    ordered = sorted(scenes, key=lambda scene: scene.floor)
    columns = _columns(len(ordered) + 1)
    cell = width // columns
    pictures = [("", exterior(ordered, cell))] if ordered else []
    pictures += [(_caption(scene), cutaway(scene, cell)) for scene in ordered]
    head, foot = round(0.05 * width), round(0.026 * width)
    rows = -(-len(pictures) // columns)
    tall = max((picture.height for _, picture in pictures), default=cell)
    sheet = Image.new("RGB", (width, head + rows * (tall + foot)), _rgb(PAPER))
    pen = ImageDraw.Draw(sheet)
    for k, (caption, picture) in enumerate(pictures):
        x, y = (k % columns) * cell, head + (k // columns) * (tall + foot)
        sheet.paste(picture, (x + (cell - picture.width) // 2, y + (tall - picture.height) // 2))
        pen.text(
            (x + cell // 2, y + tall + foot // 3),
            caption,
            font=load_font(round(0.4 * foot), False),
            fill=INK["muted"],
            anchor="mm",
        )
    title = ordered[0].building_id.replace("_", " ") if ordered else ""
    pen.text(
        (round(0.02 * width), head // 2),
        title,
        font=load_font(round(0.42 * head), True),
        fill=INK["text"],
        anchor="lm",
    )
    buffer = io.BytesIO()
    sheet.save(buffer, format="PNG", compress_level=6)
    return buffer.getvalue()


def cutaway(scene: FloorScene, width: int) -> "Image":
    """Draw one floor from above with its walls cut at `CUT`, at most `width` pixels wide."""
    model = floor_model(scene, ceilings=False)
    solid = flatten(model, lambda node: node.group != "objects")
    movable = flatten(model, lambda node: node.group == "objects" and _low(node))
    return _picture(
        Triangles.join([_cut(solid), movable]), width, View(azimuth=-68.0, elevation=54.0)
    )


def exterior(scenes: Sequence[FloorScene], width: int) -> "Image":
    """Draw the building from outside, roof and all."""
    parts = []
    for model in building_models(scenes):
        shell = flatten(model, lambda node: node.group != "objects")
        lift = np.array([0.0, 0.0, model.elevation])
        parts.append(Triangles(shell.corners + lift, shell.colors, shell.alpha))
    return _picture(Triangles.join(parts), width, View(azimuth=-58.0, elevation=26.0))


def _columns(count: int) -> int:
    return count if count <= 3 else math.ceil(math.sqrt(count))


def _caption(scene: FloorScene) -> str:
    rooms = sum(room.kind not in ("stair", "elevator") for room in scene.rooms)
    area = sum(room.area for room in scene.rooms if room.kind not in ("stair", "elevator"))
    return f"Floor {scene.label}: {rooms} rooms, {area:.0f} m², {len(scene.objects)} objects"


def _low(node: Node) -> bool:
    return node.position[2] < CUT + 0.4


def _cut(triangles: Triangles) -> Triangles:
    """Cut upright bodies at `CUT`: flatten what rises above, drop what begins above."""
    heights = triangles.corners[..., 2]
    keep = heights.min(1) < CUT - 1e-6
    corners, colors = triangles.corners[keep].copy(), triangles.colors[keep].copy()
    above = corners[..., 2] > CUT
    corners[..., 2] = np.minimum(corners[..., 2], CUT)
    capped = Triangles(corners, colors, triangles.alpha[keep])
    flat = ~keep & (heights.max(1) - heights.min(1) < 1e-6)
    lids = triangles.corners[flat].copy()
    # A box's lid lies above the cut: bring it down to close the box, unless the box began above, too.
    closed = _over_kept(lids, corners[above.any(1)])
    lids = lids[closed]
    lids[..., 2] = CUT
    return Triangles.join(
        [capped, Triangles(lids, np.tile(CAP, (len(lids), 1)), np.ones(len(lids)))]
    )


def _over_kept(
    lids: npt.NDArray[np.float64], sides: npt.NDArray[np.float64]
) -> npt.NDArray[np.bool_]:
    """Tell which lids have all their corners on sides that reach below the cut."""
    if not len(lids) or not len(sides):
        return np.zeros(len(lids), dtype=bool)
    known = {tuple(point) for point in np.round(sides[..., :2].reshape(-1, 2), 4).tolist()}
    points = np.round(lids[..., :2], 4).tolist()
    return np.array([all(tuple(point) in known for point in lid) for lid in points], dtype=bool)


def _picture(triangles: Triangles, width: int, view: View) -> "Image":
    from PIL import Image

    axes = view.axes()
    seen = triangles.corners.reshape(-1, 3) @ axes.T
    extent = seen.max(0) - seen.min(0)
    scale = min(0.94 * width / extent[0], 0.8 * width / extent[1]) * SUPERSAMPLING
    pixels = render(triangles, View(view.azimuth, view.elevation, float(scale)), PAPER)
    return Image.fromarray(pixels).reduce(SUPERSAMPLING)


def _rgb(color: tuple[float, float, float]) -> tuple[int, int, int]:
    return (round(255 * color[0]), round(255 * color[1]), round(255 * color[2]))

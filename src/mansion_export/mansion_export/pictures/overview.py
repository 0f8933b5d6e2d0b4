"""A picture of a whole building: its outside, with the sky in its panes, and each floor with its walls cut open."""

import io
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from mansion_assets.catalogue import Catalogue
from mansion_export.meshes.building_model import building_models
from mansion_export.meshes.model import Model
from mansion_export.pictures.renderer import Triangles, View, bounds, project, render
from mansion_export.plan.palette import INK
from mansion_export.plan.raster import load_font
from mansion_export.presentation import building_title, floor_name
from mansion_geometry.compiled import Floats
from mansion_msgs_py.scene import FloorScene

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

import numpy as np
import numpy.typing as npt
from shapely.geometry import Polygon

from mansion_assets.materials import set_of
from mansion_export.meshes.model import Node
from mansion_export.meshes.solids import SIDES, triangulate
from mansion_export.pictures.renderer import flatten
from mansion_export.pictures.texture_sampling import texture_number
from mansion_export.presentation import quarter_turns
from mansion_knowledge import is_class

__all__ = ["mirroring", "overview_files", "overview_png"]

WIDTH = 1600
PAPER = (0.965, 0.968, 0.974)
SUPERSAMPLING = 2
OUTSIDE = 0.36
"""Share of the width for the picture from outside."""

MOST_COLUMNS = 6
FROM_ABOVE = View(azimuth=-72.0, elevation=54.0)
FROM_STREET = View(azimuth=-56.0, elevation=21.0)


CUT = 1.5
"""Height at which walls are cut open, metres."""

CAP = np.array([0.23, 0.25, 0.28])
"""Colour of cut walls."""

DEPTH = np.array([0.36, 0.38, 0.41])
"""Colour of the ground of shafts, which is seen through the openings of stairs and lifts."""

_SHAFT = 0.35
"""How far below the floor a shaft's dark ground lies, metres."""


@dataclass(frozen=True, slots=True)
class _Sheet:
    """Columns of the floors' grid, its left edge, and a cell's size without caption; pixels."""

    columns: int
    left: int
    cell: tuple[int, int]
    head: int
    foot: int

    def height(self, floors: int) -> int:
        return self.head + -(-floors // self.columns) * (self.cell[1] + self.foot)


def overview_png(
    scenes: Sequence[FloorScene],
    width: int = WIDTH,
    *,
    site: bool = True,
    catalogue: Catalogue | None = None,
    models: Sequence[Model] | None = None,
) -> bytes:
    """Draw a building from outside, and beside it each floor with its walls cut open.

    Parameters
    ----------
    scenes : sequence of FloorScene
    width : int
        Width of the picture, pixels.
    site : bool
        With the plot around the building, unless the models are given.
    catalogue : Catalogue, optional
        Where the assets are, when they are not all in the shipped one.
    models : sequence of Model, optional
        Models of the same floors, lowest first, with ceilings, if they are made already.

    Returns
    -------
    bytes
        PNG without metadata; the same bytes for the same scenes.
    """
    from PIL import Image, ImageDraw

    ordered = sorted(scenes, key=lambda scene: scene.floor)
    if models is None:
        models = building_models(ordered, site=site, catalogue=catalogue)
    turns = quarter_turns(ordered)
    floors = [_cut_open(model, scene, turns) for model, scene in zip(models, ordered)]
    layout = _layout(floors, width)
    sheet = Image.new("RGB", (width, max(layout.height(len(floors)), layout.head)), _rgb(PAPER))
    pen = ImageDraw.Draw(sheet)
    _title(pen, building_title(ordered), layout.head, width)
    if ordered:
        room = (layout.left, sheet.height - layout.head)
        picture = _picture(_shell(models, ordered, turns), room, FROM_STREET)
        at = (room[0] - picture.width) // 2, layout.head + (room[1] - picture.height) // 2
        sheet.paste(picture, at)
    for k, (scene, triangles) in enumerate(zip(ordered, floors)):
        picture = _picture(triangles, layout.cell, FROM_ABOVE)
        x = layout.left + (k % layout.columns) * layout.cell[0]
        y = layout.head + (k // layout.columns) * (layout.cell[1] + layout.foot)
        slack = layout.cell[0] - picture.width, layout.cell[1] - picture.height
        sheet.paste(picture, (x + slack[0] // 2, y + slack[1] // 2))
        pen.text(
            (x + layout.cell[0] // 2, y + layout.cell[1] + layout.foot // 3),
            _caption(scene),
            font=load_font(max(8, min(round(0.0095 * width), layout.cell[0] // 24)), bold=False),
            fill=INK["muted"],
            anchor="mm",
        )
    buffer = io.BytesIO()
    sheet.save(buffer, format="PNG", compress_level=4)
    return buffer.getvalue()


def overview_files(scenes: Sequence[FloorScene], *, site: bool = True) -> dict[str, bytes]:
    """Return ``building.png`` by its path in the building's folder."""
    return {"building.png": overview_png(scenes, site=site)}


def _layout(floors: Sequence[Triangles], width: int) -> _Sheet:
    """Choose the fewest columns with which the floors' pictures are no taller than three quarters of the width."""
    head, foot, left = round(0.045 * width), round(0.024 * width), round(OUTSIDE * width)
    sizes = [_size(floor, FROM_ABOVE) for floor in floors if len(floor.alpha)] or [(1.0, 1.0)]
    across, tall = max(w for w, _ in sizes), max(h for _, h in sizes)
    for columns in range(1, MOST_COLUMNS + 1):
        cell_width = (width - left) // columns
        cell = (cell_width, round(cell_width * tall / across))
        sheet = _Sheet(columns, left, cell, head, foot)
        if sheet.height(len(floors)) <= 0.75 * width:
            return sheet
    rows = -(-len(floors) // MOST_COLUMNS)
    return _Sheet(MOST_COLUMNS, left, (cell_width, max(cell[1] // rows, cell_width // 3)), head, foot)


def _size(triangles: Triangles, view: View) -> tuple[float, float]:
    """Width and height of what is seen, metres of the picture's plane."""
    low, high = bounds(project(triangles.corners, view.axes()))
    extent = high - low
    return max(float(extent[0]), 0.1), max(float(extent[1]), 0.1)


def _picture(triangles: Triangles, room: tuple[int, int], view: View) -> "Image":
    """Draw triangles as large as fits `room`, less a margin."""
    from PIL import Image

    across, tall = _size(triangles, view)
    scale = 0.93 * min(room[0] / across, room[1] / tall) * SUPERSAMPLING
    pixels = render(triangles, View(view.azimuth, view.elevation, scale), PAPER)
    return Image.fromarray(pixels).reduce(SUPERSAMPLING)


def _title(pen: "ImageDraw", title: str, head: int, width: int) -> None:
    """Write the title, smaller where it would run out of the picture."""
    size = 0.5 * head
    length = load_font(round(size), bold=True).getlength(title)
    size *= min(1.0, 0.94 * width / max(length, 1.0))
    pen.text(
        (round(0.02 * width), round(0.55 * head)),
        title,
        font=load_font(max(8, math.floor(size)), bold=True),
        fill=INK["text"],
        anchor="lm",
    )


def _caption(scene: FloorScene) -> str:
    rooms = sum(room.kind not in ("stair", "elevator") for room in scene.rooms)
    area = sum(room.area for room in scene.rooms if room.kind not in ("stair", "elevator"))
    name = floor_name(scene)
    return f"{name[0].upper()}{name[1:]}: {rooms} room{'s' * (rooms != 1)}, {area:.0f} m², {len(scene.objects)} objects"


def _rgb(color: tuple[float, float, float]) -> tuple[int, int, int]:
    return (round(255 * color[0]), round(255 * color[1]), round(255 * color[2]))


def _cut_open(model: Model, scene: FloorScene, turns: int = 0) -> Triangles:
    """Return a floor without ceilings, its walls cut at `CUT`."""
    solid = flatten(model, lambda node: node.group not in ("objects", "ceiling", "site"))
    movable = flatten(model, lambda node: node.group == "objects" and _low(node))
    shafts = [_ground(core.polygon) for core in scene.cores]
    return _turned(Triangles.join([_cut(solid), movable, *shafts]), turns)


def _shell(models: Sequence[Model], scenes: Sequence[FloorScene], turns: int = 0) -> Triangles:
    """Return what is seen of a building above the ground, and the floors behind its windows."""
    parts = []
    buried = all(scene.floor < 1 for scene in scenes)
    for model, scene in zip(models, scenes):
        if scene.floor < 1 and not buried:
            continue
        terraces = {room.id for room in scene.rooms if is_class(room.room_type, "outdoor")}
        outer = {wall.id for wall in scene.walls if wall.exterior or {wall.left, wall.right} & terraces}
        inner = {wall.id for wall in scene.walls} - outer
        inner |= {door.id for door in scene.doors if None not in door.rooms and not {*door.rooms} & terraces}
        shell = flatten(model, lambda node, inner=inner: _outside(node, inner))  # type: ignore[misc]
        standing = flatten(model, lambda node, rooms=terraces: node.group == "objects" and node.room in rooms)  # type: ignore[misc]
        part = Triangles.join([mirroring(shell), standing])
        parts.append(replace(part, corners=part.corners + np.array([0.0, 0.0, model.elevation])))
    return _turned(Triangles.join(parts), turns)


def _outside(node: Node, inner: set[str]) -> bool:
    if node.group in ("structure", "windows", "doors", "site"):
        return node.id not in inner and node.id.removesuffix("/leaf") not in inner
    return node.group == "ceiling" and (node.id.endswith("/roof") or "/chimney_" in node.id)


def _turned(triangles: Triangles, turns: int) -> Triangles:
    """Return triangles turned by quarters about the vertical, counter-clockwise."""
    if turns % 4 == 0:
        return triangles
    c, s = ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[turns % 4]
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    return replace(triangles, corners=project(triangles.corners, turn))


def _low(node: Node) -> bool:
    return node.position[2] < CUT + 0.4


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
    kept = triangles.where(keep)
    above = highest[keep] > CUT
    capped = _lowered(kept)
    flat = ~keep & (highest - lowest < 1e-6)
    lids = triangles.corners[flat]
    # A box's lid lies above the cut: bring it down to close the box, unless the box began above, too.
    lids = lids[_over_kept(lids, capped.corners[above])]
    lids[..., 2] = CUT
    return Triangles.join([capped, Triangles.plain(lids, CAP)])


def _lowered(triangles: Triangles) -> Triangles:
    """Bring corners above `CUT` down to it, and their places on textures with them."""
    corners, coordinates = triangles.corners.copy(), triangles.coordinates.copy()
    fall = np.minimum(CUT - corners[..., 2], 0.0)
    some = (fall < 0.0).any(axis=1) & (triangles.textures >= 0)
    sides, laid = (values[some][:, 1:] - values[some][:, :1] for values in (corners, coordinates))
    # How far a place moves on its texture with each metre up: least squares over the two sides of the triangle.
    (aa, ab), (_, bb) = np.einsum("kix,kjx->ijk", sides, sides)
    a, b = sides[:, 0, 2], sides[:, 1, 2]
    weights = np.stack([bb * a - ab * b, aa * b - ab * a], axis=1) / np.maximum(aa * bb - ab * ab, 1e-12)[:, None]
    rise = np.einsum("ki,kil->kl", weights, laid)
    coordinates[some] += fall[some][..., None] * rise[:, None]
    corners[..., 2] += fall
    return replace(triangles, corners=corners, coordinates=coordinates)


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


TONES: Final = np.array([(0.94, 0.97, 1.0), (0.8, 0.85, 0.9), (0.86, 0.88, 0.88), (0.7, 0.76, 0.82), (1.0, 1.0, 0.98)])
"""What the sky in a pane is multiplied with: rooms behind are bright or dark, curtains open or drawn."""


def mirroring(triangles: Triangles) -> Triangles:
    """Return triangles whose boxes of glass are opaque and show the sky, each pane in a tone of its own."""
    glass = np.flatnonzero(triangles.alpha < 0.99)
    if not len(glass) or len(glass) % len(SIDES):
        return triangles
    corners = triangles.corners[glass].reshape(-1, len(SIDES) * 3, 3)
    low, high = corners.min(axis=1), corners.max(axis=1)
    height = np.maximum(high[:, 2] - low[:, 2], 1e-3)[:, None]
    extent = high - low
    turned = (extent[:, 1] > extent[:, 0])[:, None]
    across = np.where(turned, corners[..., 1], corners[..., 0]) / height
    up = (corners[..., 2] - low[:, None, 2]) / height
    # Neighbours differ, and the same building always looks the same.
    numbers = np.round((low + high) @ (3.1, 5.3, 7.7)).astype(np.int64) % len(TONES)
    colors, alpha = triangles.colors.copy(), triangles.alpha.copy()
    textures, coordinates = triangles.textures.copy(), triangles.coordinates.copy()
    colors[glass] = np.repeat(TONES[numbers], len(SIDES), axis=0)
    alpha[glass] = 1.0
    textures[glass] = texture_number(set_of("mirroring_glass"))
    coordinates[glass] = np.stack([across, up], axis=-1).reshape(-1, 3, 2)
    return replace(triangles, colors=colors, alpha=alpha, textures=textures, coordinates=coordinates)

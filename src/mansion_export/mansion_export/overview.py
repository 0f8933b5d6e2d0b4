"""One picture of a whole building: its outside, and each floor cut open."""

import io
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from mansion_assets.catalogue import Catalogue
from mansion_export.cutaway import cut_open, quarter_turns, shell
from mansion_export.meshes import building_models
from mansion_export.model import Model
from mansion_export.plan.palette import INK
from mansion_export.plan.raster import load_font
from mansion_export.titles import building_title, floor_name
from mansion_export.triangles import Triangles, bounds, project
from mansion_export.zbuffer import View, render
from mansion_msgs_py.scene import FloorScene

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

__all__ = ["overview_png"]

WIDTH = 1600
PAPER = (0.965, 0.968, 0.974)
SUPERSAMPLING = 2
OUTSIDE = 0.36
"""Share of the width for the picture from outside."""

MOST_COLUMNS = 6
FROM_ABOVE = View(azimuth=-72.0, elevation=54.0)
FROM_STREET = View(azimuth=-58.0, elevation=26.0)


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
    catalogue: Catalogue | None = None,
    models: Sequence[Model] | None = None,
) -> bytes:
    """Draw a building from outside, and beside it each floor with its walls cut open.

    Parameters
    ----------
    scenes : sequence of FloorScene
    width : int
        Of the picture, pixels.
    catalogue : Catalogue, optional
        Where the assets are, when they are not all in the shipped one.
    models : sequence of Model, optional
        Of the same floors, lowest first, with ceilings, where they are made already.

    Returns
    -------
    bytes
        PNG without metadata; the same bytes for the same scenes.
    """
    from PIL import Image, ImageDraw

    ordered = sorted(scenes, key=lambda scene: scene.floor)
    if models is None:
        models = building_models(ordered, catalogue=catalogue)
    turns = quarter_turns(ordered)
    floors = [cut_open(model, scene, turns) for model, scene in zip(models, ordered)]
    layout = _layout(floors, width)
    sheet = Image.new("RGB", (width, max(layout.height(len(floors)), layout.head)), _rgb(PAPER))
    pen = ImageDraw.Draw(sheet)
    _title(pen, building_title(ordered), layout.head, width)
    if ordered:
        room = (layout.left, sheet.height - layout.head)
        picture = _picture(shell(models, ordered, turns), room, FROM_STREET)
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
            font=load_font(max(8, min(round(0.0095 * width), layout.cell[0] // 24)), False),
            fill=INK["muted"],
            anchor="mm",
        )
    buffer = io.BytesIO()
    sheet.save(buffer, format="PNG", compress_level=4)
    return buffer.getvalue()


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
    length = load_font(round(size), True).getlength(title)
    size *= min(1.0, 0.94 * width / max(length, 1.0))
    pen.text(
        (round(0.02 * width), round(0.55 * head)),
        title,
        font=load_font(max(8, math.floor(size)), True),
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

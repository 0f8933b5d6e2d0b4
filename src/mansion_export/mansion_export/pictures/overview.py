"""A picture of a whole building: its outside from the street, and each floor with its walls cut open."""

import io
import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

import numpy as np
from shapely.geometry import Polygon, box

from mansion_assets.catalogue import Catalogue
from mansion_export.meshes.building_model import building_models
from mansion_export.meshes.model import Model
from mansion_export.pictures.cut_open import cut_open
from mansion_export.pictures.projecting import bounds_along, project, turned
from mansion_export.pictures.renderer import Triangles, View, render
from mansion_export.pictures.street_view import StreetView
from mansion_export.plan.palette import INK
from mansion_export.plan.raster import load_font
from mansion_export.presentation import building_title, floor_name, quarter_turns, room_title
from mansion_geometry.compiled import Floats
from mansion_knowledge import is_class
from mansion_msgs_py.scene import FloorScene

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

__all__ = ["overview_files", "overview_png"]

WIDTH = 1440
PAPER = (0.965, 0.968, 0.974)

MOST_COLUMNS = 6
TALLEST: Final = 0.6
"""Height of all floors' pictures together at most, as a share of the width."""

FROM_ABOVE = View(azimuth=-76.0, elevation=57.0)

LETTER: Final = (0.0066, 0.0078)
"""Smallest and largest letters of a room's name, as shares of the width."""


@dataclass(frozen=True, slots=True)
class _Sheet:
    """Columns of the floors' grid, its upper edge, and a cell's size without caption; pixels."""

    columns: int
    top: int
    cell: tuple[int, int]
    foot: int

    def height(self, floors: int) -> int:
        return self.top + -(-floors // self.columns) * (self.cell[1] + self.foot)


def overview_png(
    scenes: Sequence[FloorScene],
    width: int = WIDTH,
    *,
    site: bool = True,
    catalogue: Catalogue | None = None,
    models: Sequence[Model] | None = None,
) -> bytes:
    """Draw a building from the street, and below it each floor with its walls cut open and the names of its rooms.

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
        models = building_models(ordered, ceilings=False, roofs=True, site=site, catalogue=catalogue)
    turns = quarter_turns(ordered)
    head = round(0.045 * width)
    street = StreetView(models, ordered) if ordered else None
    outside = street.draw(width, street.height(width)) if street else None
    floors = [cut_open(model, scene, turns) for model, scene in zip(models, ordered)]
    layout = _layout(floors, width, head + (outside.height if outside else 0))
    sheet = Image.new("RGB", (width, layout.height(len(floors))), _rgb(PAPER))
    pen = ImageDraw.Draw(sheet)
    _title(pen, building_title(ordered), head, width)
    if outside:
        sheet.paste(outside, (0, head))
    for k, (scene, triangles) in enumerate(zip(ordered, floors)):
        x = (k % layout.columns) * layout.cell[0]
        y = layout.top + (k // layout.columns) * (layout.cell[1] + layout.foot)
        _floor(sheet, pen, scene, triangles, (x, y), layout.cell, turns)
        pen.text(
            (x + layout.cell[0] // 2, y + layout.cell[1] + layout.foot // 3),
            _caption(scene),
            font=load_font(max(8, min(round(0.0095 * width), layout.cell[0] // 24)), bold=False),
            fill=INK["muted"],
            anchor="mm",
        )
    buffer = io.BytesIO()
    sheet.save(buffer, format="PNG", compress_level=1)
    return buffer.getvalue()


def overview_files(scenes: Sequence[FloorScene], *, site: bool = True) -> dict[str, bytes]:
    """Return ``building.png`` by its path in the building's folder."""
    return {"building.png": overview_png(scenes, site=site)}


def _layout(floors: Sequence[Triangles], width: int, top: int) -> _Sheet:
    """Choose the fewest columns with which the floors' pictures are not too tall together."""
    foot = round(0.024 * width)
    sizes = [_size(floor, FROM_ABOVE) for floor in floors if len(floor)] or [(1.0, 1.0)]
    across, tall = max(w for w, _ in sizes), max(h for _, h in sizes)
    for columns in range(1, MOST_COLUMNS + 1):
        cell_width = width // columns
        cell = (cell_width, round(cell_width * tall / across))
        sheet = _Sheet(columns, top, cell, foot)
        if columns >= len(floors) or sheet.height(len(floors)) - top <= TALLEST * width:
            break
    # As many rows with as few columns: four floors lie two by two.
    rows = max(-(-len(floors) // columns), 1)
    columns = max(-(-len(floors) // rows), 1)
    cell_width = width // columns
    cell = (cell_width, round(cell_width * tall / across))
    most = max(round(TALLEST * width / rows) - foot, cell_width // 3)
    return _Sheet(columns, top, (cell_width, min(cell[1], most)), foot)


def _size(triangles: Triangles, view: View) -> tuple[float, float]:
    """Width and height of what is seen, metres of the picture's plane."""
    low, high = bounds_along(triangles.corners, view.axes())
    extent = high - low
    return max(float(extent[0]), 0.1), max(float(extent[1]), 0.1)


def _floor(
    sheet: "Image",
    pen: "ImageDraw",
    scene: FloorScene,
    triangles: Triangles,
    at: tuple[int, int],
    room: tuple[int, int],
    turns: int,
) -> None:
    """Draw a floor in the middle of a cell, as large as fits it less a margin, with the names of its rooms."""
    from PIL import Image

    axes = FROM_ABOVE.axes()
    low, high = bounds_along(triangles.corners, axes)
    extent = np.maximum(high - low, 0.1)
    scale = 0.95 * min(room[0] / float(extent[0]), room[1] / float(extent[1]))
    view = View(FROM_ABOVE.azimuth, FROM_ABOVE.elevation, scale)
    picture = Image.fromarray(render(triangles, view, PAPER))
    left, top = at[0] + (room[0] - picture.width) // 2, at[1] + (room[1] - picture.height) // 2
    sheet.paste(picture, (left, top))
    # The picture's border is a few pixels wide.
    origin = np.array([left + picture.width / 2, top + picture.height / 2])
    middle = (low + high)[:2] / 2

    def place(point: Floats) -> tuple[float, float]:
        shown = project(turned(np.array([[point] * 3]), turns), axes)[0, 0, :2] - middle
        return float(origin[0] + scale * shown[0]), float(origin[1] - scale * shown[1])

    taken: list[Polygon] = []
    for title, (x, y), wide in _names(scene, scale, turns):
        _name(pen, title, place(np.array([x, y, 0.3])), wide, sheet.width, taken)


def _names(scene: FloorScene, scale: float, turns: int) -> list[tuple[str, tuple[float, float], float]]:
    """Return each room's name, where its middle is, and how wide it is in the picture, pixels; ways through last."""
    found = []
    for room in sorted(scene.rooms, key=lambda room: is_class(room.room_type, "circulation")):
        if room.kind in ("stair", "elevator"):
            continue
        polygon = Polygon(room.polygon, room.holes)
        middle = polygon.centroid if polygon.contains(polygon.centroid) else polygon.representative_point()
        x0, y0, x1, y1 = polygon.bounds
        wide = (y1 - y0) if turns % 2 else (x1 - x0)
        found.append((room_title(room), (middle.x, middle.y), wide * scale))
    return found


def _name(pen: "ImageDraw", title: str, at: tuple[float, float], wide: float, width: int, taken: list[Polygon]) -> None:
    """Write a room's name in one row or two where it fits and covers no other, dark with a light rim."""
    for size in (round(share * width) for share in reversed(LETTER)):
        font = load_font(max(size, 7), bold=True)
        for text in _rows(title):
            style = {"font": font, "anchor": "mm", "align": "center", "spacing": 1, "stroke_width": 2}
            covered = box(*pen.multiline_textbbox(at, text, **style))
            x0, _, x1, _ = covered.bounds
            if x1 - x0 <= 0.98 * wide and not any(covered.intersects(other) for other in taken):
                pen.multiline_text(at, text, fill=INK["text"], stroke_fill=_rgb(PAPER), **style)
                taken.append(covered)
                return


def _rows(title: str) -> list[str]:
    """Return a title in one row and, of several words, broken nearest its middle."""
    breaks = [k for k, letter in enumerate(title) if letter == " "]
    if not breaks:
        return [title]
    best = min(breaks, key=lambda k: abs(2 * k - len(title)))
    return [title, f"{title[:best]}\n{title[best + 1 :]}"]


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

"""The PNG writer: Pillow at twice the size, then halved for smooth edges."""

import importlib.util
import io
import itertools
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from mansion_export.plan.drawing import Drawing, draw_plan
from mansion_export.plan.shapes import Area, Label, Line
from mansion_msgs_py.scene import FloorScene

if TYPE_CHECKING:
    from PIL.Image import Image
    from PIL.ImageDraw import ImageDraw

__all__ = ["drawing_png", "load_font", "plan_png"]

LONGEST = 1600
FINEST = 90.0
"""Pixels of the longer side at most, and pixels for each metre at most."""

SUPERSAMPLING = 2


def plan_png(scene: FloorScene, longest: int = LONGEST) -> bytes:
    """Draw a floor's plan as PNG.

    Parameters
    ----------
    scene : FloorScene
    longest : int
        Pixels of the longer side; small floors get fewer.

    Returns
    -------
    bytes
        The file, without dates or other metadata: the same bytes for the same scene.
    """
    return drawing_png(draw_plan(scene), longest)


def drawing_png(drawing: Drawing, longest: int = LONGEST) -> bytes:
    """Draw a drawing as PNG; see `plan_png`."""
    scale = min(longest / max(drawing.width, drawing.height), FINEST)
    picture = _paint(drawing, scale)
    buffer = io.BytesIO()
    picture.save(buffer, format="PNG", compress_level=1)
    return buffer.getvalue()


def _paint(drawing: Drawing, scale: float) -> "Image":
    from PIL import Image, ImageDraw

    fine = scale * SUPERSAMPLING
    size = (round(drawing.width * scale), round(drawing.height * scale))
    picture = Image.new("RGB", (size[0] * SUPERSAMPLING, size[1] * SUPERSAMPLING), "#ffffff")
    brush = ImageDraw.Draw(picture, "RGBA")
    painter = _Painter(drawing, fine, brush)
    for canvas in drawing.canvases:
        for shape in canvas.shapes:
            if isinstance(shape, Area):
                painter.area(shape)
            elif isinstance(shape, Line):
                painter.line(shape)
            else:
                painter.label(shape, picture)
    return picture.reduce(SUPERSAMPLING)


class _Painter:
    """Shapes in plan metres on a Pillow brush."""

    def __init__(self, drawing: Drawing, scale: float, brush: "ImageDraw") -> None:
        self.drawing, self.scale, self.brush = drawing, scale, brush

    def pixels(self, points: Any) -> list[tuple[float, float]]:
        x0, y1, scale = self.drawing.x0, self.drawing.y1, self.scale
        return [((x - x0) * scale, (y1 - y) * scale) for x, y in points]

    def width(self, metres: float) -> int:
        return max(1, round(metres * self.scale))

    def area(self, area: Area) -> None:
        points = self.pixels(area.points)
        if area.fill is not None:
            if area.holes:
                points = _keyhole(points, [self.pixels(hole) for hole in area.holes])
            self.brush.polygon(points, fill=area.fill)
        if area.stroke and area.width > 0:
            ring = self.pixels(area.points)
            width = self.width(area.width)
            self.brush.line([*ring, ring[0], ring[1]], fill=area.stroke, width=width, joint="curve")

    def line(self, line: Line) -> None:
        points, width = self.pixels(line.points), self.width(line.width)
        if not line.dash:
            self.brush.line(points, fill=line.stroke, width=width, joint="curve")
            return
        dash = line.dash * self.scale
        for (ax, ay), (bx, by) in itertools.pairwise(points):
            length = float(np.hypot(bx - ax, by - ay))
            for k in range(0, int(length / dash) + 1, 2):
                low, high = k * dash / length, min((k + 1) * dash / length, 1.0)
                a = (ax + (bx - ax) * low, ay + (by - ay) * low)
                b = (ax + (bx - ax) * high, ay + (by - ay) * high)
                self.brush.line([a, b], fill=line.stroke, width=width)

    def label(self, label: Label, picture: "Image") -> None:
        from PIL import Image, ImageDraw

        font = load_font(max(6, round(label.size * self.scale)), bold=label.bold)
        halo = round(0.11 * label.size * self.scale) if label.halo else 0
        (x, y) = self.pixels([label.at])[0]
        anchor = {"start": "lm", "middle": "mm", "end": "rm"}[label.anchor]
        if not label.angle:
            if halo:
                self.brush.text(
                    (x, y), label.text, font=font, fill="#ffffffcc", anchor=anchor,
                    stroke_width=halo, stroke_fill="#ffffffcc",
                )  # fmt: skip
            self.brush.text((x, y), label.text, font=font, fill=label.color, anchor=anchor)
            return
        reach = round(font.getlength(label.text)) + 4 * halo + 8
        tile = Image.new("RGBA", (reach, round(1.8 * label.size * self.scale) + 4 * halo + 4))
        pen = ImageDraw.Draw(tile)
        middle = (tile.width / 2, tile.height / 2)
        if halo:
            pen.text(
                middle, label.text, font=font, fill="#ffffffcc", anchor="mm",
                stroke_width=halo, stroke_fill="#ffffffcc",
            )  # fmt: skip
        pen.text(middle, label.text, font=font, fill=label.color, anchor="mm")
        tile = tile.rotate(label.angle, expand=True, resample=Image.Resampling.BICUBIC)
        picture.paste(tile, (round(x - tile.width / 2), round(y - tile.height / 2)), tile)


def _keyhole(ring: list[tuple[float, float]], holes: list[list[tuple[float, float]]]) -> list[tuple[float, float]]:
    """Join holes to a ring by a doubled line, which Pillow's even-odd filling leaves out."""
    joined = [*ring, ring[0]]
    for hole in holes:
        joined += [*hole, hole[0], ring[0]]
    return joined


@lru_cache(maxsize=64)
def load_font(size: int, *, bold: bool) -> Any:
    """Load DejaVu Sans, which matplotlib carries, so that no font of the machine changes a picture."""
    from PIL import ImageFont

    found = importlib.util.find_spec("matplotlib")
    for place in (found.submodule_search_locations or []) if found else []:
        name = "DejaVuSans-Bold.ttf" if bold else "DejaVuSans.ttf"
        path = Path(place) / "mpl-data" / "fonts" / "ttf" / name
        if path.is_file():
            return ImageFont.truetype(str(path), size)
    return ImageFont.load_default(size)

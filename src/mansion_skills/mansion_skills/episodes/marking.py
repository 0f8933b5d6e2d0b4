"""Numbers drawn into pictures: marks on the objects in view, tiles of landmarks."""

from collections.abc import Mapping, Sequence
from io import BytesIO
from math import ceil
from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["label", "marked_view", "png", "tiles"]

TILE = (320, 200)
"""Pixels of a landmark's tile, its label included."""

PER_PAGE = 9
"""Landmarks in one picture: with more of them a model's downscaled picture shows none (section F.5, case 2)."""

LEAST = 12
"""Pixels of an object that gets a mark."""


def png(picture: Any) -> bytes:
    """Return a Pillow image as PNG."""
    stream = BytesIO()
    picture.save(stream, "PNG", compress_level=6)
    return stream.getvalue()


def label(drawing: Any, place: tuple[float, float], text: str, *, size: int = 14) -> None:
    """Draw a text in white on a black box, its upper left corner at `place`."""
    from PIL import ImageFont

    font = ImageFont.load_default(size)
    box = drawing.textbbox(place, text, font=font)
    drawing.rectangle((box[0] - 2, box[1] - 2, box[2] + 2, box[3] + 2), fill=(0, 0, 0))
    drawing.text(place, text, fill=(255, 255, 255), font=font)


def marked_view(
    rgb: npt.NDArray[np.uint8],
    segmentation: npt.NDArray[np.int32],
    names: Sequence[str],
    marks: Mapping[str, str],
) -> bytes:
    """Return a camera's picture with a number on each object of `marks` that it shows.

    Parameters
    ----------
    rgb, segmentation : arrays
        (height, width, 3) and (height, width); labels are indices into `names`.
    marks : mapping
        Id to number.
    """
    from PIL import Image, ImageDraw

    picture = Image.fromarray(rgb)
    drawing = ImageDraw.Draw(picture)
    numbers = {name: index for index, name in enumerate(names)}
    for name, mark in marks.items():
        rows, columns = np.nonzero(segmentation == numbers.get(name, -2))
        if len(rows) < LEAST:
            continue
        middle = int(np.argsort(columns, kind="stable")[len(columns) // 2])
        label(drawing, (float(columns[middle]) - 6, float(rows[middle]) - 8), mark)
    return png(picture)


def tiles(pictures: Sequence[tuple[str, npt.NDArray[np.uint8] | None]]) -> list[bytes]:
    """Return labelled pictures as pages of at most `PER_PAGE` tiles; a label without picture gets a grey tile."""
    from PIL import Image, ImageDraw

    pages = []
    for first in range(0, len(pictures), PER_PAGE):
        chunk = pictures[first : first + PER_PAGE]
        columns = min(3, len(chunk))
        page = Image.new(
            "RGB", (columns * TILE[0], ceil(len(chunk) / columns) * TILE[1]), (40, 40, 40)
        )
        drawing = ImageDraw.Draw(page)
        for k, (name, pixels) in enumerate(chunk):
            x, y = k % columns * TILE[0], k // columns * TILE[1]
            if pixels is not None:
                tile = Image.fromarray(pixels)
                tile.thumbnail((TILE[0] - 4, TILE[1] - 4))
                page.paste(tile, (x + 2, y + 2))
            label(drawing, (x + 6, y + 6), name, size=22)
        pages.append(png(page))
    return pages

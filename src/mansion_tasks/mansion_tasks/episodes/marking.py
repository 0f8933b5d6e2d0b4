"""Numbers drawn into the camera's picture: marks on the objects in view."""

from collections.abc import Mapping, Sequence
from io import BytesIO
from typing import Any

import numpy as np
import numpy.typing as npt

__all__ = ["marked_view", "png"]

LEAST = 12
"""Pixels of an object that gets a mark."""


def png(picture: Any) -> bytes:
    """Return a Pillow image as PNG."""
    stream = BytesIO()
    picture.save(stream, "PNG", compress_level=6)
    return stream.getvalue()


def _label(drawing: Any, place: tuple[float, float], text: str, *, size: int = 14) -> None:
    """Draw a text in white on a black box, its upper left corner at `place`."""
    from PIL import ImageFont

    font = ImageFont.load_default(size)
    box = drawing.textbbox(place, text, font=font)
    drawing.rectangle((box[0] - 2, box[1] - 2, box[2] + 2, box[3] + 2), fill=(0, 0, 0))
    drawing.text(place, text, fill=(255, 255, 255), font=font)


def marked_view(
    rgb: npt.NDArray[np.uint8], segmentation: npt.NDArray[np.int32], names: Sequence[str], marks: Mapping[str, str]
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
        column = int(np.sort(columns)[len(columns) // 2])
        row = int(np.median(rows[columns == column]))
        _label(drawing, (column - 8.0, row - 8.0), mark)
    return png(picture)

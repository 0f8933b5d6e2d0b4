"""Pictures of places as labelled tiles, so many a page that a model still sees what they show."""

from collections.abc import Sequence
from math import ceil, sqrt

import numpy as np

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_skills.vision.drawing import ACCENT, INK, PAPER, write
from mansion_skills.vision.frame import Picture

__all__ = ["MOST", "TILE", "tile_pages"]

TILE = (480, 280)
"""Width and height of a tile without its label, pixels."""

LABEL, GAP, TITLE = 40, 12, 48
"""Height of a label, space around tiles, height of the title; pixels."""

MOST = 16
"""Tiles a page: with more, models that scale pictures down to 768 pixels see less than 190 pixels of each."""


def tile_pages(entries: Sequence[tuple[str, Picture]], title: str, per_page: int = 9) -> list[Picture]:
    """Lay panoramas out as numbered, labelled tiles; each is folded into two halves of a round.

    The upper half looks along the panorama's middle, the lower one back.

    Parameters
    ----------
    entries : sequence of (str, (h, w, 3) array)
        Label and panorama.
    title : str
        Of all pages; each adds its number.
    per_page : int
        1 to 16.

    Returns
    -------
    list of (h, w, 3) arrays of uint8
        Numbers run on from page to page.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for a `per_page` out of its range.
    """
    if not 1 <= per_page <= MOST:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, f"{per_page} tiles a page; 1 to {MOST} stay legible", path="$.per_page"
        )
    pages = [entries[i : i + per_page] for i in range(0, len(entries), per_page)]
    columns = ceil(sqrt(min(per_page, len(entries)))) if entries else 1
    return [
        _page(
            page,
            number * per_page + 1,
            f"{title}, page {number + 1} of {len(pages)}" if len(pages) > 1 else title,
            columns,
        )
        for number, page in enumerate(pages)
    ]


def _page(entries: Sequence[tuple[str, Picture]], first: int, title: str, columns: int) -> Picture:
    from PIL import Image, ImageDraw

    rows = ceil(len(entries) / columns)
    step_x, step_y = TILE[0] + GAP, TILE[1] + LABEL + GAP
    sheet = Image.new("RGB", (columns * step_x + GAP, TITLE + rows * step_y), PAPER)
    draw = ImageDraw.Draw(sheet)
    write(draw, (GAP, TITLE / 2), title, 26, width=sheet.width - 2 * GAP)
    for i, (label, picture) in enumerate(entries):
        x, y = GAP + (i % columns) * step_x, TITLE + (i // columns) * step_y
        draw.rectangle((x, y, x + TILE[0] - 1, y + LABEL - 1), fill=INK)
        draw.rectangle((x, y, x + 52, y + LABEL - 1), fill=ACCENT)
        write(draw, (x + 26, y + LABEL / 2), str(first + i), 28, width=48, anchor="mm")
        write(draw, (x + 62, y + LABEL / 2), label, 26, width=TILE[0] - 70, fill=PAPER)
        # The upper half is the middle of the round: what the picture is of is not cut in two.
        half = picture.shape[1] // 2
        turned = np.roll(picture, -half // 2, axis=1)
        folded = np.vstack([turned[:, :half], turned[:, half:]])
        tile = Image.fromarray(folded).resize(TILE, Image.Resampling.LANCZOS)
        sheet.paste(tile, (x, y + LABEL))
    return np.array(sheet)

"""Pictures drawn for a model or a person to read: pages of panoramas, lift panels, and arrows over stairs."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil, sqrt
from typing import Any

import numpy as np

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_skills.vision.frame import Picture

__all__ = [
    "ACCENT",
    "Button",
    "DOWN",
    "INK",
    "MOST",
    "MUTED",
    "PAPER",
    "TILE",
    "UP",
    "fitted",
    "floor_title",
    "font",
    "panel_picture",
    "tile_pages",
    "with_arrows",
    "wrapped",
    "write",
]

PAPER, INK, MUTED = (250, 250, 248), (24, 28, 34), (150, 154, 160)
ACCENT, UP, DOWN = (255, 190, 60), (40, 165, 90), (225, 115, 35)

SMALLEST = 12
"""Least size of text, pixels; smaller is illegible."""

TILE = (480, 280)
"""Width and height of a tile without its label, pixels."""

LABEL, GAP, TITLE = 40, 12, 48
"""Height of a label, space around tiles, height of the title; pixels."""

MOST = 16
"""Tiles a page: with more, models that scale pictures down to 768 pixels see less than 190 pixels of each."""

STEEL, PLATE, DIM = (196, 200, 204), (232, 234, 236), (176, 180, 184)

ROWS = 6
"""Buttons above each other."""

CELL = (210, 84)
"""Width and height of a button with what is written beside it, pixels."""

HEAD = 104


def font(size: int) -> Any:
    """Return the font that comes with Pillow."""
    from PIL import ImageFont

    return ImageFont.load_default(size)


def fitted(text: str, width: float, size: int) -> tuple[str, Any]:
    """Return text and a font that fit a width: first a smaller font, then the text cut in its middle."""
    while size > SMALLEST and font(size).getlength(text) > width:
        size -= 1
    chosen = font(size)
    return _shortened(text, width, chosen), chosen


def _shortened(text: str, width: float, chosen: Any) -> str:
    """Cut out as much of a text's middle as makes it fit."""
    kept = text
    while len(kept) > 3 and chosen.getlength(text) > width:
        kept = kept[: len(kept) // 2] + kept[len(kept) // 2 + 1 :]
        text = f"{kept[: len(kept) // 2]}…{kept[len(kept) // 2 :]}"
    return text


def wrapped(text: str, width: float, size: int) -> list[str]:
    """Break text into rows that fit a width; a word that is wider loses its middle."""
    chosen = font(size)
    rows: list[str] = []
    for word in text.split():
        longer = f"{rows[-1]} {word}" if rows else word
        if rows and chosen.getlength(longer) <= width:
            rows[-1] = longer
        else:
            rows.append(_shortened(word, width, chosen))
    return rows or [""]


def write(
    draw: Any,
    at: tuple[float, float],
    text: str,
    size: int,
    *,
    width: float = float("inf"),
    fill: tuple[int, int, int] = INK,
    anchor: str = "lm",
) -> None:
    """Write a line of text, made to fit into a width."""
    shown, chosen = fitted(text, width, size)
    draw.text(at, shown, fill=fill, font=chosen, anchor=anchor)


def floor_title(floor: int, label: str) -> str:
    """Return a floor's number, with its label where that says something else."""
    return label if label == str(floor) else f"{floor} ({label})"


def tile_pages(entries: Sequence[tuple[str, Picture]], title: str, per_page: int = 9) -> list[Picture]:
    """Lay panoramas out as numbered, labelled tiles; each is folded into two halves of a round.

    The upper half looks along the panorama's middle, the lower one back.

    Parameters
    ----------
    entries : sequence of (str, (h, w, 3) array)
        Label and panorama.
    title : str
        Title of all pages; each adds its number.
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


@dataclass(frozen=True)
class Button:
    """A floor of the building; `served` where this lift stops."""

    floor: int
    label: str
    served: bool = True


def panel_picture(lift: str, buttons: Sequence[Button], current: int, view: Picture | None = None) -> Picture:
    """Draw a lift's panel: a button for each floor, the current one lit, those without a stop crossed out.

    Parameters
    ----------
    buttons : sequence of Button
        Any order; the highest floor is drawn uppermost.
    current : int
        Floor of the robot.
    view : (h, w, 3) array, optional
        What the camera sees of the lift; drawn to the left.
    """
    from PIL import Image, ImageDraw

    ordered = sorted(buttons, key=lambda button: -button.floor)
    columns = max(1, ceil(len(ordered) / ROWS))
    rows = ceil(len(ordered) / columns)
    width, height = max(columns * CELL[0] + 40, 420), HEAD + rows * CELL[1] + 30
    height = max(height, view.shape[0] if view is not None else 0)
    sheet = Image.new("RGB", (width, height), STEEL)
    draw = ImageDraw.Draw(sheet)
    draw.rounded_rectangle((10, 10, width - 11, height - 11), 18, fill=PLATE, outline=MUTED)
    here = next((b for b in ordered if b.floor == current), None)
    draw.rounded_rectangle((28, 24, width - 29, HEAD - 12), 8, fill=INK)
    text = f"at floor {current}" if here is None else f"at floor {floor_title(here.floor, here.label)}"
    write(draw, (width / 2, 46), text, 30, width=width - 80, fill=ACCENT, anchor="mm")
    write(draw, (width / 2, 76), lift, 18, width=width - 80, fill=PAPER, anchor="mm")
    for i, button in enumerate(ordered):
        # Down the columns, so that floors next to each other are above each other.
        column, row = i // rows, i % rows
        _button(draw, 30 + column * CELL[0], HEAD + row * CELL[1], button, current)
    panel = np.array(sheet)
    if view is None:
        return panel
    seen = Image.fromarray(view)
    seen = seen.resize((round(seen.width * height / seen.height), height), Image.Resampling.LANCZOS)
    return np.hstack([np.array(seen), panel])


def _button(draw: Any, x: float, y: float, button: Button, current: int) -> None:
    middle, radius = (x + 38, y + CELL[1] / 2), 34
    box = (middle[0] - radius, middle[1] - radius, middle[0] + radius, middle[1] + radius)
    lit = button.floor == current
    fill = ACCENT if lit else PAPER if button.served else DIM
    draw.ellipse(box, fill=fill, outline=INK if button.served else MUTED, width=3)
    ink = INK if button.served else MUTED
    write(draw, middle, button.label, 34, width=56, fill=ink, anchor="mm")
    note = "you are here" if lit else f"floor {button.floor}" if button.served else "no stop"
    write(draw, (x + 84, middle[1]), note, 20, width=CELL[0] - 94, fill=ink)
    if not button.served:
        draw.line((box[0] + 10, box[3] - 10, box[2] - 10, box[1] + 10), fill=MUTED, width=4)


def with_arrows(view: Picture, up: str | None, down: str | None) -> Picture:
    """Draw an arrow up and an arrow down, each with what is written below it; ``None`` where there is no way.

    Parameters
    ----------
    view : (h, w, 3) array of uint8
    up, down : str, optional
        ``Up to floor 3``, say.
    """
    from PIL import Image, ImageDraw

    picture = Image.fromarray(view).convert("RGBA")
    layer = Image.new("RGBA", picture.size, (0, 0, 0, 0))
    draw = ImageDraw.Draw(layer)
    width, height = picture.size
    for text, sign, x, color in ((up, -1, 0.3, UP), (down, 1, 0.7, DOWN)):
        if text is not None:
            _arrow(draw, (width * x, height * 0.62), height * 0.17, sign, color)
            band = (width * (x - 0.19), height * 0.83, width * (x + 0.19), height * 0.92)
            draw.rounded_rectangle(band, height * 0.02, fill=(*color, 235))
            middle = (width * x, height * 0.875)
            size = round(height * 0.055)
            write(draw, middle, text, size, width=width * 0.36, fill=PAPER, anchor="mm")
    return np.array(Image.alpha_composite(picture, layer).convert("RGB"))


def _arrow(draw: Any, middle: tuple[float, float], reach: float, sign: int, color: tuple[int, int, int]) -> None:
    """Draw an arrow that points up (`sign` -1) or down (1)."""
    x, y = middle
    shape = [(0, 1), (0.75, 0.15), (0.32, 0.15), (0.32, -1), (-0.32, -1), (-0.32, 0.15), (-0.75, 0.15)]
    points = [(x + reach * u, y + sign * reach * v) for u, v in shape]
    draw.polygon(points, fill=(*color, 225), outline=(*PAPER, 255), width=3)

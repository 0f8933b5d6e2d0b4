"""The button panel of a lift, as a picture."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil
from typing import Any

import numpy as np

from mansion_skills.vision.drawing import ACCENT, INK, MUTED, PAPER, floor_title, write
from mansion_skills.vision.frame import Picture

__all__ = ["Button", "panel_picture"]

STEEL, PLATE, DIM = (196, 200, 204), (232, 234, 236), (176, 180, 184)
ROWS = 6
"""Buttons above each other."""

CELL = (210, 84)
"""Width and height of a button with what is written beside it, pixels."""

HEAD = 104


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

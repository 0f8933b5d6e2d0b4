"""Text and colours of the pictures that are drawn for a model or a person to read."""

from typing import Any

__all__ = ["ACCENT", "DOWN", "INK", "MUTED", "PAPER", "UP", "fitted", "floor_title", "font", "wrapped", "write"]

PAPER, INK, MUTED = (250, 250, 248), (24, 28, 34), (150, 154, 160)
ACCENT, UP, DOWN = (255, 190, 60), (40, 165, 90), (225, 115, 35)

SMALLEST = 12
"""Pixels; smaller text cannot be read."""


def font(size: int) -> Any:
    """Return the font that comes with Pillow."""
    from PIL import ImageFont

    return ImageFont.load_default(size)


def fitted(text: str, width: float, size: int) -> tuple[str, Any]:
    """Return text and a font in which it is at most so wide: smaller, then cut in its middle."""
    while size > SMALLEST and font(size).getlength(text) > width:
        size -= 1
    chosen = font(size)
    return _shortened(text, width, chosen), chosen


def _shortened(text: str, width: float, chosen: Any) -> str:
    """Cut out as much of a text's middle as makes it fit."""
    whole = text
    while len(whole) > 3 and chosen.getlength(text) > width:
        whole = whole[: len(whole) // 2] + whole[len(whole) // 2 + 1 :]
        text = f"{whole[: len(whole) // 2]}…{whole[len(whole) // 2 :]}"
    return text


def wrapped(text: str, width: float, size: int) -> list[str]:
    """Break text into rows that are at most so wide; a word that is wider loses its middle."""
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

"""Words for colours."""

from typing import Final

__all__ = ["COLOURS", "COLOUR_WORDS", "colour_of"]

COLOURS: Final = (
    "white", "black", "grey", "red", "blue", "green", "yellow", "orange", "purple", "brown", "beige", "pink",
)  # fmt: skip
"""Colours as the names of materials have them; observations encode a colour as its position here."""

COLOUR_WORDS: Final = {
    **{name: name for name in COLOURS},
    "gray": "grey",
    "silver": "grey",
    "violet": "purple",
    "lilac": "purple",
    "navy": "blue",
    "azure": "blue",
    "scarlet": "red",
    "crimson": "red",
    "maroon": "red",
    "golden": "yellow",
    "tan": "beige",
    "cream": "beige",
}
"""Words for colours, and the name that materials have for each."""


def colour_of(material: str) -> str:
    """Return the colour in the name of a material, empty when it names none.

    Examples
    --------
    >>> colour_of("paint_red")
    'red'
    """
    return next((part for part in material.split("_") if part in COLOURS), "")

"""Words for colours."""

from typing import Final

__all__ = ["COLOURS", "SPOKEN_COLOURS"]

# fmt: off
COLOURS: Final = (
    "white", "black", "grey", "red", "blue", "green", "yellow", "orange", "purple", "brown", "beige", "pink",
)
"""Words that materials use for colours; what an agent observes are the places in this order."""

SPOKEN_COLOURS: Final = frozenset((
    *COLOURS,
    "gray", "violet", "silver", "gold", "golden", "cream", "turquoise", "teal", "navy", "maroon", "tan", "transparent",
))
"""Words that instructions use for colours."""
# fmt: on

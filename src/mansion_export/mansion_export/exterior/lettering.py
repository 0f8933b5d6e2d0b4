"""Capital letters as flat shapes: the strokes of a plain face without serifs, with breadth."""

from functools import cache
from typing import Final

import shapely
from shapely import affinity
from shapely.geometry import LineString, box
from shapely.geometry.base import BaseGeometry

__all__ = ["lettering"]

BREADTH: Final = 0.15
"""Width of a stroke, as a share of the height."""

ASPECT: Final = 0.62
"""Width of the grid on which letters are drawn over its height."""

SPACE: Final = 0.5
"""Between two words, as a share of the height."""

BETWEEN: Final = 0.3
"""From the middle of a letter's last stroke to that of the next one's first, as a share of the height."""

# The strokes of each letter; a stroke is a row of points, each its column (0 to 4) and its row (0 to 6, from below).
_STROKES: Final = {
    "A": "002640 1232",
    "B": "00063645443303 3342413000",
    "C": "4536160501103041",
    "D": "00062644422000",
    "E": "46060040 0333",
    "F": "460600 0333",
    "G": "45361605011030414323",
    "H": "0006 4046 0343",
    "I": "0006",
    "J": "4641301001",
    "K": "0006 460340",
    "L": "060040",
    "M": "0006234640",
    "N": "00064046",
    "O": "051636454130100105",
    "P": "00063645443303",
    "Q": "051636454130100105 2240",
    "R": "00063645443303 2340",
    "S": "453616050413334241301001",
    "T": "0646 2026",
    "U": "060110304146",
    "V": "062046",
    "W": "0610243046",
    "X": "0640 0046",
    "Y": "062346 2320",
    "Z": "06460040",
}


def lettering(text: str) -> BaseGeometry:
    """Return a text in capitals of height 1, its lower left corner at the origin; what is no letter is a blank.

    Examples
    --------
    >>> tuple(round(x, 2) for x in lettering("TO").bounds)
    (0.0, 0.0, 1.41, 1.0)
    """
    shapes, at = [], BREADTH / 2
    for letter in text.upper():
        if letter not in _STROKES:
            at += SPACE - BETWEEN
            continue
        shape, width = _letter(letter)
        shapes.append(affinity.translate(shape, at))
        at += width + BETWEEN
    return shapely.union_all(shapes)


@cache
def _letter(letter: str) -> tuple[BaseGeometry, float]:
    """Return the shape of a letter whose first stroke's middle is at 0, and how far its last one's lies from there."""
    rows = 1.0 - BREADTH
    strokes = [
        [(int(x) * ASPECT * rows / 4, BREADTH / 2 + int(y) * rows / 6) for x, y in zip(stroke[::2], stroke[1::2])]
        for stroke in _STROKES[letter].split()
    ]
    shape = shapely.union_all([LineString(points).buffer(BREADTH / 2, 2, cap_style="square") for points in strokes])
    return shape.intersection(box(-1.0, 0.0, 2.0, 1.0)), max(x for points in strokes for x, _ in points)

"""Flat faces of an asset that bear marks: letters, discs, lines and fields that stand out by a millimetre or two."""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Final

import numpy as np

from mansion_assets.convex import bounding_box
from mansion_assets.solids import Vec3, box_solid
from mansion_geometry.compiled import Floats

if TYPE_CHECKING:
    from mansion_assets.builder import Builder

__all__ = ["DrawnFace"]

Span = tuple[float, float]

_ROWS: Final = 5
"""Rows of dots of a letter."""

_LETTERS: Final = {
    "A": "010 101 111 101 101", "B": "110 101 110 101 110", "C": "011 100 100 100 011", "D": "110 101 101 101 110",
    "E": "111 100 110 100 111", "F": "111 100 110 100 100", "G": "011 100 101 101 011", "H": "101 101 111 101 101",
    "I": "1 1 1 1 1", "J": "001 001 001 101 010", "K": "101 101 110 101 101", "L": "100 100 100 100 111",
    "M": "10001 11011 10101 10001 10001", "N": "1001 1101 1011 1001 1001", "O": "010 101 101 101 010",
    "P": "110 101 110 100 100", "Q": "010 101 101 110 011", "R": "110 101 110 101 101", "S": "011 100 010 001 110",
    "T": "111 010 010 010 010", "U": "101 101 101 101 111", "V": "101 101 101 101 010",
    "W": "10001 10001 10101 11011 10001", "X": "101 101 010 101 101", "Y": "101 101 010 010 010",
    "Z": "111 001 010 100 111", "0": "111 101 101 101 111", "1": "01 11 01 01 01", "2": "111 001 111 100 111",
    "3": "111 001 011 001 111", "4": "101 101 111 001 001", "5": "111 100 111 001 111", "6": "111 100 111 101 111",
    "7": "111 001 001 010 010", "8": "111 101 111 101 111", "9": "111 101 111 001 111", ":": "0 1 0 1 0",
    "%": "101 001 010 100 101", "+": "000 010 111 010 000", "-": "000 000 111 000 000", " ": "00 00 00 00 00",
}  # fmt: skip
"""Dots of each letter, row by row from above."""


class DrawnFace:
    """A plane with a corner, a direction to the right and one upwards, as seen by somebody who looks at the face.

    Parameters
    ----------
    right, up : (float, float, float)
        Unit vectors at a right angle; the face looks along their cross product.
    """

    def __init__(self, b: "Builder", corner: Vec3, right: Vec3, up: Vec3) -> None:
        self._builder = b
        self._corner, self._right, self._up = np.array(corner), np.array(right), np.array(up)
        self._out = np.cross(self._right, self._up)

    @classmethod
    def front(cls, b: "Builder", y: float) -> "DrawnFace":
        """Return the face at `y` that looks to the front; from its middle at the floor, right is -x."""
        return cls(b, (0.0, y, 0.0), (-1.0, 0.0, 0.0), (0.0, 0.0, 1.0))

    @classmethod
    def side(cls, b: "Builder", x: float) -> "DrawnFace":
        """Return the face at `x` that looks along +x; from its middle at the floor, right is +y."""
        return cls(b, (x, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))

    @classmethod
    def top(cls, b: "Builder", z: float) -> "DrawnFace":
        """Return the face at `z` that looks upwards, read from the front: right is -x, up is -y."""
        return cls(b, (0.0, 0.0, z), (-1.0, 0.0, 0.0), (0.0, -1.0, 0.0))

    @classmethod
    def sloped(cls, b: "Builder", low: Span, high: Span) -> "DrawnFace":
        """Return the face between two level lines (y, z), read from the front, with its corner in the lower one."""
        rise = np.array([0.0, high[0] - low[0], high[1] - low[1]])
        rise /= np.linalg.norm(rise)
        return cls(b, (0.0, *low), (-1.0, 0.0, 0.0), (0.0, float(rise[1]), float(rise[2])))

    def at(self, u: float, v: float, out: float = 0.0) -> Vec3:
        """Return the point `u` to the right, `v` up and `out` before the face."""
        x, y, z = self._corner + u * self._right + v * self._up + out * self._out
        return float(x), float(y), float(z)

    def field(self, u: Span, v: Span, material: str, part: str = "print", depth: float = 0.002) -> None:
        """Add a rectangle that stands out by `depth`."""
        self._add([(u, v)], material, part, depth)

    def disc(
        self, u: float, v: float, r: float, material: str, part: str = "print", depth: float = 0.002, n: int = 18
    ) -> None:
        """Add a disc that stands out by `depth`."""
        self._builder.rod(self.at(u, v), self.at(u, v, depth), r, material, part, n)

    def line(self, points: Sequence[Span], r: float, material: str, part: str = "print", out: float = 0.0) -> None:
        """Add round bars of radius `r` along points of the face."""
        self._builder.path([self.at(u, v, out) for u, v in points], r, material, part)

    def write(self, text: str, u: Span, v: Span, material: str, part: str = "letters", depth: float = 0.002) -> None:
        """Add capitals and figures in the middle of a rectangle, as large as fits."""
        dots: list[tuple[int, int, int]] = []
        column = 0
        for letter in text:
            rows = _LETTERS[letter].split()
            dots += [
                (column + first, column + last, row) for row, bits in enumerate(rows) for first, last in _runs(bits)
            ]
            column += len(rows[0]) + 1
        dot = min((u[1] - u[0]) / (column - 1), (v[1] - v[0]) / _ROWS)
        left, top = (u[0] + u[1] - dot * (column - 1)) / 2, (v[0] + v[1] + dot * _ROWS) / 2
        fields = [
            ((left + first * dot, left + last * dot), (top - (row + 1) * dot, top - row * dot))
            for first, last, row in dots
        ]
        self._add(fields, material, part, depth)

    def _add(self, fields: Sequence[tuple[Span, Span]], material: str, part: str, depth: float) -> None:
        """Add rectangles as one body that collides."""
        turn = np.stack([self._right, self._up, self._out])
        vertices: list[Floats] = []
        faces = []
        for number, (u, v) in enumerate(fields):
            corners, triangles = box_solid(u, v, (-depth / 2, depth))
            vertices.append(corners @ turn + self._corner)
            faces.append(triangles + 8 * number)
        points = np.concatenate(vertices)
        body = bounding_box(points.min(axis=0), points.max(axis=0))
        self._builder.raw(points, np.concatenate(faces), material, part, bodies=[body])


def _runs(bits: str) -> list[tuple[int, int]]:
    """Return the runs of dots of a row, as their first column and the one after their last."""
    edges = [k for k in range(len(bits) + 1) if (bits[k : k + 1] == "1") != (k > 0 and bits[k - 1] == "1")]
    return list(zip(edges[::2], edges[1::2], strict=True))

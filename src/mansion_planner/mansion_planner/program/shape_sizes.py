"""The least area of a storey for an outline of a shape, such as an L, and how many storeys an area is enough for."""

__all__ = ["holds_shape", "least_area", "most_storeys"]

_LEAST = {"L": 104.0, "T": 170.0, "U": 300.0, "H": 380.0, "courtyard": 440.0}
_LEAST_WITHOUT_STAIR = {**_LEAST, "U": 190.0}


def least_area(shape: str, stairs: int) -> float:
    """Return the least gross area of a storey with an outline of a shape, square metres.

    Examples
    --------
    >>> least_area("U", 1), least_area("U", 0), least_area("rectangle", 0)
    (300.0, 190.0, 0.0)
    """
    return (_LEAST if stairs else _LEAST_WITHOUT_STAIR).get(shape, 0.0)


_SHORT = 0.02
"""Share by which an area may fall short of what a shape needs: outlines are in whole metres."""


def holds_shape(shape: str, area: float, stairs: int) -> bool:
    """Whether a storey of an area, square metres, is large enough for wings along a corridor in a shape."""
    return area >= (1.0 - _SHORT) * least_area(shape, stairs)


def most_storeys(shape: str, area: float, most: int) -> int:
    """Return over how many storeys, up to `most`, an area may be divided for each to have the shape; 1 at least.

    Examples
    --------
    >>> most_storeys("L", 170.0, 3), most_storeys("L", 400.0, 3), most_storeys("rectangle", 400.0, 9)
    (1, 3, 9)
    """
    least = least_area(shape, 1)
    return max(1, min(most, int(area / least))) if least else most

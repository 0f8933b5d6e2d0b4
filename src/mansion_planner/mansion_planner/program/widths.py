"""Widths of rooms side by side that are to keep a least width each."""

__all__ = ["widened"]


def widened(widths: list[float], least: list[float]) -> list[float]:
    """Raise widths to their least; those that have more to spare give it, in proportion.

    The sum stays; widths that cannot all have their least stay as they are.

    Examples
    --------
    >>> widened([1.0, 4.0], [1.5, 2.0])
    [1.5, 3.5]
    """
    need = sum(max(low - width, 0.0) for width, low in zip(widths, least))
    spare = sum(max(width - low, 0.0) for width, low in zip(widths, least))
    if need <= 0.0 or spare <= need:
        return widths
    return [low if width < low else width - (width - low) * need / spare for width, low in zip(widths, least)]

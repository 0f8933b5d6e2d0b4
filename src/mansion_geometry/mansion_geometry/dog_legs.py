"""Which dog-leg stair fits a core: risers, goings and landings.

Steps follow the rule of F. Blondel (Cours d'architecture, 1675), two risers and a going of about 0.63 m, with risers
of 0.15 to 0.19 m.
"""

from typing import Final

__all__ = ["FLIGHT_WELL", "MAX_RISER", "MIN_RISER", "dog_leg", "landing_depth"]

MIN_RISER: Final = 0.15
MAX_RISER: Final = 0.19
FLIGHT_WELL: Final = 0.12
"""Metres between the two flights."""

_GOINGS: Final = (0.30, 0.29, 0.28, 0.27, 0.26, 0.25, 0.24, 0.23, 0.22)
_COMFORT: Final = 0.63
_WIDE: Final = 1.0
"""Metres from which a flight is one of a public building (DIN 18065:2015, table 1)."""
_DEEP: Final = 0.26
"""Least going of such a flight, metres; it comes before the most comfortable sum."""
_MIN_FLIGHT: Final = 0.75


def landing_depth(length: float) -> float:
    """Return the depth of the floor landing of a stair that is `length` metres long inside its walls.

    It depends on the core alone, so that it is the same on every floor.
    """
    return min(max(0.24 * length, 0.9), 1.6)


def dog_leg(length: float, width: float, height: float) -> tuple[int, float] | None:
    """Return risers and going of the most comfortable dog-leg that fits, if one does.

    Steps of flights from 1.0 m on are at least 0.26 m deep where the core is long enough.

    Parameters
    ----------
    length, width : float
        Length and width of the core inside its walls, along and across the flights, metres.
    height : float
        Height of the storey, metres.

    Examples
    --------
    >>> dog_leg(5.88, 2.88, 3.3), dog_leg(3.0, 1.0, 3.0)
    ((20, 0.3), None)
    """
    flight = (width - FLIGHT_WELL) / 2
    if flight < _MIN_FLIGHT:
        return None
    best: tuple[bool, float, int, float] | None = None
    for risers in _even_risers(height):
        for going in _GOINGS:
            half_landing = length - landing_depth(length) - (risers // 2 - 1) * going
            if half_landing < min(flight, 1.2) - 0.05:
                continue
            discomfort = abs(2 * height / risers + going - _COMFORT)
            shallow = flight >= _WIDE and going < _DEEP - 1e-9
            if best is None or (shallow, discomfort) < (best[0], best[1] - 1e-9):
                best = shallow, discomfort, risers, going
    return best[2:] if best is not None else None


def _even_risers(height: float) -> list[int]:
    counts = [n for n in range(4, 200, 2) if MIN_RISER - 1e-9 <= height / n <= MAX_RISER + 1e-9]
    return sorted(counts, key=lambda n: (abs(height / n - 0.17), n))

"""Intervals for rates and means of few episodes."""

from collections.abc import Sequence
from math import sqrt

import numpy as np

__all__ = ["bootstrap_interval", "wilson_interval"]

Z = 1.959963984540054
"""Of the normal distribution, for 95%."""


def wilson_interval(successes: int, trials: int) -> tuple[float, float]:
    """Return the 95% score interval of a rate (Wilson, 1927).

    Examples
    --------
    >>> low, high = wilson_interval(10, 10)
    >>> round(low, 3), high
    (0.722, 1.0)
    """
    if trials == 0:
        return 0.0, 1.0
    rate, square = successes / trials, Z * Z / trials
    middle = rate + square / 2
    half = Z * sqrt(rate * (1 - rate) / trials + square / (4 * trials))
    low, high = (middle - half) / (1 + square), (middle + half) / (1 + square)
    return (0.0 if successes == 0 else low), (1.0 if successes == trials else high)


def bootstrap_interval(values: Sequence[float], *, resamples: int = 1000, seed: int = 0) -> tuple[float, float]:
    """Return the 95% percentile interval of a mean, from resamples with replacement.

    Examples
    --------
    >>> bootstrap_interval([0.5, 0.5, 0.5])
    (0.5, 0.5)
    """
    if not values:
        return 0.0, 0.0
    data = np.asarray(values, dtype=float)
    picks = np.random.default_rng(seed).integers(len(data), size=(resamples, len(data)))
    low, high = np.percentile(data[picks].mean(axis=1), [2.5, 97.5])
    return float(low), float(high)

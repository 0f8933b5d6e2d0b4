"""Arrays are kept up to a number of bytes."""

import numpy as np

from mansion_export.pictures.texture_sampling import ArrayCache
from mansion_geometry.compiled import Floats


def array(number: int) -> Floats:
    """An array of 800 bytes."""
    return np.full(100, float(number))


def test_an_array_is_made_once() -> None:
    cache = ArrayCache(most=8_000)
    made = cache.get("a", lambda: array(1))
    assert cache.get("a", lambda: array(2)) is made


def test_the_memory_of_any_number_of_arrays_is_bounded() -> None:
    cache = ArrayCache(most=8_000)
    for number in range(1_000):
        assert cache.get(number, lambda number=number: array(number))[0] == number  # type: ignore[misc]
        assert cache.size <= 8_000
    assert cache.size == 8_000


def test_what_was_used_longest_ago_goes_first() -> None:
    cache = ArrayCache(most=1_600)
    first, second = cache.get("first", lambda: array(1)), cache.get("second", lambda: array(2))
    assert cache.get("first", lambda: array(0)) is first
    cache.get("third", lambda: array(3))
    assert cache.get("first", lambda: array(0)) is first
    assert cache.get("second", lambda: array(0)) is not second


def test_the_latest_array_stays_however_large_it_is() -> None:
    cache = ArrayCache(most=100)
    made = cache.get("large", lambda: array(1))
    assert cache.get("large", lambda: array(2)) is made
    cache.get("larger", lambda: np.zeros(1_000))
    assert cache.size == 8_000

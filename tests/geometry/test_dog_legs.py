"""Stairs with a turn fit their cores, or there are none."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from mansion_geometry.dog_legs import MAX_RISER, MIN_RISER, dog_leg, landing_depth


@pytest.mark.parametrize(
    ("length", "width", "height", "fit"),
    [(5.88, 2.88, 3.3, (20, 0.3)), (3.88, 1.88, 3.0, (16, 0.26)), (3.88, 1.5, 3.0, None), (2.4, 1.88, 3.0, None)],
)
def test_sizes(length: float, width: float, height: float, fit: tuple[int, float] | None) -> None:
    assert dog_leg(length, width, height) == fit


@given(st.floats(2.5, 8.0), st.floats(1.5, 4.0), st.floats(2.4, 4.5))
def test_flights_and_landings_fill_no_more_than_the_core(length: float, width: float, height: float) -> None:
    fit = dog_leg(length, width, height)
    if fit is not None:
        risers, going = fit
        assert MIN_RISER - 1e-6 <= height / risers <= MAX_RISER + 1e-6
        assert landing_depth(length) + (risers // 2 - 1) * going < length


@pytest.mark.parametrize("height", [3.0, 3.2, 3.4, 3.6, 3.8, 4.0, 4.2])
def test_steps_of_public_stairs_are_deep_enough_at_every_usual_height(height: float) -> None:
    fit = dog_leg(5.88, 2.88, height)
    assert fit is not None
    assert fit[1] >= 0.26


def test_a_wide_stair_in_a_short_core_keeps_the_steps_that_fit() -> None:
    fit = dog_leg(4.4, 2.88, 3.6)
    assert fit is not None
    assert fit[1] < 0.26

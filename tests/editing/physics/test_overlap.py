"""The depth of one box in another."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from mansion_editing.physics.thor_engine import OrientedBox, depth, upright

UNIT = upright((0.0, 0.0, 0.0), (1.0, 1.0, 1.0), 0.0)
SIZES = st.floats(0.05, 2.0)
PLACES = st.floats(-1.5, 1.5)
TURNS = st.floats(0.0, 360.0)
BOXES = st.builds(upright, st.tuples(PLACES, PLACES, PLACES), st.tuples(SIZES, SIZES, SIZES), TURNS)


@pytest.mark.parametrize(
    ("x", "turn", "expected"),
    [(0.9, 0.0, 0.1), (1.0, 0.0, 0.0), (1.3, 0.0, 0.0), (1.2, 45.0, 0.5 + np.sqrt(0.5) - 1.2), (1.21, 45.0, 0.0)],
)
def test_depth_is_the_way_out(x: float, turn: float, expected: float) -> None:
    other = upright((x, 0.0, 0.0), (1.0, 1.0, 1.0), turn)
    assert depth(UNIT, other) == pytest.approx(expected, abs=1e-9)


def test_edges_that_cross_are_apart_though_all_shadows_on_the_faces_meet() -> None:
    def tilted(axis: int, center: tuple[float, float, float]) -> OrientedBox:
        c = s = np.sqrt(0.5)
        turn = np.array([[1, 0, 0], [0, c, -s], [0, s, c]])
        if axis == 1:
            turn = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
        return OrientedBox(center, (1.0, 1.0, 1.0), turn)

    reach = np.sqrt(0.5)
    low, high = tilted(0, (0.0, 0.0, 0.0)), tilted(1, (0.0, 0.0, 2 * reach + 0.01))
    assert depth(low, high) == 0.0
    assert depth(low, tilted(1, (0.0, 0.0, 2 * reach - 0.01))) == pytest.approx(0.01, abs=1e-9)


@given(one=BOXES, other=BOXES)
@settings(max_examples=60, deadline=None)
def test_both_are_as_deep_in_each_other_and_a_move_by_the_depth_frees_them(
    one: OrientedBox, other: OrientedBox
) -> None:
    found = depth(one, other)
    assert found == pytest.approx(depth(other, one), abs=1e-9)
    gaps = [
        depth(one, other._replace(center=tuple(np.array(other.center) + sign * found * axis)))
        for axis in (*one.axes.T, *other.axes.T)
        for sign in (-1.0, 1.0)
    ]
    assert min(gaps) < 1e-6

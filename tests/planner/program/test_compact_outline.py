"""L-shaped homes that are too small for wings get an outline of two short arms, and keep their area."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from shapely.geometry import Polygon

from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building
from mansion_planner.program.compact_outline import compact_l


def planned(description: str, **fields: float) -> tuple[Polygon, list[str]]:
    """The outline of the ground floor, and what gave way."""
    reply = plan_building(BuildRequest(description=description, seed=5, **fields))  # type: ignore[arg-type]
    return Polygon(reply.program.floors[0].outline), [downgrade.wish for downgrade in reply.program.downgrades]


@given(area=st.floats(48.0, 140.0), seed=st.integers(0, 2**40), step=st.sampled_from([0.5, 1.0]))
def test_an_outline_has_six_corners_the_area_and_arms_that_rooms_fit_in(area: float, seed: int, step: float) -> None:
    outline = compact_l(area, seed, step)
    assert outline.is_valid
    assert outline.exterior.is_ccw
    assert len(outline.exterior.coords) - 1 == 6
    assert outline.area == pytest.approx(area, rel=0.05)
    assert all(value % step == 0.0 for corner in outline.exterior.coords for value in corner)
    assert outline.bounds[:2] == pytest.approx((0.0, 0.0))
    assert not outline.buffer(-1.7).is_empty
    assert isinstance(outline.buffer(-1.7), Polygon)
    assert 0.68 < outline.area / (outline.bounds[2] * outline.bounds[3]) < 0.85


@pytest.mark.parametrize("area", [55.0, 64.0, 88.0])
def test_a_small_flat_is_l_shaped_where_the_brief_says_so(area: float) -> None:
    outline, given_up = planned("An L-shaped flat with one bedroom.", floor_area=area)
    assert len(outline.exterior.coords) - 1 == 6
    assert outline.area == pytest.approx(area, rel=0.05)
    assert given_up == []


def test_a_small_duplex_is_l_shaped_around_its_stair() -> None:
    outline, given_up = planned("An L-shaped duplex of two floors with two bedrooms.", floors=2, floor_area=72.0)
    assert len(outline.exterior.coords) - 1 == 6
    assert given_up == []


def test_what_is_too_small_for_two_arms_stays_a_rectangle_and_says_so() -> None:
    outline, given_up = planned("An L-shaped studio flat of 30 m2.")
    assert len(outline.exterior.coords) - 1 == 4
    assert given_up == ["L outline"]


def test_seeds_give_different_outlines() -> None:
    assert len({compact_l(70.0, seed).wkt for seed in range(20)}) > 15

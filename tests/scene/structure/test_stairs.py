"""Stairs that fit their core and meet the next floor."""

from types import ModuleType

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely.geometry import LineString, Polygon, box

from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.program import CorePlan
from mansion_msgs_py.scene import StairDetails
from mansion_scene.structure import build_structure
from mansion_scene.structure.stairs import landing_zone, stair_details, stair_frame

OUTLINE = box(0, 0, 20, 20)
SIDES = ["north", "south", "east", "west", None]


def details_of(side=None, height=3.2, size=(3.0, 6.0), up=True, below=True) -> StairDetails:
    core = CorePlan(id="stair_1", type="stair", x=(0, size[0]), y=(0, size[1]), door_side=side)
    net = box(0.0, 0.0, size[0] - 0.06, size[1] - 0.06)
    return stair_details("stair_1", stair_frame(core, net, OUTLINE), height, goes_up=up, comes_from_below=below)


@settings(max_examples=60, deadline=None)
@given(st.floats(3.0, 4.2), st.sampled_from(SIDES), st.booleans())
def test_risers_are_comfortable_and_climb_a_storey_in_walking_order(
    height: float, side: str | None, turned: bool
) -> None:
    size = (6.0, 3.0) if turned else (3.0, 6.0)
    stair = details_of(side, height, size)
    assert 0.15 <= stair.riser <= 0.19
    assert stair.risers * stair.riser == pytest.approx(height, abs=0.01)
    assert 0.22 <= stair.going <= 0.30
    half = len(stair.treads) // 2
    levels = [tread[1][2] for tread in stair.treads]
    levels.insert(half, stair.landings[0][1][2])
    rises = np.diff([0.0, *levels, height])
    assert np.allclose(rises, stair.riser, atol=2e-3)


@settings(max_examples=40, deadline=None)
@given(st.floats(3.0, 4.2), st.sampled_from(SIDES), st.booleans())
def test_flights_lie_inside_the_core_and_off_the_floor_landing(height: float, side: str | None, turned: bool) -> None:
    size = (6.0, 3.0) if turned else (3.0, 6.0)
    stair = details_of(side, height, size)
    core, landing = box(0, 0, *size).buffer(1e-6), Polygon(stair.floor_landing)
    opening = Polygon(stair.ceiling_opening)
    steps = [box(*low[:2], *high[:2]) for low, high in (*stair.treads, *stair.landings)]
    for index, step in enumerate(steps):
        assert core.covers(step)
        assert step.intersection(landing).area < 1e-6
        assert opening.buffer(1e-3).covers(step)
        assert all(step.intersection(other).area < 1e-6 for other in steps[:index])
    assert min(stair.width, landing.area / size[turned]) > 0.9


def test_the_first_and_the_last_step_touch_the_floor_landing() -> None:
    stair = details_of("south")
    landing = Polygon(stair.floor_landing)
    for low, high in (stair.treads[0], stair.treads[-1]):
        assert box(*low[:2], *high[:2]).distance(landing) < 1e-6


def test_flights_of_different_storeys_meet_at_the_same_landing() -> None:
    assert details_of("south", 3.0).floor_landing == details_of("south", 4.2).floor_landing


def test_the_top_floor_has_an_opening_and_no_flight() -> None:
    top = details_of(up=False)
    assert top.treads == [] and top.risers == 0 and top.ceiling_opening == []
    assert top.floor_opening != [] and top.rails != []
    ground = details_of(below=False)
    assert ground.floor_opening == [] and ground.ceiling_opening != []


def test_a_small_core_still_takes_a_house_stair() -> None:
    stair = details_of("south", 3.0, (2.0, 4.0))
    assert 0.15 <= stair.riser <= 0.19 and stair.width >= 0.75


def test_a_core_that_is_too_small_is_refused_with_what_would_do() -> None:
    with pytest.raises(MansionError, match="3 x 6 m"):
        details_of("south", 3.2, (1.4, 3.0))


def test_the_door_of_a_stair_opens_on_to_its_landing(sample_floors: ModuleType) -> None:
    request = sample_floors.office(2)
    structure = build_structure(request)
    core = next(core for core in structure.cores if core.id == "stair_1")
    door = next(door for door in structure.doors if door.id == core.door)
    zone = landing_zone(request.connectivity.cores[0], box(0, 0, 20, 14))
    assert zone.buffer(0.01).covers(LineString(door.segment))

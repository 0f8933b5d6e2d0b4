"""Stairs land at the same end on every floor."""

import pytest
from hypothesis import given
from hypothesis import strategies as st
from shapely.geometry import box

from mansion_geometry.stair_landings import landing_end, with_landings
from mansion_msgs_py.program import AreaSummary, BuildingProgram, CorePlan, FloorProgram, VerticalConnectivity
from mansion_msgs_py.shapes import CompassSide


def core(door: CompassSide | None, width: float = 3.0, depth: float = 6.0) -> CorePlan:
    return CorePlan(id="stair_1", type="stair", x=(4.0, 4.0 + width), y=(0.0, depth), door_side=door)


@pytest.mark.parametrize("door", ["south", "north"])
def test_a_door_at_a_short_side_has_the_landing_behind_it(door: CompassSide) -> None:
    assert landing_end(core(door), box(0, 0, 7, 9)) == door


@pytest.mark.parametrize("door", ["west", "east", None])
def test_otherwise_the_landing_lies_deeper_in_the_building(door: CompassSide | None) -> None:
    assert landing_end(core(door), box(0, 0, 7, 9)) == "north"
    assert landing_end(core(door), box(0, -9, 7, 6)) == "south"


@given(st.lists(st.floats(6.0, 20.0), min_size=1, max_size=5))
def test_floors_of_any_depths_share_the_end_that_their_common_outline_has(depths: list[float]) -> None:
    floors = [
        FloorProgram(
            index=number, requirement="", gross_floor_area=7.0 * depth, rooms=[],
            area_summary=AreaSummary(sum_rooms=0.0, reserve_ratio=0.0, fits_within_gfa=True),
            outline=[(0.0, 0.0), (7.0, 0.0), (7.0, depth), (0.0, depth)],
        )
        for number, depth in enumerate(depths, 1)
    ]  # fmt: skip
    vertical = VerticalConnectivity(method="stair", cores=[core("west")])
    program = with_landings(
        BuildingProgram(building_id="b", reasoning="", vertical_connectivity=vertical, floors=floors)
    )
    assert [c.landing for c in program.vertical_connectivity.cores] == [
        landing_end(core("west"), box(0.0, 0.0, 7.0, min(depths)))
    ]

"""Upper storeys of houses are as long as their rooms need, and rooms are no strips where other depths do."""

import pytest

from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building

VILLA = "A Mediterranean villa with a pool, four bedrooms, an open kitchen and a garage for two cars"


def areas(brief: str) -> list[float]:
    """Return the gross areas of the storeys from the ground up, square metres."""
    return [floor.gross_floor_area for floor in plan_building(BuildRequest(description=brief)).program.floors]


def test_the_upper_storey_of_a_villa_is_shorter_than_the_one_with_the_pool() -> None:
    ground, upper = areas(VILLA)
    assert upper < 0.75 * ground
    trace = plan_building(BuildRequest(description=VILLA)).program.trace
    assert any("shorter: their rooms need no more" in entry.effect for entry in trace)


@pytest.mark.parametrize("more", [" of 540 m2 in all", ", 270 m2 per floor", ", L-shaped", ", both floors the same"])
def test_what_the_brief_says_of_areas_or_outline_holds_for_all_storeys(more: str) -> None:
    ground, upper = areas(VILLA.replace("villa", "two-storey villa") + more)
    assert upper == pytest.approx(ground, rel=0.02)


def test_an_office_is_not_set_back() -> None:
    found = areas("A three-storey office with a cafeteria of 200 m2 on the ground floor")
    assert max(found) == pytest.approx(min(found))

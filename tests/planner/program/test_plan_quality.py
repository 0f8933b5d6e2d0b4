"""Storeys are filled with rooms of about the sizes that their kinds have, whatever is asked for."""

import pytest

from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.program.building import PlannedBuilding, plan_program
from mansion_planner.program.model import box_area
from mansion_planner.program.plan_quality import swollen_rooms


def planned(text: str, **fields: float) -> PlannedBuilding:
    request, knowledge = BuildRequest(description=text, **fields), default_knowledge()  # type: ignore[arg-type]
    return plan_program(request, read_brief(text, knowledge), knowledge, "b", item_generator(request.seed, "program"))


def circulation(building: PlannedBuilding, storey: int) -> float:
    """Return the share of a storey's floor that corridors take."""
    sketch = building.sketches[storey]
    corridors = sum(box_area(box) for corridor in sketch.corridors for box in corridor.boxes)
    return corridors / (corridors + sum(placement.area for placement in sketch.rooms))


@pytest.mark.parametrize("area", [150.0, 173.0, 200.0])
def test_a_large_room_leaves_a_small_storey_place_for_others(area: float) -> None:
    building = planned("a modern office for fifteen people", floors=2, floor_area=area)
    kinds = {placement.room.kind.name for placement in building.sketches[2].rooms}
    assert {"open_office", "meeting_room", "restroom"} <= kinds
    assert circulation(building, 2) < 0.3


def test_a_storey_that_is_one_room_is_no_corridor() -> None:
    building = planned(
        "a lifeboat station of two storeys: a boat hall of 210 m2, and at the top nothing but the lookout"
    )
    assert [placement.room.id for placement in building.sketches[2].rooms] == ["lookout"]
    assert circulation(building, 2) < 0.3


@pytest.mark.parametrize("text", ["a two-storey factory of 600 m2", "a two-storey warehouse of 900 m2 with an office"])
def test_offices_above_a_hall_line_a_corridor(text: str) -> None:
    building = planned(text)
    assert building.massing.hall
    assert circulation(building, 2) < 0.25


@pytest.mark.parametrize(
    "text",
    [
        "a maisonette on two floors with three bedrooms",
        "a supermarket of 600 m2",
        "a restaurant with a bar, a kitchen, a staff room and toilets",
        "a two-storey factory of 600 m2",
    ],
)
def test_no_room_fills_a_place_far_too_large_for_it(text: str) -> None:
    building = planned(text)
    assert [p.room.id for sketch in building.sketches.values() for p in swollen_rooms(sketch)] == []


def test_a_room_alone_in_a_large_place_is_swollen() -> None:
    building = planned("a maisonette on two floors with three bedrooms")
    (bathroom, *_) = [p for p in building.sketches[2].rooms if p.room.kind.name == "bathroom"]
    bathroom.boxes[:] = [(0.0, 0.0, 6.0, 6.0)]
    assert swollen_rooms(building.sketches[2]) == [bathroom]


def test_a_program_never_plans_more_than_its_floor_has() -> None:
    building = planned(
        "a blood donation centre with a 145 m2 recording studio, six commercial kitchens, a 130 m2 quality control "
        "and an art room",
        floor_area=316.0,
    )
    (floor,) = building.program.floors
    assert floor.area_summary.fits_within_gfa
    assert sum(room.area_estimate for room in floor.rooms) <= floor.gross_floor_area + 0.1

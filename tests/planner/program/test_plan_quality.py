"""Storeys are filled with rooms of about the usual sizes, and homes have no long halls and no slender rooms."""

from dataclasses import replace

import pytest

from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.program.building import PlannedBuilding, plan_program
from mansion_planner.program.model import Box, Corridor, Placement, Sketch, Storey, box_area
from mansion_planner.program.plan_quality import home_faults, is_shallow_bay, swollen_rooms
from mansion_planner.program.planned_rooms import planned_room


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


KNOWLEDGE = default_knowledge()


def storey() -> Storey:
    request = BuildRequest(description="a bungalow")
    facts = read_brief(request.description, KNOWLEDGE)
    return plan_program(request, facts, KNOWLEDGE, "b", item_generator(0, "program")).storeys[0]


def faults(rooms: dict[str, Box], hall: Box = (0.0, 4.0, 10.0, 5.0), area: float = 90.0) -> float:
    placed = [Placement(planned_room(KNOWLEDGE.room(name), KNOWLEDGE), [box], "hallway") for name, box in rooms.items()]
    sketch = Sketch([Corridor("hallway", [hall], "")], placed, {})
    return home_faults([(replace(storey(), rooms=()), sketch, area)])


def test_a_kitchen_by_the_living_room_is_no_fault_and_one_apart_is() -> None:
    together = {"kitchen": (0.0, 0.0, 4.0, 4.0), "living_room": (4.0, 0.0, 10.0, 4.0)}
    apart = {"kitchen": (0.0, 0.0, 4.0, 4.0), "bedroom": (4.0, 0.0, 7.5, 4.0), "living_room": (0.0, 5.0, 6.0, 9.0)}
    assert faults(together) == 0.0
    assert faults(apart) > 0.0


def test_a_hall_above_its_share_and_a_slender_bedroom_are_faults() -> None:
    assert faults({"bedroom": (0.0, 0.0, 4.0, 4.0)}, hall=(0.0, 4.0, 10.0, 6.0)) > 0.0
    assert faults({"bedroom": (0.0, 0.0, 2.0, 5.0)}) > faults({"bedroom": (0.0, 0.0, 3.0, 4.0)}) == 0.0


def test_a_long_living_room_that_other_rooms_line_is_a_fault() -> None:
    def lined(hub: Box) -> float:
        living = replace(storey(), rooms=(), hub=KNOWLEDGE.room("living_room"))
        return home_faults([(living, Sketch([Corridor("living_room", [hub], "")], [], {}), 80.0)])

    assert lined((0.0, 0.0, 16.0, 2.3)) > lined((0.0, 0.0, 9.0, 3.5)) > lined((0.0, 0.0, 6.0, 4.0)) == 0.0


@pytest.mark.parametrize(
    "text",
    [
        "A fire station with an apparatus bay for three engines, gear room, dormitory, kitchen, gym and an office.",
        "A two-storey fire station with a bay for two engines, a gear room, and upstairs a dormitory and kitchen.",
    ],
)
def test_engines_stand_behind_their_doors(text: str) -> None:
    building = planned(text)
    assert not is_shallow_bay(building.storeys[0], building.sketches[1])

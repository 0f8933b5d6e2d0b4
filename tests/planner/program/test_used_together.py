"""Rooms that people use together are planned side by side, and halls stay whole."""

import pytest

from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building
from mansion_planner.program.building import PlannedBuilding, plan_program
from mansion_planner.program.model import Placement, touching
from mansion_planner.program.plan_quality import carved


def planned(text: str) -> PlannedBuilding:
    knowledge = default_knowledge()
    request = BuildRequest(description=text)
    return plan_program(request, read_brief(text, knowledge), knowledge, "b", item_generator(0, "program"))


def ground(text: str) -> list[Placement]:
    return planned(text).sketches[1].rooms


@pytest.mark.parametrize(
    ("text", "one", "other"),
    [
        ("an office of 600 m2 on one floor with a canteen, three offices and two meeting rooms", "canteen", "kitchen"),
        ("a small vet practice with an operating theatre, a prep room, two consult rooms and a waiting room",
         "prep_room", "operating_theatre"),
        ("an institute on one floor, 500 m2: two laboratories, a clean room, a gowning room, six offices, a library",
         "clean_room", "gowning_room"),
    ],
)  # fmt: skip
def test_rooms_that_are_used_together_share_a_wall(text: str, one: str, other: str) -> None:
    rooms = ground(text)
    firsts, seconds = ([p for p in rooms if name in p.room.id] for name in (one, other))
    assert any(touching(a, b) for a in firsts for b in seconds)


def test_a_store_beside_a_hall_that_closes_the_bar_reaches_its_wall() -> None:
    text = (
        "A community centre of 480 m2 on one storey: hall 200 m2 with a stage and 120 chairs, chair store beside the "
        "hall, kitchen 35 m2, foyer 50 m2, café 40 m2, toilets"
    )
    rooms = ground(text)
    (store,) = [p for p in rooms if p.room.id == "chair_store"]
    (hall,) = [p for p in rooms if p.room.id == "hall"]
    assert touching(store, hall) and not carved(planned(text).sketches[1])


def test_a_stage_without_a_size_is_furniture_of_its_hall() -> None:
    program = plan_building(BuildRequest(description="a community centre with a hall of 200 m2 with a stage")).program
    rooms = [room for floor in program.floors for room in floor.rooms]
    assert not any(room.room_type == "stage" for room in rooms)
    assert any(wanted.category == "stage" for room in rooms for wanted in room.objects)


def test_toilets_without_a_number_are_planned_for_the_people_of_the_building() -> None:
    text = "A community centre of 480 m2 on one storey: hall 200 m2 with 120 chairs, café, toilets"
    program = plan_building(BuildRequest(description=text)).program
    kinds = [room.room_type for room in program.floors[0].rooms]
    assert kinds.count("restroom") == 2 and "toilet" not in kinds and "accessible_toilet" in kinds


def test_toilets_that_are_counted_stay() -> None:
    text = "A community centre of 480 m2 on one storey: hall 200 m2 with 120 chairs, café, two toilets"
    program = plan_building(BuildRequest(description=text)).program
    kinds = [room.room_type for room in program.floors[0].rooms]
    assert kinds.count("toilet") == 2 and "restroom" not in kinds


def test_what_the_rooms_leave_goes_to_the_foyer() -> None:
    text = (
        "Indoor swimming baths on one storey, 600 m2: pool hall 250 m2, two changing rooms of 30 m2, two shower "
        "rooms of 15 m2, plant room 50 m2, a ticket desk"
    )
    building = planned(text)
    assert building.storeys[0].foyer > 1.0


def test_the_desks_that_a_brief_counts_are_not_given_to_the_employees_again() -> None:
    text = "An office for 45 employees on three floors; each has an open-plan office of 120 m2 with 15 desks"
    program = plan_building(BuildRequest(description=text)).program
    counts = [wanted.count for floor in program.floors for room in floor.rooms for wanted in room.objects]
    assert counts and max(counts) == 15


def test_showers_are_with_the_changing_rooms_that_they_belong_to() -> None:
    text = "A swimming pool on one storey, 900 m2: pool hall 400 m2, two changing rooms of 40 m2, two shower rooms"
    rooms = ground(text)
    showers, changing = ([p for p in rooms if p.room.kind.name == kind] for kind in ("shower_area", "changing_room"))
    assert len(showers) == 2
    assert any(touching(a, b) for a in showers for b in changing)

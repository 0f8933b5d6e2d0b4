"""Rooms off others are entered from these, and rooms that people pass between lie side by side."""

import pytest

from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge, is_class
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


def parents(text: str) -> dict[str, str]:
    return {p.room.id: p.parent for sketch in planned(text).sketches.values() for p in sketch.rooms}


@pytest.mark.parametrize(
    ("text", "inner", "outer"),
    [
        ("a house with a balcony off the master bedroom", "balcony", "master_bedroom"),
        ("a house with a pantry off the kitchen", "pantry", "kitchen"),
        ("a clinic with a store room off the treatment room", "store_room", "treatment_room"),
        ("a two-storey house with a terrace off the living room", "terrace", "living_room"),
    ],
)
def test_a_room_off_another_is_entered_from_it(text: str, inner: str, outer: str) -> None:
    assert parents(text)[inner] == outer
    edges = [e for topology in plan_building(BuildRequest(description=text)).topologies for e in topology.edges]
    assert [(e.source, e.kind) for e in edges if e.target == inner] == [(outer, "access")]


def test_rooms_that_only_lie_side_by_side_are_reached_from_the_corridor() -> None:
    assert parents("a clinic with a store room next to the treatment room")["store_room"] != "treatment_room"


@pytest.mark.parametrize(
    ("text", "kind", "most"),
    [
        ("a two-bedroom flat with a balcony", "balcony_room", 16.0),
        ("a house with a patio", "terrace", 40.0),
        ("a cafe with a terrace", "terrace", 40.0),
    ],
)
def test_a_balcony_or_terrace_is_outdoors_and_in_scale(text: str, kind: str, most: float) -> None:
    found = [p for sketch in planned(text).sketches.values() for p in sketch.rooms if p.room.kind.name == kind]
    assert len(found) == 1
    assert is_class(kind, "outdoor")
    assert found[0].area <= most


def test_a_terrace_lies_on_the_ground_and_a_roof_terrace_on_top() -> None:
    storeys = {
        text: [
            index for index, sketch in planned(text).sketches.items() for p in sketch.rooms if "terrace" in p.room.id
        ]
        for text in ("a three-storey hotel with a terrace", "a three-storey hotel with a roof terrace")
    }
    assert list(storeys.values()) == [[1], [3]]


@pytest.mark.parametrize("text", ["a duplex with a roof garden", "a house with a roof terrace"])
def test_a_roof_terrace_of_a_home_leaves_place_for_what_it_tops(text: str) -> None:
    found = [p for sketch in planned(text).sketches.values() for p in sketch.rooms]
    assert sum(p.area for p in found if p.room.kind.name == "roof_terrace") <= 55.0
    assert any("bedroom" in p.room.kind.name for p in found)


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


def test_nobody_passes_through_a_changing_room_to_a_cell() -> None:
    of = parents("a police station with four holding cells, locker rooms, two offices and a briefing room")
    cells = [outer for inner, outer in of.items() if inner.startswith("holding_cell")]
    assert cells
    assert not any(outer.startswith("locker_room") for outer in cells)

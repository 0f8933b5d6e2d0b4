"""Where the rooms of public buildings lie: by the entrance, among those that they serve, at the end of the bar."""

import pytest

from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.program.building import PlannedBuilding, plan_program
from mansion_planner.program.model import Placement, touching
from mansion_planner.program.plan_quality import crosswise, fill


def planned(text: str, seed: int = 5) -> PlannedBuilding:
    request, knowledge = BuildRequest(description=text, seed=seed), default_knowledge()
    return plan_program(request, read_brief(text, knowledge), knowledge, "b", item_generator(seed, "program"))


def named(building: PlannedBuilding, floor: int, kind: str) -> list[Placement]:
    return [placement for placement in building.sketches[floor].rooms if placement.room.kind.name == kind]


def begin(placement: Placement) -> float:
    return min(box[0] for box in placement.boxes)


@pytest.mark.parametrize(
    ("brief", "kind"),
    [
        ("a two-storey art museum with five galleries, a gift shop near the entrance and an elevator", "shop"),
        ("a two-storey art museum with five galleries and a gift shop", "ticket_office"),
        ("a town hall with a council chamber, a service counter and offices on the second floor", "service_counter"),
        ("a two-storey hostel with eight dormitories, a shared kitchen and a lounge", "reception"),
    ],
)
def test_what_visitors_come_to_first_lies_by_the_entrance(brief: str, kind: str) -> None:
    building = planned(brief)
    (room,) = named(building, 1, kind)
    assert begin(room) < 0.5 * building.massing.length


@pytest.mark.parametrize("seed", [0, 5])
def test_a_nurse_station_lies_among_its_patients(seed: int) -> None:
    building = planned("a hospital ward with eight patient rooms, a nurse station in the middle", seed)
    (station,) = named(building, 1, "nurse_station")
    patients = [begin(room) for room in named(building, 1, "patient_room")]
    assert min(patients) < begin(station) < max(patients)


@pytest.mark.parametrize("seed", [0, 5])
def test_two_audiences_close_the_bar_lengthwise(seed: int) -> None:
    building = planned("a small cinema with two screening rooms, a ticket counter and a popcorn stand", seed)
    halls = named(building, 1, "cinema_hall")
    assert len(halls) == 2 and touching(*halls)
    assert crosswise(building.sketches[1]) == []


def test_a_gym_has_a_wing_beyond_both_stairs() -> None:
    building = planned("a primary school with six classrooms, a gym hall and a staff room")
    (gym,) = named(building, 1, "sports_hall")
    ground = building.storeys[0]
    assert ground.hall_wing and begin(gym) == building.massing.length
    passages = {corridor.id for corridor in building.sketches[1].corridors}
    assert all(parent in passages for parent in building.sketches[1].core_parent.values())
    assert building.envelopes[1].area > building.envelopes[2].area


def test_a_hall_fills_the_ground_floor_that_has_little_else() -> None:
    building = planned("a two-storey hotel with 12 rooms and a ballroom")
    assert not any(storey.hall_wing for storey in building.storeys)


@pytest.mark.parametrize("brief", ["a fitness gym with a weights area and a yoga studio", "a one-storey town hall"])
def test_accessible_toilets_are_not_cut_from_rooms_of_use_as_rectangles(brief: str) -> None:
    building = planned(brief)
    for sketch in building.sketches.values():
        assert all(fill(p.boxes) > 0.97 for p in sketch.rooms if p.room.kind.whole)


def test_men_and_women_have_restrooms_of_like_size() -> None:
    building = planned("a small cinema with two screening rooms")
    rooms = {p.room.base: p.room.area for p in building.sketches[1].rooms if p.room.kind.name == "restroom"}
    assert rooms["womens_restroom"] <= 1.5 * rooms["mens_restroom"]


def test_a_building_of_several_storeys_has_no_wings_that_nobody_asked_for() -> None:
    assert not any(planned("a three-storey office building", seed).massing.wings for seed in range(6))


def test_a_bath_lies_in_the_front_corner_of_a_narrow_guest_room() -> None:
    building = planned("a three-storey hotel with ten rooms on each upper floor")
    massing, inner = building.massing, 0
    for bath in named(building, 2, "bathroom"):
        inner += all(box[1] > 0.01 and box[3] < massing.depth - 0.01 for box in bath.boxes)
    assert inner == len(named(building, 2, "bathroom")) > 0


def test_a_garage_that_is_the_hall_leaves_a_place_for_the_second_stair() -> None:
    building = planned(
        "a fire station with a garage for two trucks and sleeping quarters for eight firefighters upstairs"
    )
    assert sum(core.type == "stair" for core in building.massing.cores) == 2

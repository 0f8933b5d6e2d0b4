"""What the sketches of public buildings do for the rules of building."""

import pytest

from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building
from mansion_planner.program.blocks import needs_outer_wall
from mansion_planner.program.building import PlannedBuilding, plan_program
from mansion_planner.program.massing import Massing
from mansion_planner.program.model import Placement, Sketch, short_edges
from mansion_planner.solver import SolverOptions
from mansion_planner.solver.grid import major_lines
from mansion_planner.solver.problem import make_model
from mansion_planner.solver.starts import planned_partition


def planned(text: str, seed: int = 0) -> PlannedBuilding:
    request, knowledge = BuildRequest(description=text, seed=seed), default_knowledge()
    return plan_program(request, read_brief(text, knowledge), knowledge, "b", item_generator(seed, "program"))


def named(sketch: Sketch, kind: str) -> list[Placement]:
    return [placement for placement in sketch.rooms if placement.room.kind.name == kind]


def is_outside(placement: Placement, massing: Massing) -> bool:
    sides = [(box[0], massing.length - box[2], box[1], massing.depth - box[3]) for box in placement.boxes]
    return any(min(abs(distance) for distance in side) < 0.01 for side in sides)


@pytest.mark.parametrize(
    "brief", ["a two-storey call center", "a factory", "a train station", "a car dealership", "a two-storey library"]
)
def test_rooms_that_must_have_a_window_reach_an_outer_wall(brief: str) -> None:
    building = planned(brief)
    for sketch in building.sketches.values():
        for placement in sketch.rooms:
            if needs_outer_wall(placement.room.kind):
                assert is_outside(placement, building.massing), placement.room.id


@pytest.mark.parametrize(
    ("brief", "seed"), [("a two-storey casino", 0), ("a two-storey casino", 1), ("a two-storey museum", 0)]
)
def test_a_lift_stands_at_the_corridor_where_a_lobby_would_be_a_long_dead_end(brief: str, seed: int) -> None:
    building = planned(brief, seed)
    massing, sketch = building.massing, building.sketches[2]
    (lift,) = [core.box for core in massing.cores if core.type == "elevator"]
    assert massing.south > 6.1 and lift[3] == pytest.approx(massing.south)
    mains = [corridor.boxes[0] for corridor in sketch.corridors]
    assert all(box[1] >= massing.south - 0.001 for box in mains)
    behind = [placement for placement in sketch.rooms if (0.0, 0.0, lift[2], lift[1]) in placement.boxes]
    assert len(behind) == 1 and not short_edges(sketch)


def test_a_lift_has_a_lobby_where_dead_ends_may_be_longer_and_where_one_exit_is_enough() -> None:
    for brief in ("a four-storey office building", "a two-storey house with an elevator"):
        lifts = [core.box for core in planned(brief).massing.cores if core.type == "elevator"]
        assert lifts and all(box[1] == 0.0 for box in lifts)


@pytest.mark.parametrize(
    ("brief", "kind", "through"),
    [
        ("a restaurant", "cold_storage", "commercial_kitchen"),
        ("a supermarket", "loading_dock", "stock_room"),
        ("a two-storey police station", "holding_cell", "security_room"),
        ("a three-storey courthouse", "holding_cell", "security_room"),
        ("a two-storey bank", "vault", "security_room"),
    ],
)
def test_stores_and_cells_do_not_open_to_the_public_hall(brief: str, kind: str, through: str) -> None:
    sketch = planned(brief).sketches[1]
    found = {placement.parent.rstrip("_0123456789") for placement in named(sketch, kind)}
    assert found == {through}


def test_a_store_that_the_brief_wants_beside_another_room_is_reached_as_before() -> None:
    sketch = planned("a restaurant with the cold storage next to the bar").sketches[1]
    assert [placement.parent for placement in named(sketch, "cold_storage")] == ["restaurant"]


def test_a_canteen_has_a_kitchen_unless_the_brief_refuses_one() -> None:
    brief = "a two-storey office with a cafeteria on the ground floor"
    assert named(planned(brief).sketches[1], "commercial_kitchen")
    assert not named(planned(f"{brief} and no kitchen").sketches[1], "commercial_kitchen")


@pytest.mark.parametrize("seed", [0, 2, 4])
def test_no_more_than_one_room_lies_between_a_restaurant_and_its_kitchen(seed: int) -> None:
    sketch = planned("a four-storey hotel", seed).sketches[1]
    parents = {named(sketch, kind)[0].parent for kind in ("restaurant", "commercial_kitchen")}
    assert len(parents) == 1


@pytest.mark.parametrize(("brief", "floor"), [("a two-storey fire station", 1), ("a three-storey office building", 2)])
def test_men_and_women_have_toilets_of_their_own_on_each_storey_of_many(brief: str, floor: int) -> None:
    ids = {placement.room.id for placement in planned(brief).sketches[floor].rooms}
    assert {"mens_restroom", "womens_restroom"} <= ids


def test_the_ground_floor_has_the_toilets_that_the_storeys_above_lack() -> None:
    def share(brief: str) -> float:
        sketch = planned(brief).sketches[1]
        return sum(room.area for room in named(sketch, "restroom")) / sum(room.area for room in sketch.rooms)

    assert share("a three-storey theatre") > share("a theatre with one floor")


def test_a_hostel_has_toilets_and_showers_for_its_beds() -> None:
    sketch = planned("a three-storey hostel").sketches[2]
    sleepers = 8 * len(named(sketch, "hostel_dorm"))
    assert named(sketch, "restroom")[0].area >= 5.0 * sleepers / 10
    assert named(sketch, "shower_area")[0].area >= 2.6 * sleepers / 8


@pytest.mark.parametrize("brief", ["a three-storey parking garage", "a sports center"])
def test_halls_of_many_people_have_a_stair_at_both_ends(brief: str) -> None:
    building = planned(brief)
    stairs = [core.box for core in building.massing.cores if core.type == "stair"]
    assert len(stairs) == 2 and stairs[1][2] == building.massing.length
    assert all(not short_edges(sketch) for sketch in building.sketches.values())


def test_the_stair_at_the_far_end_may_stand_in_the_corner_of_a_hall() -> None:
    sketches = [planned("a sports center", seed).sketches[1] for seed in range(5)]
    closed = [sketch for sketch in sketches if sketch.core_parent["stair_2"] == "sports_hall"]
    assert closed
    for sketch in closed:
        (hall,) = named(sketch, "sports_hall")
        assert len(hall.boxes) == 2 and not short_edges(sketch)


def test_a_parking_garage_is_for_cars() -> None:
    sketch = planned("a three-storey parking garage").sketches[2]
    whole = sum(corridor.area for corridor in sketch.corridors) + sum(placement.area for placement in sketch.rooms)
    assert sketch.corridors[0].area > 0.8 * whole


@pytest.mark.parametrize(
    "brief",
    ["a two-storey fire station", "a two-storey police station", "a sports center", "a three-storey parking garage"],
)
def test_the_solver_takes_the_sketches_as_they_are(brief: str) -> None:
    for problem in plan_building(BuildRequest(description=brief)).problems:
        model = make_model(problem, SolverOptions())
        assert planned_partition(model, major_lines(model)) is not None


@pytest.mark.parametrize("seed", [1, 2])
def test_guests_of_a_hotel_have_a_window_whatever_the_depth_of_the_plan(seed: int) -> None:
    building = planned("a four-storey hotel", seed)
    for sketch in building.sketches.values():
        assert all(is_outside(p, building.massing) for p in sketch.rooms if p.room.kind.name == "hotel_room")

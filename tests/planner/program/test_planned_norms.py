"""What the planner does for the rules of building, and where the brief comes before them."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.program import BuildingProgram
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building
from mansion_planner.program.massing import corridor_width


def planned(brief: str) -> BuildingProgram:
    return plan_building(BuildRequest(description=brief, seed=1)).program


def toilets(brief: str, floor: int = 1) -> list[str]:
    storey = next(storey for storey in planned(brief).floors if storey.index == floor)
    kinds = ("restroom", "toilet", "accessible_toilet")
    return sorted(room.id for room in storey.rooms if room.room_type in kinds)


@pytest.mark.parametrize("brief", ["a restaurant", "a library", "a mosque", "a school"])
def test_many_occupants_have_toilets_for_men_for_women_and_for_wheelchairs(brief: str) -> None:
    assert toilets(brief) == ["accessible_toilet", "mens_restroom", "womens_restroom"]


def test_a_shop_without_a_toilet_in_its_list_has_one_for_everybody() -> None:
    assert toilets("a bakery") == ["accessible_toilet"]


@pytest.mark.parametrize("seed", [1, 2])
def test_people_are_counted_in_rooms_as_large_as_they_are_drawn(seed: int) -> None:
    [floor] = plan_building(BuildRequest(description="a post office", seed=seed)).program.floors
    assert sum(room.room_type in ("restroom", "accessible_toilet") for room in floor.rooms) >= 2


def test_a_long_corridor_without_a_room_for_visitors_at_its_end_leads_out_there() -> None:
    reply = plan_building(BuildRequest(description="a car workshop", seed=1))
    corridor = next(node for node in reply.problems[0].nodes if node.id == "corridor_1")
    assert corridor.seed_box is not None
    xs, ys = zip(*reply.program.floors[0].outline)
    ends = (*corridor.seed_box.x, *corridor.seed_box.y)
    assert any(end == pytest.approx(edge) for end, edge in zip(ends, (min(xs), max(xs), min(ys), max(ys))))


def test_toilets_of_the_brief_stay_as_they_are() -> None:
    assert toilets("a restaurant with one restroom") == ["restroom"]
    counted = toilets("a library with four restrooms on the ground floor")
    assert not {"mens_restroom", "accessible_toilet"} & set(counted)


def test_a_dwelling_has_no_public_toilets() -> None:
    assert not {"mens_restroom", "accessible_toilet"} & set(toilets("a house"))


@pytest.mark.parametrize(
    ("brief", "method"),
    [
        ("a two-storey museum", "stair_and_elevator"),
        ("a two-storey museum without an elevator", "stair"),
        ("a two-storey office", "stair"),
        ("a two-storey house", "stair"),
    ],
)
def test_public_buildings_of_two_storeys_have_a_lift_unless_the_brief_refuses_it(brief: str, method: str) -> None:
    assert planned(brief).vertical_connectivity.method == method


def test_a_small_cafe_has_two_toilets_for_everybody_in_which_a_wheelchair_turns() -> None:
    assert toilets("a cafe") == ["accessible_toilet_1", "accessible_toilet_2"]


@pytest.mark.parametrize("brief", ["a pharmacy", "a bakery"])
@pytest.mark.parametrize("seed", [0, 1])
def test_the_main_room_of_a_shop_leaves_place_for_a_toilet(brief: str, seed: int) -> None:
    floor = plan_building(BuildRequest(description=brief, seed=seed)).program.floors[0]
    areas = {room.room_type: room.area_estimate for room in floor.rooms}
    assert areas["accessible_toilet"] >= 3.5
    assert areas["sales_area"] <= 0.7 * floor.gross_floor_area


@pytest.mark.parametrize("brief", ["a cafe", "a restaurant", "a swimming center", "a community center", "a factory"])
def test_an_accessible_toilet_is_as_wide_as_the_rules_ask(brief: str) -> None:
    problem = plan_building(BuildRequest(description=brief, seed=0)).problems[0]
    boxes = [node.seed_box for node in problem.nodes if node.room_type == "accessible_toilet"]
    assert boxes
    for box in boxes:
        assert box is not None
        sides = sorted((box.x[1] - box.x[0], box.y[1] - box.y[0]))
        assert sides[0] >= 1.5 + 0.12
        assert sides[1] >= 2.2 + 0.12


@pytest.mark.parametrize("brief", ["a data center", "a spa", "a town hall"])
def test_an_accessible_toilet_beside_a_side_passage_is_no_narrower(brief: str) -> None:
    problem = plan_building(BuildRequest(description=brief, seed=2)).problems[0]
    boxes = [node.seed_box for node in problem.nodes if node.room_type == "accessible_toilet" and node.seed_box]
    assert boxes
    assert all(min(box.x[1] - box.x[0], box.y[1] - box.y[0]) >= 1.5 + 0.12 for box in boxes)


def test_beds_pass_in_the_corridors_of_a_hospital() -> None:
    assert corridor_width(default_knowledge().buildings["hospital"], 460.0) >= 2.438 + 0.12
    assert corridor_width(default_knowledge().buildings["office"], 460.0) == 2.0

"""What the planner does for the rules of building, and where the brief comes before them."""

import pytest

from mansion_msgs_py.program import BuildingProgram
from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


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

"""Rooms shared out over storeys: what a brief counts or refuses leaves no place for its like."""

import pytest

from mansion_msgs_py.request import BuildRequest
from mansion_planner.plan import plan_building


def types(brief: str) -> list[str]:
    program = plan_building(BuildRequest(description=brief)).program
    return [room.room_type for floor in program.floors for room in floor.rooms]


def test_who_wants_no_cafeteria_gets_no_cafe_either() -> None:
    assert "cafe" in types("A museum of two floors")
    assert not {"cafe", "cafeteria", "restaurant"} & set(types("A museum of two floors. We do not want cafeteria."))


def test_counted_bathrooms_leave_no_room_for_other_toilets() -> None:
    found = types("A language school on one floor of 290 m2 with 4 classrooms and 2 bathrooms")
    assert (found.count("restroom"), {"bathroom", "toilet"} & set(found)) == (2, set())


def test_rooms_that_others_have_for_themselves_are_not_added_again() -> None:
    found = types("A courthouse of two storeys with two courtrooms, each with its own judge's chamber")
    assert found.count("judges_chamber") == 2


@pytest.mark.parametrize(
    ("brief", "kind", "count"),
    [
        ("A kindergarten with three group rooms, each with a nap room.", "nap_room", 3),
        ("A one-storey hotel with four guest rooms, each with a bathroom, and a sauna.", "sauna", 1),
    ],
)
def test_rooms_that_each_of_a_group_has_are_not_added_to(brief: str, kind: str, count: int) -> None:
    assert types(brief).count(kind) == count


def test_a_brewery_with_offices_of_its_own_has_no_office_floor() -> None:
    assert "open_office" not in types("A brewery of two storeys, 700 m2, with a brewing hall, a cold store and offices")


def storeys_of(brief: str, *kinds: str) -> set[int]:
    program = plan_building(BuildRequest(description=brief)).program
    return {floor.index for floor in program.floors for room in floor.rooms if room.room_type in kinds}


@pytest.mark.parametrize(
    "brief",
    [
        "A two-storey primary school of 1,600 m2 with eight classrooms, a canteen, a kitchen and a gym",
        "Spa hotel with three storeys: restaurant with kitchen, bar, sauna, pool and eighteen double rooms",
        "Nursing home on two levels, 1,600 m2, with a dining room, a commercial kitchen and a physiotherapy room",
    ],
)
def test_a_kitchen_is_on_the_storey_of_those_who_eat(brief: str) -> None:
    tables = storeys_of(brief, "cafeteria", "restaurant", "dining_room")
    assert tables
    assert storeys_of(brief, "commercial_kitchen") == tables


def test_a_kitchen_follows_a_restaurant_that_the_brief_puts_upstairs() -> None:
    brief = "A four-storey hotel of 1,600 m2 with a kitchen, and a restaurant on the top floor"
    assert storeys_of(brief, "restaurant") == {4}
    assert 4 in storeys_of(brief, "commercial_kitchen")


@pytest.mark.parametrize(
    ("brief", "kind"),
    [
        ("A four-storey hotel with thirty rooms, a restaurant and a bar", "restaurant"),
        ("A small brewery of two storeys, 700 m2, with offices, a cold store and a brewing hall", "production_hall"),
        ("A two-storey furniture store of 1,000 m2 with a showroom, offices and a stock room", "stock_room"),
        ("A wellness hotel of three storeys with twenty rooms, a bar, a gym and a pool", "indoor_pool"),
        ("A house of two storeys with three bedrooms and a wine cellar", "wine_cellar"),
    ],
)
def test_what_guests_goods_and_weights_come_to_lies_on_the_ground(brief: str, kind: str) -> None:
    assert storeys_of(brief, kind) == {1}


@pytest.mark.parametrize(
    "brief",
    [
        "A school of three storeys with boys' and girls' toilets.",
        "A gym of two storeys with changing rooms for men and women.",
    ],
)
def test_rooms_for_both_sexes_lie_on_one_storey(brief: str) -> None:
    floors = plan_building(BuildRequest(description=brief)).program.floors
    users = {"boy", "girl", "man", "woman"}
    assert [len({room.id.split("_")[0] for room in floor.rooms} & users) for floor in floors if floor.index == 1] == [2]


def test_the_pupils_of_a_school_are_no_men_and_women() -> None:
    program = plan_building(BuildRequest(description="A school of two storeys with toilets on each floor")).program
    names = {room.name for floor in program.floors for room in floor.rooms if room.room_type == "restroom"}
    assert names == {"boys' toilets", "girls' toilets"}

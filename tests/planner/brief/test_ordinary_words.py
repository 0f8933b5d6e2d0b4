"""Ordinary words that are no rooms, or other rooms than they seem, in the building that they are said of."""

import pytest

from mansion_knowledge import default_knowledge
from mansion_msgs_py.program import RoomProgram
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief import read_brief
from mansion_planner.plan import plan_building


def rooms(brief: str) -> list[RoomProgram]:
    program = plan_building(BuildRequest(description=brief)).program
    return [room for floor in program.floors for room in floor.rooms]


@pytest.mark.parametrize(
    "brief",
    [
        "a church with a nave, a sacristy and a bell tower",
        "a castle hotel with two round towers",
        "a town hall with a lobby, offices and a clock tower",
    ],
)
def test_a_building_with_a_tower_is_no_high_rise(brief: str) -> None:
    assert "high_rise" not in [name for name, _ in read_brief(brief, default_knowledge()).size]


@pytest.mark.parametrize("brief", ["an office tower", "a residential tower", "a slim tower with offices"])
def test_a_building_that_is_a_tower_is_a_high_rise(brief: str) -> None:
    assert "high_rise" in [name for name, _ in read_brief(brief, default_knowledge()).size]


def test_aisles_of_a_shop_are_no_rooms() -> None:
    found = rooms("a supermarket with a bakery, a fish counter and ten aisles")
    assert not any("aisle" in room.id for room in found)


def test_the_stations_of_a_hairdresser_are_chairs() -> None:
    facts = read_brief("a hair salon with six stations and a waiting area", default_knowledge())
    assert [(thing.category, thing.count) for thing in facts.objects] == [("salon_chair", 6)]
    assert not any(room.name == "station" for room in facts.rooms)


def test_the_stalls_of_a_food_court_sell_food() -> None:
    found = rooms("a food court with six stalls")
    assert [room.room_type for room in found].count("food_stall") == 6
    assert not any(room.room_type == "stable" for room in found)


def test_the_stalls_of_a_stable_are_for_horses() -> None:
    assert [room.room_type for room in rooms("a stable with six stalls")].count("food_stall") == 0


def test_a_seating_area_is_a_place_to_sit() -> None:
    kinds = {room.room_type for room in rooms("a laundromat with 20 washing machines and a seating area")}
    assert "lounge" in kinds


@pytest.mark.parametrize(
    ("brief", "kind", "count"),
    [
        ("a monastery with 12 cells and a chapel", "dorm_room", 12),
        ("a film studio with two make-up rooms", "dressing_room", 2),
        ("an optician with an eye test room", "consultation_room", 1),
        ("an escape room venue with four themed rooms", "game_room", 4),
    ],
)
def test_rooms_of_a_trade_are_of_its_kind(brief: str, kind: str, count: int) -> None:
    assert [room.room_type for room in rooms(brief)].count(kind) == count


@pytest.mark.parametrize(("brief", "most"), [("an arcade with a snack bar", 320.0), ("a container home", 60.0)])
def test_small_buildings_are_small(brief: str, most: float) -> None:
    program = plan_building(BuildRequest(description=brief)).program
    assert len(program.floors) == 1
    assert program.floors[0].gross_floor_area <= most


def test_a_bar_that_is_all_there_is_is_no_house() -> None:
    assert (
        plan_building(BuildRequest(description="a bar with a stage and a pool table")).program.building_type
        == "bar_building"
    )


def test_a_loft_of_a_home_is_a_room_below_the_roof() -> None:
    kinds = [room.room_type for room in rooms("a cabin with a loft and a sauna")]
    assert "attic" in kinds
    assert "apartment" not in kinds


def test_a_shop_with_an_apartment_above_is_no_mall() -> None:
    program = plan_building(
        BuildRequest(description="a building with a shop downstairs and an apartment upstairs")
    ).program
    assert program.building_type == "shop_building"


def test_a_cafeteria_that_is_the_building_is_for_guests() -> None:
    kinds = {room.room_type for room in rooms("a school cafeteria with kitchen and seating for 150 students")}
    assert {"restaurant", "commercial_kitchen"} <= kinds
    assert not {"bedroom", "living_room"} & kinds


@pytest.mark.parametrize(
    ("brief", "kind"),
    [("a car repair workshop with three service bays", "car_workshop_building"), ("a food court", "food_hall")],
)
def test_a_building_called_by_a_plain_noun_is_known(brief: str, kind: str) -> None:
    facts = read_brief(brief, default_knowledge())
    assert facts.building[0][0] == kind


@pytest.mark.parametrize(
    "brief",
    ["an office floor of 400 m2 with 20 cubicles", "Design a school floor with four classrooms", "a hotel floor"],
)
def test_a_floor_of_a_building_is_one_storey(brief: str) -> None:
    assert len(plan_building(BuildRequest(description=brief)).program.floors) == 1


def test_a_yard_that_a_room_looks_into_is_no_outline() -> None:
    looked_into = read_brief("a flat with a bedroom facing the courtyard", default_knowledge())
    built_around = read_brief("a house around a courtyard", default_knowledge())
    assert (looked_into.shapes, [shape for shape, _ in built_around.shapes]) == ([], ["courtyard"])


@pytest.mark.parametrize(
    "brief", ["a ground-floor flat with a patio", "a top-floor flat with two bedrooms", "a second-floor apartment"]
)
def test_a_flat_on_some_storey_is_a_flat_and_no_building_around_it(brief: str) -> None:
    program = plan_building(BuildRequest(description=brief)).program
    assert len(program.floors) == 1
    assert not any(room.room_type == "apartment" for room in program.floors[0].rooms)


@pytest.mark.parametrize("brief", ["a flat of 55 m2 with a separate toilet", "a flat of 40 m2 with a pantry"])
def test_a_small_flat_has_a_place_to_sleep(brief: str) -> None:
    assert "bedroom" in {room.room_type for room in rooms(brief)}


def test_rooms_are_numbered_in_words_as_in_digits() -> None:
    facts = read_brief("Bungalow: bedroom one 16 m2, bedroom two 12 m2, bathroom 7 m2", default_knowledge())
    assert [(room.name, room.area) for room in facts.rooms] == [
        ("bedroom_1", 16.0),
        ("bedroom_2", 12.0),
        ("bathroom", 7.0),
    ]


def test_bathrooms_that_are_counted_after_several_bedrooms_are_for_all() -> None:
    together = read_brief("Upstairs five bedrooms of 9 m2 each, with two bathrooms", default_knowledge())
    each = read_brief("Five suites each with two bathrooms", default_knowledge())
    assert [(room.name, room.count) for room in together.rooms] == [("bedroom", 5), ("bathroom", 2)]
    assert [(room.name, room.count) for room in each.rooms[0].suite] == [("bathroom", 2)]


def test_a_total_that_is_too_small_for_several_rooms_is_of_each() -> None:
    facts = read_brief("A music school with twelve practice rooms of 10 m2 in total", default_knowledge())
    assert (facts.rooms[0].count, facts.rooms[0].area, facts.area) == (12, 10.0, [])


def test_a_room_beside_a_two_car_garage_is_quoted_in_the_order_of_the_text() -> None:
    text = "A house with a mudroom next to the two-car garage"
    program = plan_building(BuildRequest(description=text)).program
    assert all(wish.span[0] <= wish.span[1] for wish in program.wishes)
    assert "double_garage" in {room.room_type for floor in program.floors for room in floor.rooms}


@pytest.mark.parametrize(
    ("brief", "below"),
    [
        ("A mansion with a basement with a pool, a sauna and a cinema with 12 seats", ["pool", "sauna", "cinema"]),
        ("A house with two floors and a basement with a laundry, a store and a gym.", ["laundry", "store", "gym"]),
        ("A house with a basement with a laundry, three bedrooms and a garage", ["laundry"]),
    ],
)
def test_a_basement_holds_what_is_listed_after_it_and_may_lie_there(brief: str, below: list[str]) -> None:
    facts = read_brief(brief, default_knowledge())
    assert [room.name for room in facts.rooms if any(ref.kind == "basement" for ref in room.floors)] == below

"""Rooms that have another type's furniture because of their building or their name."""

import pytest

from mansion_knowledge.furnished_as import furnished_as


@pytest.mark.parametrize(
    ("room_type", "building_type", "name", "expected"),
    [
        ("treatment_room", "dental_clinic", "treatment room", "dental_room"),
        ("treatment_room", "hospital", "treatment room", "treatment_room"),
        ("gym", "school", "gym", "sports_hall"),
        ("gym", "gym_building", "gym", "gym"),
        ("workshop", "car_dealership", "repair workshop", "car_workshop"),
        ("vip_room", "restaurant", "Private dining room", "private_dining_room"),
        ("vip_room", "casino", "vip room", "vip_room"),
        ("prayer_hall", "church", "", "chapel"),
        ("prayer_hall", "mosque", "", "prayer_hall"),
        ("prayer_hall", "hospital", "chapel", "chapel"),
        ("cold_storage", "funeral_home", "cold room", "morgue"),
        ("cold_storage", "restaurant", "cold room", "cold_storage"),
        ("kitchen", "nursing_home", "living-kitchen", "living_kitchen"),
        ("nap_room", "fire_station", "nap room", "on_call_room"),
        ("nap_room", "kindergarten", "nap room", "nap_room"),
        ("patient_room", "veterinary_clinic", "isolation room", "kennel"),
        ("bedroom", "", "", "bedroom"),
        ("roof_terrace", "villa", "roof terrace", "home_terrace"),
        ("roof_terrace", "hotel", "roof terrace", "roof_terrace"),
        ("restroom", "office", "womens restroom", "womens_restroom"),
        ("restroom", "office", "Women's toilets", "womens_restroom"),
        ("restroom", "office", "mens restroom", "restroom_with_urinals"),
    ],
)
def test_building_and_name_say_how_a_room_is_furnished(
    room_type: str, building_type: str, name: str, expected: str
) -> None:
    assert furnished_as(room_type, building_type, name) == expected


@pytest.mark.parametrize(
    ("beside", "expected"),
    [
        (["bathroom"], "studio_room"),
        (["bathroom", "kitchen"], "bed_sitting_room"),
        (["bedroom", "bathroom"], "living_kitchen"),
    ],
)
def test_a_studio_has_what_no_other_room_of_its_floor_is_for(beside: list[str], expected: str) -> None:
    assert furnished_as("studio_room", "studio_flat", "", beside) == expected


def test_crews_eat_in_their_kitchen_and_films_have_a_foyer() -> None:
    assert furnished_as("kitchen", "fire_station") == "crew_kitchen"
    assert furnished_as("common_room", "fire_station") == "day_room"
    assert furnished_as("lobby", "cinema") == "cinema_lobby"
    assert furnished_as("lobby", "museum") == "museum_lobby"
    assert furnished_as("lobby", "hotel") == "lobby"


def test_rooms_are_furnished_by_what_their_names_say_is_done_there() -> None:
    assert furnished_as("radiology_room", "dental_clinic") == "dental_xray_room"
    assert furnished_as("radiology_room", "hospital") == "radiology_room"
    assert furnished_as("gym", "gym_building", "Weights area") == "weights_area"
    assert furnished_as("lounge", "laboratory_building", "Test area") == "robot_test_area"


def test_those_who_need_care_wash_without_a_tub() -> None:
    assert furnished_as("bathroom", "nursing_home") == "accessible_bathroom"
    assert furnished_as("bathroom", "house", "Accessible bathroom") == "accessible_bathroom"
    assert furnished_as("bathroom", "house") == "bathroom"


@pytest.mark.parametrize(
    ("room_type", "building_type", "called", "expected"),
    [
        ("sales_area", "shop_building", "bookshop", "bookshop_floor"),
        ("sales_area", "shop_building", "", "shop"),
        ("gallery", "museum", "natural_history_museum", "natural_history_hall"),
        ("gallery", "museum", "", "gallery"),
    ],
)
def test_what_a_brief_calls_a_building_says_more_than_its_type(
    room_type: str, building_type: str, called: str, expected: str
) -> None:
    assert furnished_as(room_type, building_type, called=called) == expected


@pytest.mark.parametrize(
    ("room_type", "building_type", "name", "expected"),
    [
        ("hospital_ward", "veterinary_clinic", "ward", "animal_ward"),
        ("kennel", "veterinary_clinic", "bird ward", "animal_ward"),
        ("dressing_room", "theatre", "make-up room", "makeup_room"),
        ("dressing_room", "villa", "dressing room", "walk_in_closet"),
        ("sound_control_room", "tv_station", "editing room", "editing_suite"),
        ("gallery", "church", "choir gallery", "choir_gallery"),
        ("storage", "car_workshop", "tyre room", "tyre_store"),
        ("electrical_room", "data_center", "battery room", "battery_room"),
    ],
)
def test_rooms_for_one_use_have_its_furniture(room_type: str, building_type: str, name: str, expected: str) -> None:
    assert furnished_as(room_type, building_type, name) == expected
